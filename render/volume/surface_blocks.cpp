#include "render/volume/surface_blocks.h"

#include <algorithm>
#include <utility>

#include "render/volume/brick_cache.h"
#include "volume/skip/cell_bits.h"

namespace isolux::render {

SurfaceBlocks::SurfaceBlocks(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume,
                             scene::Field field, std::shared_ptr<const volume::MinMaxBlocks> blocks,
                             std::shared_ptr<const volume::BoxBounds> boxes)
    : gl_(std::move(gl)),
      volume_(std::move(volume)),
      field_(field),
      active_(std::move(blocks)),
      boxes_(std::move(boxes)) {}

void SurfaceBlocks::activate(std::vector<float> storedIsovalues) {
  if (storedIsovalues == storedIsovalues_ && !masks_.empty()) return;
  active_.update(storedIsovalues);
  bricks_.reset();
  storedIsovalues_ = std::move(storedIsovalues);
  updateMasks();
  uploaded_ = Uploaded::nothing;
}

std::size_t SurfaceBlocks::activeBricks() const {
  if (bricks_) return *bricks_;
  const glm::ivec3 bricks = brickDims(volume_->grid().dims()), dims = blocks().dims();
  const int perBrick = brickCells / blocks().blockCells();
  std::vector<std::uint8_t> active(static_cast<std::size_t>(bricks.x) * static_cast<std::size_t>(bricks.y) *
                                   static_cast<std::size_t>(bricks.z));
  std::size_t block = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++block)
        if (active_.flags()[block] != 0) {
          const int brick = (z / perBrick * bricks.y + y / perBrick) * bricks.x + x / perBrick;
          active[static_cast<std::size_t>(brick)] = 1;
        }
  bricks_ = static_cast<std::size_t>(std::count(active.begin(), active.end(), 1));
  return *bricks_;
}

void SurfaceBlocks::updateMasks() {
  const std::vector<std::uint8_t>& flags = active_.flags();
  if (active_.blocks().blockCells() == volume::BoxBounds::kBlockCells) {
    boxes_->masks(storedIsovalues_, flags, masks_);
  } else {  // of another size (benchmarks): every box of an active one
    masks_.resize(flags.size());
    std::transform(flags.begin(), flags.end(), masks_.begin(),
                   [](std::uint8_t flag) { return flag ? ~std::uint64_t{0} : std::uint64_t{0}; });
  }
}

bool SurfaceBlocks::mayHaveCells(const scene::Hit& hit) const {
  const glm::ivec3 dims = active_.blocks().dims();
  return hit.method == scene::HitMethod::exact && hit.field == scene::Field::trilinear &&
         volume_->grid().missingCount() == 0 && blocks().blockCells() == volume::BoxBounds::kBlockCells &&
         2 * std::max({dims.x, dims.y, dims.z}) <= gl_->max3dTexture;
}

void SurfaceBlocks::upload(bool cells) {
  const glm::ivec3 dims = (cells ? 2 : 1) * active_.blocks().dims();
  if (texture_.size() != dims) texture_ = Texture::make3D(gl_, GL_RG32UI, dims, false);
  std::vector<std::uint64_t> bits;
  if (cells) volume::cellBits(volume_->grid(), active_.blocks().dims(), masks_, storedIsovalues_, bits);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TextureSubImage3D(texture_.id(), 0, 0, 0, 0, dims.x, dims.y, dims.z, GL_RG_INTEGER, GL_UNSIGNED_INT,
                         (cells ? bits : masks_).data());
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

}  // namespace isolux::render
