#include "ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPushButton>

#include "render/graph/pass.h"
#include "scene/rules/automatic.h"
#include "scene/rules/relevance.h"
#include "ui/viewport/gl_bridge.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {
constexpr int restMilliseconds = 200;                // after the last change, before the fine picture
constexpr std::size_t brickBytesPerFrame = 8 << 20;  // a few milliseconds of uploads
constexpr std::size_t lightBytesPerFrame = 1 << 20;  // so are these: texels are filtered on their way
constexpr int seenMilliseconds = 200;                // what moves on is told at most this often
constexpr int fieldPollMilliseconds = 50;
constexpr int pointMilliseconds = 40;  // the pointer's value is looked up at most this often

bool ran(const render::FrameReport& report, const char* pass = nullptr) {  // null: any
  return std::any_of(report.passes.begin(), report.passes.end(), [pass](const render::PassReport& entry) {
    return entry.state == render::PassState::ran && (pass == nullptr || entry.name == pass);
  });
}

// What to say of a picture of which something is missing.
QString fieldNote(const app::FieldJob& job) {
  if (job.finished() && job.error()) return QString::fromStdString(job.error()->what());
  return QString("Interpolating the volume: %1 %; until then another field is shown")
      .arg(std::lround(100.0 * job.progress().fraction()));
}

QString missingNote(const render::BrickReport& bricks) {
  if (bricks.missing <= 0.0) return {};
  const QString percent = QString::number(100.0 * bricks.missing, 'g', 2);
  return bricks.pending
             ? QString("Loading: %1 % of the picture is missing").arg(percent)
             : QString("%1 % of the picture is missing: memory.gpu_budget_mb is too small for this view")
                   .arg(percent);
}

QString reasonOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const base::Error& error) {
    return QString::fromStdString(error.what());
  } catch (const std::bad_alloc&) {
    return "there is not enough memory for this picture";
  } catch (const std::exception& error) {
    return QString("a mistake in Isolux itself: ") + error.what();
  } catch (...) {
    return "a mistake in Isolux itself";
  }
}

const QString needsOpenGl = "Isolux needs OpenGL 4.5. `isolux doctor` says what this machine offers.";
const QString comesBack =
    "It is tried again when something changes: undo the last step, or choose other settings.";

// Whether two scenes differ in nothing but how a surface that is hit already is shown.
app::Motion motionBetween(const scene::Scene& from, scene::Scene to) {
  to.look = from.look;
  to.flow = from.flow;
  to.light = from.light;
  to.lamps = from.lamps;
  to.gi = from.gi;
  to.picture.exposure = from.picture.exposure;
  to.isosurface.albedo = from.isosurface.albedo;
  to.isosurface.albedoSource = from.isosurface.albedoSource;
  to.isosurface.albedoMap = from.isosurface.albedoMap;
  to.isosurface.albedoLow = from.isosurface.albedoLow;
  to.isosurface.albedoHigh = from.isosurface.albedoHigh;
  return to == from ? app::Motion::look : app::Motion::rays;
}
}  // namespace

Viewport::Viewport(QWidget* parent)
    : QOpenGLWidget(parent), overlay_(new ViewportOverlay(this)), remedy_(new QPushButton(this)) {
  resolved_ = scene::resolve(scene_, {});  // the background, until there is a volume
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
  setAccessibleName("Picture");
  remedy_->setObjectName("remedy");
  remedy_->hide();
  connect(remedy_, &QPushButton::clicked, this, &Viewport::takeRemedy);
  refineTimer_.setSingleShot(true);
  connect(&refineTimer_, &QTimer::timeout, this, &Viewport::refine);
  pointTimer_.setSingleShot(true);
  pointTimer_.setInterval(pointMilliseconds);
  connect(&pointTimer_, &QTimer::timeout, this, &Viewport::reportPointed);
  fieldTimer_.setInterval(fieldPollMilliseconds);
  connect(&fieldTimer_, &QTimer::timeout, this, &Viewport::pollFields);
  // Without any context initializeGL() is never called; half a second after showing it would have been.
  contextTimer_.setSingleShot(true);
  contextTimer_.setInterval(500);
  connect(&contextTimer_, &QTimer::timeout, this, [this] {
    if (isVisible() && !isValid() && !problem_)
      fail("no OpenGL context could be made for the window", needsOpenGl);
  });
}

