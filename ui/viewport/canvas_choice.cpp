#include "ui/viewport/canvas_choice.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include <QDate>
#include <QDir>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>
#include <QProcessEnvironment>
#include <QSettings>
#include <QStringList>
#include <QSurfaceFormat>

#include "base/clock.h"
#include "base/error.h"
#include "render/gl/gl.h"
#include "render/gl/gl_objects.h"

namespace isolux::ui {

namespace {

constexpr auto measuredKey = "window/canvas_measured", measuredOnKey = "window/canvas_measured_on",
               measuredAtKey = "window/canvas_measured_at";
constexpr qint64 daysValid = 7;  // another driver may have been installed
constexpr glm::ivec2 measuredSize(640, 450);

[[noreturn]] void fail(const char* reason) {
  throw base::Error(base::ErrorKind::graphics, "", "OpenGL", reason);
}

class SharedContext final : public render::OffscreenContext {
 public:
  explicit SharedContext(std::shared_ptr<QOffscreenSurface> surface) : surface_(std::move(surface)) {
    QOpenGLContext* const window = QOpenGLContext::globalShareContext();
    context_.setFormat(window->format());
    context_.setShareContext(window);
    if (!context_.create()) fail("the window system creates no second context");
    if (!QOpenGLContext::areSharing(&context_, window)) fail("the driver shares no objects between contexts");
    SharedContext::makeCurrent();
    load("Qt " + QGuiApplication::platformName().toStdString() + ", shared with the window",
         [this](const char* name) { return reinterpret_cast<void*>(context_.getProcAddress(name)); });
  }
  ~SharedContext() override { context_.doneCurrent(); }
  void makeCurrent() override {
    if (!context_.makeCurrent(surface_.get())) fail("the window system cannot make the context current");
  }

 private:
  std::shared_ptr<QOffscreenSurface> surface_;
  QOpenGLContext context_;
};

// Returns a function that creates a context for the picture thread, which shares objects with the window's,
// on the thread that calls it. It throws base::Error{graphics} if the driver cannot share.
std::function<std::unique_ptr<render::OffscreenContext>()> sharedContext() {
  // Made, used and destroyed by different threads; windows belong to that of the application.
  const std::shared_ptr<QOffscreenSurface> surface(new QOffscreenSurface,
                                                   [](QOffscreenSurface* made) { made->deleteLater(); });
  surface->setFormat(QOpenGLContext::globalShareContext()->format());
  surface->create();
  return [surface] { return std::make_unique<SharedContext>(surface); };
}

// Whatever decides which driver answers, as far as it can be asked without a context.
QStringList placeOfDrivers() {
  QStringList place{qVersion()};
  for (const char* const folder : {"/dev/dri", "/dev"})
    place += QDir(folder).entryList({"render*", "card*", "nvidia*", "dxg"}, QDir::System | QDir::Files);
  for (const QString& variable : QProcessEnvironment::systemEnvironment().toStringList())
    for (const char* const name :
         {"DISPLAY=", "WAYLAND_DISPLAY=", "QT_", "LIBGL_", "MESA_", "GALLIUM_", "__"})
      if (variable.startsWith(name)) place += variable;
  return place;
}

// Why pixels are known to be the choice, or nothing.
QString storedReason() {
  const QSettings kept;
  const qint64 days = kept.value(measuredAtKey).toDate().daysTo(QDate::currentDate());
  const bool isValid =
      days >= 0 && days < daysValid && kept.value(measuredOnKey).toStringList() == placeOfDrivers();
  return isValid ? kept.value(measuredKey).toString() : QString();
}

template <class Work>
double leastMilliseconds(Work work) {
  constexpr int rounds = 3;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    least = std::min(least, 1000.0 * base::secondsSince(begin));
  }
  return least;
}

struct Measured {
  double texturesMs = 0.0, pixelsMs = 0.0;
};

// What either canvas does between a finished picture and the window's own pixels.
Measured measure(const render::GlPtr& gl) {
  const render::Texture picture = render::Texture::make2D(gl, GL_RGBA8, measuredSize),
                        canvas = render::Texture::make2D(gl, GL_RGBA8, measuredSize),
                        window = render::Texture::make2D(gl, GL_RGBA8, measuredSize);
  render::Program program(gl, "fullscreen.vert.glsl", "canvas.frag.glsl");
  const render::VertexArray empty(gl);
  const auto draw = [&](const render::Texture& from, const render::Texture& to) {
    const render::Framebuffer target(gl, {&to});
    gl->BindFramebuffer(GL_FRAMEBUFFER, target.id());
    gl->Viewport(0, 0, measuredSize.x, measuredSize.y);
    program.setTexture("uPicture", 0, from);
    program.set("uSize", measuredSize);
    gl->UseProgram(program.id());
    gl->BindVertexArray(empty.id());
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
  };
  QImage shown(measuredSize.x, measuredSize.y, QImage::Format_RGB32);
  const auto readBack = [&](QImage& pixels, const render::Texture& from) {
    gl->GetTextureImage(from.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.sizeInBytes()),
                        pixels.bits());
  };
  QImage pixels(shown.size(), QImage::Format_RGBX8888);
  return {leastMilliseconds([&] {
            draw(picture, canvas);  // by the canvas, then by the composition of the window
            draw(canvas, window);
            readBack(pixels, window);  // a software driver puts it onto the screen from main memory
          }),
          leastMilliseconds([&] {
            readBack(pixels, picture);
            const QImage upright = pixels.mirrored().convertToFormat(QImage::Format_RGB32);
            QPainter(&shown).drawImage(0, 0, upright);
          })};
}

