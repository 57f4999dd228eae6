#include "volume/color/second_volume.h"

#include "volume/read/reader.h"

namespace isolux::volume {

SecondVolumes::Key SecondVolumes::keyOf(const scene::ColorVolume& color, bool withCoefficients) {
  return {color.volume, color.raw, color.component, color.timeStep, withCoefficients};
}

std::shared_ptr<const SecondVolume> SecondVolumes::find(const scene::ColorVolume& color) const {
  if (color.volume.empty()) return nullptr;
  auto found = kept_.find(keyOf(color, true));
  if (!found && color.field != scene::Field::cubic_interpolating) found = kept_.find(keyOf(color, false));
  return found.value_or(nullptr);
}

std::shared_ptr<const SecondVolume> SecondVolumes::make(const scene::ColorVolume& color,
                                                        base::Progress& progress) {
  if (color.volume.empty()) return nullptr;
  if (auto found = find(color)) return found;
  const bool cubic = color.field == scene::Field::cubic_interpolating;
  const auto plain = kept_.find(keyOf(color, false));
  return kept_.get(keyOf(color, cubic), [&] {
    auto made = std::make_shared<SecondVolume>();
    made->volume = plain ? (*plain)->volume : read(color, progress);
    if (cubic)
      made->coefficients =
          std::make_shared<const Coefficients>(interpolatingCoefficients(made->grid(), progress));
    return made;
  });
}

Volume SecondVolumes::read(const scene::ColorVolume& color, base::Progress& progress) const {
  ReadOptions options;
  options.raw = color.raw;
  options.component = color.component;
  options.timeStep = color.timeStep;
  options.grid = first_->geometry();
  return readVolume(color.volume, options, progress);
}

}  // namespace isolux::volume
