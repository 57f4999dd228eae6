// A volume on the GPU, in the smallest format that holds its voxels exactly.
#pragma once

#include <vector>

#include "render/gl_objects.h"
#include "volume/grid.h"

namespace isolux::render {

// stored = texel * scale + offset, where texel is what the shader fetches:
//   int8, uint8   R8   (int8 biased by 128)      scale 255
//   int16, uint16 R16  (int16 biased by 32768)   scale 65535
//   float32       R32F multiplied by a power of two that brings the largest magnitude near 1 (exact)
struct VolumeTexture {
  Texture texture;
  double scale = 1.0, offset = 0.0;
};
// Throws scene::Error{memory} when an axis exceeds the driver's limit or the bytes the budget.
VolumeTexture uploadVolume(const GlPtr& gl, const volume::Grid& grid, std::size_t budgetBytes);
// Float coefficients on the grid's axes (volume::interpolatingCoefficients), scaled like a float32 volume.
VolumeTexture uploadCoefficients(const GlPtr& gl, const std::vector<float>& coefficients, glm::ivec3 dims,
                                 std::size_t budgetBytes);

}  // namespace isolux::render
