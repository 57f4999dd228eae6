// Stored light on the GPU: those blocks of the light lattices that exist, in slots of a buffer, and a page
// table that says which slot is whose.
//
// Both lattices of a side, the sky's and the lamps', have the same geometry and share slots. The inner side's
// blocks have pages of their own behind the outer side's, once there are any. Only what has
// changed since the last update() is uploaded. A block that finds no room is left out; light there is local.
// Reads LightLattice from the GL thread while bakes go on. Texels are render/light/light_texel.h's, x
// fastest, 512 a slot. Wyman et al. 2006 sec. 4.2 keeps one texture over the whole volume.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_set>
#include <vector>

#include "gi/harmonics/open_sky.h"
#include "gi/picture_light.h"
#include "render/gl/gl_objects.h"
#include "render/light/light_filter.h"
#include "render/light/light_texel.h"
#include "volume/grid.h"

namespace isolux::render {

class LightAtlas {
 public:
  explicit LightAtlas(GlPtr gl);

  // What the atlas holds from now on. Where that differs in kind from what it held, it starts empty.
  // `grid` is what texels take their isovalues from, where `isovalues` or `filtered` ask for them.
  struct Source {
    std::shared_ptr<const gi::PictureLight> light;  // null: nothing
    scene::GiPrecision precision = scene::GiPrecision::r11g11b10;
    bool isovalues = false;
    // Light without its noise (render/light/light_filter.h); the sky's irradiance as parts of gi::OpenSky.
    bool filtered = false;
    std::shared_ptr<const volume::Grid> grid;
    std::size_t budgetBytes = 0;
  };
  bool setSource(const Source& source);  // true: update() has something to do
  bool stores() const { return layout_.stores(); }
  const LightTexelLayout& layout() const { return layout_; }
  const gi::LatticeGeometry& geometry() const { return geometry_; }
  bool hasInner() const { return sides_[kInner].light.sky || sides_[kInner].light.lamps; }
  const std::shared_ptr<const volume::Grid>& grid() const { return source_.grid; }
  bool holdsPartsOfOpenSky() const { return source_.filtered && storesSkyIrradiance(); }
  const gi::OpenSky& openSky() const { return openSky_; }

  // Uploads what has changed, at most `limitBytes` but at least one block (0: all of it). Throws
  // base::Error{memory}.
  void update(std::size_t limitBytes);
  bool pending() const { return !queue_.empty(); }

  // uLightPages and uLightTexels, in units `unit` and unit + 1; uInnerPages.
  void bind(Program& program, int unit) const;

  std::size_t bytes() const { return pages_.bytes() + texels_.bytes(); }
  std::size_t resident() const { return used_ - free_.size(); }  // blocks
  std::size_t withoutRoom() const { return left_.size(); }       // blocks that exist but do not fit
  std::size_t uploaded() const { return uploaded_; }             // by the last update()

 private:
  bool storesSkyIrradiance() const {
    return layout_.sky != LightPacking::none && layout_.sky != LightPacking::codes;
  }
  // Of one side of the surfaces. Its block b has the page first + b.
  struct Side {
    gi::StoredSide light;
    std::uint32_t first = 0;
    std::uint64_t skySeen = 0, lampsSeen = 0;  // revisions
  };
  void start();  // empty
  bool follow(Side& side, const gi::StoredSide& light);
  void makePages();
  void freePages(const Side& side);
  void queueBefore(const Side& side);
  void collect();
  void queue(std::uint32_t page);
  void queueNeighbours(const Side& side, std::uint32_t block);
  const Side& sideOf(std::uint32_t page) const {
    return page < geometry_.blockCount() ? sides_[kOuter] : sides_[kInner];
  }
  float isovalueOf(glm::ivec3 texel) const;  // stored units; NaN: a voxel is missing
  // A block's texels and those about it; transfer vectors are those of `kept`.
  std::vector<FilterTexel> texelsAbout(std::uint32_t page,
                                       std::vector<std::shared_ptr<const gi::LatticeBlock>>& kept) const;
  bool reserve(std::size_t slots);  // room for so many, false where that is not to be had
  std::size_t slotBytes() const;
  std::size_t mostSlots() const;
  std::uint32_t newSlot();                                    // plus 1; 0: there is no room
  bool pack(std::uint32_t page, std::uint32_t* words) const;  // false: nothing is lit there
  void upload(const std::vector<std::uint32_t>& pages);

  GlPtr gl_;
  Source source_;
  LightTexelLayout layout_;
  gi::LatticeGeometry geometry_;
  static constexpr std::size_t kOuter = 0, kInner = 1;
  std::array<Side, 2> sides_;
  std::shared_ptr<const gi::TransferBasis> basis_;
  gi::OpenSky openSky_;
  std::deque<std::uint32_t> queue_;  // pages that wait for their upload, each once
  std::unordered_set<std::uint32_t> queued_, left_;
  std::vector<std::uint32_t> slots_;  // of each page, plus 1; 0: none
  std::vector<std::uint32_t> free_;   // slots that were used, plus 1
  Buffer pages_, texels_;
  BufferTexture pagesTexture_, texelsTexture_;
  std::size_t capacity_ = 0, used_ = 0, uploaded_ = 0;  // slots, with the free ones; blocks
  std::size_t mostBufferBytes_ = 0;
};

}  // namespace isolux::render
