// From blocks of the lattices to the words of a slot.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "render/gl/constants.h"
#include "render/light/light_atlas.h"
#include "volume/field/reconstruct.h"

namespace isolux::render {

namespace {

// A texel with this many paths, or all that are wanted, has its whole weight.
constexpr std::uint32_t kPathsOfFullWeight = 16;

// The isovalues of the texels around a block of the light lattice, each computed once, and the field's shape
// at the block's texels and their neighbours.
class IsovaluesAbout {
 public:
  // Returns the isovalue of a texel within the lattice, NaN if a voxel is missing.
  using IsovalueOf = std::function<float(glm::ivec3)>;
  IsovaluesAbout(const gi::LatticeGeometry& lattice, std::uint32_t block, IsovalueOf isovalueOf)
      : lattice_(lattice), first_(lattice.firstTexelOf(block) - kReach), isovalueOf_(std::move(isovalueOf)) {}

  float at(glm::ivec3 texel) {  // NaN outside the lattice
    const glm::ivec3 step = texel - first_;
    const std::size_t i = volume::Extent3{glm::ivec3(kEdge)}.index(step);
    if (!known_[i]) {
      isovalues_[i] = lattice_.contains(texel) ? isovalueOf_(texel) : std::numeric_limits<float>::quiet_NaN();
      known_[i] = true;
    }
    return isovalues_[i];
  }
  FieldShape shapeAt(glm::ivec3 t) {
    const glm::ivec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    return fieldShape(at(t), {at(t - x), at(t - y), at(t - z)}, {at(t + x), at(t + y), at(t + z)});
  }

 private:
  static constexpr int kReach = kFilterBorder + 1, kEdge = gi::kBlockTexels + 2 * kReach;
  static constexpr std::size_t kTexels = std::size_t{kEdge} * kEdge * kEdge;

  const gi::LatticeGeometry& lattice_;
  glm::ivec3 first_;
  IsovalueOf isovalueOf_;
  std::vector<bool> known_ = std::vector<bool>(kTexels);
  std::array<float, kTexels> isovalues_;
};

// A block with the texels of `before` where there are none yet.
std::shared_ptr<const gi::LatticeBlock> blockOf(const std::shared_ptr<const gi::LightLattice>& lattice,
                                                const std::shared_ptr<const gi::LightLattice>& before,
                                                std::uint32_t block) {
  if (!lattice) return nullptr;
  std::shared_ptr<const gi::LatticeBlock> now = lattice->at(block);
  const std::shared_ptr<const gi::LatticeBlock> then = before ? before->at(block) : nullptr;
  if (!now || !then) return now ? now : then;
  gi::LatticeBlock both = *now;
  const auto components = static_cast<std::size_t>(lattice->content().components());
  for (std::size_t i = 0; i < gi::kTexelsOfBlock; ++i) {
    if (both.samples[i] > 0 || both.unlit[i] || then->samples[i] == 0) continue;
    both.samples[i] = then->samples[i];
    both.normals[i] = then->normals[i];
    if (!both.places.empty()) both.places[i] = then->places[i];
    std::copy_n(&then->means[i * components], components, &both.means[i * components]);
  }
  return std::make_shared<const gi::LatticeBlock>(std::move(both));
}

}  // namespace

float LightAtlas::isovalueOf(glm::ivec3 texel) const {
  const volume::Grid& grid = *source_.grid;
  double stored;
  if (geometry_.dims == geometry_.volumeDims)
    stored = grid.stored(texel);
  else
    stored = grid.storedOfValue(volume::sampleTrilinear(grid, geometry_.voxelOf(texel)).value);
  return static_cast<float>(stored);
}

std::vector<FilterTexel> LightAtlas::texelsAbout(
    std::uint32_t page, std::vector<std::shared_ptr<const gi::LatticeBlock>>& kept) const {
  constexpr int edge = kFilterTexels;
  const Side& side = sideOf(page);
  const gi::StoredSide& stored = side.light;
  const std::uint32_t block = page - side.first;
  const volume::Extent3 extent{glm::ivec3(edge)};
  std::vector<FilterTexel> texels(extent.count());
  const glm::ivec3 first = geometry_.firstTexelOf(block) - kFilterBorder;
  IsovaluesAbout isovalues(geometry_, block, [this](glm::ivec3 texel) { return isovalueOf(texel); });
  std::uint32_t before = ~0u;
  std::shared_ptr<const gi::LatticeBlock> sky, lamps;
  const auto light = [](const gi::LightLattice& lattice, const gi::LatticeBlock& from, std::size_t i) {
    const auto channels = static_cast<std::size_t>(lattice.content().channels);
    const float* const e = &from.means[i * channels];
    return channels == 3 ? glm::vec3(e[0], e[1], e[2]) : glm::vec3(e[0]);
  };
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const glm::ivec3 texel = first + extent.at(i);
    FilterTexel& out = texels[i];
    if (!geometry_.contains(texel)) continue;  // no light of its own
    const std::uint32_t of = geometry_.blockOf(texel);
    if (of != before) {
      sky = blockOf(stored.sky, stored.skyBefore, of);
      lamps = blockOf(stored.lamps, stored.lampsBefore, of);
      before = of;
      if (sky) kept.push_back(sky);
    }
    const auto at = static_cast<std::size_t>(gi::LatticeGeometry::indexInBlock(texel));
    const auto stand = [&](const gi::LatticeBlock& from) {
      out.normal = from.normals[at];
      out.place =
          from.places.empty() ? glm::vec3(texel) : glm::vec3(geometry_.texelOf(glm::dvec3(from.places[at])));
    };
    if (lamps && lamps->samples[at] > 0) {
      stand(*lamps);
      out.lampsPaths = static_cast<float>(lamps->samples[at]);
      out.lamps = light(*stored.lamps, *lamps, at);
    }
    if (sky && sky->samples[at] > 0) {
      stand(*sky);
      out.skyPaths = static_cast<float>(sky->samples[at]);
      if (layout_.sky == LightPacking::codes)
        out.transfer = &sky->means[at * static_cast<std::size_t>(stored.sky->content().components())];
      else
        out.sky = light(*stored.sky, *sky, at) / openSky_.at(out.normal);
    }
    if (out.normal == glm::vec3(0.0f)) continue;
    out.isovalue = geometry_.isovalue ? 0.0f : isovalues.at(texel);
    out.shape = geometry_.isovalue ? FieldShape{1.0f, 0.0f} : isovalues.shapeAt(texel);
  }
  return texels;
}

