// Pictures of ui/viewport/viewport.h: ordered, shown, saved, and what follows from each.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QPushButton>

#include "app/ready/rest_scene.h"
#include "render/gl/gl.h"
#include "render/graph/pass.h"
#include "scene/rules/relevance.h"
#include "ui/document/background_task.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {
constexpr std::size_t brickBytesPerFrame = 8 << 20;  // a few milliseconds of uploads
constexpr std::size_t lightBytesPerFrame = 1 << 20;  // so are these: texels are filtered on their way
constexpr int seenMilliseconds = 200;                // what moves on is told at most this often
constexpr int fadeMilliseconds = 400,
              fadeStepMilliseconds = 30;  // from a picture to the same in stored light
constexpr double mostRaysTold = 8 << 20;  // 96 MiB of points

double raysOf(const render::FrameRequest& request) {
  return static_cast<double>(request.size.x) * request.size.y * request.supersampling * request.supersampling;
}

bool sameRays(const render::FrameRequest& a, const render::FrameRequest& b) {
  return a.size == b.size && a.supersampling == b.supersampling;
}

bool ran(const render::FrameReport& report, const char* pass = nullptr) {  // null: any
  return std::any_of(report.passes.begin(), report.passes.end(), [pass](const render::PassReport& entry) {
    return entry.state == render::PassState::ran && (pass == nullptr || entry.name == pass);
  });
}

// What to say of a picture of which something is missing.
QString missingNote(const render::BrickReport& bricks) {
  if (bricks.missing <= 0.0) return {};
  const QString percent = QString::number(100.0 * bricks.missing, 'g', 2);
  return bricks.pending
             ? QObject::tr("Loading: %1 % of the image is missing").arg(percent)
             : QObject::tr("%1 % of the image is missing; raise Graphics memory (memory.gpu_budget_mb)")
                   .arg(percent);
}

QString reasonOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const base::Error& error) {
    return QString::fromStdString(error.what());
  } catch (const std::bad_alloc&) {
    return QObject::tr("not enough memory for this image");
  } catch (const std::exception& error) {
    return QObject::tr("internal error: %1").arg(error.what());
  } catch (...) {
    return QObject::tr("internal error");
  }
}

[[noreturn]] void throwCancelled() {
  throw base::Error(base::ErrorKind::interrupted, "", "",
                    Viewport::tr("waiting for the image was cancelled").toStdString());
}

constexpr auto needsOpenGl = QT_TRANSLATE_NOOP(
    "QObject", "Isolux requires OpenGL 4.5. `isolux doctor` lists what this computer supports.");
constexpr auto comesBack =
    QT_TRANSLATE_NOOP("QObject", "To try again, undo the last step or change a setting.");
}  // namespace

void Viewport::setCanvas(CanvasChoice choice) {
  canvasChoice_ = std::move(choice);
  hasContext_ = failed_ = false;
  picture_ = before_ = {};
  laid_ = {};
  awaited_.clear();
  shownChanges_ = orderedChanges_ = 0;
  canvas_ = makeCanvas(canvasChoice_.kind, this, [this] { painted(); });
  canvas_->widget()->setGeometry(rect());
  canvas_->widget()->lower();
  canvas_->widget()->show();
  thread_ = std::make_unique<app::PictureThread>(
      app::PictureThread::Options{.context = canvasChoice_.context,
                                  .handsTextures = canvasChoice_.kind == CanvasKind::textures,
                                  .news = posted(this, [this] { poll(); })});
  Q_EMIT canvasChanged();
}

void Viewport::takeContext() {
  const app::PictureThread::Context* const context = thread_->context();
  if (context == nullptr) return;
  if (context->failure && canvas_->kind() == CanvasKind::textures) {
    setCanvas({CanvasKind::pixels, reasonOf(context->failure)});
    Q_EMIT noted(tr("Images are copied through main memory: %1").arg(canvasChoice_.why));
    return;
  }
  if (context->failure) {
    fail(reasonOf(context->failure), QObject::tr(needsOpenGl));
    return;
  }
  hasContext_ = true;
  glDescription_ = QString::fromStdString(context->description->renderer + ", OpenGL " +
                                          context->description->version + ", " + context->description->kind);
  quality_ = app::PictureQuality(context->description->software);
  quality_.setSupersampling(resolved_.picture.supersampling);
  quality_.setHostSettings(host_);
  redraw();
}

