#include "render/volume_texture.h"

#include <algorithm>
#include <cmath>

#include "render/constants.h"
#include "scene/error.h"

namespace isolux::render {

namespace {

Texture allocated(const GlPtr& gl, GLenum format, glm::ivec3 dims, std::size_t bytes,
                  std::size_t budgetBytes) {
  const auto refuse = [](const std::string& reason) {
    throw scene::Error(scene::ErrorKind::memory, "", "graphics memory", reason);
  };
  if (std::max({dims.x, dims.y, dims.z}) > gl->max3dTexture)
    refuse("the volume has an axis of " + std::to_string(std::max({dims.x, dims.y, dims.z})) +
           " voxels, this driver takes at most " + std::to_string(gl->max3dTexture));
  if (bytes > budgetBytes)
    refuse("the volume needs " + std::to_string(bytes >> 20) + " MiB, memory.gpu_budget_mb allows " +
           std::to_string(budgetBytes >> 20));
  return Texture::make3D(gl, format, dims, true);
}

// Slab by slab through one converted buffer: no second copy of the volume.
template <class Source, class Target, class Convert>
void uploadSlabs(const Gl& gl, const Texture& texture, GLenum type, const Source* voxels, Convert convert) {
  const glm::ivec3 size = texture.size();
  const std::size_t slice = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  const int slices =
      static_cast<int>(std::max<std::size_t>(1, (std::size_t{8} << 20) / (slice * sizeof(Target))));
  std::vector<Target> buffer(slice * static_cast<std::size_t>(std::min(slices, size.z)));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int z = 0; z < size.z; z += slices) {
    const int count = std::min(slices, size.z - z);
    const Source* from = voxels + slice * static_cast<std::size_t>(z);
    std::transform(from, from + slice * static_cast<std::size_t>(count), buffer.begin(), convert);
    gl.TextureSubImage3D(texture.id(), 0, 0, 0, z, size.x, size.y, count, GL_RED, type, buffer.data());
  }
}

VolumeTexture uploadFloats(const GlPtr& gl, const std::vector<float>& values, glm::ivec3 dims,
                           std::size_t budgetBytes) {
  float largest = 0.0f;
  for (const float v : values)
    if (std::fabs(v) > largest) largest = std::fabs(v);
  int exponent = 0;
  if (largest > 0.0f) std::frexp(largest, &exponent);
  exponent = std::clamp(exponent, -126, 127);
  VolumeTexture result{allocated(gl, GL_R32F, dims, values.size() * 4, budgetBytes),
                       std::ldexp(1.0, exponent), 0.0};
  const int shift = -exponent;
  uploadSlabs<float, float>(*gl, result.texture, GL_FLOAT, values.data(),
                            [shift](float v) { return std::isnan(v) ? missingTexel : std::ldexp(v, shift); });
  return result;
}

}  // namespace

VolumeTexture uploadVolume(const GlPtr& gl, const volume::Grid& grid, std::size_t budgetBytes) {
  const glm::ivec3 dims = grid.dims();
  return std::visit(
      [&](const auto& voxels) -> VolumeTexture {
        using T = typename std::decay_t<decltype(voxels)>::value_type;
        if constexpr (std::is_same_v<T, float>) {
          return uploadFloats(gl, voxels, dims, budgetBytes);
        } else {
          using Unsigned = std::make_unsigned_t<T>;
          constexpr bool oneByte = sizeof(T) == 1;
          constexpr int bias = std::is_signed_v<T> ? (oneByte ? 128 : 32768) : 0;
          VolumeTexture result{allocated(gl, oneByte ? GL_R8 : GL_R16, dims, grid.bytes(), budgetBytes),
                               oneByte ? 255.0 : 65535.0, -static_cast<double>(bias)};
          uploadSlabs<T, Unsigned>(*gl, result.texture, oneByte ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT,
                                   voxels.data(),
                                   [](T v) { return static_cast<Unsigned>(static_cast<int>(v) + bias); });
          return result;
        }
      },
      grid.voxels());
}

VolumeTexture uploadCoefficients(const GlPtr& gl, const std::vector<float>& coefficients, glm::ivec3 dims,
                                 std::size_t budgetBytes) {
  return uploadFloats(gl, coefficients, dims, budgetBytes);
}

}  // namespace isolux::render
