#include "volume/statistics/white_matter.h"

#include <algorithm>

#include "volume/pieces/body.h"
#include "volume/statistics/histogram.h"

namespace isolux::volume {

namespace {

constexpr double kDeepFrom = 0.2, kLeastWhite = 0.25, kMostWhite = 0.6, kLeastGrey = 0.72, kMostGrey = 0.92;
constexpr std::size_t kDeepBins = 512;

Histogram valuesDeepIn(const Grid& grid, const Body& body, const base::Progress& progress) {
  Histogram histogram{body.isovalue(), grid.maximum(), std::vector<std::uint64_t>(kDeepBins), {}};
  const double bins = static_cast<double>(kDeepBins) / (histogram.maximum - histogram.minimum);
  const glm::ivec3 dims = grid.dims();
  for (int z = 0; z < dims.z; z += 2) {
    progress.throwIfStopped();
    for (int y = 0; y < dims.y; y += 2)
      for (int x = 0; x < dims.x; x += 2) {
        if (static_cast<double>(body.depth({x, y, z})) < kDeepFrom) continue;
        const double at = (grid.value(x, y, z) - histogram.minimum) * bins;
        if (at >= 0.0) ++histogram.counts[std::min(static_cast<std::size_t>(at), kDeepBins - 1)];
      }
  }
  return histogram;
}

}  // namespace

std::optional<WhiteMatter> whiteMatterOf(const Grid& grid, double skin, base::Progress& progress) {
  if (!(skin < grid.maximum())) return std::nullopt;
  const Body body(grid, skin, progress);
  const ValueClasses classes = threeClasses(valuesDeepIn(grid, body, progress));
  const double part = classes.parts[2], grey = classes.means[1], white = classes.means[2];
  if (!(part >= kLeastWhite && part <= kMostWhite)) return std::nullopt;
  if (!(grey >= kLeastGrey * white && grey <= kMostGrey * white)) return std::nullopt;
  return WhiteMatter{classes.borders[1], white};
}

const std::optional<WhiteMatter>& KeptWhiteMatter::get() const {
  std::call_once(looked_, [this] {
    base::Progress unheard;
    if (grid_) found_ = whiteMatterOf(*grid_, skin_, unheard);
  });
  return found_;
}

}  // namespace isolux::volume