Viewport::~Viewport() {
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  releaseRenderer();
}

// ---- GL
// -----------------------------------------------------------------------------------------------------

void Viewport::initializeGL() {
  try {
    QOpenGLContext* current = context();
    // The context can go away before this widget does (moved to another window or screen).
    connect(current, &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseRenderer,
            static_cast<Qt::ConnectionType>(Qt::DirectConnection | Qt::UniqueConnection));
    gl_ = loadGl(
        [current](const char* name) { return reinterpret_cast<void*>(current->getProcAddress(name)); });
    glDescription_ = QString::fromStdString(describeGl(*gl_));
    quality_ = app::PictureQuality(isSoftware(*gl_));
    quality_.setSupersampling(resolved_.picture.supersampling);
    quality_.setMachine(machine_);
    redraw();
  } catch (...) {
    gl_.reset();
    fail(reasonOf(std::current_exception()), needsOpenGl);
  }
}

void Viewport::releaseRenderer() {
  gl_.reset();
  if (!renderer_) return;
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewport::fail(const QString& reason, const QString& advice) {
  const bool news = problem_ != reason;
  failed_ = true;
  remedy_->hide();
  problem_ = reason;
  overlay_->setProblem(reason, advice);
  if (news) Q_EMIT failed(reason);
}

void Viewport::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  contextTimer_.start();
}

void Viewport::resizeGL(int, int) {
  redraw();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  overlay_->setGeometry(rect());
  placeRemedy();
  showLamps();
}

glm::ivec2 Viewport::pixelSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
          std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

