#include "render/volume/gpu_volume.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "volume/edge/surface_edges.h"
#include "volume/field/reconstruct.h"

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
  if (!grid().isWhole()) parts_ = std::make_unique<PartBoxes>(volume_->volume.grid);
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
  Bricks::Moved moved;
  if (parts_) {
    parts_->clear();
    moved = [this](glm::ivec3 brick, bool isResident, BlockBits lost) {
      parts_->moved(brick, isResident, lost);
      for (const auto& surface : surfaces_) surface->updateMasks(brick);
    };
  }
  // The masks of blocks, of large volumes, are not small.
  const std::size_t masks = volume_->blocks->count() * sizeof(std::uint64_t);
  bricks_.emplace(gl_, std::move(sources), apron,
                  std::max(budgetBytes / 4, budgetBytes - std::min(budgetBytes, masks)), std::move(moved));
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
  const bool whole =
      memory.layout == scene::MemoryLayout::whole ||
      (memory.layout == scene::MemoryLayout::automatic && grid().isWhole() && fitsWhole(budgetBytes));
  if (whole)
    makeWhole(budgetBytes);
  else
    makeBricks(budgetBytes);
  layout_ = memory;
}

const volume::Coefficients* GpuVolume::coefficients(scene::Field field) const {
  return field == scene::Field::cubic_interpolating ? cubic(field).coefficients.get() : nullptr;
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

double GpuVolume::texelOf(double value, scene::Field field) const {
  return (grid().storedOfValue(value) - sourceOf({field}).offset()) / sourceOf({field}).scale();
}

double GpuVolume::dataUnitsPerTexel(scene::Field field) const {
  return grid().slope() * sourceOf({field}).scale();
}

bool GpuVolume::mayCross(scene::Field field, const std::vector<double>& values) const {
  if (!hasCells()) return false;
  // The smoothing spline stays within the range of the samples; the interpolating one need not.
  const bool overshoots = field == scene::Field::cubic_interpolating;
  return std::any_of(values.begin(), values.end(), [&](double value) {
    return overshoots || (value >= grid().minimum() && value <= grid().maximum());
  });
}

SurfaceBlocks& GpuVolume::blocksOf(scene::Field field) {
  const auto found = std::find_if(surfaces_.begin(), surfaces_.end(),
                                  [field](const auto& kept) { return kept->field() == field; });
  if (found != surfaces_.end()) {
    std::rotate(found, found + 1, surfaces_.end());
    return *surfaces_.back();
  }
  std::shared_ptr<const volume::MinMaxBlocks> blocks = volume_->blocks;
  std::shared_ptr<const volume::BoxBounds> boxes = volume_->boxes;
  if (field != scene::Field::trilinear) {
    const volume::CubicField& made = cubic(field);
    blocks = {volume_, &made.blocks};
    boxes = {volume_, &made.boxes};
  }
  if (surfaces_.size() == kKeptFields) surfaces_.erase(surfaces_.begin());
  surfaces_.push_back(std::make_unique<SurfaceBlocks>(gl_, volume_, field, std::move(blocks),
                                                      std::move(boxes), parts_.get()));
  return *surfaces_.back();
}

void GpuVolume::activate(scene::Field field, const std::vector<double>& values) {
  SurfaceBlocks& surface = blocksOf(field);
  if (!hasCells()) return;
  std::vector<float> stored;
  stored.reserve(values.size());
  // Blocks and boxes of coefficients lack the coefficients' offset.
  const double offset = field == scene::Field::cubic_interpolating ? cubic(field).coefficients->offset : 0.0;
  for (const double value : values)
    stored.push_back(static_cast<float>(grid().storedOfValue(value) - offset));
  std::vector<volume::PartlyShown> shown;
  if (!hidden_.empty())
    for (std::size_t k = 0; k < values.size(); ++k) {
      const volume::HiddenPieces own = volume::hiddenAt(hidden_, values[k]);
      shown.push_back(
          {stored[k], own.voxels, volume::InsideLevel::of(grid(), values[k], hidden_.front().inside)});
    }
  surface.activate(std::move(stored), {std::move(shown), hidden_});
}

glm::dvec3 GpuVolume::noiseBlur() const {
  base::Progress unwatched;
  return volume_->derivativeChoices->noise(unwatched).correlation;
}

volume::CurvatureStatistics GpuVolume::curvatureStatistics(const FieldAt& of, double value, double outward,
                                                           const volume::HiddenPieces& hidden) const {
  if (!hasCells()) return {};
  const volume::ScaledField* const atScale = scaled(of);
  return volume::curvatureStatistics(grid(), *volume_->blocks, value, outward,
                                     atScale ? nullptr : coefficients(of.field), atScale, hidden);
}

std::vector<volume::VisiblePoint> GpuVolume::visiblePoints(double value) const {
  if (!hasCells()) return {};
  return volume::visiblePoints(grid(), *volume_->blocks, value);
}

volume::Quantiles GpuVolume::edgeOffsets(const FieldAt& of, const volume::EdgeSearch<double>& search,
                                         double value) const {
  if (!hasCells()) return {};
  const volume::EdgeFinder finder(grid(), {of.field, coefficients(of.field), scaled(of)}, search);
  const volume::EdgeStatistics edges = volume::edgeStatistics(finder, visiblePoints(value));
  return {edges.low.value_or(0.0), edges.median.value_or(0.0), edges.high.value_or(0.0)};
}

std::size_t GpuVolume::bytes() const {
  std::size_t sum = bricks_ ? bricks_->bytes() : 0;
  for (const auto& surface : surfaces_) sum += surface->textureBytes();
  for (const auto& channel : channels_) sum += channel->whole.bytes();
  return sum;
}

}  // namespace isolux::render