void Viewport::fail(const QString& reason, const QString& advice) {
  const bool news = problem_ != reason;
  failed_ = true;
  remedy_->hide();
  problem_ = reason;
  overlay_->setProblem(reason, advice);
  paintCanvas();
  if (news) Q_EMIT failed(reason);
}

void Viewport::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  orderSoon();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  overlay_->setGeometry(rect());
  if (canvas_) canvas_->widget()->setGeometry(rect());
  placeButtons();
  showLamps();
  showCuts();
  redraw();
  Q_EMIT resized();
}

app::Edges Viewport::letterEdges(glm::ivec2 pixels, double ratio) {
  return {std::min(std::max(34.0 * ratio, 0.06 * pixels.x), 0.3 * pixels.x),
          std::min(26.0 * ratio, 0.1 * pixels.y)};
}

glm::ivec2 Viewport::pixelSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
          std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

void Viewport::paintCanvas() {
  if (!canvas_) return;
  CanvasContent content;
  if (!problem_) content.picture = picture_;
  for (const Over what : {Over::errors, Over::levelZero, Over::structure})
    if (showsOver(what) && content.over.isNull()) content.over = laid_[static_cast<std::size_t>(what)].image;
  const double faded = static_cast<double>(sinceFade_.elapsed()) / fadeMilliseconds;
  if (before_ && faded < 1.0 && content.picture && content.over.isNull()) {
    content.before = before_;
    content.opacityBefore = 1.0 - faded;
  } else {
    before_ = {};
    fadeTimer_.stop();
  }
  canvas_->show(std::move(content));
}

void Viewport::painted() {
  if (!canvas_->content().picture) return;
  const auto since = [now = std::chrono::steady_clock::now()](Moment moment) {
    return std::chrono::duration<double, std::milli>(now - moment).count();
  };
  if (unpainted_) Q_EMIT answered(since(*std::exchange(unpainted_, std::nullopt)), since(finished_));
  if (!sameRays(shownRequest_, quality_.request(pixelSize())))
    orderSoon();  // on a screen of another pixel ratio
}

const QImage& Viewport::shown() const {
  if (picture_.pixels.isNull() && picture_) picture_.pixels = canvas_->read(picture_);
  return picture_.pixels;
}

void Viewport::setOver(Over what, const QImage& image, const QImage& of,
                       const std::optional<render::Tile>& legend) {
  laid_[static_cast<std::size_t>(what)] = {image.convertToFormat(QImage::Format_RGB32), of.cacheKey(),
                                           legend};
  placeButtons();
  paintCanvas();
}

// Once for all that changes in one turn of the event loop.
void Viewport::orderSoon() {
  if (std::exchange(orderComes_, true)) return;
  QMetaObject::invokeMethod(this, &Viewport::order, Qt::QueuedConnection);
}

void Viewport::order() {
  orderComes_ = false;
  if (!hasContext_ || failed_ || !isVisible()) return;
  const render::FrameRequest request = quality_.request(pixelSize());
  const bool tellsAll = wantedHits(request) == render::FrameRequest::Hits::all;
  if (complete() && !tellsAll) return;
  const bool atRest = drawsRest();
  const bool onItsWay = thread_->busy() && orderedChanges_ == changes_ && orderedAtRest_ == atRest &&
                        sameRays(orderedRequest_, request);
  const bool isThere = current() && !bricksPending_ && !lightPending_ && shownAtRest_ == atRest &&
                       sameRays(shownRequest_, request) && !tellsAll;
  if (isThere) return refineSoon();  // the picture in motion was as fine as this stage asks for
  if (onItsWay) return;
  setDrawing(true);
  orderedRequest_ = request;
  orderedChanges_ = changes_;
  orderedAtRest_ = atRest;
  app::PictureOrder picture = orderOf(request, atRest);
  picture.scene.camera = cameraNow();
  picture.request.brickUploadBytes = brickBytesPerFrame;
  picture.request.lightUploadBytes = lightBytesPerFrame;
  picture.draft = quality_.stage() == app::PictureQuality::Stage::moving;
  picture.request.hits = wantedHits(request);
  orderNumber_ = thread_->draw(std::move(picture));
  awaited_.push_back({orderNumber_, view_, standsIn(), std::exchange(changed_, std::nullopt)});
}

