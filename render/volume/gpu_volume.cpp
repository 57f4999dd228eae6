#include "render/volume/gpu_volume.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "volume/field/reconstruct.h"
#include "volume/skip/cell_bits.h"

namespace isolux::render {

namespace {

// The masks of the blocks are a texture.
void checkBlocks(const Gl& gl, const volume::MinMaxBlocks& blocks, const std::string& name) {
  const glm::ivec3 dims = blocks.dims();
  const int longest = std::max({dims.x, dims.y, dims.z});
  if (longest > gl.max3dTexture)
    throw base::Error(base::ErrorKind::memory, name, "graphics memory",
                      "an axis of " + std::to_string(longest * blocks.blockCells()) +
                          " voxels cannot be drawn with this driver, which takes up to " +
                          std::to_string(gl.max3dTexture * blocks.blockCells()) +
                          "; read a part of the volume");
}

// What a lookup is made from: the trilinear field and the B-spline `cubic` share the samples.
FieldAt sourceAt(const FieldAt& of) {
  if (of.scaleMm > 0.0 && of.field != scene::Field::trilinear) return of;
  const bool samples = of.field != scene::Field::cubic_interpolating;
  return {samples ? scene::Field::trilinear : of.field, 0.0};
}

// The samples, and what else these fields are made from.
std::vector<FieldAt> sourcesOf(const std::vector<FieldAt>& fields) {
  std::vector<FieldAt> sources = {FieldAt()};
  for (const FieldAt& field : fields)
    if (const FieldAt source = sourceAt(field);
        std::find(sources.begin(), sources.end(), source) == sources.end())
      sources.push_back(source);
  return sources;
}

}  // namespace

GpuVolume::GpuVolume(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume)
    : gl_(std::move(gl)), volume_(std::move(volume)) {
  checkBlocks(*gl_, *volume_->blocks, volume_->volume.name);
}

bool GpuVolume::hasCells() const {
  return glm::all(glm::greaterThan(volume_->blocks->dims(), glm::ivec3(0)));
}

const volume::CubicField& GpuVolume::cubic(scene::Field field) const {
  base::Progress unwatched;
  return *volume_->cubicFields->make(field, unwatched);  // which keeps it
}

std::unique_ptr<GpuVolume::Channel> GpuVolume::makeChannel(const FieldAt& of) const {
  if (of.scaleMm > 0.0) {
    base::Progress unwatched;
    std::shared_ptr<const volume::ScaledField> scaled =
        volume_->cubicFields->make(of.field, of.scaleMm, unwatched);
    TexelSource texels(scaled->coefficients, grid().dims());
    return std::make_unique<Channel>(of, std::move(scaled), std::move(texels));
  }
  const volume::Coefficients* const own = coefficients(of.field);
  return std::make_unique<Channel>(of, nullptr, own ? TexelSource(*own, grid().dims()) : TexelSource(grid()));
}

std::size_t GpuVolume::channelOf(const FieldAt& of) const {
  const FieldAt source = sourceAt(of);
  const auto at = std::find_if(channels_.begin(), channels_.end(),
                               [&](const auto& channel) { return channel->of == source; });
  return static_cast<std::size_t>(at - channels_.begin());
}

std::size_t GpuVolume::channelBytes() const {
  std::size_t sum = 0;
  for (const auto& channel : channels_) sum += channel->source.bytes();
  return sum;
}

bool GpuVolume::fitsWhole(std::size_t budgetBytes) const {
  const glm::ivec3 dims = grid().dims();
  return std::max({dims.x, dims.y, dims.z}) <= gl_->max3dTexture && channelBytes() <= budgetBytes;
}

void GpuVolume::makeWhole(std::size_t budgetBytes) {
  bricks_.reset();
  if (channelBytes() > budgetBytes)
    for (const auto& channel : channels_)
      channel->whole = Texture();  // made under a larger budget: refused now
  std::size_t left = budgetBytes;
  for (const auto& channel : channels_) {
    if (!channel->whole) channel->whole = uploadWhole(gl_, channel->source, left);
    left -= std::min(left, channel->whole.bytes());
  }
}

void GpuVolume::makeBricks(std::size_t budgetBytes) {
  bricks_.reset();
  std::vector<const TexelSource*> sources;
  int apron = cubicApron;
  for (const auto& channel : channels_) {
    channel->whole = Texture();
    sources.push_back(&channel->source);
    if (channel->scaled) apron = quinticApron;
  }
  bricks_.emplace(gl_, std::move(sources), apron, budgetBytes);
  ++bricksMade_;
}

void GpuVolume::dropOthers(const std::vector<FieldAt>& wanted) {
  const auto unwanted = [&](const auto& channel) {
    return std::find(wanted.begin(), wanted.end(), channel->of) == wanted.end();
  };
  if (std::none_of(channels_.begin(), channels_.end(), unwanted)) return;
  bricks_.reset();  // they point to the channels
  layout_.reset();
  std::erase_if(channels_, unwanted);
}

void GpuVolume::requireFields(const std::vector<FieldAt>& fields) {
  if (!hasCells()) return;
  const std::vector<FieldAt> wanted = sourcesOf(fields);
  const auto isThere = [&](const FieldAt& source) { return channelOf(source) < channels_.size(); };
  if (std::all_of(wanted.begin(), wanted.end(), isThere)) return;
  dropOthers(wanted);
  for (const FieldAt& source : wanted)
    if (!isThere(source)) channels_.push_back(makeChannel(source));
  layout_.reset();
}

void GpuVolume::require(const std::vector<FieldAt>& fields, const scene::Memory& memory) {
  if (!hasCells()) return;
  requireFields(fields);
  if (layout_ == memory) return;
  layout_.reset();
  dropOthers(sourcesOf(fields));
  const std::size_t budgetBytes = static_cast<std::size_t>(memory.gpuBudgetMb) << 20;
  const bool whole = memory.layout == scene::MemoryLayout::whole ||
                     (memory.layout == scene::MemoryLayout::automatic && fitsWhole(budgetBytes));
  if (whole)
    makeWhole(budgetBytes);
  else
    makeBricks(budgetBytes);
  layout_ = memory;
}

std::size_t GpuVolume::activeBricks() const {
  if (!active_ || !hasCells()) return 0;
  if (activeBricks_) return *activeBricks_;
  const glm::ivec3 bricks = brickDims(grid().dims()), dims = blocks().dims();
  const int perBrick = brickCells / blocks().blockCells();
  std::vector<std::uint8_t> active(static_cast<std::size_t>(bricks.x) * static_cast<std::size_t>(bricks.y) *
                                   static_cast<std::size_t>(bricks.z));
  std::size_t block = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++block)
        if (isActive(block)) {
          const int brick = (z / perBrick * bricks.y + y / perBrick) * bricks.x + x / perBrick;
          active[static_cast<std::size_t>(brick)] = 1;
        }
  activeBricks_ = static_cast<std::size_t>(std::count(active.begin(), active.end(), 1));
  return *activeBricks_;
}

