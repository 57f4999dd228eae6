#include "render/volume/volume_texture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "render/gl/constants.h"
#include "volume/bricks/brick_source.h"
#include "volume/field/value_scaling.h"
#include "volume/voxels/stored_type.h"

namespace isolux::render {

namespace {

template <class Voxel, class Texel, class Convert>
void convertRows(const Voxel* voxels, glm::ivec3 dims, glm::ivec3 first, glm::ivec3 size, Texel* out,
                 Convert convert) {
  const int from = std::clamp(-first.x, 0, size.x);           // texels before the first voxel
  const int to = std::clamp(dims.x - first.x, from, size.x);  // and behind the last
  const auto row = [&](int y, int z) {
    return voxels + volume::Extent3{dims}.index(0, std::clamp(first.y + y, 0, dims.y - 1),
                                                std::clamp(first.z + z, 0, dims.z - 1));
  };
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y) {
      const Voxel* const voxel = row(y, z);
      out = std::fill_n(out, from, convert(voxel[0]));
      out = std::transform(voxel + first.x + from, voxel + first.x + to, out, convert);
      out = std::fill_n(out, size.x - to, convert(voxel[dims.x - 1]));
    }
}

}  // namespace

TexelSource::TexelSource(const volume::Grid& grid)
    : dims_(grid.dims()),
      parts_(grid.source()),
      partsType_(grid.storedType()),
      voxels_(grid.isWhole() ? &grid.voxels() : nullptr) {
  using volume::VoxelType;
  switch (grid.storedType()) {
    case VoxelType::int8:
    case VoxelType::uint8:
      scale_ = 255.0;
      break;
    case VoxelType::int16:
    case VoxelType::uint16:
      scale_ = 65535.0;
      break;
    default: {
      const volume::ValueScaling scaling = volume::scalingOf(grid.storedMinimum(), grid.storedMaximum());
      exponent_ = scaling.exponent;
      subtracted_ = scaling.offset;
      offset_ = static_cast<double>(subtracted_);
      scale_ = std::ldexp(1.0, exponent_);
    }
  }
  if (grid.storedType() == VoxelType::int8) offset_ = -128.0;
  if (grid.storedType() == VoxelType::int16) offset_ = -32768.0;
}

TexelSource::TexelSource(const volume::Coefficients& coefficients, glm::ivec3 dims)
    : dims_(dims),
      coefficients_(&coefficients.values),
      offset_(coefficients.offset),
      exponent_(volume::exponentOf(static_cast<double>(coefficients.least),
                                   static_cast<double>(coefficients.most))) {
  scale_ = std::ldexp(1.0, exponent_);
}

std::size_t TexelSource::texelBytes() const {
  if (parts_) return volume::bytesOf(partsType_);
  if (!voxels_) return sizeof(float);
  return std::visit([](const auto& voxels) { return sizeof(voxels[0]); }, *voxels_);
}

std::size_t TexelSource::bytes() const {
  return texelBytes() * volume::Extent3{dims_}.count();
}

GLenum TexelSource::internalFormat() const {
  return texelBytes() == 1 ? GL_R8 : texelBytes() == 2 ? GL_R16 : GL_R32F;
}

GLenum TexelSource::type() const {
  return texelBytes() == 1 ? GL_UNSIGNED_BYTE : texelBytes() == 2 ? GL_UNSIGNED_SHORT : GL_FLOAT;
}

template <class Voxel>
void TexelSource::convertBox(const Voxel* voxels, glm::ivec3 dims, glm::ivec3 first, glm::ivec3 size,
                             void* texels) const {
  if constexpr (std::is_same_v<Voxel, float>) {
    convertRows(voxels, dims, first, size, static_cast<float*>(texels),
                [shift = -exponent_, offset = subtracted_](float v) {
                  return std::isnan(v) ? missingTexel : std::ldexp(v - offset, shift);
                });
  } else {
    using Unsigned = std::make_unsigned_t<Voxel>;
    constexpr int bias = std::is_signed_v<Voxel> ? (sizeof(Voxel) == 1 ? 128 : 32768) : 0;
    convertRows(voxels, dims, first, size, static_cast<Unsigned*>(texels),
                [](Voxel v) { return static_cast<Unsigned>(static_cast<int>(v) + bias); });
  }
}

void TexelSource::copyBox(glm::ivec3 first, glm::ivec3 size, void* texels,
                          std::vector<volume::DamagedPart>* unknown) const {
  if (parts_) {
    const volume::GridGeometry box{.dims = size};
    volume::withStoredType(partsType_, [&](auto zero) {
      std::vector<decltype(zero)> voxels(box.voxelCount());
      parts_->copyBox(0, first, size, std::as_writable_bytes(std::span(voxels)), unknown);
      convertBox(voxels.data(), size, glm::ivec3(0), size, texels);
    });
  } else if (voxels_) {
    std::visit([&](const auto& voxels) { convertBox(voxels.data(), dims_, first, size, texels); }, *voxels_);
  } else {
    convertBox(coefficients_->data(), dims_, first, size, texels);
  }
}

Texture uploadWhole(const GlPtr& gl, const TexelSource& source, std::size_t budgetBytes) {
  const auto refuse = [](const std::string& reason) {
    throw base::Error(base::ErrorKind::memory, "", "graphics memory", reason);
  };
  const glm::ivec3 dims = source.dims();
  const int longest = std::max({dims.x, dims.y, dims.z});
  if (longest > gl->max3dTexture)
    refuse("the volume has an axis of " + std::to_string(longest) + " voxels, this driver takes at most " +
           std::to_string(gl->max3dTexture) + " in one texture");
  if (source.bytes() > budgetBytes)
    refuse("the volume needs " + std::to_string(source.bytes() >> 20) + " MiB, memory.gpu_budget_mb allows " +
           std::to_string(budgetBytes >> 20));
  Texture texture = Texture::make3D(gl, source.internalFormat(), dims, true);
  // Slab by slab through one converted buffer: no second copy of the volume.
  const std::size_t slice = source.bytes() / static_cast<std::size_t>(dims.z);
  const int slices = static_cast<int>(
      std::clamp<std::size_t>((std::size_t{8} << 20) / slice, 1, static_cast<std::size_t>(dims.z)));
  std::vector<std::byte> buffer(slice * static_cast<std::size_t>(slices));
  for (int z = 0; z < dims.z; z += slices) {
    const glm::ivec3 low(0, 0, z), size(dims.x, dims.y, std::min(slices, dims.z - z));
    source.copyBox(low, size, buffer.data());
    texture.write(GL_RED, source.type(), buffer.data(), low, size);
  }
  return texture;
}

}  // namespace isolux::render
