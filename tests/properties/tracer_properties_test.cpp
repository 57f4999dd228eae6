// Entries that the light's tracer finds (volume/tracer), on every instruction set of this machine.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/properties/agreeing_hits.h"
#include "tests/properties/property_run.h"
#include "tests/properties/searched_ray.h"
#include "tests/support/rays.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::test {
namespace {

// Twice what volume/tracer/isosurface_tracer.h states of places along a ray, voxels.
constexpr double kApart = 2e-4;

std::string entriesAreClear(const PropertyCase& made) {
  const auto grid = std::make_shared<const volume::Grid>(made.grid());
  const auto inside = made.seed % 2 == 0 ? scene::Inside::above : scene::Inside::below;
  const auto isovalue = grid->storedIsovalue(made.isovalueIn(*grid));
  const bool rises = (inside == scene::Inside::above) == (grid->slope() > 0.0);
  const DoubleField field(*grid, scene::Field::trilinear);
  const double stored = static_cast<double>(isovalue);
  // The tracer subtracts no offset: samples and isovalue have the roundings of floats of their size.
  const double largest = std::max({std::abs(field.least()), std::abs(field.most()), std::abs(stored)});
  const double ofValue = 24.0 * (0x1p-24 * largest + 0x1p-149);
  const double margin = ofValue + 3.0 * kApart * field.range();
  std::vector<volume::TraceRay> rays;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const volume::Ray ray = randomRay(64 * made.seed + i, grid->dims());
    rays.push_back({glm::vec3(ray.origin), glm::vec3(ray.direction), isovalue});
  }
  std::vector<float> t(rays.size());
  std::vector<std::uint8_t> any(rays.size());
  base::Progress progress;
  for (const volume::TracerTarget target : volume::IsosurfaceTracer::availableTargets()) {
    const volume::IsosurfaceTracer tracer(grid, inside, progress, target);
    tracer.firstEntries(rays, t);
    tracer.anyEntries(rays, any);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const volume::Ray ray{glm::dvec3(rays[i].origin), glm::dvec3(rays[i].direction)};
      const double size = glm::length(ray.direction), at = static_cast<double>(t[i]);
      const auto says = [&](const char* what) {
        return std::string(tracer.target()) + ": " + what + " at " + exactText(at) + ", " + textOf(ray);
      };
      // Of rays that start on the surface, rounding.
      if (!(at * size >= -1e-6)) return says("no number");
      const auto clear = firstClearCrossing(field, stored, margin, kApart, ray, rises);
      if (clear && !(at <= clear->t + 4.0 * kApart / size)) return says("a clear entry is missed");
      // Of touches each may say something else.
      if (clear && any[i] == 0) return says("that there is a clear entry is missed");
      if (std::isinf(at)) continue;
      const glm::dvec3 voxel = ray.origin + at * ray.direction;
      const double off = std::abs(field(voxel) - stored);  // NaN on the border of a gap
      if (off > ofValue + 3.0 * kApart * field.rangeAt(voxel)) return says("an entry is off the surface");
    }
  }
  return {};
}

TEST(TracerProperties, EntriesLieOnTheSurfaceAndNoneIsMissed) {
  expectHolds("Entries", 0.06, entriesAreClear);
}

}  // namespace
}  // namespace isolux::test
