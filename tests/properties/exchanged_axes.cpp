#include "tests/properties/exchanged_axes.h"

#include <utility>

#include "base/random.h"
#include "tests/support/volumes.h"

namespace isolux::test {

glm::dvec3 AxisExchange::point(const glm::dvec3& old, glm::ivec3 oldDims) const {
  glm::dvec3 made;
  for (int a = 0; a < 3; ++a) {
    const int axis = from[static_cast<std::size_t>(a)];
    made[a] = mirrored[static_cast<std::size_t>(a)] ? oldDims[axis] - 1 - old[axis] : old[axis];
  }
  return made;
}

glm::dvec3 AxisExchange::direction(const glm::dvec3& old) const {
  return point(old, glm::ivec3(1));
}

glm::dvec3 AxisExchange::pointBefore(const glm::dvec3& made, glm::ivec3 oldDims) const {
  glm::dvec3 old;
  for (int a = 0; a < 3; ++a) {
    const int axis = from[static_cast<std::size_t>(a)];
    old[axis] = mirrored[static_cast<std::size_t>(a)] ? oldDims[axis] - 1 - made[a] : made[a];
  }
  return old;
}

AxisExchange exchangeOf(std::uint64_t seed) {
  AxisExchange made;
  const std::uint64_t random = base::hash64(seed);
  std::swap(made.from[0], made.from[random % 3]);
  std::swap(made.from[1], made.from[1 + random / 3 % 2]);
  for (std::size_t a = 0; a < 3; ++a) made.mirrored[a] = (random >> (20 + a) & 1) != 0;
  return made;
}

volume::Grid exchanged(const volume::Grid& grid, const AxisExchange& exchange) {
  const glm::ivec3 dims = grid.dims();
  glm::ivec3 made;
  for (int a = 0; a < 3; ++a) made[a] = dims[exchange.from[static_cast<std::size_t>(a)]];
  const volume::GridGeometry geometry = unitGeometry(made);
  volume::VoxelArray voxels = grid.voxels();
  std::visit(
      [&](auto& values) {
        const auto old = values;
        for (int z = 0; z < dims.z; ++z)
          for (int y = 0; y < dims.y; ++y)
            for (int x = 0; x < dims.x; ++x) {
              const glm::ivec3 at(exchange.point(glm::dvec3(x, y, z), dims));
              values[(static_cast<std::size_t>(at.z) * static_cast<std::size_t>(made.y) +
                      static_cast<std::size_t>(at.y)) *
                         static_cast<std::size_t>(made.x) +
                     static_cast<std::size_t>(at.x)] = old[grid.index(x, y, z)];
            }
      },
      voxels);
  return {geometry, std::move(voxels), grid.slope(), grid.intercept()};
}

}  // namespace isolux::test