void Viewport::paintGL() {
  const render::FrameReport* report = nullptr;
  QElapsedTimer timer;
  timer.start();
  if (gl_ && !failed_) {
    Q_EMIT drawing(true);
    try {
      report = &drawPicture();
    } catch (const base::Error&) {  // the renderer is as good as before
      fail(reasonOf(std::current_exception()), comesBack);
    } catch (...) {  // and here nobody knows
      renderer_.reset();
      fail(reasonOf(std::current_exception()), comesBack);
    }
    Q_EMIT drawing(false);
  }
  if (report)
    showed(*report, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  else
    clearPicture();
}

const render::FrameReport& Viewport::drawPicture() {
  if (!renderer_) {
    renderer_ = std::make_unique<render::Renderer>(gl_);
    renderer_->setMachine(machine_);
    renderer_->setVolume(volume_);
    current_ = false;
  }
  if (!complete()) lastRequest_ = quality_.request(pixelSize());  // else the same picture is shown again
  lastRequest_.pixelRatio = devicePixelRatioF();
  lastRequest_.brickUploadBytes = brickBytesPerFrame;
  lastRequest_.lightUploadBytes = lightBytesPerFrame;
  renderer_->setLight(light_);
  const render::FrameReport& report = renderer_->render(drawable(), lastRequest_);
  renderer_->present(defaultFramebufferObject(), pixelSize());
  return report;
}

void Viewport::clearPicture() {
  QOpenGLFunctions* functions = context()->functions();
  functions->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  functions->glClearColor(0.09F, 0.10F, 0.12F, 1.0F);
  functions->glClear(GL_COLOR_BUFFER_BIT);
}

// A picture is on screen: what follows from it.
void Viewport::showed(const render::FrameReport& report, double milliseconds) {
  problem_.reset();
  overlay_->setProblem({});
  current_ = true;
  if (ran(report)) {  // not when the same picture is only shown again
    quality_.measured(milliseconds, ran(report, render::pass::cast) ? app::Motion::rays : app::Motion::look);
    pictureMilliseconds_ = milliseconds;
    if (underMouse()) pointTimer_.start();  // another point may lie under a pointer that rests
  }
  const bool waits = refineTimer_.isActive();  // an animation draws while a finer picture is on its way
  if (quality_.stage() == app::PictureQuality::Stage::sharp && quality_.mayRefine() && !waits) {
    refineTimer_.start(static_cast<int>(quality_.pauseMilliseconds()));
  }
  bricksPending_ = report.bricks.pending;
  lightPending_ = report.light.pending;
  const bool empty = report.empty && !fieldsPending_;
  overlay_->setNote(fieldsPending_ ? fieldNote(*fieldJob_)
                    : empty        ? QString::fromStdString(report.empty->reason)
                                   : missingNote(report.bricks));
  offerRemedy(empty ? report.empty : std::nullopt);
  if (bricksPending_ || lightPending_) update();  // the next frame gets further
  reportSeen();
  Q_EMIT reported(report, lastRequest_);
  Q_EMIT drawn(pictureMilliseconds_, complete());
}

// An empty picture says why (the overlay's note), and what would fill it is one click away.
void Viewport::offerRemedy(const std::optional<render::EmptyPicture>& empty) {
  using Remedy = render::EmptyPicture::Remedy;
  offered_ = empty ? empty->remedy : Remedy::none;
  remedy_->setVisible(offered_ != Remedy::none);
  switch (offered_) {
    case Remedy::none:
      return;
    case Remedy::isovalue:
      remedy_->setText("Suggested isovalue");
      break;
    case Remedy::view:
      remedy_->setText("Reset view");
      break;
    case Remedy::opacity:
      remedy_->setText("Make it opaque");
      break;
  }
  placeRemedy();
}

void Viewport::takeRemedy() {
  using Remedy = render::EmptyPicture::Remedy;
  if (offered_ == Remedy::view) {
    resetView();
    return;
  }
  Edit edit{scene_, remedy_->text(), {}, false};
  if (offered_ == Remedy::isovalue) edit.scene.isosurface.value.reset();
  if (offered_ == Remedy::opacity) edit.scene.isosurface.opacity = 1.0;
  Q_EMIT edited(edit);
}

void Viewport::placeRemedy() {
  constexpr int belowNote = 64;  // pixels: under the overlay's line
  remedy_->adjustSize();
  remedy_->move((width() - remedy_->width()) / 2, belowNote);
}

// Light is wanted first where it is seen. A view that keeps turning is told a few times a second.
void Viewport::reportSeen() {
  if (!volume_ || bricksPending_ || scene::shadingOf(resolved_) != scene::Shading::gi) return;
  // By pixels: what further rays of a pixel hit is in its texels' neighbourhood, which is wanted anyway.
  const double pixels = static_cast<double>(lastRequest_.size.x) * lastRequest_.size.y;
  if (pixels <= seenPixels_) return;
  const bool moving = quality_.stage() == app::PictureQuality::Stage::moving;
  if (moving && sinceSeen_.isValid() && sinceSeen_.elapsed() < seenMilliseconds) return;
  sinceSeen_.start();
  Q_EMIT seen(renderer_->hitVoxels(), seenPixels_ > 0.0);
  seenPixels_ = pixels;
}

bool Viewport::complete() const {
  return renderer_ && current_ && !bricksPending_ && !lightPending_ && !fieldsPending_ &&
         lastRequest_.size == pixelSize() &&
         lastRequest_.supersampling == std::clamp(resolved_.picture.supersampling, 1, 4);
}

void Viewport::redraw(app::Motion motion) {
  current_ = false;
  failed_ = false;
  if (motion == app::Motion::rays) seenPixels_ = 0.0;
  quality_.changed(motion);
  refineTimer_.start(restMilliseconds);
  update();
}

void Viewport::refine() {
  if (interacting_ || drag_ != Drag::none) return;  // starts again when the gesture ends
  if (complete()) {                                 // drawn in full at once: nothing finer follows
    while (quality_.refine()) {
    }
    return;
  }
  quality_.refine();
  update();  // paintGL() starts the timer for the stage after this one
}

void Viewport::setInteracting(bool interacting) {
  interacting_ = interacting;
  if (!interacting) rest();
}

void Viewport::rest() {
  refineTimer_.start(restMilliseconds);
}

scene::WorldAxes Viewport::axes() const {
  return volume_ ? volume_->volume.axes : scene::WorldAxes::zUp;
}

void Viewport::setHint(const QString& text) {
  overlay_->setHint(text);
}

scene::Scene Viewport::drawable() {
  fieldsPending_ = volume_ && !volume_->cubicFields->readyFor(resolved_);
  if (!fieldsPending_) return resolved_;
  if (!fieldJob_ || (fieldJob_->finished() && !fieldJob_->isFor(resolved_)))
    fieldJob_ = std::make_unique<app::FieldJob>(volume_, resolved_);
  if (!fieldTimer_.isActive()) fieldTimer_.start();
  return app::withReadyFields(resolved_, *volume_->cubicFields);
}

void Viewport::pollFields() {
  if (!fieldJob_ || !volume_ || volume_->cubicFields->readyFor(resolved_)) {
    fieldTimer_.stop();
    if (fieldsPending_) redraw();
    return;
  }
  overlay_->setNote(fieldNote(*fieldJob_));
  if (!fieldJob_->finished()) return;
  fieldTimer_.stop();
  if (!fieldJob_->isFor(resolved_)) redraw();  // the next one's turn
}

void Viewport::setTopInset(int pixels) {
  overlay_->setTopInset(pixels);
}

void Viewport::setVolume(VolumePointer volume) {
  fieldJob_.reset();
  volume_ = std::move(volume);
  if (renderer_) {
    makeCurrent();
    renderer_->setVolume(volume_);
    doneCurrent();
  }
  redraw();
}

void Viewport::setMachine(const scene::Machine& machine) {
  if (machine == machine_) return;
  machine_ = machine;
  quality_.setMachine(machine);
  if (renderer_) renderer_->setMachine(machine);
  redraw();
}

void Viewport::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  const app::Motion motion = motionBetween(resolved_, resolved);
  const bool switchedOn =
      scene::shadingOf(resolved) == scene::Shading::gi && scene::shadingOf(resolved_) != scene::Shading::gi;
  if (switchedOn) seenPixels_ = 0.0;
  scene_ = scene;
  resolved_ = resolved;
  overlay_->setScene(resolved, volume_ != nullptr, axes());
  showLamps();
  quality_.setSupersampling(resolved.picture.supersampling);
  redraw(motion);
}

