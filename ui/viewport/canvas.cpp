#include "ui/viewport/canvas.h"

#include <optional>
#include <utility>

#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QPainter>

#include "render/gl/gl_objects.h"

namespace isolux::ui {

namespace {

// Paints pictures in main memory with Qt's raster engine: where OpenGL is software, or the window system has
// none.
class PixelCanvas : public QWidget, public Canvas {
 public:
  PixelCanvas(QWidget* parent, Painted painted) : QWidget(parent), Canvas(std::move(painted)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  QWidget* widget() override { return this; }
  CanvasKind kind() const override { return CanvasKind::pixels; }
  QImage read(const CanvasPicture& picture) override { return picture.pixels; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const CanvasContent& shown = content();
    if (!shown.picture) {
      painter.fillRect(rect(), QColor::fromRgbF(canvasGround[0], canvasGround[1], canvasGround[2]));
    } else {
      const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
      painter.setRenderHint(QPainter::SmoothPixmapTransform, shown.picture.size() != pixels);
      painter.drawImage(rect(), shown.over.isNull() ? shown.picture.pixels : shown.over);
      if (shown.opacityBefore > 0.0) {
        painter.setOpacity(shown.opacityBefore);
        painter.drawImage(rect(), shown.before.pixels);
      }
    }
    painter.end();
    this->painted();
  }
};

// Shows pictures that stay on the graphics card. Its context shares objects with that of the picture thread,
// through Qt's global share context.
class TextureCanvas : public QOpenGLWidget, public Canvas {
 public:
  TextureCanvas(QWidget* parent, Painted painted) : QOpenGLWidget(parent), Canvas(std::move(painted)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  ~TextureCanvas() override { release(); }
  QWidget* widget() override { return this; }
  CanvasKind kind() const override { return CanvasKind::textures; }
  QImage read(const CanvasPicture& picture) override {
    if (!picture.texture) return picture.pixels;
    makeCurrent();
    if (!objects_) return {};  // never shown
    const render::Gl& gl = *objects_->gl;
    QImage image(picture.size(), QImage::Format_RGBX8888);
    picture.texture->await(gl);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.GetTextureImage(picture.texture->texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       static_cast<GLsizei>(image.sizeInBytes()), image.bits());
    picture.texture->readUntilHere(gl);
    doneCurrent();
    return image.mirrored().convertToFormat(QImage::Format_RGB32);
  }

 protected:
  void initializeGL() override {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &TextureCanvas::release,
            Qt::UniqueConnection);
    objects_.emplace(render::Gl::load(
        [this](const char* name) { return reinterpret_cast<void*>(context()->getProcAddress(name)); }));
  }
  void paintGL() override {
    const CanvasContent& shown = content();
    if (shown.picture.texture) {
      draw(shown);
    } else {
      const float ground[4] = {canvasGround[0], canvasGround[1], canvasGround[2], 1.0F};
      objects_->gl->ClearNamedFramebufferfv(defaultFramebufferObject(), GL_COLOR, 0, ground);
    }
    painted();
  }

 private:
  // Holds the objects of one context; the window system may replace the context.
  struct Objects {
    explicit Objects(render::GlPtr pointer)
        : gl(std::move(pointer)), program(gl, "fullscreen.vert.glsl", "canvas.frag.glsl"), empty(gl) {}
    render::GlPtr gl;
    render::Program program;
    render::VertexArray empty;
    render::Texture over;
    qint64 overKey = 0;  // QImage::cacheKey of what `over` holds
  };
  void release() {
    if (!objects_) return;
    makeCurrent();
    objects_.reset();
    doneCurrent();
  }
  // Sets all state that it relies on: Qt's widgets are drawn with another context.
  void draw(const CanvasContent& shown) {
    Objects& own = *objects_;
    const render::Gl& gl = *own.gl;
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    gl.Viewport(0, 0, pixels.width(), pixels.height());
    const bool isOver = !shown.over.isNull(), fades = shown.opacityBefore > 0.0;
    shown.picture.texture->await(gl);
    if (fades) shown.before.texture->await(gl);
    gl.BindTextureUnit(0, isOver ? overTexture(shown.over) : shown.picture.texture->texture());
    gl.BindTextureUnit(1, fades ? shown.before.texture->texture() : 0);
    own.program.set("uPicture", 0);
    own.program.set("uBefore", 1);
    own.program.set("uOpacityBefore", fades ? static_cast<float>(shown.opacityBefore) : 0.0F);
    own.program.set("uSize", glm::ivec2(pixels.width(), pixels.height()));
    own.program.set("uTopRowFirst", isOver ? 1 : 0);
    gl.UseProgram(own.program.id());
    gl.BindVertexArray(own.empty.id());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    shown.picture.texture->readUntilHere(gl);
    if (fades) shown.before.texture->readUntilHere(gl);
  }
  GLuint overTexture(const QImage& over) {
    Objects& own = *objects_;
    if (own.overKey == over.cacheKey()) return own.over.id();
    const QImage image = over.convertToFormat(QImage::Format_RGBX8888);
    own.over = render::Texture::make2D(own.gl, GL_RGBA8, {image.width(), image.height()});
    own.over.setFilter(GL_LINEAR);
    own.over.write(GL_RGBA, GL_UNSIGNED_BYTE, image.constBits());
    own.overKey = over.cacheKey();
    return own.over.id();
  }
  std::optional<Objects> objects_;
};

}  // namespace

std::unique_ptr<Canvas> makeCanvas(CanvasKind kind, QWidget* parent, Canvas::Painted painted) {
  if (kind == CanvasKind::textures) return std::make_unique<TextureCanvas>(parent, std::move(painted));
  return std::make_unique<PixelCanvas>(parent, std::move(painted));
}

}  // namespace isolux::ui
