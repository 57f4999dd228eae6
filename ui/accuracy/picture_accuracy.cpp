#include "ui/accuracy/picture_accuracy.h"

#include <utility>

namespace isolux::ui {

namespace {

bool samePicture(const PictureAccuracy::Subject& a, const PictureAccuracy::Subject& b) {
  return a.volume == b.volume && a.scene == b.scene && a.light == b.light && a.size == b.size &&
         a.onProcessor == b.onProcessor;
}

bool samePicture(const std::optional<PictureAccuracy::Subject>& a,
                 const std::optional<PictureAccuracy::Subject>& b) {
  return a.has_value() == b.has_value() && (!a || samePicture(*a, *b));
}

}  // namespace

void PictureAccuracy::show(std::optional<Subject> subject) {
  if (subject) {  // which no bound depends on
    subject->scene.marks.clear();
    subject->scene.picture.letters = subject->scene.picture.scaleBar = subject->scene.picture.isovalue =
        subject->scene.picture.caveats = false;
  }
  if (samePicture(subject, shown_)) return;
  drop();
  shown_ = std::move(subject);
  Q_EMIT changed();
}

bool PictureAccuracy::wanted() const {
  if (!shown_) return false;
  return !samePicture(shown_, measured_) || (keepsImages_ && accuracy_ && !images_);
}

void PictureAccuracy::measure() {
  if (task_ || !wanted()) return;
  Subject subject = *shown_;
  subject.keepImages = keepsImages_;
  task_.watch(app::accuracyTask(std::move(subject)), [this](auto& task) { take(task); });
  ++jobsBegun_;
}

void PictureAccuracy::forget() {
  show(std::nullopt);
  measured_.reset();
  accuracy_.reset();
  images_.reset();
}

const std::optional<app::Accuracy>& PictureAccuracy::known() const {
  static const std::optional<app::Accuracy> none;
  return shown_ && samePicture(shown_, measured_) ? accuracy_ : none;
}

void PictureAccuracy::keepImages(bool kept) {
  if (std::exchange(keepsImages_, kept) == kept) return;
  drop();
  if (!kept) images_.reset();
}

std::shared_ptr<const app::PictureErrors> PictureAccuracy::images() const {
  return known() ? images_ : nullptr;
}

void PictureAccuracy::take(app::AccuracyTask& task) {
  measured_ = shown_;
  accuracy_.reset();
  images_.reset();
  if (!task.error()) {
    accuracy_ = std::move(task.value().accuracy);
    images_ = std::move(task.value().images);
  }
  Q_EMIT changed();
  Q_EMIT ended();
}

}  // namespace isolux::ui
