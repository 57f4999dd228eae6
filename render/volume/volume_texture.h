// Stores a volume on the GPU in the smallest format that holds its voxels exactly.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "render/gl/gl_objects.h"
#include "volume/bricks/damage.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"

namespace isolux::render {

// Provides voxels as texels: stored = texel * scale + offset, where texel is the value that the shader
// fetches:
//   int8, uint8   R8   (int8 biased by 128)      scale 255
//   int16, uint16 R16  (int16 biased by 32768)   scale 65535
//   float32       R32F multiplied by a power of two that brings the largest magnitude near 1 (exact).
//                 If all values are within a factor of two of one another, their middle is subtracted first
//                 (exact, Sterbenz 1974). Of 1e6 + small, filters and sums then preserve the small part.
// Keeps pointers to the voxels it is made from.
class TexelSource {
 public:
  // If the grid's voxels stay in a file, copyBox() waits for them and throws base::Error{input}.
  explicit TexelSource(const volume::Grid& grid);
  // Takes coefficients on the axes of a grid (volume::interpolatingCoefficients): texels are those of their
  // values, as of a float32 volume, and offset() is theirs.
  TexelSource(const volume::Coefficients& coefficients, glm::ivec3 dims);

  glm::ivec3 dims() const { return dims_; }
  double scale() const { return scale_; }
  double offset() const { return offset_; }
  GLenum internalFormat() const;
  GLenum type() const;  // of the texels that copyBox() writes
  std::size_t texelBytes() const;
  std::size_t bytes() const;  // of all texels

  // Copies the texels of voxels first .. first + size - 1, x fastest; beyond the border the border voxel
  // repeats. `unknown`: as for BrickSource::copyBox().
  void copyBox(glm::ivec3 first, glm::ivec3 size, void* texels,
               std::vector<volume::DamagedPart>* unknown = nullptr) const;
  // Returns the object that reads ahead for copyBox(); null if the voxels are in memory.
  volume::BrickSource* parts() const { return parts_.get(); }

 private:
  template <class Voxel>
  void convertBox(const Voxel* voxels, glm::ivec3 dims, glm::ivec3 first, glm::ivec3 size,
                  void* texels) const;

  glm::ivec3 dims_;
  std::shared_ptr<volume::BrickSource> parts_;  // voxels of this type, or:
  volume::VoxelType partsType_ = volume::VoxelType::uint8;
  const volume::VoxelArray* voxels_ = nullptr;  // or:
  const std::vector<float>* coefficients_ = nullptr;
  double scale_ = 1.0, offset_ = 0.0;
  float subtracted_ = 0.0f;  // from each voxel
  int exponent_ = 0;
};

// Uploads the whole volume as one texture. Throws base::Error{memory} if an axis exceeds the driver's limit
// or the bytes exceed the budget.
Texture uploadWhole(const GlPtr& gl, const TexelSource& source, std::size_t budgetBytes);

}  // namespace isolux::render
