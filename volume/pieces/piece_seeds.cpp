#include "volume/pieces/piece_seeds.h"

#include <mutex>
#include <unordered_map>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

struct Deepest {
  double depth = -1.0;
  glm::ivec3 voxel{0};
  std::size_t index = 0;
  bool before(const Deepest& other) const {
    return depth != other.depth ? depth > other.depth : index < other.index;
  }
};

// Of the pieces in one layer of voxels.
std::unordered_map<std::uint32_t, Deepest> deepestOfLayer(const Pieces& pieces, int z) {
  const Grid& grid = pieces.grid();
  std::unordered_map<std::uint32_t, Deepest> found;
  std::uint32_t last = Pieces::kNone;
  Deepest* best = nullptr;
  for (int y = 0; y < grid.dims().y; ++y)
    for (int x = 0; x < grid.dims().x; ++x) {
      const std::uint32_t piece = pieces.ofVoxel({x, y, z});
      if (piece == Pieces::kNone) continue;
      if (piece != last) best = &found[piece];
      last = piece;
      const Deepest here{pieces.level().depth(grid.stored(x, y, z)), {x, y, z}, grid.index(x, y, z)};
      if (here.before(*best)) *best = here;
    }
  return found;
}

}  // namespace

std::vector<glm::ivec3> pieceSeeds(const Pieces& pieces, base::Progress& progress) {
  std::vector<Deepest> all(pieces.list().size());
  std::mutex mutex;
  parallelSteps(static_cast<std::size_t>(pieces.grid().dims().z), progress, {}, [&](std::size_t z) {
    const auto found = deepestOfLayer(pieces, static_cast<int>(z));
    const std::lock_guard lock(mutex);
    for (const auto& [piece, deepest] : found)
      if (deepest.before(all[piece])) all[piece] = deepest;
  });
  std::vector<glm::ivec3> seeds;
  seeds.reserve(all.size());
  for (const Deepest& deepest : all) seeds.push_back(deepest.voxel);
  return seeds;
}

glm::ivec3 seedAbove(const Grid& grid, InsideLevel level, glm::ivec3 voxel) {
  const auto depth = [&](glm::ivec3 at) { return level.depth(grid.stored(at.x, at.y, at.z)); };
  double here = depth(voxel);
  for (;;) {
    glm::ivec3 best = voxel;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        glm::ivec3 next = voxel;
        next[axis] += step;
        if (next[axis] < 0 || next[axis] >= grid.dims()[axis]) continue;
        const double there = depth(next);
        if (!(there > here)) continue;  // false where it is missing
        best = next;
        here = there;
      }
    if (best == voxel) return voxel;
    voxel = best;
  }
}

glm::dvec3 worldOf(const GridGeometry& geometry, glm::ivec3 voxel) {
  return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(voxel), 1.0));
}

}  // namespace isolux::volume
