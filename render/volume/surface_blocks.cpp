#include "render/volume/surface_blocks.h"

#include <algorithm>
#include <utility>

#include "render/volume/brick_cache.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/skip/cell_bits.h"

namespace isolux::render {

SurfaceBlocks::SurfaceBlocks(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume,
                             scene::Field field, std::shared_ptr<const volume::MinMaxBlocks> blocks,
                             std::shared_ptr<const volume::BoxBounds> boxes, const PartBoxes* parts)
    : gl_(std::move(gl)),
      volume_(std::move(volume)),
      field_(field),
      active_(std::move(blocks)),
      boxes_(std::move(boxes)),
      parts_(parts) {}

void SurfaceBlocks::activate(std::vector<float> storedIsovalues, Hidden hidden) {
  const std::uint64_t key = volume::keyOf(hidden.voxels);
  if (storedIsovalues == storedIsovalues_ && key == hiddenKey_ && !masks_.empty()) return;
  hidden_ = std::move(hidden);
  hiddenKey_ = key;
  hiddenTextures_.clear();
  active_.update(storedIsovalues);
  bricks_.reset();
  storedIsovalues_ = std::move(storedIsovalues);
  updateMasks();
  uploaded_ = Uploaded::nothing;
}

std::size_t SurfaceBlocks::activeBricks() const {
  if (bricks_) return *bricks_;
  const volume::Extent3 bricks{brickDims(volume_->grid().dims())};
  const int perBrick = brickCells / blocks().blockCells();
  std::vector<std::uint8_t> active(bricks.count());
  volume::forEachIn(glm::ivec3(0), blocks().dims(), [&](glm::ivec3 block) {
    if (active_.flags()[blocks().index(block)] != 0) active[bricks.index(block / perBrick)] = 1;
  });
  bricks_ = static_cast<std::size_t>(std::count(active.begin(), active.end(), 1));
  return *bricks_;
}

void SurfaceBlocks::updateMasks() {
  const std::vector<std::uint8_t>& flags = active_.flags();
  if (boxes_ && active_.blocks().blockCells() == volume::BoxBounds::kBlockCells) {
    if (hidden_.surfaces.empty())
      boxes_->masks(storedIsovalues_, flags, masks_);
    else
      volume::shownBoxes(volume_->grid(), *boxes_, hidden_.surfaces, field_ != scene::Field::trilinear, flags,
                         masks_);
  } else {  // of another size (benchmarks), or not known yet: every box of an active one
    masks_.resize(flags.size());
    std::transform(flags.begin(), flags.end(), masks_.begin(),
                   [](std::uint8_t flag) { return flag ? ~std::uint64_t{0} : std::uint64_t{0}; });
    if (parts_)
      for (const glm::ivec3& brick : parts_->resident()) takeMasks(brick);
  }
}

PartBoxes::Blocks SurfaceBlocks::takeMasks(glm::ivec3 brick) {
  PartBoxes::Blocks found = parts_->masks(brick, storedIsovalues_, active_);
  for (std::size_t i = 0; i < found.masks.size(); ++i)
    masks_[blocks().index(found.low + volume::Extent3{found.size}.at(i))] = found.masks[i];
  return found;
}

void SurfaceBlocks::updateMasks(glm::ivec3 brick) {
  if (masks_.empty()) return;  // no surface yet
  const PartBoxes::Blocks found = takeMasks(brick);
  if (uploaded_ == Uploaded::nothing || found.masks.empty()) return;
  texture_.write(GL_RG_INTEGER, GL_UNSIGNED_INT, found.masks.data(), found.low, found.size);
}

bool SurfaceBlocks::mayHaveCells(const scene::Hit& hit) const {
  const glm::ivec3 dims = active_.blocks().dims();
  return hit.method == scene::HitMethod::exact && hit.field == scene::Field::trilinear &&
         volume_->grid().isWhole() && volume_->grid().missingCount() == 0 &&
         blocks().blockCells() == volume::BoxBounds::kBlockCells &&
         2 * std::max({dims.x, dims.y, dims.z}) <= gl_->max3dTexture;
}

void SurfaceBlocks::upload(bool cells) {
  const glm::ivec3 dims = (cells ? 2 : 1) * active_.blocks().dims();
  if (texture_.size() != dims) texture_ = Texture::make3D(gl_, GL_RG32UI, dims, false);
  std::vector<std::uint64_t> bits;
  const glm::ivec3 blockDims = active_.blocks().dims();
  if (cells && hidden_.surfaces.empty())
    volume::cellBits(volume_->grid(), blockDims, masks_, storedIsovalues_, bits);
  else if (cells)
    volume::shownCellBits(volume_->grid(), blockDims, masks_, hidden_.surfaces, bits);
  texture_.write(GL_RG_INTEGER, GL_UNSIGNED_INT, (cells ? bits : masks_).data(), glm::ivec3(0), dims);
  uploaded_ = cells ? Uploaded::cells : Uploaded::boxes;
}

void SurfaceBlocks::prepareMasks(const scene::Hit& hit) {
  if (uploaded_ == Uploaded::nothing)
    upload(false);
  else if (uploaded_ == Uploaded::boxes && mayHaveCells(hit))
    upload(true);
}

void SurfaceBlocks::bindMasks(Program& program, const scene::Hit& hit, int unit) {
  if (uploaded_ == Uploaded::nothing || (uploaded_ == Uploaded::cells && !mayHaveCells(hit))) upload(false);
  program.setTexture("uMasks", unit, texture_);
  const bool ofCells = uploaded_ == Uploaded::cells || blocks().blockCells() == 4;
  program.set("uMaskShift", ofCells ? 0 : 1);
}

// A texel holds 4x4x2 voxels, bit x + 4 y + 16 z, in a channel for each surface.
Texture SurfaceBlocks::hiddenTextureOf(std::span<const volume::PartlyShown> surfaces) const {
  const glm::ivec3 voxels = volume_->grid().dims(),
                   dims = (voxels + glm::ivec3(3, 3, 1)) / glm::ivec3(4, 4, 2);
  const std::size_t channels = surfaces.size() <= 2 ? surfaces.size() : 4;
  const volume::Extent3 extent{dims};
  std::vector<std::uint32_t> texels(extent.count() * channels);
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const volume::VoxelMask* const hidden = surfaces[k].hidden;
    if (!hidden) continue;
    volume::parallelEach(dims.z, [&](int slice) {
      for (int z = 2 * slice; z < std::min(2 * slice + 2, voxels.z); ++z)
        for (int y = 0; y < voxels.y; ++y) {
          std::uint32_t* const to = &texels[extent.index(0, y / 4, slice) * channels];
          const volume::Extent3 words{{hidden->wordsPerRow(), voxels.y, voxels.z}};
          const std::uint64_t* const from = &hidden->words()[words.index(0, y, z)];
          for (std::size_t x = 0; x < extent.row(); ++x) {
            const auto four = static_cast<std::uint32_t>(from[x / 16] >> (4 * (x % 16)) & 15u);
            to[x * channels + k] |= four << (4 * (y & 3) + 16 * (z & 1));
          }
        }
    });
  }
  const GLenum formats[] = {GL_R32UI, GL_RG32UI, GL_RGBA32UI, GL_RGBA32UI};
  const GLenum layouts[] = {GL_RED_INTEGER, GL_RG_INTEGER, GL_RGBA_INTEGER, GL_RGBA_INTEGER};
  Texture texture = Texture::make3D(gl_, formats[channels - 1], dims, false);
  texture.write(layouts[channels - 1], GL_UNSIGNED_INT, texels.data(), glm::ivec3(0), dims);
  return texture;
}

std::size_t SurfaceBlocks::textureBytes() const {
  std::size_t sum = texture_.bytes();
  for (const auto& [first, texture] : hiddenTextures_) sum += texture.bytes();
  return sum;
}

void SurfaceBlocks::bindHidden(Program& program, int unit, std::size_t first) {
  const auto surfaces = std::span(hidden_.surfaces).subspan(first);
  Texture& texture = hiddenTextures_[first];
  if (!texture) texture = hiddenTextureOf(surfaces.first(std::min<std::size_t>(surfaces.size(), 4)));
  program.setTexture("uHidden", unit, texture);
  const volume::InsideLevel level = hidden_.surfaces.front().level;
  const bool hidesStrays =
      std::any_of(hidden_.surfaces.begin(), hidden_.surfaces.end(), [](const auto& surface) {
        return surface.hidden && surface.hidden->hidesStrays();  // one choice for all
      });
  program.set("uInsideHigh", level.high ? 1 : 0);
  program.set("uHidesStrays", hidesStrays ? 1 : 0);
}

}  // namespace isolux::render