void Viewport::setDrawing(bool draws) {
  if (std::exchange(drawing_, draws) != draws) Q_EMIT drawing(draws);
}

bool Viewport::standsIn() const {
  return !showsLight_ && scene::usesGi(resolved_);
}

app::PictureOrder Viewport::orderOf(const render::FrameRequest& request, bool atRest) {
  app::PictureOrder picture{volume_, drawable(), host_, light_, request};
  if (atRest && volume_) picture.scene = app::atRestIfReady(std::move(picture.scene), *volume_);
  if (standsIn()) picture.scene = scene::withoutGi(std::move(picture.scene));
  picture.request.pixelRatio = devicePixelRatioF();
  return picture;
}

// Light is wanted first where it is seen. A view that keeps turning is told a few times a second. At rest
// every ray counts: a texel that only one of a pixel's rays looks up would be there or not by where one has
// been before, and the same view another picture.
render::FrameRequest::Hits Viewport::wantedHits(const render::FrameRequest& request) const {
  using Hits = render::FrameRequest::Hits;
  if (!volume_ || scene::shadingOf(resolved_) != scene::Shading::gi) return Hits::none;
  if (raysOf(request) <= toldRays()) return Hits::none;
  if (quality_.stage() != app::PictureQuality::Stage::moving)
    return quality_.complete() && raysOf(request) <= mostRaysTold ? Hits::all : Hits::many;
  const bool due = !sinceSeen_.isValid() || sinceSeen_.elapsed() >= seenMilliseconds;
  return due ? Hits::many : Hits::none;
}

// Pictures without baked light reflect nothing.
double Viewport::toldRays() const {
  return scene::showsGloss(resolved_) && !standsIn() ? std::min(seenRays_, seenReflections_) : seenRays_;
}

bool Viewport::toldEveryRay() const {
  render::FrameRequest full;
  full.size = pixelSize();
  full.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
  return toldRays() >= raysOf(full);
}

void Viewport::poll() {
  if (!hasContext_) {
    takeContext();
    return;
  }
  auto result = thread_->take();
  if (!thread_->busy()) setDrawing(false);
  if (!result) return;
  if (auto* const picture = std::get_if<app::DrawnPicture>(&*result))
    put(*picture);
  else if (const auto& failure = std::get<app::FailedPicture>(*result); failure.order == orderNumber_)
    failedPicture(failure.reason);
}

void Viewport::failedPicture(const std::exception_ptr& reason) {
  try {
    std::rethrow_exception(reason);
  } catch (const render::ContextLost& lost) {
    // The next picture has another context; the window's, with which textures were shared, is lost for good.
    if (canvas_->kind() == CanvasKind::textures)
      setCanvas({CanvasKind::pixels, translatedSentence(lost.reason())});
    Q_EMIT noted(tr("The graphics driver was reset; the image is drawn again"));
    redraw();
  } catch (...) {
    fail(reasonOf(reason), QObject::tr(comesBack));
  }
}

