// Determines which blocks, sub-blocks and cells of a hit field can contain the shown isosurfaces. Holds the
// result in main memory, and as the texture by which shaders skip empty space.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/volume/part_boxes.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/skip/active_blocks.h"
#include "volume/skip/shown_boxes.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::render {

class SurfaceBlocks {
 public:
  // `blocks` and `boxes` are the field's and must outlive this. If `boxes` is null, the volume is
  // out-of-core, and `parts` provides the sub-blocks; it must outlive this, too.
  SurfaceBlocks(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume, scene::Field field,
                std::shared_ptr<const volume::MinMaxBlocks> blocks,
                std::shared_ptr<const volume::BoxBounds> boxes, const PartBoxes* parts);

  scene::Field field() const { return field_; }
  // The hidden components of the surfaces; empty if all are shown.
  struct Hidden {
    std::vector<volume::PartlyShown> surfaces;
    std::vector<volume::HiddenOfSurface> voxels;  // of some of them
  };
  // Activates the blocks for surfaces of these values, in the blocks' units, in time proportional to the
  // change.
  void activate(std::vector<float> storedIsovalues, Hidden hidden);

  const volume::ActiveBlocks& active() const { return active_; }
  const volume::MinMaxBlocks& blocks() const { return active_.blocks(); }
  // Returns the sub-blocks of each block that can contain a surface (volume::BoxBounds); empty unless blocks
  // have 8^3 cells.
  std::span<const std::uint64_t> masks() const { return masks_; }
  std::size_t activeBricks() const;  // bricks with an active block

  // Updates the masks after a change of a brick in `parts`.
  void updateMasks(glm::ivec3 brick);

  // Prepares for casting an image of these surfaces. The first is cast by sub-blocks. From the second on,
  // each cell has a bit (volume/skip/cell_bits.h) if its corners determine it. Computing the bits reads the
  // voxels of active blocks once, which takes too long while the isovalue changes. Hits are the same.
  void prepareMasks(const scene::Hit& hit);
  // Sets the masks that trace.glsl skips empty space by, on texture unit `unit`.
  void bindMasks(Program& program, const scene::Hit& hit, int unit);

  // Sets the hidden components of up to four of the active surfaces, from the place `first` on, on texture
  // unit `unit`.
  void bindHidden(Program& program, int unit, std::size_t first);

  std::size_t textureBytes() const;
  std::size_t bytes() const { return masks_.size() * sizeof(std::uint64_t) + textureBytes(); }

 private:
  void updateMasks();
  PartBoxes::Blocks takeMasks(glm::ivec3 brick);
  Texture hiddenTextureOf(std::span<const volume::PartlyShown> surfaces) const;
  bool mayHaveCells(const scene::Hit& hit) const;
  void upload(bool cells);

  GlPtr gl_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Field field_;
  volume::ActiveBlocks active_;
  std::shared_ptr<const volume::BoxBounds> boxes_;
  const PartBoxes* parts_;
  std::vector<std::uint64_t> masks_;
  std::vector<float> storedIsovalues_;         // of the masks
  mutable std::optional<std::size_t> bricks_;  // computed at the first call
  Texture texture_;                            // RG32UI
  Hidden hidden_;
  std::uint64_t hiddenKey_ = 0;
  std::map<std::size_t, Texture> hiddenTextures_;  // hidden.glsl, by first surface, once they are used
  enum class Uploaded { nothing, boxes, cells };
  Uploaded uploaded_ = Uploaded::nothing;  // of these surfaces
};

}  // namespace isolux::render