void Viewport::setFlowTime(double seconds) {
  resolved_.flow.time = seconds;
  current_ = false;
  quality_.animated();
  update();
}

void Viewport::setLight(LightPointer light, bool changing) {
  light_ = std::move(light);
  quality_.setLightChanging(changing);
  current_ = false;
  if (!changing && !refineTimer_.isActive()) rest();
  update();
}

render::StillPicture Viewport::picture(bool linear) {
  if (!renderer_) throw base::Error(base::ErrorKind::graphics, "", "", "there is no picture to save");
  makeCurrent();
  try {
    render::FrameRequest request;
    request.size = pixelSize();
    request.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
    request.pixelRatio = devicePixelRatioF();
    const bool ready = !volume_ || volume_->cubicFields->readyFor(resolved_);
    if (!ready && fieldJob_ && fieldJob_->finished() && fieldJob_->error())
      throw base::Error(*fieldJob_->error());
    if (!ready)
      throw base::Error(base::ErrorKind::graphics, "", "",
                        "the volume is still being interpolated for this picture; save it in a moment");
    renderer_->setLight(light_);
    request.linear = linear;
    base::Progress unwatched;
    render::StillPicture picture = render::drawStill(*renderer_, resolved_, request, unwatched);
    current_ = false;  // what pick() reads is drawn anew
    update();
    doneCurrent();
    return picture;
  } catch (const base::Error&) {
    doneCurrent();
    throw;
  } catch (...) {
    renderer_.reset();
    doneCurrent();
    throw base::Error(base::ErrorKind::graphics, "", "", reasonOf(std::current_exception()).toStdString());
  }
}

QString Viewport::description() const {
  return problem_ ? *problem_ : glDescription_;
}

std::optional<render::Pick> Viewport::pickAt(QPointF position) {
  if (!renderer_ || !volume_ || lastRequest_.size.x < 1 || width() < 1 || height() < 1) return std::nullopt;
  const QPointF fraction(position.x() / width(), position.y() / height());
  const glm::ivec2 pixel{static_cast<int>(std::floor(fraction.x() * lastRequest_.size.x)),
                         static_cast<int>(std::floor(fraction.y() * lastRequest_.size.y))};
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= lastRequest_.size.x || pixel.y >= lastRequest_.size.y) {
    return std::nullopt;
  }
  makeCurrent();
  std::optional<render::Pick> pick;
  try {
    pick = renderer_->pick(pixel);
  } catch (...) {
    pick.reset();  // nothing to read yet
  }
  doneCurrent();
  return pick;
}

}  // namespace isolux::ui
