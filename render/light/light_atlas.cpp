#include "render/light/light_atlas.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "volume/parallel/parallel_loops.h"

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

bool follows(const gi::StoredSide& light, const gi::StoredSide& was) {
  return standsIn(light.skyBefore, light.sky, was.sky, was.skyBefore) &&
         standsIn(light.lampsBefore, light.lamps, was.lamps, was.lampsBefore);
}

// Of the inner side: what has the geometry and the contents of the outer side's.
Lattice alike(const Lattice& lattice, const Lattice& outer) {
  const bool fits =
      lattice && outer && lattice->geometry() == outer->geometry() && lattice->content() == outer->content();
  return fits ? lattice : nullptr;
}

gi::StoredSide outerOf(const gi::PictureLight& light) {
  gi::StoredSide side = light;
  if (side.sky && side.lamps && !(side.sky->geometry() == side.lamps->geometry())) side.lamps = nullptr;
  return side;
}

gi::StoredSide innerOf(const gi::PictureLight& light, const gi::StoredSide& outer) {
  gi::StoredSide inner = light.inner;
  inner.sky = alike(inner.sky, outer.sky);
  inner.lamps = alike(inner.lamps, outer.lamps);
  // A texel has all parts of its layout.
  if (!inner.sky == !outer.sky && !inner.lamps == !outer.lamps) return inner;
  return {};
}

// Unoccluded irradiance of the sky as it is stored, the mean over all normals.
double meanOfOpenSky(const gi::PictureLight& light) {
  constexpr float firstHarmonic = 0.2820948f;
  double most = 0.0;
  for (int c = 0; c < 3; ++c)
    if (light.skyScale[c] > 0.0f)
      most =
          std::max(most, static_cast<double>(firstHarmonic * light.irradianceSh[0][c] / light.skyScale[c]));
  return most;
}

}  // namespace

LightAtlas::LightAtlas(GlPtr gl)
    : gl_(std::move(gl)),
      pages_(gl_),
      texels_(gl_),
      mostBufferBytes_(static_cast<std::size_t>(std::max(gl_->maxBufferTexels, 0)) * sizeof(std::uint32_t)) {}

std::size_t LightAtlas::slotBytes() const {
  return static_cast<std::size_t>(layout_.words()) * gi::kTexelsOfBlock * sizeof(std::uint32_t);
}

std::size_t LightAtlas::mostSlots() const {
  const std::size_t pages = slots_.size() * sizeof(std::uint32_t);
  const std::size_t room =
      std::min(source_.budgetBytes - std::min(source_.budgetBytes, pages), mostBufferBytes_);
  return std::min<std::size_t>(room / slotBytes(), slots_.size());
}

bool LightAtlas::setSource(const Source& source) {
  const gi::PictureLight* const light = source.light.get();
  gi::StoredSide outer = light ? outerOf(*light) : gi::StoredSide();
  const bool transfer = outer.sky && outer.sky->content().kind == gi::LightContent::Kind::transfer;
  std::shared_ptr<const gi::TransferBasis> basis = transfer ? light->basis : nullptr;
  LightTexelLayout layout = lightTexelLayout(contentOf(outer.sky), contentOf(outer.lamps), basis.get(),
                                             source.precision, source.isovalues);
  if (light) layout.skyUnit = lightUnit(meanOfOpenSky(*light));
  if (light) layout.lampsUnit = lightUnit(static_cast<double>(light->lampsIrradiance));
  if (layout.sky == LightPacking::none) outer.sky = nullptr;
  const gi::StoredSide inner = light ? innerOf(*light, outer) : gi::StoredSide();
  const std::uint32_t wantedBefore = source_.light ? source_.light->samplesWanted : 0;
  const gi::OpenSky openSky = light ? gi::OpenSky(light->irradianceSh) : gi::OpenSky();
  const gi::StoredSide& was = sides_[kOuter].light;
  const bool same = layout == layout_ && outer.sky == was.sky && outer.lamps == was.lamps &&
                    basis == basis_ && source.grid == source_.grid && source.filtered == source_.filtered &&
                    (!source.filtered || openSky.nearly(openSky_)) &&
                    (!light || light->samplesWanted == wantedBefore);
  const bool followed = layout == layout_ && !basis && source.grid == source_.grid &&
                        source.filtered == source_.filtered && openSky.nearly(openSky_) && light &&
                        light->samplesWanted == wantedBefore && follows(outer, was);
  const bool moreRoom = source.budgetBytes > source_.budgetBytes;
  const bool tooMuch = source.budgetBytes < texels_.bytes();
  source_ = source;
  if ((same || followed) && !tooMuch) {
    const bool otherOuter = follow(sides_[kOuter], outer), otherInner = follow(sides_[kInner], inner);
    if (moreRoom)
      for (const std::uint32_t page : left_) queue(page);
    const bool grows = moreRoom && !left_.empty();
    if (moreRoom) left_.clear();
    return grows || otherOuter || otherInner;
  }
  layout_ = layout;
  basis_ = std::move(basis);
  openSky_ = openSky;
  if (layout_.stores()) geometry_ = (outer.sky ? outer.sky : outer.lamps)->geometry();
  sides_[kOuter] = {std::move(outer), 0, 0, 0};
  sides_[kInner] = {inner, layout_.stores() ? geometry_.blockCount() : 0, 0, 0};
  start();
  return true;
}

