#include "render/volume/bricks.h"

#include <algorithm>
#include <chrono>
#include <tuple>

#include <glm/vector_relational.hpp>

#include "base/clock.h"
#include "base/error.h"
#include "volume/bricks/brick_source.h"

namespace isolux::render {

namespace {

constexpr GLuint kUseBinding = 0;  // bricks.glsl
constexpr int kTableUnit = 15;
constexpr std::size_t kFewestSlots = 8;
constexpr int kBlockCells = 8, kBlocks = brickCells / kBlockCells;
constexpr std::uint32_t kUsed = 1, kAskedFor = 2;  // bricks.glsl
constexpr std::size_t kCounts = 2;                 // before the marks of bricks: waiting rays, lost rays

std::size_t countOf(glm::ivec3 dims) {
  return volume::Extent3{dims}.count();
}

std::size_t brickTexelCount(int apron) {
  return countOf(glm::ivec3(brickTexels(apron)));
}

std::size_t slotBytes(const std::vector<const TexelSource*>& channels, int apron) {
  std::size_t sum = 0;
  for (const TexelSource* channel : channels) sum += channel->texelBytes() * brickTexelCount(apron);
  return sum;
}

// Slots per axis of a cache: at most `perAxis` on each, as many as fit into `most`, as near to a cube as that
// goes.
glm::ivec3 slotDimsFor(std::size_t most, int perAxis) {
  glm::ivec3 best(1);
  for (int x = 1; x <= perAxis; ++x)
    for (int y = x; y <= perAxis; ++y) {
      const std::size_t z = most / (static_cast<std::size_t>(x) * static_cast<std::size_t>(y));
      if (z < static_cast<std::size_t>(y) && y > x) break;
      const glm::ivec3 dims(
          x, y, static_cast<int>(std::clamp<std::size_t>(z, 1, static_cast<std::size_t>(perAxis))));
      if (countOf(dims) > most) continue;
      const bool more = countOf(dims) > countOf(best);
      if (more || (countOf(dims) == countOf(best) && dims.z < best.z)) best = dims;
    }
  return best;
}

glm::ivec3 checkedSlots(const Gl& gl, std::size_t slotBytes, int apron, std::size_t bricks,
                        std::size_t budgetBytes) {
  const std::size_t affordable = std::min(budgetBytes / slotBytes, bricks);
  const int perAxis = gl.max3dTexture / brickTexels(apron);
  const glm::ivec3 dims = slotDimsFor(std::max<std::size_t>(affordable, 1), std::max(perAxis, 1));
  if (affordable < std::min(kFewestSlots, bricks) || perAxis < 1 ||
      countOf(dims) < std::min(kFewestSlots, bricks))
    throw base::Error(base::ErrorKind::memory, "", "graphics memory",
                      "not even " + std::to_string(kFewestSlots) + " bricks of " +
                          std::to_string(slotBytes >> 10) + " KiB fit: memory.gpu_budget_mb is too small");
  return dims;
}

// Of a volume that stays in its file, bricks that are about to be uploaded are read by several threads: as
// long as the requests live, and no more than half of what its source keeps.
std::vector<volume::BrickSource::Request> readAhead(const TexelSource& texels, glm::ivec3 dims, int apron,
                                                    const std::vector<BrickCache::Brick>& wanted,
                                                    std::size_t most) {
  std::vector<volume::BrickSource::Request> requests;
  volume::BrickSource* const source = texels.parts();
  if (!source) return requests;
  const std::size_t each = texels.texelBytes() * brickTexelCount(apron);
  const std::size_t count = std::min({wanted.size(), most, source->budgetBytes() / 2 / each});
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 low = volume::Extent3{dims}.at(wanted[i]) * brickCells - apron;
    for (auto& request : source->requestBox(0, low, glm::ivec3(brickTexels(apron)), -static_cast<int>(i)))
      requests.push_back(std::move(request));
  }
  return requests;
}

}  // namespace