CanvasChoice pixelsBecause(const QString& why) {
  return {CanvasKind::pixels, why};
}

CanvasChoice textures(const QString& why) {
  return {CanvasKind::textures, why, sharedContext()};
}

CanvasChoice chooseWith(QOpenGLContext& window, scene::Canvas request) {
  QOffscreenSurface surface;
  surface.setFormat(window.format());
  surface.create();
  if (!window.makeCurrent(&surface)) return pixelsBecause(QObject::tr("OpenGL of the window does not work"));
  const auto gl = render::Gl::load(
      [&](const char* name) { return reinterpret_cast<void*>(window.getProcAddress(name)); });
  const QString driver = QString::fromStdString(gl->string(GL_RENDERER));
  std::optional<Measured> measured;
  if (request == scene::Canvas::automatic && gl->software) measured = measure(gl);
  window.doneCurrent();
  if (request == scene::Canvas::textures)
    return textures(QObject::tr("set by window.canvas; %1").arg(driver));
  if (!measured) return textures(driver);
  const QString figures = QObject::tr("%1: textures take %2 ms, pixels %3 ms")
                              .arg(driver)
                              .arg(measured->texturesMs, 0, 'f', 1)
                              .arg(measured->pixelsMs, 0, 'f', 1);
  if (measured->texturesMs < measured->pixelsMs) return textures(figures);
  QSettings kept;
  kept.setValue(measuredKey, figures);
  kept.setValue(measuredOnKey, placeOfDrivers());
  kept.setValue(measuredAtKey, QDate::currentDate());
  return pixelsBecause(figures);
}

}  // namespace

void prepareCanvas(scene::Canvas request) {
  if (request == scene::Canvas::pixels) return;
  if (request == scene::Canvas::automatic && !storedReason().isEmpty()) return;
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setOption(QSurfaceFormat::ResetNotification);
  format.setDepthBufferSize(0);
  format.setStencilBufferSize(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

CanvasChoice chooseCanvas(scene::Canvas request) {
  if (request == scene::Canvas::pixels) return pixelsBecause(QObject::tr("set by window.canvas"));
  if (!QCoreApplication::testAttribute(Qt::AA_ShareOpenGLContexts)) {
    const QString reason = request == scene::Canvas::automatic ? storedReason() : QString();
    return pixelsBecause(reason.isEmpty() ? QObject::tr("window.canvas takes effect at the next start")
                                          : reason);
  }
  QOpenGLContext* const window = QOpenGLContext::globalShareContext();
  if (window == nullptr || !window->isValid())
    return pixelsBecause(QObject::tr("the window system offers no OpenGL"));
  try {
    return chooseWith(*window, request);
  } catch (const base::Error& error) {
    return pixelsBecause(QString::fromStdString(error.reason()));
  }
}

QString describe(const CanvasChoice& choice) {
  return choice.kind == CanvasKind::textures
             ? QObject::tr("images stay on the graphics card as textures (%1)").arg(choice.why)
             : QObject::tr("images are copied to main memory (%1)").arg(choice.why);
}

}  // namespace isolux::ui
