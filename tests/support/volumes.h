// Volumes for tests: phantoms and fields of formulas, as grids and prepared.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "volume/prepared/prepared_volume.h"

namespace isolux::test {

// Voxels of 1 mm, the first at the world's origin.
volume::GridGeometry unitGeometry(glm::ivec3 dims);

// `size` voxels per axis; 0: the phantom's own number. `noise`: standard deviation, data units.
volume::Grid phantomGrid(const std::string& name, int size, double noise = 0.0);
volume::Grid phantomGrid(const std::string& name, const volume::GridGeometry& geometry);
volume::Grid phantomGrid(const std::string& name, glm::ivec3 dims);  // unitGeometry()

// float32, of f(glm::dvec3), at positions in voxels and in the world.
template <class F>
volume::Grid gridOfVoxels(const volume::GridGeometry& geometry, const F& f) {
  std::vector<float> voxels;
  voxels.reserve(geometry.voxelCount());
  for (int z = 0; z < geometry.dims.z; ++z)
    for (int y = 0; y < geometry.dims.y; ++y)
      for (int x = 0; x < geometry.dims.x; ++x) voxels.push_back(static_cast<float>(f(glm::dvec3(x, y, z))));
  return volume::Grid(geometry, std::move(voxels));
}
template <class F>
volume::Grid gridOfWorld(const volume::GridGeometry& geometry, const F& f) {
  return gridOfVoxels(geometry, [&](glm::dvec3 voxel) {
    return f(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0)));
  });
}

// Noise of deviation 1, as if white noise on a ring had been blurred by a Gaussian of this deviation along
// each axis, voxels.
std::vector<float> blurredNoise(glm::ivec3 dims, glm::dvec3 blur, std::uint64_t seed);
// The grid's values with noise, float32; or int16, which stay `air` where the grid has that value or less.
volume::Grid withNoise(const volume::Grid& grid, double deviation, glm::dvec3 blur, std::uint64_t seed);
volume::Grid roundedWithNoise(const volume::Grid& grid, double deviation, glm::dvec3 blur, std::uint64_t seed,
                              double air);

std::shared_ptr<const volume::PreparedVolume> prepared(volume::Grid grid);
std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name, int size);
std::shared_ptr<const volume::PreparedVolume> phantom(const std::string& name,
                                                      const volume::GridGeometry& geometry);

}  // namespace isolux::test