Bricks::Bricks(GlPtr gl, std::vector<const TexelSource*> channels, int apron, std::size_t budgetBytes,
               Moved moved)
    : gl_(std::move(gl)),
      channels_(std::move(channels)),
      apron_(apron),
      moved_(std::move(moved)),
      dims_(brickDims(channels_[0]->dims())),
      slotDims_(checkedSlots(*gl_, slotBytes(channels_, apron_), apron_, countOf(dims_), budgetBytes)),
      cache_(countOf(dims_), std::min(countOf(slotDims_), countOf(dims_))),
      hasBlockBits_(channels_[0]->parts() && 2 * dims_.z <= gl_->max3dTexture),
      table_(Texture::make3D(gl_, GL_RGBA16UI, hasBlockBits_ ? dims_ * glm::ivec3(1, 1, 2) : dims_, false)),
      use_(gl_),
      marks_(countOf(dims_) + kCounts, 0),
      texels_(channels_.size()) {
  for (const TexelSource* channel : channels_)
    caches_.push_back(Texture::make3D(gl_, channel->internalFormat(), slotDims_ * brickTexels(apron_), true));
  const std::vector<std::uint16_t> nowhere(4 * countOf(dims_), 0);
  table_.write(GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, nowhere.data(), glm::ivec3(0), dims_);
  const std::size_t markBytes = marks_.size() * sizeof(std::uint32_t);
  if (markBytes > static_cast<std::size_t>(std::max(gl_->maxStorageBytes, 0)))
    throw base::Error(base::ErrorKind::memory, "", "graphics memory",
                      "the volume has " + std::to_string(countOf(dims_)) +
                          " bricks, more than this driver's buffers hold marks for");
  use_.setData(nullptr, markBytes);
}

void Bricks::bind(Program& program) const {
  program.setTexture("uBricks", kTableUnit, table_);
}

std::size_t Bricks::bytes() const {
  std::size_t sum = table_.bytes() + use_.bytes();
  for (const Texture& cache : caches_) sum += cache.bytes();
  return sum;
}

bool Bricks::holdsAll() const {
  return cache_.slots() == countOf(dims_);
}

bool Bricks::readsTwice() const {
  const volume::BrickSource* const source = channels_[0]->parts();
  return source && source->budgetBytes() < channels_[0]->bytes();
}

void Bricks::beginFrame() {
  frameBegins_ = true;
  uploaded_ = evicted_ = 0;
  uploadMilliseconds_ = 0.0;
}

void Bricks::beginRound() {
  const BrickCache::Round round = cache_.beginRound();
  if (frameBegins_) frameRound_ = round;
  frameBegins_ = false;
  gl_->ClearNamedBufferData(use_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, kUseBinding, use_.id());
}

void Bricks::endRound() {
  gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl_->GetNamedBufferSubData(use_.id(), 0, static_cast<GLsizeiptr>(use_.bytes()), marks_.data());
  gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, kUseBinding, 0);
  waitingRays_ = marks_[0];
  lostRays_ = marks_[1];
  for (std::size_t i = kCounts; i < marks_.size(); ++i) {
    const auto brick = static_cast<BrickCache::Brick>(i - kCounts);
    if (marks_[i] == kUsed)
      cache_.use(brick);
    else if (marks_[i] == kAskedFor)
      wanted_.push_back(brick);
  }
  if (volume::BrickSource* const source = channels_[0]->parts()) {
    const auto partOf = [&](BrickCache::Brick brick) {
      const glm::ivec3 part = source->brickOf(0, brickAt(brick) * brickCells);
      return std::tuple(part.z, part.y, part.x);
    };
    std::stable_sort(wanted_.begin(), wanted_.end(),
                     [&](BrickCache::Brick a, BrickCache::Brick b) { return partOf(a) < partOf(b); });
  }
}

bool Bricks::canServe(BrickCache::Round kept) const {
  return !wanted_.empty() && cache_.oldest() < kept;
}

std::size_t Bricks::serve(BrickCache::Round kept, std::size_t limitBytes) {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t each = slotBytes(channels_, apron_);
  std::size_t count = 0, next = 0;
  const std::vector<volume::BrickSource::Request> ahead =
      readAhead(*channels_[0], dims_, apron_, wanted_, limitBytes / each);
  for (; next < wanted_.size() && (count == 0 || (count + 1) * each <= limitBytes); ++next) {
    const BrickCache::Brick brick = wanted_[next];
    if (cache_.slotOf(brick)) continue;  // asked for twice
    if (!cache_.hasPlace(kept)) break;
    ++count;
    if (fetch(brick) == blocksOf(brick)) {
      setEntry(brick, Entry::lost);
      continue;
    }
    const BrickCache::Placement placement = *cache_.place(brick, kept);
    if (placement.evicted) {
      setEntry(*placement.evicted, Entry::absent);
      ++evicted_;
    }
    upload(brick, placement.slot);
    ++uploaded_;
  }
  wanted_.erase(wanted_.begin(), wanted_.begin() + static_cast<std::ptrdiff_t>(next));
  uploadMilliseconds_ += 1000.0 * base::secondsSince(begin);
  return count;
}

