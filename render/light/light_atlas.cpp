#include "render/light/light_atlas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <tbb/parallel_for.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "render/constants.h"
#include "render/light/isovalues_about.h"
#include "volume/field/reconstruct.h"

namespace isolux::render {

namespace {

constexpr std::size_t kFirstSlots = 64;
constexpr std::size_t kTogether = 64;               // blocks packed at a time
constexpr std::size_t kWorkOfFilteredTransfer = 4;  // packing its block takes so many times as long
// A texel with this many paths, or all that are wanted, has its whole weight.
constexpr std::uint32_t kPathsOfFullWeight = 16;

const gi::LightContent* contentOf(const std::shared_ptr<const gi::LightLattice>& lattice) {
  return lattice ? &lattice->content() : nullptr;
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
  const bool same = layout == layout_ && sky == sky_ && lamps == lamps_ && basis == basis_ &&
                    source.grid == source_.grid && source.filtered == source_.filtered &&
                    (!light || light->samplesWanted == wantedBefore);
  const bool moreRoom = source.budgetBytes > source_.budgetBytes;
  const bool tooMuch = source.budgetBytes < texels_.bytes();
  source_ = source;
  if (same && !tooMuch) {
    if (moreRoom)
      for (const std::uint32_t block : left_) queue(block);
    const bool grows = moreRoom && !left_.empty();
    if (moreRoom) left_.clear();
    return grows;
  }
  layout_ = layout;
  sky_ = std::move(sky);
  lamps_ = std::move(lamps);
  basis_ = std::move(basis);
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

float LightAtlas::isovalueOf(glm::ivec3 texel) const {
  const volume::Grid& grid = *source_.grid;
  double stored;
  if (geometry_.dims == geometry_.volumeDims)
    stored = grid.stored(texel.x, texel.y, texel.z);
  else
    stored = grid.storedOfValue(volume::sampleTrilinear(grid, geometry_.voxelOf(texel)).value);
  return static_cast<float>(stored);
}

std::vector<FilterTexel> LightAtlas::texelsAbout(
    std::uint32_t block, std::vector<std::shared_ptr<const gi::LatticeBlock>>& kept) const {
  constexpr int edge = kFilterTexels;
  std::vector<FilterTexel> texels(static_cast<std::size_t>(edge * edge * edge));
  const glm::ivec3 first = geometry_.firstTexelOf(block) - 1;
  IsovaluesAbout isovalues(geometry_, block, [this](glm::ivec3 texel) { return isovalueOf(texel); });
  std::uint32_t before = ~0u;
  std::shared_ptr<const gi::LatticeBlock> sky, lamps;
  const auto light = [](const gi::LightLattice& lattice, const gi::LatticeBlock& from, std::size_t i) {
    const auto channels = static_cast<std::size_t>(lattice.content().channels);
    const float* const e = &from.means[i * channels];
    return channels == 3 ? glm::vec3(e[0], e[1], e[2]) : glm::vec3(e[0]);
  };
  for (int i = 0; i < edge * edge * edge; ++i) {
    const glm::ivec3 step(i % edge, i / edge % edge, i / (edge * edge));
    const glm::ivec3 texel = glm::clamp(first + step, glm::ivec3(0), geometry_.dims - 1);
    FilterTexel& out = texels[static_cast<std::size_t>(i)];
    if (texel != first + step) continue;  // outside: no light of its own
    const std::uint32_t of = geometry_.blockOf(texel);
    if (of != before) {
      sky = sky_ ? sky_->at(of) : nullptr;
      lamps = lamps_ ? lamps_->at(of) : nullptr;
      before = of;
      if (sky) kept.push_back(sky);
    }
    const auto at = static_cast<std::size_t>(gi::LatticeGeometry::indexInBlock(texel));
    if (lamps && lamps->samples[at] > 0) {
      out.normal = lamps->normals[at];
      out.lampsPaths = static_cast<float>(lamps->samples[at]);
      out.lamps = light(*lamps_, *lamps, at);
    }
    if (sky && sky->samples[at] > 0) {
      out.normal = sky->normals[at];
      out.skyPaths = static_cast<float>(sky->samples[at]);
      if (layout_.sky == LightPacking::codes)
        out.transfer = &sky->means[at * static_cast<std::size_t>(sky_->content().components())];
      else
        out.sky = light(*sky_, *sky, at);
    }
    if (out.normal == glm::vec3(0.0f)) continue;
    out.isovalue = isovalues.at(texel);
    out.shape = isovalues.shapeAt(texel);
  }
  return texels;
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

bool LightAtlas::pack(std::uint32_t block, std::uint32_t* words) const {
  const std::shared_ptr<const gi::LatticeBlock> sky = sky_ ? sky_->at(block) : nullptr;
  const std::shared_ptr<const gi::LatticeBlock> lamps = lamps_ ? lamps_->at(block) : nullptr;
  if (!sky && !lamps) return false;
  const std::uint32_t whole = std::clamp(source_.light->samplesWanted, 1u, kPathsOfFullWeight);
  // A texel without a normal counts as baked, with no light: nothing better will come.
  const auto fraction = [&](const gi::LatticeBlock* from, std::size_t i) {
    if (!from) return 0.0f;
    if (from->unlit[i]) return 1.0f;
    return std::min(1.0f, static_cast<float>(from->samples[i]) / static_cast<float>(whole));
  };
  const int stride = layout_.words();
  std::vector<FilterTexel> smooth;
  std::vector<float> smoothTransfer;
  if (source_.filtered) {
    std::vector<std::shared_ptr<const gi::LatticeBlock>> kept;
    const std::vector<FilterTexel> texels = texelsAbout(block, kept);
    if (layout_.sky != LightPacking::codes || lamps_) smooth = filterBlock(texels);
    if (layout_.sky == LightPacking::codes)
      smoothTransfer = filterTransfer(texels, static_cast<std::size_t>(sky_->content().components()));
  }
  for (std::size_t i = 0; i < gi::kTexelsOfBlock; ++i) {
    std::uint32_t* const out = words + i * static_cast<std::size_t>(stride);
    std::fill_n(out, stride, 0u);
    const float skyPart = fraction(sky.get(), i), lampsPart = fraction(lamps.get(), i);
    if (skyPart == 0.0f && lampsPart == 0.0f) continue;
    const bool skyLit = sky && sky->samples[i] > 0, lampsLit = lamps && lamps->samples[i] > 0;
    const glm::vec3 normal = skyLit ? sky->normals[i] : lampsLit ? lamps->normals[i] : glm::vec3(0.0f);
    out[0] = packTexelState(normal, skyPart, lampsPart);
    std::uint32_t* next = out + 1;
    if (sky_) {
      const gi::LightContent& content = sky_->content();
      const std::size_t first = i * static_cast<std::size_t>(content.components());
      if (skyLit)
        packLight(layout_.sky,
                  !smoothTransfer.empty() ? &smoothTransfer[first]
                  : !smooth.empty()       ? &smooth[i].sky[0]
                                          : &sky->means[first],
                  content, basis_.get(), next);
      next += layout_.wordsOf(layout_.sky);
    }
    if (lamps_) {
      const gi::LightContent& content = lamps_->content();
      if (lampsLit && source_.filtered)
        packLight(layout_.lamps, &smooth[i].lamps[0], content, nullptr, next);
      else if (lampsLit)
        packLight(layout_.lamps, &lamps->means[i * static_cast<std::size_t>(content.components())], content,
                  nullptr, next);
      next += layout_.wordsOf(layout_.lamps);
    }
    if (layout_.isovalue) {
      const float isovalue = isovalueOf(geometry_.texelOf(block, static_cast<int>(i)));
      const float value = std::isfinite(isovalue) ? isovalue : missingTexel;
      std::memcpy(next, &value, sizeof value);
    }
  }
  return true;
}

void LightAtlas::upload(const std::vector<std::uint32_t>& blocks) {
  const std::size_t wordsOfSlot = slotBytes() / sizeof(std::uint32_t);
  std::vector<std::uint32_t> words(blocks.size() * wordsOfSlot);
  std::vector<std::uint8_t> lit(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(),
                    [&](std::size_t i) { lit[i] = pack(blocks[i], &words[i * wordsOfSlot]) ? 1 : 0; });
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!lit[i]) continue;  // cleared meanwhile
    std::uint32_t& slot = slots_[blocks[i]];
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
