#include "ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEventLoop>
#include <QGuiApplication>
#include <QPainter>
#include <QPushButton>

#include "render/graph/pass.h"
#include "scene/rules/automatic.h"
#include "scene/rules/relevance.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {
constexpr int restMilliseconds = 200;                // after the last change, before the fine picture
constexpr std::size_t brickBytesPerFrame = 8 << 20;  // a few milliseconds of uploads
constexpr std::size_t lightBytesPerFrame = 1 << 20;  // so are these: texels are filtered on their way
constexpr int seenMilliseconds = 200;                // what moves on is told at most this often
constexpr int fieldPollMilliseconds = 50;
constexpr int pollMilliseconds = 4;    // a picture that is there is taken
constexpr int pointMilliseconds = 40;  // the pointer's value is looked up at most this often

bool sameRays(const render::FrameRequest& a, const render::FrameRequest& b) {
  return a.size == b.size && a.supersampling == b.supersampling;
}

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
    : QWidget(parent), overlay_(new ViewportOverlay(this)), remedy_(new QPushButton(this)) {
  resolved_ = scene::resolve(scene_, {});  // the background, until there is a volume
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setAttribute(Qt::WA_OpaquePaintEvent);
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
  pollTimer_.setTimerType(Qt::PreciseTimer);
  pollTimer_.setInterval(pollMilliseconds);
  connect(&pollTimer_, &QTimer::timeout, this, &Viewport::poll);
}

Viewport::~Viewport() = default;

// ---- Pictures
// -----------------------------------------------------------------------------------------------

void Viewport::takeContext() {
  const app::PictureThread::Context* const context = thread_.context();
  if (context == nullptr) return;
  if (context->failure) {
    pollTimer_.stop();
    fail(reasonOf(context->failure), needsOpenGl);
    return;
  }
  hasContext_ = true;
  glDescription_ = QString::fromStdString(context->description->renderer + ", OpenGL " +
                                          context->description->version + ", " + context->description->kind);
  quality_ = app::PictureQuality(context->description->software);
  quality_.setSupersampling(resolved_.picture.supersampling);
  quality_.setMachine(machine_);
  redraw();
}

void Viewport::fail(const QString& reason, const QString& advice) {
  const bool news = problem_ != reason;
  failed_ = true;
  remedy_->hide();
  problem_ = reason;
  overlay_->setProblem(reason, advice);
  update();
  if (news) Q_EMIT failed(reason);
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  pollTimer_.start();
  orderSoon();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  overlay_->setGeometry(rect());
  placeRemedy();
  showLamps();
  redraw();
}

glm::ivec2 Viewport::pixelSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
          std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

void Viewport::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image_.isNull() || problem_) {
    painter.fillRect(rect(), QColor::fromRgbF(0.09F, 0.10F, 0.12F));
    return;
  }
  const glm::ivec2 size = pixelSize();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != QSize(size.x, size.y));
  painter.drawImage(rect(), image_);
  if (unpainted_)
    Q_EMIT answered(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() -
                                                              *std::exchange(unpainted_, std::nullopt))
                        .count());
  if (!sameRays(shownRequest_, quality_.request(size))) orderSoon();  // on a screen of another pixel ratio
}

// Once for all that changes in one turn of the event loop.
void Viewport::orderSoon() {
  if (std::exchange(orderComes_, true)) return;
  QMetaObject::invokeMethod(this, &Viewport::order, Qt::QueuedConnection);
}

void Viewport::order() {
  orderComes_ = false;
  if (!hasContext_ || failed_ || !isVisible() || complete()) return;
  const render::FrameRequest request = quality_.request(pixelSize());
  const bool onItsWay = thread_.busy() && orderedChanges_ == changes_ && sameRays(orderedRequest_, request);
  const bool isThere = current() && !bricksPending_ && !lightPending_ && sameRays(shownRequest_, request);
  if (onItsWay || isThere) return;
  setDrawing(true);
  orderedRequest_ = request;
  orderedChanges_ = changes_;
  app::PictureOrder picture = orderOf(request);
  picture.request.brickUploadBytes = brickBytesPerFrame;
  picture.request.lightUploadBytes = lightBytesPerFrame;
  picture.draft = quality_.stage() == app::PictureQuality::Stage::moving;
  picture.tellsHits = wantsHits(request);
  orderNumber_ = thread_.draw(std::move(picture));
  awaited_.push_back({orderNumber_, view_, std::exchange(changed_, std::nullopt)});
  pollTimer_.start();
}

