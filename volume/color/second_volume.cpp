#include "volume/color/second_volume.h"

#include <utility>

#include "base/make_room.h"
#include "volume/read/reader.h"

namespace isolux::volume {

SecondVolumes::Key SecondVolumes::keyOf(const scene::ColorVolume& color) {
  return {color.volume, color.raw, color.component, color.timeStep};
}

std::shared_ptr<const SecondVolume> SecondVolumes::find(const scene::ColorVolume& color) const {
  if (color.volume.empty()) return nullptr;
  const std::lock_guard lock(mutex_);
  if (!kept_ || !(key_ == keyOf(color))) return nullptr;
  const bool complete = color.field != scene::Field::cubic_interpolating || kept_->coefficients;
  return complete ? kept_ : nullptr;
}

std::shared_ptr<const SecondVolume> SecondVolumes::make(const scene::ColorVolume& color,
                                                        base::Progress& progress) {
  if (color.volume.empty()) return nullptr;
  if (std::shared_ptr<const SecondVolume> found = find(color)) return found;
  auto made = base::madeWithRoom([&] { return fresh(color, progress); },
                                 [this] {
                                   const std::lock_guard lock(mutex_);
                                   return std::exchange(kept_, nullptr) != nullptr;
                                 });
  const std::lock_guard lock(mutex_);
  key_ = keyOf(color);
  kept_ = made;
  return made;
}

std::shared_ptr<const SecondVolume> SecondVolumes::fresh(const scene::ColorVolume& color,
                                                         base::Progress& progress) const {
  auto made = std::make_shared<SecondVolume>();
  scene::ColorVolume plain = color;
  plain.field = scene::Field::trilinear;
  if (const std::shared_ptr<const SecondVolume> read = find(plain)) {
    *made = *read;
  } else {
    ReadOptions options;
    options.raw = color.raw;
    options.component = color.component;
    options.timeStep = color.timeStep;
    options.grid = first_->geometry();
    made->volume = readVolume(color.volume, options, progress);
  }
  if (color.field == scene::Field::cubic_interpolating)
    made->coefficients =
        std::make_shared<const Coefficients>(interpolatingCoefficients(made->grid(), progress));
  return made;
}

}  // namespace isolux::volume