void Viewport::put(const app::DrawnPicture& picture) {
  const Answered now = answer(picture.order);
  const bool lights = now.view == shownAs_.view && shownAs_.standsIn && !now.standsIn;
  if (lights && picture.report.light.pending) return orderSoon();  // until all of its light is there
  const glm::ivec2 size = picture.color.size;
  const CanvasPicture before = picture_;
  picture_ = {};
  if (picture.texture)
    picture_.texture = picture.texture;
  else
    picture_.pixels = QImage(picture.color.rgba.data(), size.x, size.y, QImage::Format_RGBX8888)
                          .convertToFormat(QImage::Format_RGB32);
  laid_ = {};
  finished_ = picture.finished;
  legend_ = picture.report.legend;
  placeButtons();
  // A draft that comes after a change is shown all the same, so that the view moves.
  shownChanges_ = picture.order == orderNumber_ ? orderedChanges_ : 0;
  shownAtRest_ = picture.order == orderNumber_ && orderedAtRest_;
  shownRequest_ = picture.request;
  if (now.view != shownAs_.view) before_ = {};
  if (lights) {
    before_ = before;
    sinceFade_.start();
    fadeTimer_.start(fadeStepMilliseconds);
  }
  shownAs_ = now;
  showed(picture, now.view);
  paintCanvas();
}

// What was changed before this order is answered by its picture. Which view it shows.
Viewport::Answered Viewport::answer(std::uint64_t order) {
  Answered answer;
  const auto answered = [&](const Awaited& awaited) {
    if (awaited.order > order) return false;
    if (!unpainted_) unpainted_ = awaited.changed;
    answer = {awaited.view, awaited.standsIn};
    return true;
  };
  awaited_.erase(std::remove_if(awaited_.begin(), awaited_.end(), answered), awaited_.end());
  return answer;
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
  refineSoon();
  const bool empty = report.empty && !fieldsPending_;
  overlay_->setNote(fieldsPending_ && makesFields() ? fieldNote()
                    : empty                         ? translatedSentence(report.empty->reason)
                                                    : missingNote(report.bricks));
  offerRemedy(empty ? report.empty : std::nullopt);
  showCaveats();
  if (bricksPending_ || lightPending_) orderSoon();  // the next picture gets further
  tellSeen(picture, view);
  Q_EMIT reported(report, picture.request);
  Q_EMIT drawn(picture.milliseconds, complete());
}

// The stage after the sharp picture on screen.
void Viewport::refineSoon() {
  const bool waits = refineTimer_.isActive();  // an animation draws while a finer picture is on its way
  if (current() && quality_.stage() == app::PictureQuality::Stage::sharp && quality_.mayRefine() && !waits)
    refineTimer_.start(static_cast<int>(quality_.pauseMilliseconds()));
}

void Viewport::tellSeen(const app::DrawnPicture& picture, std::uint64_t view) {
  if (picture.hitVoxels.empty() || bricksPending_) return;
  const bool same = view == view_;
  sinceSeen_.start();
  Q_EMIT seen(picture.hitVoxels, same && seenRays_ > 0.0);
  if (!same) return;
  seenRays_ = raysOf(picture.request);
  const auto reflects = [](const render::PassReport& pass) {
    return pass.name == render::pass::reflections && pass.state != render::PassState::skipped;
  };
  const auto& passes = picture.report.passes;
  if (std::any_of(passes.begin(), passes.end(), reflects)) seenReflections_ = seenRays_;
}

void Viewport::viewChanged() {
  ++view_;
  seenRays_ = seenReflections_ = 0.0;
}

bool Viewport::restDiffers() const {
  return volume_ && app::atRestIfReady(resolved_, *volume_).hit.field != resolved_.hit.field;
}

bool Viewport::drawsRest() const {
  return quality_.complete() && quality_.stage() != app::PictureQuality::Stage::moving && restDiffers();
}

scene::Scene Viewport::drawable() {
  fieldsPending_ = volume_ && !app::fieldsAreReady(resolved_, *volume_);
  if (!volume_) return resolved_;
  const scene::Scene ready = app::withReadyFields(resolved_, *volume_, lastDerivatives_);
  if (!fieldsPending_) {
    lastDerivatives_ = ready.derivatives;
    return ready;
  }
  if (!interacting_) makeFields();
  return ready;
}