void Viewport::setDrawing(bool draws) {
  if (std::exchange(drawing_, draws) != draws) Q_EMIT drawing(draws);
}

app::PictureOrder Viewport::orderOf(const render::FrameRequest& request) {
  app::PictureOrder picture{volume_, drawable(), machine_, light_, request};
  picture.request.pixelRatio = devicePixelRatioF();
  return picture;
}

// Light is wanted first where it is seen. A view that keeps turning is told a few times a second. By pixels:
// what further rays of a pixel hit is in its texels' neighbourhood, which is wanted anyway.
bool Viewport::wantsHits(const render::FrameRequest& request) const {
  if (!volume_ || scene::shadingOf(resolved_) != scene::Shading::gi) return false;
  if (static_cast<double>(request.size.x) * request.size.y <= seenPixels_) return false;
  const bool moving = quality_.stage() == app::PictureQuality::Stage::moving;
  return !moving || !sinceSeen_.isValid() || sinceSeen_.elapsed() >= seenMilliseconds;
}

void Viewport::poll() {
  if (!hasContext_) {
    takeContext();
    return;
  }
  auto result = thread_.take();
  if (!thread_.busy()) {
    pollTimer_.stop();
    setDrawing(false);
  }
  if (!result) return;
  if (auto* const picture = std::get_if<app::DrawnPicture>(&*result))
    put(*picture);
  else if (const auto& failure = std::get<app::FailedPicture>(*result); failure.order == orderNumber_)
    fail(reasonOf(failure.reason), comesBack);
}

void Viewport::put(const app::DrawnPicture& picture) {
  const glm::ivec2 size = picture.color.size;
  image_ = QImage(picture.color.rgba.data(), size.x, size.y, QImage::Format_RGBX8888)
               .convertToFormat(QImage::Format_RGB32);
  // A draft that comes after a change is shown all the same, so that the view moves.
  shownChanges_ = picture.order == orderNumber_ ? orderedChanges_ : 0;
  shownRequest_ = picture.request;
  showed(picture, answer(picture.order));
  update();
}

// What was changed before this order is answered by its picture. Which view it shows.
std::uint64_t Viewport::answer(std::uint64_t order) {
  std::uint64_t view = 0;
  const auto answered = [&](const Awaited& awaited) {
    if (awaited.order > order) return false;
    if (!unpainted_) unpainted_ = awaited.changed;
    view = awaited.view;
    return true;
  };
  awaited_.erase(std::remove_if(awaited_.begin(), awaited_.end(), answered), awaited_.end());
  return view;
}

// A picture is on screen: what follows from it.
void Viewport::showed(const app::DrawnPicture& picture, std::uint64_t view) {
  const render::FrameReport& report = picture.report;
  problem_.reset();
  failed_ = false;
  overlay_->setProblem({});
  if (ran(report) && sameRays(picture.request, quality_.request(pixelSize())))  // else it tells nothing of it
    quality_.measured(picture.milliseconds,
                      ran(report, render::pass::cast) ? app::Motion::rays : app::Motion::look);
  if (underMouse()) pointTimer_.start();  // another point may lie under a pointer that rests
  bricksPending_ = report.bricks.pending;
  lightPending_ = report.light.pending;
  const bool waits = refineTimer_.isActive();  // an animation draws while a finer picture is on its way
  if (current() && quality_.stage() == app::PictureQuality::Stage::sharp && quality_.mayRefine() && !waits)
    refineTimer_.start(static_cast<int>(quality_.pauseMilliseconds()));
  const bool empty = report.empty && !fieldsPending_;
  overlay_->setNote(fieldsPending_ ? fieldNote(*fieldJob_)
                    : empty        ? QString::fromStdString(report.empty->reason)
                                   : missingNote(report.bricks));
  offerRemedy(empty ? report.empty : std::nullopt);
  if (bricksPending_ || lightPending_) orderSoon();  // the next picture gets further
  tellSeen(picture, view);
  Q_EMIT reported(report, picture.request);
  Q_EMIT drawn(picture.milliseconds, complete());
}

void Viewport::tellSeen(const app::DrawnPicture& picture, std::uint64_t view) {
  if (picture.hitVoxels.empty() || bricksPending_) return;
  const bool same = view == view_;
  sinceSeen_.start();
  Q_EMIT seen(picture.hitVoxels, same && seenPixels_ > 0.0);
  if (same) seenPixels_ = static_cast<double>(picture.request.size.x) * picture.request.size.y;
}