bool LightAtlas::pack(std::uint32_t page, std::uint32_t* words) const {
  const Side& side = sideOf(page);
  const gi::StoredSide& stored = side.light;
  const std::uint32_t block = page - side.first;
  const std::shared_ptr<const gi::LatticeBlock> sky = blockOf(stored.sky, stored.skyBefore, block);
  const std::shared_ptr<const gi::LatticeBlock> lamps = blockOf(stored.lamps, stored.lampsBefore, block);
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
    const std::vector<FilterTexel> texels = texelsAbout(page, kept);
    if (layout_.sky != LightPacking::codes || stored.lamps)
      smooth = filterBlock(texels, geometry_.firstTexelOf(block) - kFilterBorder);
    if (layout_.sky == LightPacking::codes)
      smoothTransfer = filterTransfer(texels, static_cast<std::size_t>(stored.sky->content().components()));
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
    if (stored.sky) {
      const gi::LightContent& content = stored.sky->content();
      const std::size_t from = i * static_cast<std::size_t>(content.components());
      if (skyLit)
        packLight(layout_.sky,
                  holdsPartsOfOpenSky()     ? &smooth[i].sky[0]
                  : !smoothTransfer.empty() ? &smoothTransfer[from]
                                            : &sky->means[from],
                  layout_.skyUnit, content, basis_.get(), next);
      next += layout_.wordsOf(layout_.sky);
    }
    if (stored.lamps) {
      const gi::LightContent& content = stored.lamps->content();
      if (lampsLit && source_.filtered)
        packLight(layout_.lamps, &smooth[i].lamps[0], layout_.lampsUnit, content, nullptr, next);
      else if (lampsLit)
        packLight(layout_.lamps, &lamps->means[i * static_cast<std::size_t>(content.components())],
                  layout_.lampsUnit, content, nullptr, next);
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

}  // namespace isolux::render
