#include "volume/prepared/surface_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/clip/surface_cut.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/prepared/surface_crossings.h"

namespace isolux::volume {

namespace {

// Folds all crossings into one value: fold(part, point) within a block, join(all, part) between them.
template <class Value, class Fold, class Join>
bool foldCrossings(const PreparedVolume& volume, const scene::Scene& resolved, Value& all, const Fold& fold,
                   const Join& join, base::Progress& progress) {
  const Grid& grid = volume.grid();
  const MinMaxBlocks& blocks = *volume.blocks;
  const SurfaceCut cut(resolved, grid.geometry());
  const Value nothing = all;
  std::mutex mutex;
  bool any = false;
  for (const Surface& surface : shownSurfaces(volume, resolved, progress)) {
    std::vector<std::uint8_t> active;
    blocks.activeBlocks(grid.storedIsovalue(surface.isovalue), active);
    parallelSteps(blocks.count(), progress, {}, [&](std::size_t index) {
      if (!active[index]) return;
      Value part = nothing;
      bool found = false;
      eachCrossing(volume, surface, resolved.isosurface.inside, index, [&](glm::ivec3, glm::dvec3 point) {
        if (!cut.keeps(surface.isovalue, point)) return;
        fold(part, point);
        found = true;
      });
      if (!found) return;
      const std::lock_guard lock(mutex);
      join(all, part);
      any = true;
    });
  }
  return any;
}

}  // namespace

std::optional<std::vector<double>> surfaceReach(const PreparedVolume& volume, const scene::Scene& resolved,
                                                std::span<const glm::dvec3> directions,
                                                base::Progress& progress) {
  // In voxel coordinates: d . (A p + o) = (A^T d) . p + d . o
  const glm::dmat4& world = volume.grid().geometry().worldFromVoxel;
  const glm::dmat3 linear(world);
  const glm::dvec3 origin(world[3]);
  std::vector<glm::dvec3> ofVoxels;
  ofVoxels.reserve(directions.size());
  for (const glm::dvec3& direction : directions) ofVoxels.push_back(glm::transpose(linear) * direction);
  std::vector<double> farthest(directions.size(), -std::numeric_limits<double>::infinity());
  const bool any = foldCrossings(
      volume, resolved, farthest,
      [&](std::vector<double>& part, glm::dvec3 point) {
        for (std::size_t i = 0; i < part.size(); ++i)
          part[i] = std::max(part[i], glm::dot(ofVoxels[i], point));
      },
      [](std::vector<double>& all, const std::vector<double>& part) {
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::max(all[i], part[i]);
      },
      progress);
  if (!any) return std::nullopt;
  for (std::size_t i = 0; i < farthest.size(); ++i) farthest[i] += glm::dot(directions[i], origin);
  return farthest;
}

std::optional<Ball> surfaceBall(const PreparedVolume& volume, const scene::Scene& resolved,
                                base::Progress& progress) {
  constexpr std::array<glm::dvec3, 6> axes{glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0},          {0, 0, 1},  {0, 0, -1}};
  const auto reach = surfaceReach(volume, resolved, axes, progress);
  if (!reach) return std::nullopt;
  Ball ball;
  for (int axis = 0; axis < 3; ++axis) {
    const auto first = static_cast<std::size_t>(2 * axis);
    ball.centreMm[axis] = ((*reach)[first] - (*reach)[first + 1]) / 2.0;
  }
  const glm::dmat4& world = volume.grid().geometry().worldFromVoxel;
  double square = 0.0;
  foldCrossings(
      volume, resolved, square,
      [&](double& part, glm::dvec3 point) {
        const glm::dvec3 d = glm::dvec3(world * glm::dvec4(point, 1.0)) - ball.centreMm;
        part = std::max(part, glm::dot(d, d));
      },
      [](double& all, double part) { all = std::max(all, part); }, progress);
  ball.radiusMm = std::sqrt(square);
  return ball;
}

}  // namespace isolux::volume
