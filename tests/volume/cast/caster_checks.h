// What tests of the caster share: a volume ready to cast, views of it, and hits judged by the
// double-precision references.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "scene/scene.h"
#include "volume/cast/surface_caster.h"
#include "volume/clip/clip_region.h"
#include "volume/derived/cubic_fields.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_cubic_hit.h"

namespace isolux::test::casting {

inline constexpr glm::ivec2 kSize{90, 71};  // no multiple of a packet

std::vector<volume::TracerTarget> targets();  // of this machine

// What a caster needs of a grid and one of its fields.
class Prepared {
 public:
  // hidden: of each value, null where all is shown; or empty.
  Prepared(volume::Grid made, std::vector<double> values, scene::Field of = scene::Field::trilinear,
           std::vector<const volume::VoxelMask*> hidden = {}, scene::Inside inside = scene::Inside::above);

  // From now on surfaces k of which `clipped` has the bit k are seen in the region only (voxel coordinates).
  void cut(const volume::ClipRegion& region, int clipped) { region_ = region, clipped_ = clipped; }

  const volume::Grid& grid() const { return *grid_; }
  const volume::MinMaxBlocks& blocks() const { return cubic_ ? cubic_->blocks : *blocks_; }
  volume::SurfaceCaster caster(volume::TracerTarget target, std::span<const float> rayEnds = {}) const;
  // By the reference of the field: of a surface that is cut the first of all crossings that the region
  // contains.
  volume::CubicHit firstHit(double isovalue, const volume::Ray& ray) const;

  const std::vector<double> isovalues;

 private:
  volume::HiddenPieces hiddenOf(double isovalue) const;
  volume::CubicHit wholeHit(double isovalue, const volume::Ray& ray) const;

  base::Progress progress_;
  std::shared_ptr<const volume::Grid> grid_;
  scene::Field field_;
  std::shared_ptr<const volume::CubicField> cubic_;  // or, trilinear:
  std::unique_ptr<volume::MinMaxBlocks> blocks_;
  std::vector<std::uint64_t> masks_;
  std::vector<const volume::VoxelMask*> hidden_;
  scene::Inside inside_;
  volume::ClipRegion region_;
  int clipped_ = 0;
};

// View `k` of the middle of a volume of voxels of 1 mm: outside, close by and inside, and both projections.
volume::PictureRays view(int k, glm::ivec3 dims);
volume::Ray rayOf(const volume::PictureRays& rays, glm::dvec2 fragment);
volume::CrossingImage cast(const volume::SurfaceCaster& caster, const volume::PictureRays& rays);

// Every target finds the reference's first hits in so many views. A hit or miss that differs is accepted only
// where the reference cannot tell, or itself changes its answer within the rounding of float: for a ray a
// hundredth of a pixel beside it.
void expectFirstHits(const Prepared& volume, const char* name, int views);

// The same values in another type, from `from` to `to`.
template <class T>
volume::Grid quantized(const volume::Grid& grid, double from, double to, double slope) {
  std::vector<T> voxels;
  const glm::ivec3 dims = grid.dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(
            static_cast<T>(std::lround(from + (to - from) * (grid.value(x, y, z) - grid.minimum()) /
                                                  (grid.maximum() - grid.minimum()))));
  return volume::Grid(grid.geometry(), volume::VoxelArray(std::move(voxels)), slope, 3.0);
}
// Each value by a function of its voxel and itself.
volume::Grid changed(const volume::Grid& grid, const std::function<float(glm::ivec3, double)>& change);
volume::Grid withHoles(const volume::Grid& grid);  // a seventh of 3^3 voxels each is missing

}  // namespace isolux::test::casting