void LightAtlas::start() {
  for (Side& side : sides_) side.skySeen = side.lampsSeen = 0;
  queue_.clear();
  queued_.clear();
  left_.clear();
  free_.clear();
  used_ = capacity_ = 0;
  texels_ = Buffer(gl_);
  pages_ = Buffer(gl_);
  slots_.clear();
  if (!layout_.stores()) return;
  makePages();
  reserve(1);
  for (const Side& side : sides_) queueBefore(side);
}

// As many as are needed: the inner side's once it has light.
void LightAtlas::makePages() {
  const std::size_t wanted = geometry_.blockCount() * (hasInner() ? 2u : 1u);
  if (slots_.size() >= wanted) return;
  slots_.resize(wanted, 0);
  pages_.setData(slots_.data(), slots_.size() * sizeof(std::uint32_t));
  pagesTexture_ = BufferTexture(pages_, GL_R32UI);
}

// Nothing of the side is resident then.
void LightAtlas::freePages(const Side& side) {
  bool any = false;
  for (std::uint32_t page = side.first;
       page < std::min<std::size_t>(side.first + geometry_.blockCount(), slots_.size()); ++page) {
    if (slots_[page] == 0) continue;
    free_.push_back(std::exchange(slots_[page], 0u));
    any = true;
  }
  if (any) pages_.write(0, slots_.data(), slots_.size() * sizeof(std::uint32_t));
}

// Takes over the lattices of a side; true if they are others. Until a resident block is uploaded anew what is
// there is seen, if the new light says that it may stand in.
bool LightAtlas::follow(Side& side, const gi::StoredSide& light) {
  if (light == side.light || !layout_.stores()) return false;
  if (!follows(light, side.light)) freePages(side);
  side.light = light;
  side.skySeen = side.lampsSeen = 0;
  if (light.sky || light.lamps) geometry_ = (light.sky ? light.sky : light.lamps)->geometry();
  makePages();
  for (std::uint32_t block = 0; block < geometry_.blockCount(); ++block)
    if (const std::uint32_t page = side.first + block; page < slots_.size() && slots_[page] != 0) queue(page);
  queueBefore(side);
  return true;
}

void LightAtlas::queueBefore(const Side& side) {
  for (const auto& lattice : {side.light.skyBefore, side.light.lampsBefore})
    if (lattice)
      for (const std::uint32_t block : lattice->changedSince(0)) queue(side.first + block);
}

void LightAtlas::collect() {
  const auto cleared = [](const Lattice& lattice, std::uint64_t seen) {
    return lattice && seen > 0 && lattice->clearedAt() > seen;
  };
  for (const Side& side : sides_)
    if (cleared(side.light.sky, side.skySeen) || cleared(side.light.lamps, side.lampsSeen)) {
      start();
      break;
    }
  const auto take = [&](const Side& side, const Lattice& lattice, std::uint64_t& seen) {
    if (!lattice) return;
    const std::uint64_t now = lattice->revision();
    if (now == seen) return;
    const std::vector<std::uint32_t> changed = lattice->changedSince(seen);
    for (const std::uint32_t block : changed)
      if (left_.count(side.first + block) == 0) queue(side.first + block);
    if (source_.filtered)
      for (const std::uint32_t block : changed) queueNeighbours(side, block);
    seen = now;
  };
  for (Side& side : sides_) {
    take(side, side.light.sky, side.skySeen);
    take(side, side.light.lamps, side.lampsSeen);
  }
}

