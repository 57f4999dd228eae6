#include "render/light/light_atlas.h"

#include <algorithm>

#include <tbb/parallel_for.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace isolux::render {

namespace {

constexpr std::size_t kFirstSlots = 64;
constexpr std::size_t kTogether = 64;               // blocks packed at a time
constexpr std::size_t kWorkOfFilteredTransfer = 4;  // packing its block takes so many times as long

const gi::LightContent* contentOf(const std::shared_ptr<const gi::LightLattice>& lattice) {
  return lattice ? &lattice->content() : nullptr;
}

using Lattice = std::shared_ptr<const gi::LightLattice>;

// Whether the light that was there can be seen until that of `lattice` comes.
bool standsIn(const Lattice& before, const Lattice& lattice, const Lattice& was, const Lattice& wasBefore) {
  return lattice == was || (before && (before == was || before == wasBefore));
}

}  // namespace

LightAtlas::LightAtlas(GlPtr gl) : gl_(std::move(gl)), pages_(gl_), texels_(gl_) {
  GLint most = 0;
  gl_->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);  // words
  mostBufferBytes_ = static_cast<std::size_t>(std::max(most, 0)) * sizeof(std::uint32_t);
}

std::size_t LightAtlas::slotBytes() const {
  return static_cast<std::size_t>(layout_.words()) * gi::kTexelsOfBlock * sizeof(std::uint32_t);
}

std::size_t LightAtlas::mostSlots() const {
  const std::size_t pages = geometry_.blockCount() * sizeof(std::uint32_t);
  const std::size_t room =
      std::min(source_.budgetBytes - std::min(source_.budgetBytes, pages), mostBufferBytes_);
  return std::min<std::size_t>(room / slotBytes(), geometry_.blockCount());
}

bool LightAtlas::setSource(const Source& source) {
  const gi::PictureLight* const light = source.light.get();
  std::shared_ptr<const gi::LightLattice> sky = light ? light->sky : nullptr;
  std::shared_ptr<const gi::LightLattice> lamps = light ? light->lamps : nullptr;
  if (sky && lamps && !(sky->geometry() == lamps->geometry())) lamps = nullptr;
  const bool transfer = sky && sky->content().kind == gi::LightContent::Kind::transfer;
  std::shared_ptr<const gi::TransferBasis> basis = transfer ? light->basis : nullptr;
  const LightTexelLayout layout =
      lightTexelLayout(contentOf(sky), contentOf(lamps), basis.get(), source.precision, source.isovalues);
  if (layout.sky == LightPacking::none) sky = nullptr;
  const std::uint32_t wantedBefore = source_.light ? source_.light->samplesWanted : 0;
  const gi::OpenSky openSky = light ? gi::OpenSky(light->irradianceSh) : gi::OpenSky();
  const bool same = layout == layout_ && sky == sky_ && lamps == lamps_ && basis == basis_ &&
                    source.grid == source_.grid && source.filtered == source_.filtered &&
                    (!source.filtered || openSky.nearly(openSky_)) &&
                    (!light || light->samplesWanted == wantedBefore);
  const bool follows = layout == layout_ && !basis && source.grid == source_.grid &&
                       source.filtered == source_.filtered && openSky.nearly(openSky_) && light &&
                       light->samplesWanted == wantedBefore &&
                       standsIn(light->skyBefore, sky, sky_, skyBefore_) &&
                       standsIn(light->lampsBefore, lamps, lamps_, lampsBefore_);
  const bool moreRoom = source.budgetBytes > source_.budgetBytes;
  const bool tooMuch = source.budgetBytes < texels_.bytes();
  source_ = source;
  if ((same || follows) && !tooMuch) {
    const bool others = follow(sky, lamps);
    if (moreRoom)
      for (const std::uint32_t block : left_) queue(block);
    const bool grows = moreRoom && !left_.empty();
    if (moreRoom) left_.clear();
    return grows || others;
  }
  layout_ = layout;
  sky_ = std::move(sky);
  lamps_ = std::move(lamps);
  basis_ = std::move(basis);
  openSky_ = openSky;
  skyBefore_ = light ? light->skyBefore : nullptr;
  lampsBefore_ = light ? light->lampsBefore : nullptr;
  if (layout_.stores()) geometry_ = (sky_ ? sky_ : lamps_)->geometry();
  start();
  return true;
}

void LightAtlas::start() {
  skySeen_ = lampsSeen_ = 0;
  queue_.clear();
  queued_.clear();
  left_.clear();
  used_ = capacity_ = 0;
  texels_ = Buffer(gl_);
  pages_ = Buffer(gl_);
  slots_.assign(layout_.stores() ? geometry_.blockCount() : 0, 0);
  if (slots_.empty()) return;
  pages_.setData(slots_.data(), slots_.size() * sizeof(std::uint32_t));
  pagesTexture_ = BufferTexture(pages_, GL_R32UI);
  reserve(1);
  queueBefore();
}

