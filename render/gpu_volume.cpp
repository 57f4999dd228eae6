#include "render/gpu_volume.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "scene/error.h"
#include "volume/reconstruct.h"

namespace isolux::render {

GpuVolume::GpuVolume(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume)
    : gl_(std::move(gl)), volume_(std::move(volume)), faceBuffer_(gl_) {
  const glm::ivec3 blocks = volume_->blocks->dims();
  if (std::max({blocks.x, blocks.y, blocks.z}) > maxBlocksPerAxis)
    throw scene::Error(scene::ErrorKind::memory, volume_->volume.name, "graphics memory",
                       "the volume has more than " + std::to_string(maxBlocksPerAxis) + " blocks on an axis");
}

bool GpuVolume::hasCells() const {
  return glm::all(glm::greaterThan(volume_->blocks->dims(), glm::ivec3(0)));
}

const std::vector<float>& GpuVolume::coefficients() {
  if (coefficients_.empty()) coefficients_ = volume::interpolatingCoefficients(grid());
  return coefficients_;
}

void GpuVolume::require(const scene::Scene& scene, std::size_t budgetBytes) {
  if (!hasCells()) return;
  if (!samplesTexture_) samplesTexture_ = uploadVolume(gl_, grid(), budgetBytes);
  if (coefficientsTexture_ || (scene.hit.field != scene::Field::cubic_interpolating &&
                               scene.derivatives.field != scene::Field::cubic_interpolating))
    return;
  coefficientsTexture_ =
      uploadCoefficients(gl_, coefficients(), grid().dims(),
                         budgetBytes - std::min(budgetBytes, samplesTexture_->texture.bytes()));
}

const VolumeTexture& GpuVolume::textureOf(scene::Field field) const {
  return field == scene::Field::cubic_interpolating ? *coefficientsTexture_ : *samplesTexture_;
}

void GpuVolume::bind(Program& program, scene::Field field) const {
  program.setTexture("uVolume", 0, samplesTexture_->texture);
  program.setTexture("uField", 1, textureOf(field).texture);
  program.set("uDims", grid().dims());
  program.set("uFieldPerVolume", static_cast<float>(textureOf(field).scale / samplesTexture_->scale));
}

double GpuVolume::texelOf(double value) const {
  return (grid().storedOfValue(value) - samplesTexture_->offset) / samplesTexture_->scale;
}

double GpuVolume::texelOf(double value, scene::Field field) const {
  return (grid().storedOfValue(value) - textureOf(field).offset) / textureOf(field).scale;
}

double GpuVolume::dataUnitsPerTexel() const {
  return grid().slope() * samplesTexture_->scale;
}

double GpuVolume::dataUnitsPerTexel(scene::Field field) const {
  return grid().slope() * textureOf(field).scale;
}

std::shared_ptr<const volume::MinMaxBlocks> GpuVolume::boundsOf(scene::Field field) {
  scene::Progress unwatched;
  if (field == scene::Field::cubic)
    return std::make_shared<volume::MinMaxBlocks>(
        volume::MinMaxBlocks::ofCubic(grid(), volume::kBlockCells, unwatched));
  if (field == scene::Field::cubic_interpolating)
    return std::make_shared<volume::MinMaxBlocks>(
        volume::MinMaxBlocks::ofCubic(coefficients(), grid(), volume::kBlockCells, unwatched));
  return volume_->blocks;
}

void GpuVolume::activate(scene::Field field, const std::vector<double>& values) {
  if (activeField_ != field) {
    active_ = std::make_unique<volume::ActiveBlocks>(boundsOf(field));
    faces_ = std::make_unique<BlockFaceSet>(active_->blocks().dims());
    activeTexture_ = hasCells() ? Texture::make3D(gl_, GL_R8, active_->blocks().dims(), false) : Texture();
    faceCapacity_ = 0;
    activeField_ = field;
  }
  if (!hasCells()) return;
  std::vector<float> stored;
  for (const double value : values) stored.push_back(static_cast<float>(grid().storedOfValue(value)));
  const bool fresh = faceCapacity_ == 0;
  const std::span<const std::uint32_t> changed = active_->update(stored);
  faces_->update(active_->flags(), changed);

  // Flags are 0 or 1 of 255: the shader compares with 0.
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const glm::ivec3 dims = active_->blocks().dims();
  constexpr std::size_t few = 256;
  if (fresh || changed.size() > few) {
    gl_->TextureSubImage3D(activeTexture_.id(), 0, 0, 0, 0, dims.x, dims.y, dims.z, GL_RED, GL_UNSIGNED_BYTE,
                           active_->flags().data());
  } else {
    for (const std::uint32_t block : changed) {
      const int b = static_cast<int>(block);
      gl_->TextureSubImage3D(activeTexture_.id(), 0, b % dims.x, b / dims.x % dims.y, b / (dims.x * dims.y),
                             1, 1, 1, GL_RED, GL_UNSIGNED_BYTE, &active_->flags()[block]);
    }
  }
  const std::vector<PackedFace>& faces = faces_->faces();
  const std::vector<BlockFaceSet::Range> dirty = faces_->takeDirty();
  if (fresh || faces.size() > faceCapacity_) {
    faceCapacity_ = std::max<std::size_t>(faces.size() + faces.size() / 4, 1024);
    faceBuffer_.setData(nullptr, faceCapacity_ * sizeof(PackedFace));
    faceBuffer_.write(0, faces.data(), faces.size() * sizeof(PackedFace));
  } else {
    for (const BlockFaceSet::Range& range : dirty)
      faceBuffer_.write(range.first * sizeof(PackedFace), &faces[range.first],
                        range.count * sizeof(PackedFace));
  }
}

std::size_t GpuVolume::bytes() const {
  std::size_t sum = blockBytes();
  for (const auto* texture : {&samplesTexture_, &coefficientsTexture_})
    if (*texture) sum += (*texture)->texture.bytes();
  return sum;
}

}  // namespace isolux::render