void LightAtlas::queue(std::uint32_t page) {
  if (queued_.insert(page).second) queue_.push_back(page);
}

// Those that are resident: their texels at the border see this block's.
void LightAtlas::queueNeighbours(const Side& side, std::uint32_t block) {
  const glm::ivec3 dims = geometry_.blockDims(), own = geometry_.firstTexelOf(block) / gi::kBlockTexels;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 other = own + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    if (glm::any(glm::lessThan(other, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(other, dims)))
      continue;
    const std::uint32_t page = side.first + geometry_.blockOf(other * gi::kBlockTexels);
    if (slots_[page] != 0) queue(page);
  }
}

bool LightAtlas::reserve(std::size_t slots) {
  if (slots <= capacity_) return true;
  const std::size_t most = mostSlots();
  if (slots > most) return false;
  const std::size_t wanted = std::min(std::max({slots, 2 * capacity_, kFirstSlots}), most);
  Buffer larger(gl_);
  larger.setData(nullptr, wanted * slotBytes());
  constexpr std::size_t mostAtOnce = std::size_t{1} << 25;  // bytes: a few milliseconds of a card
  for (std::size_t from = 0; from < used_ * slotBytes(); from += mostAtOnce) {
    const auto bytes = static_cast<GLsizeiptr>(std::min(mostAtOnce, used_ * slotBytes() - from));
    gl_->CopyNamedBufferSubData(texels_.id(), larger.id(), static_cast<GLintptr>(from),
                                static_cast<GLintptr>(from), bytes);
    gl_->Flush();
  }
  texels_ = std::move(larger);
  texelsTexture_ = BufferTexture(texels_, layout_.words() % 2 == 0 ? GL_RG32UI : GL_R32UI);
  capacity_ = wanted;
  return true;
}

std::uint32_t LightAtlas::newSlot() {
  if (!free_.empty()) {
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  return reserve(used_ + 1) ? static_cast<std::uint32_t>(++used_) : 0;
}

void LightAtlas::upload(const std::vector<std::uint32_t>& pages) {
  const std::size_t wordsOfSlot = slotBytes() / sizeof(std::uint32_t);
  std::vector<std::uint32_t> words(pages.size() * wordsOfSlot);
  std::vector<std::uint8_t> lit(pages.size());
  volume::parallelEach(pages.size(),
                       [&](std::size_t i) { lit[i] = pack(pages[i], &words[i * wordsOfSlot]) ? 1 : 0; });
  for (std::size_t i = 0; i < pages.size(); ++i) {
    std::uint32_t& slot = slots_[pages[i]];
    if (!lit[i]) {  // cleared meanwhile, or of an isovalue long gone: zeros
      if (slot != 0) texels_.write((slot - 1) * slotBytes(), &words[i * wordsOfSlot], slotBytes());
      continue;
    }
    if (slot == 0) {
      slot = newSlot();
      if (slot == 0) {
        left_.insert(pages[i]);
        continue;
      }
      pages_.write(pages[i] * sizeof(std::uint32_t), &slot, sizeof slot);
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
  std::vector<std::uint32_t> pages;
  for (std::size_t done = 0; done < most && !queue_.empty(); done += pages.size()) {
    pages.clear();
    while (!queue_.empty() && pages.size() < std::min(kTogether, most - done)) {
      pages.push_back(queue_.front());
      queued_.erase(queue_.front());
      queue_.pop_front();
    }
    upload(pages);
  }
}

void LightAtlas::bind(Program& program, int unit) const {
  program.setTexture("uLightPages", unit, pagesTexture_);
  program.setTexture("uLightTexels", unit + 1, texelsTexture_);
  program.set("uInnerPages", hasInner() ? static_cast<int>(sides_[kInner].first) : -1);
}

}  // namespace isolux::render
