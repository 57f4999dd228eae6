#include "render/block_faces.h"

namespace isolux::render {

std::vector<PackedFace> boundaryFaces(const std::vector<std::uint8_t>& active, glm::ivec3 dims) {
  std::vector<PackedFace> faces;
  const std::ptrdiff_t strides[3] = {1, dims.x, static_cast<std::ptrdiff_t>(dims.x) * dims.y};
  std::size_t i = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i) {
        if (!active[i]) continue;
        const glm::ivec3 block(x, y, z);
        const auto packed = static_cast<PackedFace>(x | y << 9 | z << 18);
        for (int axis = 0; axis < 3; ++axis) {
          const auto neighbour = [&](std::ptrdiff_t step) {
            return active[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step)] != 0;
          };
          if (block[axis] == 0 || !neighbour(-strides[axis]))
            faces.push_back(packed | static_cast<PackedFace>(axis) << 27);
          if (block[axis] == dims[axis] - 1 || !neighbour(strides[axis]))
            faces.push_back(packed | static_cast<PackedFace>(axis) << 27 | 1u << 29);
        }
      }
  return faces;
}

}  // namespace isolux::render
