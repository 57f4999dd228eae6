#include "scene/albedo.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "scene/color_maps.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

AlbedoOfIsovalue::AlbedoOfIsovalue(const Scene& scene) {
  if (scene.isosurface.albedoSource == AlbedoSource::map) {
    constexpr int mapSamples = 256;
    samples_ = colorMapSamples(scene.isosurface.albedoMap, mapSamples);
    low_ = scene.isosurface.albedoLow.value();
    high_ = scene.isosurface.albedoHigh.value();
    return;
  }
  std::vector<std::pair<double, glm::vec3>> shown;
  for (const Surface& surface : shownSurfaces(scene))
    shown.emplace_back(surface.value.value(), glm::vec3(surface.albedo));
  std::ranges::stable_sort(shown, [](auto& a, auto& b) { return a.first < b.first; });
  const bool same =
      std::ranges::all_of(shown, [&](const auto& one) { return one.second == shown.front().second; });
  if (same) shown.resize(1);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    samples_.push_back(shown[i].second);
    if (i > 0) borders_.push_back(0.5 * shown[i - 1].first + 0.5 * shown[i].first);
  }
}

glm::vec3 AlbedoOfIsovalue::at(double isovalue) const {
  if (isConstant()) return samples_.front();
  if (!borders_.empty()) {
    const auto above = std::ranges::upper_bound(borders_, isovalue);
    return samples_[static_cast<std::size_t>(above - borders_.begin())];
  }
  // An empty range is a step.
  const double position = high_ > low_ ? (isovalue - low_) / (high_ - low_) : isovalue < low_ ? 0.0 : 1.0;
  const double last = static_cast<double>(samples_.size() - 1);
  const double x = std::clamp(std::isnan(position) ? 0.0 : position, 0.0, 1.0) * last;
  const auto i = std::min(static_cast<std::size_t>(x), samples_.size() - 2);
  return glm::mix(samples_[i], samples_[i + 1], static_cast<float>(x - static_cast<double>(i)));
}

}  // namespace isolux::scene