const volume::Coefficients* GpuVolume::coefficients(scene::Field field) const {
  return field == scene::Field::cubic_interpolating ? &*cubic(field).coefficients : nullptr;
}

const volume::ScaledField* GpuVolume::scaled(const FieldAt& of) const {
  const std::size_t channel = channelOf(of);
  return channel < channels_.size() ? channels_[channel]->scaled.get() : nullptr;
}

const TexelSource& GpuVolume::sourceOf(const FieldAt& of) const {
  return channels_[channelOf(of)]->source;
}

void GpuVolume::bind(Program& program, const FieldAt& of) const {
  const std::size_t channel = channelOf(of);
  const auto texture = [&](std::size_t i) -> const Texture& {
    return bricks_ ? bricks_->texture(i) : channels_[i]->whole;
  };
  program.setTexture("uVolume", 0, texture(0));
  program.setTexture("uField", 1, texture(channel));
  if (bricks_) bricks_->bind(program);
  program.set("uDims", grid().dims());
  program.set("uFour", 4);
  program.set("uSix", 6);
  program.set("uFieldPerVolume", static_cast<float>(sourceOf(of).scale() / channels_[0]->source.scale()));
}

double GpuVolume::texelOf(double value) const {
  return texelOf(value, scene::Field::trilinear);
}

double GpuVolume::texelOf(double value, scene::Field field) const {
  return (grid().storedOfValue(value) - sourceOf({field}).offset()) / sourceOf({field}).scale();
}

double GpuVolume::dataUnitsPerTexel() const {
  return dataUnitsPerTexel(scene::Field::trilinear);
}

double GpuVolume::dataUnitsPerTexel(scene::Field field) const {
  return grid().slope() * sourceOf({field}).scale();
}

void GpuVolume::setField(scene::Field field) {
  using volume::BoxBounds;
  using volume::MinMaxBlocks;
  if (activeField_ == field) return;
  std::shared_ptr<const MinMaxBlocks> blocks = volume_->blocks;
  boxes_ = volume_->boxes;
  if (field != scene::Field::trilinear) {
    const volume::CubicField& made = cubic(field);
    blocks = {volume_, &made.blocks};
    boxes_ = {volume_, &made.boxes};
  }
  active_ = std::make_unique<volume::ActiveBlocks>(blocks);
  storedIsovalues_.clear();
  masks_.clear();
  maskTexture_ = Texture();
  activeField_ = field;
}

