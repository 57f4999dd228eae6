#include "ui/presets/thumbnail_painter.h"

#include <algorithm>
#include <utility>

#include "ui/document/background_task.h"

namespace isolux::ui {

namespace {
constexpr int restMilliseconds = 400;
constexpr std::size_t mostKept = 4;  // of one place
constexpr int raysPerAxis = 2;       // of a pixel
}  // namespace

ThumbnailPainter::ThumbnailPainter(QObject* parent) : QObject(parent) {
  callOnce(restTimer_, restMilliseconds, this, &ThumbnailPainter::next);
}

void ThumbnailPainter::setVolume(const VolumePointer& volume) {
  if (volume == volume_) return;
  drop();
  if (thread_) thread_->forget();
  volume_ = volume;
  places_.clear();
}

void ThumbnailPainter::want(std::vector<std::optional<scene::Scene>> scenes, QSize pixels) {
  if (pixels != pixels_) places_.clear();
  pixels_ = pixels;
  places_.resize(scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (places_[i].wanted == scenes[i]) continue;
    places_[i].wanted = std::move(scenes[i]);
    places_[i].failed = false;
    if (drawing_ == i) drop();
  }
  if (!busy_ && !drawing_ && !complete()) restTimer_.start();
}

void ThumbnailPainter::setBusy(bool busy) {
  busy_ = busy;
  if (busy) {
    restTimer_.stop();
    drop();
  } else if (!complete()) {
    restTimer_.start();
  }
}

void ThumbnailPainter::drop() {
  if (!drawing_) return;
  drawing_.reset();
  thread_->drop();
}

bool ThumbnailPainter::isThere(const Place& place) const {
  if (!place.wanted || place.failed) return true;
  return std::any_of(place.kept.begin(), place.kept.end(),
                     [&](const Kept& kept) { return kept.scene == *place.wanted; });
}

const QImage* ThumbnailPainter::picture(std::size_t place) const {
  if (place >= places_.size() || !places_[place].wanted) return nullptr;
  for (const Kept& kept : places_[place].kept)
    if (kept.scene == *places_[place].wanted) return &kept.image;
  return nullptr;
}

bool ThumbnailPainter::complete() const {
  return std::all_of(places_.begin(), places_.end(), [this](const Place& place) { return isThere(place); });
}

// Those that are wanted and have no picture, the first first.
void ThumbnailPainter::next() {
  if (busy_ || drawing_ || !volume_) return;
  const auto wanted =
      std::find_if(places_.begin(), places_.end(), [this](const Place& place) { return !isThere(place); });
  if (wanted == places_.end()) return;
  if (!thread_)
    thread_ = std::make_unique<app::PictureThread>(app::PictureThread::Options{
        .priority = app::PictureThread::Priority::background, .news = posted(this, [this] { take(); })});
  app::PictureOrder order{volume_, *wanted->wanted, {}, nullptr, {}};
  order.host.executor = scene::Executor::cpu;  // the volume is on the graphics card once, for the user
  order.request.size = {pixels_.width(), pixels_.height()};
  order.request.supersampling = raysPerAxis;
  order.request.hits = render::FrameRequest::Hits::none;
  thread_->draw(std::move(order));
  drawing_ = static_cast<std::size_t>(wanted - places_.begin());
  take();  // there may be no context to draw with
}

void ThumbnailPainter::take() {
  if (!drawing_) return;
  const app::PictureThread::Context* const context = thread_->context();
  const bool refused = context && context->failure;
  auto result = refused ? std::nullopt : thread_->take();
  if (!result && !refused) return;
  const std::size_t place = std::exchange(drawing_, std::nullopt).value();
  if (result && std::holds_alternative<app::DrawnPicture>(*result))
    put(place, std::get<app::DrawnPicture>(*result));
  else
    places_[place].failed = true;
  if (!refused) next();
}

void ThumbnailPainter::put(std::size_t place, const app::DrawnPicture& picture) {
  const glm::ivec2 size = picture.color.size;
  Place& of = places_[place];
  of.kept.push_front({*of.wanted, QImage(picture.color.rgba.data(), size.x, size.y, QImage::Format_RGBX8888)
                                      .convertToFormat(QImage::Format_RGB32)});
  if (of.kept.size() > mostKept) of.kept.pop_back();
  ++drawn_;
  Q_EMIT drawn(static_cast<int>(place));
}

}  // namespace isolux::ui
