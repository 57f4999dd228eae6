#include "ui/levels/full_resolution_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QSettings>

#include "base/destroy_in_background.h"
#include "ui/document/picture_pixels.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/widgets/waiting.h"

namespace isolux::ui {

namespace {

constexpr const char* wantedKey = "levelZeroAtRest";

QString whatOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return QString::fromStdString(error.what());
  } catch (...) {
    return QObject::tr("internal error");
  }
}

bool sameVolume(scene::Source a, const scene::Source& b) {
  a.level = b.level;
  return a == b;
}

}  // namespace

FullResolutionView::FullResolutionView(QObject* parent)
    : QObject(parent), wanted_(QSettings().value(wantedKey, true).toBool()) {}

void FullResolutionView::setSource(const std::optional<scene::Source>& source) {
  const bool same = source && source_ && sameVolume(*source, *source_);
  source_ = source;
  if (same) return;
  show({});
  opening_.reset();
  base::destroyInBackground(std::exchange(whole_, nullptr));  // gigabytes
  refused_.reset();
  thread_.reset();
  say({}, {});
}

void FullResolutionView::show(const std::optional<Shown>& shown) {
  if (shown == shown_) return;
  stopDrawing();
  image_ = {};
  shown_ = shown;
  if (!shown_ || !wanted_ || !source_) return;
  if (whole_)
    draw();
  else
    open();
}

void FullResolutionView::setWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  QSettings().setValue(wantedKey, wanted);
  const std::optional<Shown> shown = std::exchange(shown_, std::nullopt);
  stopDrawing();
  image_ = {};
  if (!wanted) {
    opening_.reset();  // what is done of an index is kept
    say({}, {});
    if (shown) Q_EMIT painted({}, shown->picture);
  }
  refused_.reset();
  show(shown);
}

void FullResolutionView::open() {
  if (refused_) return say({}, *refused_);
  if (opening_) return;
  opening_.watch(
      app::wholeFileTask(*source_, host_), [this](auto& task) { takeVolume(task); },
      [this] { sayOpening(); });
}

app::PictureOrder FullResolutionView::order(const render::FrameRequest& request) const {
  app::PictureOrder order;
  order.volume = whole_;
  order.scene = app::sceneOfWholeFile(shown_->scene, shown_->resolved, *whole_);
  order.host = wholeMachine_;
  order.request = request;
  return order;
}

void FullResolutionView::draw() {
  render::FrameRequest request;
  request.size = {shown_->picture.width(), shown_->picture.height()};
  request.supersampling = std::clamp(shown_->resolved.picture.supersampling, 1, 4);
  request.pixelRatio = shown_->pixelRatio;
  try {
    app::PictureOrder wanted = order(request);
    wanted.scene.picture.transparent = false;
    if (!thread_)
      thread_ = std::make_unique<app::PictureThread>(
          app::PictureThread::Options{.priority = app::PictureThread::Priority::background,
                                      .news = posted(this, [this] { takeStill(); })});
    drawing_ = thread_->drawStill(std::move(wanted));
  } catch (const base::Error& error) {
    return say({}, tr("Full resolution is not drawn: %1").arg(QString::fromStdString(error.reason())));
  }
  say(tr("drawing full resolution"), {});
  takeStill();  // there may be no context to draw with
}

void FullResolutionView::stopDrawing() {
  if (drawing_) std::exchange(drawing_, nullptr)->progress.requestStop();
}

void FullResolutionView::sayOpening() {
  const base::Progress& progress = opening_->progress();
  say(tr("%1: %2 %")
          .arg(translated(texts::words, progress.stage()))
          .arg(std::lround(100.0 * progress.fraction())),
      tr("Full resolution is drawn from the file once its index exists."));
}

void FullResolutionView::takeStill() {
  if (!drawing_) return;
  const app::PictureThread::Context* const context = thread_->context();
  const bool finished = drawing_->finished;
  if (!finished && !(context && context->failure)) return;
  const auto still = std::exchange(drawing_, nullptr);
  const std::exception_ptr failure = finished ? still->failure : context->failure;
  if (failure) return say({}, tr("Full resolution is not drawn: %1").arg(whatOf(failure)));
  takePicture(still->picture);
}

void FullResolutionView::takeVolume(app::WholeFileTask& task) {
  if (task.error()) {
    refused_ = tr("Full resolution is not drawn: %1").arg(QString::fromStdString(task.error()->what()));
    return say({}, *refused_);
  }
  whole_ = task.value().volume;
  wholeMachine_ = task.value().host;
  say({}, {});
  Q_EMIT opened();
  if (shown_) draw();
}

void FullResolutionView::takePicture(const render::StillPicture& picture) {
  image_ = imageOf(picture.color);
  const render::BrickReport& bricks = picture.report.bricks;
  const auto percent = [](double share) { return numberText(100.0 * share, 2); };
  QString meaning = tr("When the view is idle, the image shows the file at full resolution (level 0).");
  if (bricks.lost > 0.0)
    meaning = tr("%1 % of the image is hatched, because the volume is unreadable there: %2")
                  .arg(percent(bricks.lost), QString::fromStdString(bricks.lostReason));
  else if (bricks.missing > 0.0)
    meaning = tr("%1 % of the image is missing; raise Graphics memory (memory.gpu_budget_mb)")
                  .arg(percent(bricks.missing));
  Q_EMIT painted(image_, shown_->picture);
  say({}, meaning);
  Q_EMIT changed();
}

render::StillPicture FullResolutionView::picture(const render::FrameRequest& request, bool transparent,
                                                 QWidget* window, const QString& what) {
  app::PictureOrder wanted = order(request);
  wanted.scene.picture.transparent = transparent;
  const auto still = thread_->drawStill(std::move(wanted));
  waitFor(window, {what, [&] { return still->finished.load(); }, [&] { return still->progress.fraction(); },
                   [&] { still->progress.requestStop(); }});
  if (!still->finished)
    throw base::Error(base::ErrorKind::interrupted, "", "",
                      tr("waiting for the image was cancelled").toStdString());
  if (still->failure) std::rethrow_exception(still->failure);
  return std::move(still->picture);
}

void FullResolutionView::say(const QString& text, const QString& meaning) {
  if (text == text_ && meaning == meaning_) return;
  text_ = text;
  meaning_ = meaning;
  Q_EMIT changed();
}

}  // namespace isolux::ui