void GpuVolume::updateMasks() {
  const std::vector<std::uint8_t>& flags = active_->flags();
  if (active_->blocks().blockCells() == volume::BoxBounds::kBlockCells) {
    boxes_->masks(storedIsovalues_, flags, masks_);
  } else {  // of another size (benchmarks): every box of an active one
    masks_.resize(flags.size());
    std::transform(flags.begin(), flags.end(), masks_.begin(),
                   [](std::uint8_t flag) { return flag ? ~std::uint64_t{0} : std::uint64_t{0}; });
  }
}

bool GpuVolume::mayHaveCells(const scene::Hit& hit) const {
  const glm::ivec3 dims = blocks().dims();
  return hit.method == scene::HitMethod::exact && hit.field == scene::Field::trilinear &&
         grid().missingCount() == 0 && blocks().blockCells() == volume::BoxBounds::kBlockCells &&
         2 * std::max({dims.x, dims.y, dims.z}) <= gl_->max3dTexture;
}

void GpuVolume::uploadMasks(bool cells) {
  const glm::ivec3 dims = (cells ? 2 : 1) * blocks().dims();
  if (maskTexture_.size() != dims) maskTexture_ = Texture::make3D(gl_, GL_RG32UI, dims, false);
  std::vector<std::uint64_t> bits;
  if (cells) volume::cellBits(grid(), blocks().dims(), masks_, storedIsovalues_, bits);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TextureSubImage3D(maskTexture_.id(), 0, 0, 0, 0, dims.x, dims.y, dims.z, GL_RG_INTEGER,
                         GL_UNSIGNED_INT, (cells ? bits : masks_).data());
  uploaded_ = cells ? Uploaded::cells : Uploaded::boxes;
}

void GpuVolume::prepareMasks(const scene::Hit& hit) {
  if (uploaded_ == Uploaded::nothing)
    uploadMasks(false);
  else if (uploaded_ == Uploaded::boxes && mayHaveCells(hit))
    uploadMasks(true);
}

void GpuVolume::bindMasks(Program& program, const scene::Hit& hit, int unit) {
  if (uploaded_ == Uploaded::nothing || (uploaded_ == Uploaded::cells && !mayHaveCells(hit)))
    uploadMasks(false);
  program.setTexture("uMasks", unit, maskTexture_);
  const bool ofCells = uploaded_ == Uploaded::cells || blocks().blockCells() == 4;
  program.set("uMaskShift", ofCells ? 0 : 1);
}

bool GpuVolume::mayCross(scene::Field field, const std::vector<double>& values) const {
  if (!hasCells()) return false;
  // The smoothing spline stays within the range of the samples; the interpolating one need not.
  const bool overshoots = field == scene::Field::cubic_interpolating;
  return std::any_of(values.begin(), values.end(), [&](double value) {
    return overshoots || (value >= grid().minimum() && value <= grid().maximum());
  });
}

void GpuVolume::activate(scene::Field field, const std::vector<double>& values) {
  setField(field);
  if (!hasCells()) return;
  std::vector<float> stored;
  stored.reserve(values.size());
  // Blocks and boxes of coefficients lack the coefficients' offset.
  const double offset = field == scene::Field::cubic_interpolating ? cubic(field).coefficients->offset : 0.0;
  for (const double value : values)
    stored.push_back(static_cast<float>(grid().storedOfValue(value) - offset));
  if (stored == storedIsovalues_ && !masks_.empty()) return;
  active_->update(stored);
  activeBricks_.reset();
  storedIsovalues_ = std::move(stored);
  updateMasks();
  uploaded_ = Uploaded::nothing;
}

volume::CurvatureStatistics GpuVolume::curvatureStatistics(const FieldAt& of, double value, double outward) {
  if (!hasCells()) return {};
  if (const volume::ScaledField* const atScale = scaled(of))
    return volume::curvatureStatistics(grid(), *volume_->blocks, value, outward, *atScale);
  return volume::curvatureStatistics(grid(), *volume_->blocks, value, outward, coefficients(of.field));
}

std::size_t GpuVolume::bytes() const {
  std::size_t sum = maskTexture_.bytes() + (bricks_ ? bricks_->bytes() : 0);
  for (const auto& channel : channels_) sum += channel->whole.bytes();
  return sum;
}

}  // namespace isolux::render
