#include "app/view_math/piece_choice.h"

#include <algorithm>

#include "volume/hit/surface_voxel.h"
#include "volume/pieces/piece_seeds.h"
#include "volume/pieces/pieces.h"

namespace isolux::app {

std::optional<glm::dvec3> seedOfPick(const volume::PreparedVolume& volume, const Pick& pick,
                                     scene::Inside inside) {
  const volume::Grid& grid = volume.grid();
  const auto level = volume::InsideLevel::of(grid, pick.isovalue, inside);
  const auto voxel = volume::surfaceVoxel(grid, level, pick.voxel);
  if (!voxel) return std::nullopt;
  return grid.geometry().worldOf(volume::seedAbove(grid, level, *voxel));
}

scene::Pieces withHidden(scene::Pieces choice, const std::vector<glm::dvec3>& seedsMm) {
  choice.hidden.insert(choice.hidden.end(), seedsMm.begin(), seedsMm.end());
  return choice;
}

scene::Pieces withShown(scene::Pieces choice, const volume::Pieces& pieces, std::uint32_t id,
                        const glm::dvec3& seedMm) {
  const glm::dmat4 voxelFromWorld = pieces.grid().geometry().voxelFromWorld();
  const auto namesIt = [&](const glm::dvec3& pointMm) {
    return pieces.ofPoint(glm::dvec3(voxelFromWorld * glm::dvec4(pointMm, 1.0))) == id;
  };
  std::erase_if(choice.hidden, namesIt);
  if (!choice.only.empty() && std::ranges::none_of(choice.only, namesIt)) choice.only.push_back(seedMm);
  return choice;
}

scene::Pieces onlyThese(const std::vector<glm::dvec3>& seedsMm) {
  scene::Pieces choice;
  choice.only = seedsMm;
  return choice;
}

scene::Pieces onlyLargest(int count) {
  scene::Pieces choice;
  choice.keep = count;
  return choice;
}

}  // namespace isolux::app