bool Viewport::makesFields() const {
  return fieldsOf_ && app::needSameFields(*fieldsOf_, resolved_);
}

// One after the other; of those that could not be made, no more.
void Viewport::makeFields() {
  if (fieldTask_ || makesFields()) return;
  fieldsOf_ = resolved_;
  fieldError_.reset();
  const auto ended = [this](app::FieldTask& task) {
    fieldError_ = task.error();
    lookAtFields();
  };
  fieldTask_.watch(app::fieldTask(volume_, resolved_), ended, [this] { lookAtFields(); });
}

void Viewport::lookAtFields() {
  if (app::fieldsAreReady(resolved_, *volume_)) {
    if (!fieldsPending_) return;
    redraw();
    Q_EMIT derivativesChosen();
    return;
  }
  overlay_->setNote(fieldNote());
  if (!fieldTask_ && !makesFields()) redraw();  // the next one's turn
}

QString Viewport::fieldNote() const {
  if (!fieldTask_) return fieldError_ ? QString::fromStdString(fieldError_->what()) : QString();
  const base::Progress& progress = fieldTask_->progress();
  return QObject::tr("Preparing the volume (%1): %2 %; a substitute field is shown")
      .arg(translated(texts::words, progress.stage()))
      .arg(std::lround(100.0 * progress.fraction()));
}

render::StillPicture Viewport::picture(const StillRequest& asked) {
  const auto refuse = [](const QString& why) {
    throw base::Error(base::ErrorKind::graphics, "", "", why.toStdString());
  };
  if (stillComes_) refuse(tr("another image is being saved"));
  const QString what = asked.what.isEmpty() ? tr("Drawing the image") : asked.what;
  await({what, [this] { return hasContext_ || failed_; }, [] { return 0.0; }});  // of a new window
  if (!hasContext_ || failed_) refuse(tr("there is no image to save"));
  awaitFields(what);
  const bool ofScreen = asked.size == glm::ivec2(0);
  render::FrameRequest request;
  request.size = ofScreen ? pixelSize() : asked.size;
  request.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
  request.linear = asked.linear;
  app::PictureOrder order = orderOf(request, true);
  if (!ofScreen) order.request.pixelRatio = asked.pixelRatio;
  if (asked.camera) order.scene.camera = *asked.camera;
  order.scene.picture.transparent = scene_.picture.transparent;
  const auto still = thread_->drawStill(std::move(order));
  setDrawing(true);
  const bool finished =
      await({what, [&] { return still->finished.load(); }, [&] { return still->progress.fraction(); },
             [&] { still->progress.requestStop(); }});
  setDrawing(false);
  changed();  // the order that was dropped for it
  if (!finished) throwCancelled();
  if (!still->failure) return std::move(still->picture);
  try {
    std::rethrow_exception(still->failure);
  } catch (const base::Error&) {
    throw;
  } catch (...) {
    throw base::Error(base::ErrorKind::graphics, "", "", reasonOf(still->failure).toStdString());
  }
}

// Whether it is done; false: the user has cancelled, or the program ends.
bool Viewport::await(Waiting waiting) {
  const std::function<bool()> done = waiting.done;
  if (done()) return true;
  bool stopped = false;
  if (!waiting.cancel) {
    waiting.cancel = [&] { stopped = true; };
    waiting.done = [&] { return done() || stopped; };
  }
  stillComes_ = true;
  waitFor(window(), waiting);
  stillComes_ = false;
  return done();
}

// Throws what ended the job.
void Viewport::awaitFields(const QString& what) {
  const auto ready = [this] { return !volume_ || app::fieldsAreReady(resolved_, *volume_); };
  await({what,
         [&] {
           if (!ready()) makeFields();
           return ready() || !fieldTask_;
         },
         [this] { return fieldTask_ ? fieldTask_->progress().fraction() : 0.0; }});
  if (ready()) return;
  if (!fieldTask_ && fieldError_) throw base::Error(*fieldError_);
  throwCancelled();
}

}  // namespace isolux::ui
