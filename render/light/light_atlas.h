// Stores baked lighting on the GPU: existing blocks of the light lattices in slots of a buffer, and a page
// table from blocks to slots.
//
// The two lattices of a side, of the sky and of the light sources, have the same geometry and share slots.
// Blocks of back faces, if any, have separate pages after those of front faces. update() uploads only blocks
// that changed since the last call. It omits blocks that do not fit; unshadowed light replaces them. Reads
// LightLattice on the GL thread while bakes run. Texels are those of render/light/light_texel.h, x fastest,
// 512 per slot. Wyman et al. 2006 sec. 4.2 keeps one texture over the whole volume.
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

  // The contents of the atlas. If they differ in kind from the present ones, the atlas starts empty. Texels
  // take their isovalues from `grid` if `isovalues` or `filtered` require them.
  struct Source {
    std::shared_ptr<const gi::PictureLight> light;  // null: nothing
    scene::GiPrecision precision = scene::GiPrecision::r11g11b10;
    bool isovalues = false;
    // Denoise the light (render/light/light_filter.h); the sky's irradiance is then a fraction of
    // gi::OpenSky.
    bool filtered = false;
    std::shared_ptr<const volume::Grid> grid;
    std::size_t budgetBytes = 0;
  };
  bool setSource(const Source& source);  // returns whether update() has something to do
  bool stores() const { return layout_.stores(); }
  const LightTexelLayout& layout() const { return layout_; }
  const gi::LatticeGeometry& geometry() const { return geometry_; }
  bool hasInner() const { return sides_[kInner].light.sky || sides_[kInner].light.lamps; }
  const std::shared_ptr<const volume::Grid>& grid() const { return source_.grid; }
  bool holdsPartsOfOpenSky() const { return source_.filtered && storesSkyIrradiance(); }
  const gi::OpenSky& openSky() const { return openSky_; }

  // Uploads changes, at most `limitBytes` but at least one block (0: no limit). Throws base::Error{memory}.
  void update(std::size_t limitBytes);
  bool pending() const { return !queue_.empty(); }

  // Binds uLightPages and uLightTexels to the units `unit` and `unit` + 1, and sets uInnerPages.
  void bind(Program& program, int unit) const;

  std::size_t bytes() const { return pages_.bytes() + texels_.bytes(); }
  std::size_t resident() const { return used_ - free_.size(); }  // blocks
  std::size_t withoutRoom() const { return left_.size(); }       // existing blocks that do not fit
  std::size_t uploaded() const { return uploaded_; }             // by the last update()

 private:
  bool storesSkyIrradiance() const {
    return layout_.sky != LightPacking::none && layout_.sky != LightPacking::codes;
  }
  // One side of the surfaces. Its block b has the page first + b.
  struct Side {
    gi::StoredSide light;
    std::uint32_t first = 0;
    std::uint64_t skySeen = 0, lampsSeen = 0;  // revisions
  };
  void start();  // resets to empty
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
  float isovalueOf(glm::ivec3 texel) const;  // stored units; NaN if a voxel is missing
  // Returns a block's texels and their neighbours; transfer vectors point into `kept`.
  std::vector<FilterTexel> texelsAbout(std::uint32_t page,
                                       std::vector<std::shared_ptr<const gi::LatticeBlock>>& kept) const;
  bool reserve(std::size_t slots);  // allocates these slots; false if they do not fit
  std::size_t slotBytes() const;
  std::size_t mostSlots() const;
  std::uint32_t newSlot();                                    // plus 1; 0: no room
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
  std::deque<std::uint32_t> queue_;  // pages waiting for upload, each once
  std::unordered_set<std::uint32_t> queued_, left_;
  std::vector<std::uint32_t> slots_;  // of each page, plus 1; 0: none
  std::vector<std::uint32_t> free_;   // released slots, plus 1
  Buffer pages_, texels_;
  BufferTexture pagesTexture_, texelsTexture_;
  std::size_t capacity_ = 0, used_ = 0, uploaded_ = 0;  // slots, including the free ones; blocks
  std::size_t mostBufferBytes_ = 0;
};

}  // namespace isolux::render
