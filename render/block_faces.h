// The faces between active and inactive blocks: the geometry that says where rays start and end.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::render {

// One face, packed: bits 0-8, 9-17, 18-26: block coordinates (so at most 512 blocks per axis); bits 27-28:
// axis of the normal; bit 29: set when the face is on the block's high side.
using PackedFace = std::uint32_t;
constexpr int maxBlocksPerAxis = 512;

// Outward faces of the active blocks toward inactive blocks and toward the volume's outside.
// `active`: one byte per block, x fastest.
std::vector<PackedFace> boundaryFaces(const std::vector<std::uint8_t>& active, glm::ivec3 blockDims);

}  // namespace isolux::render