// The lattices of another isovalue whose light is to be seen until they are lit; true if anything is new.
// What is resident stays until its block is uploaded anew.
bool LightAtlas::follow(const std::shared_ptr<const gi::LightLattice>& sky,
                        const std::shared_ptr<const gi::LightLattice>& lamps) {
  const gi::PictureLight* const light = source_.light.get();
  const auto skyBefore = light ? light->skyBefore : nullptr;
  const auto lampsBefore = light ? light->lampsBefore : nullptr;
  if (sky == sky_ && lamps == lamps_ && skyBefore == skyBefore_ && lampsBefore == lampsBefore_) return false;
  sky_ = sky;
  lamps_ = lamps;
  skyBefore_ = skyBefore;
  lampsBefore_ = lampsBefore;
  geometry_ = (sky_ ? sky_ : lamps_)->geometry();
  skySeen_ = lampsSeen_ = 0;
  for (std::uint32_t block = 0; block < slots_.size(); ++block)
    if (slots_[block] != 0) queue(block);
  queueBefore();
  return true;
}

void LightAtlas::queueBefore() {
  for (const auto& lattice : {skyBefore_, lampsBefore_})
    if (lattice)
      for (const std::uint32_t block : lattice->changedSince(0)) queue(block);
}

void LightAtlas::collect() {
  const auto cleared = [](const std::shared_ptr<const gi::LightLattice>& lattice, std::uint64_t seen) {
    return lattice && seen > 0 && lattice->clearedAt() > seen;
  };
  if (cleared(sky_, skySeen_) || cleared(lamps_, lampsSeen_)) start();
  const auto take = [&](const std::shared_ptr<const gi::LightLattice>& lattice, std::uint64_t& seen) {
    if (!lattice) return;
    const std::uint64_t now = lattice->revision();
    if (now == seen) return;
    const std::vector<std::uint32_t> changed = lattice->changedSince(seen);
    for (const std::uint32_t block : changed)
      if (left_.count(block) == 0) queue(block);
    if (source_.filtered)
      for (const std::uint32_t block : changed) queueNeighbours(block);
    seen = now;
  };
  take(sky_, skySeen_);
  take(lamps_, lampsSeen_);
}

void LightAtlas::queue(std::uint32_t block) {
  if (queued_.insert(block).second) queue_.push_back(block);
}

// Those that are resident: their texels at the border see this block's.
void LightAtlas::queueNeighbours(std::uint32_t block) {
  const glm::ivec3 dims = geometry_.blockDims(), own = geometry_.firstTexelOf(block) / gi::kBlockTexels;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 other = own + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    if (glm::any(glm::lessThan(other, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(other, dims)))
      continue;
    const std::uint32_t index = geometry_.blockOf(other * gi::kBlockTexels);
    if (slots_[index] != 0) queue(index);
  }
}

bool LightAtlas::reserve(std::size_t slots) {
  if (slots <= capacity_) return true;
  const std::size_t most = mostSlots();
  if (slots > most) return false;
  const std::size_t wanted = std::min(std::max({slots, 2 * capacity_, kFirstSlots}), most);
  Buffer larger(gl_);
  larger.setData(nullptr, wanted * slotBytes());
  if (used_ > 0)
    gl_->CopyNamedBufferSubData(texels_.id(), larger.id(), 0, 0,
                                static_cast<GLsizeiptr>(used_ * slotBytes()));
  texels_ = std::move(larger);
  texelsTexture_ = BufferTexture(texels_, layout_.words() % 2 == 0 ? GL_RG32UI : GL_R32UI);
  capacity_ = wanted;
  return true;
}

void LightAtlas::upload(const std::vector<std::uint32_t>& blocks) {
  const std::size_t wordsOfSlot = slotBytes() / sizeof(std::uint32_t);
  std::vector<std::uint32_t> words(blocks.size() * wordsOfSlot);
  std::vector<std::uint8_t> lit(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(),
                    [&](std::size_t i) { lit[i] = pack(blocks[i], &words[i * wordsOfSlot]) ? 1 : 0; });
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::uint32_t& slot = slots_[blocks[i]];
    if (!lit[i]) {  // cleared meanwhile, or of an isovalue long gone: zeros
      if (slot != 0) texels_.write((slot - 1) * slotBytes(), &words[i * wordsOfSlot], slotBytes());
      continue;
    }
    if (slot == 0) {
      if (!reserve(used_ + 1)) {
        left_.insert(blocks[i]);
        continue;
      }
      slot = static_cast<std::uint32_t>(++used_);
      pages_.write(blocks[i] * sizeof(std::uint32_t), &slot, sizeof slot);
    }
    texels_.write((slot - 1) * slotBytes(), &words[i * wordsOfSlot], slotBytes());
    ++uploaded_;
  }
}

void LightAtlas::update(std::size_t limitBytes) {
  uploaded_ = 0;
  if (!stores()) return;
  collect();
  const bool slow = source_.filtered && layout_.sky == LightPacking::codes;
  const std::size_t workBytes = slotBytes() * (slow ? kWorkOfFilteredTransfer : 1);
  const std::size_t most = limitBytes == 0 ? queue_.size() : std::max<std::size_t>(1, limitBytes / workBytes);
  std::vector<std::uint32_t> blocks;
  for (std::size_t done = 0; done < most && !queue_.empty(); done += blocks.size()) {
    blocks.clear();
    while (!queue_.empty() && blocks.size() < std::min(kTogether, most - done)) {
      blocks.push_back(queue_.front());
      queued_.erase(queue_.front());
      queue_.pop_front();
    }
    upload(blocks);
  }
}

void LightAtlas::bind(Program& program, int unit) const {
  program.setTexture("uLightPages", unit, pagesTexture_);
  program.setTexture("uLightTexels", unit + 1, texelsTexture_);
}

}  // namespace isolux::render