void Viewport::viewChanged() {
  ++view_;
  seenPixels_ = 0.0;
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

bool Viewport::complete() const {
  return current() && !bricksPending_ && !lightPending_ && !fieldsPending_ &&
         shownRequest_.size == pixelSize() &&
         shownRequest_.supersampling == std::clamp(resolved_.picture.supersampling, 1, 4);
}

// Something of the picture is another one.
void Viewport::changed() {
  ++changes_;
  if (!changed_) changed_ = std::chrono::steady_clock::now();
  if (hasContext_) failed_ = false;
  orderSoon();
}

void Viewport::redraw(app::Motion motion) {
  changed();
  if (motion == app::Motion::rays) viewChanged();
  quality_.changed(motion);
  refineTimer_.start(restMilliseconds);
}

void Viewport::refine() {
  if (interacting_ || drag_ != Drag::none) return;  // starts again when the gesture ends
  if (complete()) {                                 // drawn in full at once: nothing finer follows
    while (quality_.refine()) {
    }
    return;
  }
  quality_.refine();
  orderSoon();  // showed() starts the timer for the stage after this one
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
  redraw();
}

void Viewport::setMachine(const scene::Machine& machine) {
  if (machine == machine_) return;
  machine_ = machine;
  quality_.setMachine(machine);
  redraw();
}

void Viewport::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  const app::Motion motion = motionBetween(resolved_, resolved);
  const bool switchedOn =
      scene::shadingOf(resolved) == scene::Shading::gi && scene::shadingOf(resolved_) != scene::Shading::gi;
  if (switchedOn) viewChanged();
  scene_ = scene;
  resolved_ = resolved;
  overlay_->setScene(resolved, volume_ != nullptr, axes());
  showLamps();
  quality_.setSupersampling(resolved.picture.supersampling);
  redraw(motion);
}

void Viewport::setFlowTime(double seconds) {
  resolved_.flow.time = seconds;
  quality_.animated();
  changed();
}

void Viewport::setLight(LightPointer light, bool changing) {
  light_ = std::move(light);
  quality_.setLightChanging(changing);
  if (!changing && !refineTimer_.isActive()) rest();
  changed();
}

render::StillPicture Viewport::picture(bool linear) {
  const auto refuse = [](const char* why) { throw base::Error(base::ErrorKind::graphics, "", "", why); };
  if (!hasContext_ || failed_) refuse("there is no picture to save");
  if (stillComes_) refuse("another picture is being saved");
  if (volume_ && !volume_->cubicFields->readyFor(resolved_)) {
    if (fieldJob_ && fieldJob_->finished() && fieldJob_->error()) throw base::Error(*fieldJob_->error());
    refuse("the volume is still being interpolated for this picture; save it in a moment");
  }
  render::FrameRequest request;
  request.size = pixelSize();
  request.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
  request.linear = linear;
  thread_.drawStill(orderOf(request));
  const std::unique_ptr<app::PictureThread::Still> still = awaitStill();
  changed();  // the order that was dropped for it
  if (!still) throw base::Error(base::ErrorKind::interrupted, "", "", "the picture was not waited for");
  if (auto* const picture = std::get_if<render::StillPicture>(still.get())) return std::move(*picture);
  try {
    std::rethrow_exception(std::get<std::exception_ptr>(*still));
  } catch (const base::Error&) {
    throw;
  } catch (...) {
    throw base::Error(base::ErrorKind::graphics, "", "", reasonOf(std::current_exception()).toStdString());
  }
}

// Null: the program ends.
std::unique_ptr<app::PictureThread::Still> Viewport::awaitStill() {
  std::unique_ptr<app::PictureThread::Still> still;
  QEventLoop loop;
  QTimer timer;
  connect(&timer, &QTimer::timeout, &loop, [&] {
    still = thread_.takeStill();
    if (still) loop.quit();
  });
  timer.start(pollMilliseconds);
  stillComes_ = true;
  setDrawing(true);
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  QGuiApplication::restoreOverrideCursor();
  stillComes_ = false;
  setDrawing(false);
  return still;
}

QString Viewport::description() const {
  return problem_ ? *problem_ : glDescription_;
}

std::optional<app::Pick> Viewport::pickAt(QPointF position) const {
  if (!volume_ || !hasContext_ || failed_ || !rect().contains(position.toPoint())) return std::nullopt;
  const glm::dvec2 fraction(position.x() / width(), position.y() / height());
  const double aspect = static_cast<double>(pixelSize().x) / pixelSize().y;
  return app::pickSurface(*volume_, resolved_, {2.0 * fraction.x - 1.0, 1.0 - 2.0 * fraction.y}, aspect);
}

}  // namespace isolux::ui