glm::ivec3 Bricks::brickAt(BrickCache::Brick brick) const {
  return volume::Extent3{dims_}.at(brick);
}

void Bricks::setEntry(BrickCache::Brick brick, Entry state) const {
  const bool isResident = state == Entry::resident || state == Entry::partlyLost;
  const glm::ivec3 slot = volume::Extent3{slotDims_}.at(isResident ? *cache_.slotOf(brick) : 0u);
  const auto part = [](auto v) { return static_cast<std::uint16_t>(v); };
  const std::uint16_t entry[4] = {part(slot.x), part(slot.y), part(slot.z), part(static_cast<int>(state))};
  const glm::ivec3 at = brickAt(brick);
  const auto set = [&](glm::ivec3 texel, const std::uint16_t* values) {
    table_.write(GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, values, texel, glm::ivec3(1));
  };
  BlockBits lost = 0;
  if (state == Entry::partlyLost) {
    lost = lost_.at(brick);
    const std::uint16_t layers[4] = {part(lost), part(lost >> 16), part(lost >> 32), part(lost >> 48)};
    set(at + glm::ivec3(0, 0, dims_.z), layers);
  }
  set(at, entry);
  if (moved_ && state != Entry::lost) moved_(at, isResident, lost);
}

BlockBits Bricks::blocksOf(BrickCache::Brick brick) const {
  const glm::ivec3 cells = glm::max(channels_[0]->dims() - 1, glm::ivec3(1)) - brickAt(brick) * brickCells;
  BlockBits blocks = 0;
  volume::forEachIn(glm::ivec3(0), glm::min((cells + kBlockCells - 1) / kBlockCells, kBlocks),
                    [&](glm::ivec3 block) { blocks |= blockBit(block); });
  return blocks;
}

BlockBits Bricks::fetch(BrickCache::Brick brick) {
  const int side = brickTexels(apron_);
  const glm::ivec3 first = brickAt(brick) * brickCells - apron_;
  std::vector<volume::DamagedPart> unknown;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    texels_[i].resize(channels_[i]->texelBytes() * brickTexelCount(apron_));
    channels_[i]->copyBox(first, glm::ivec3(side), texels_[i].data(), &unknown);
  }
  if (unknown.empty()) {
    lost_.erase(brick);  // read again, and there now
    return 0;
  }
  if (lost_.empty()) lostReason_ = unknown.front().error;
  // Where the table has no room for their bits all blocks are.
  BlockBits lost = hasBlockBits_ ? 0 : blocksOf(brick);
  volume::forEachIn(glm::ivec3(0), glm::ivec3(kBlocks), [&](glm::ivec3 block) {
    // Voxels that lookups around the block's cells read.
    const glm::ivec3 low = first + kBlockCells * block, behind = low + kBlockCells + 1 + 2 * apron_;
    for (const volume::DamagedPart& part : unknown)
      if (glm::all(glm::lessThan(part.low, behind)) && glm::all(glm::lessThan(low, part.low + part.size)))
        lost |= blockBit(block);
  });
  lost &= blocksOf(brick);
  if (lost != 0) lost_.insert_or_assign(brick, lost);
  return lost;
}

void Bricks::upload(BrickCache::Brick brick, BrickCache::Slot slot) {
  const int side = brickTexels(apron_);
  const glm::ivec3 to = side * volume::Extent3{slotDims_}.at(slot);
  for (std::size_t i = 0; i < channels_.size(); ++i)
    caches_[i].write(GL_RED, channels_[i]->type(), texels_[i].data(), to, glm::ivec3(side));
  setEntry(brick, lost_.contains(brick) ? Entry::partlyLost : Entry::resident);
}

}  // namespace isolux::render
