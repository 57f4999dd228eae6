// A volume as the passes read it: its textures, and the blocks that hold the isosurface.
//
// Positions are voxel coordinates. A texture holds texels: stored = texel * scale + offset
// (volume_texture.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/volume/bricks.h"
#include "render/volume/part_boxes.h"
#include "render/volume/surface_blocks.h"
#include "render/volume/volume_texture.h"
#include "scene/machine.h"
#include "scene/scene.h"
#include "volume/edge/edge_walk.h"
#include "volume/field/scaled_field.h"
#include "volume/prepared_volume.h"
#include "volume/skip/box_bounds.h"
#include "volume/statistics/curvature_statistics.h"
#include "volume/statistics/visible_points.h"

namespace isolux::render {

// What a lookup is of: a field, at a scale (mm) where that is above 0 (volume/field/scaled_field.h).
struct FieldAt {
  scene::Field field = scene::Field::trilinear;
  double scaleMm = 0.0;
  bool operator==(const FieldAt&) const = default;
};

class GpuVolume {
 public:
  // Nothing is uploaded yet. Throws base::Error{memory} where the driver cannot draw as many blocks.
  GpuVolume(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume);

  const volume::Grid& grid() const { return volume_->grid(); }
  const scene::VolumeFacts& facts() const { return volume_->facts; }
  std::shared_ptr<const volume::Grid> sharedGrid() const { return volume_->volume.grid; }
  bool hasCells() const;  // an axis of one voxel has none, and no surface

  // Makes room for what these fields need and is not there yet, as one texture each or as bricks
  // (memory.layout), and uploads whole textures; memory.gpu_budget_mb is for all textures together. Throws
  // base::Error{memory}.
  void require(const std::vector<FieldAt>& fields, const scene::Memory& memory);
  // The same without textures, where nothing on the graphics card reads voxels. What others needed stays
  // until something new is made.
  void requireFields(const std::vector<FieldAt>& fields);
  // None: the volume is whole.
  Bricks* bricks() { return bricks_ ? &*bricks_ : nullptr; }
  const Bricks* bricks() const { return bricks_ ? &*bricks_ : nullptr; }
  std::size_t bricksMade() const { return bricksMade_; }  // how often: what was resident is gone then
  // Bricks that hold an active block: what pictures of these isosurfaces can need.
  std::size_t activeBricks() const { return surfaces_.empty() || !hasCells() ? 0 : surface().activeBricks(); }

  // Sets uVolume and uDims, and uField, uFieldPerVolume for the texture that the field is made from. Uses
  // texture units 0 and 1, and 15 for bricks.
  void bind(Program& program, const FieldAt& of) const;
  // A value in data units as a texel of uVolume, or of the texture `field` is made from.
  double texelOf(double value) const;
  double texelOf(double value, scene::Field field) const;
  double dataUnitsPerTexel() const;  // of uVolume
  double dataUnitsPerTexel(scene::Field field) const;

  glm::dvec3 noiseBlur() const;  // scene::NoiseModel; estimated where nobody has asked for it yet
  // How the surface of `value` (data units) is curved by these derivatives. All 0 where there is none.
  volume::CurvatureStatistics curvatureStatistics(const FieldAt& of, double value, double outward,
                                                  const volume::HiddenPieces& hidden);

  std::vector<volume::VisiblePoint> visiblePoints(double value) const;  // of that surface
  // How far edges lie from the surface of `value`: offsets of points that can be seen, mm.
  volume::Quantiles edgeOffsets(const FieldAt& of, const volume::EdgeSearch<double>& search,
                                double value) const;

  // False: no cell of this field can hold a surface of one of `values` (data units).
  bool mayCross(scene::Field field, const std::vector<double>& values) const;
  // Makes the blocks active that the surfaces of `values` (data units) of this field can cross, in time
  // proportional to what changes; uploads the masks of their boxes.
  // What of them is hidden is not in the masks.
  void activate(scene::Field field, const std::vector<double>& values,
                const std::vector<volume::HiddenOfSurface>& hidden);
  std::size_t activeBlocks() const { return surfaces_.empty() ? 0 : surface().active().activeCount(); }
  const volume::MinMaxBlocks& blocks() const { return surface().blocks(); }
  // Of each block, the boxes that can hold a surface (volume::BoxBounds); none where blocks are not of 8^3
  // cells.
  std::span<const std::uint64_t> masks() const { return surface().masks(); }
  // Of the field's B-spline; null: the samples themselves.
  const volume::Coefficients* coefficients(scene::Field field) const;
  // Null: the scale is 0, or was not required.
  const volume::ScaledField* scaled(const FieldAt& of) const;
  bool isActive(std::size_t block) const { return surface().active().flags()[block] != 0; }
  // A picture of these surfaces is about to be cast. The first is cast by boxes; from the second on each cell
  // has a bit (volume/skip/cell_bits.h) where its corners decide, which reads the voxels of active blocks
  // once: a moving isovalue does not pay for it. Hits are the same.
  void prepareMasks(const scene::Hit& hit) { surface().prepareMasks(hit); }
  // Sets what trace.glsl skips empty space by, on texture unit `unit`.
  void bindMasks(Program& program, const scene::Hit& hit, int unit) {
    surface().bindMasks(program, hit, unit);
  }

  // What of the active surfaces is hidden, where something is: on texture unit `unit`.
  void bindHidden(Program& program, int unit) { surface().bindHidden(program, unit); }

  // Of which boxes can hold a surface, on the processor and, once shaders have asked for them, as a texture.
  std::size_t blockBytes() const { return surfaces_.empty() ? 0 : surface().bytes(); }
  std::size_t bytes() const;

 private:
  // One texture, or one channel of the bricks: the samples, or the coefficients of what it is of.
  struct Channel {
    Channel(const FieldAt& field, std::shared_ptr<const volume::ScaledField> kept, TexelSource texels)
        : of(field), scaled(std::move(kept)), source(std::move(texels)) {}
    FieldAt of;
    std::shared_ptr<const volume::ScaledField> scaled;  // whose coefficients they are; null: the scale is 0
    TexelSource source;
    Texture whole;  // none: the volume is in bricks, or on the processor only
  };
  using Channels = std::vector<std::unique_ptr<Channel>>;  // their sources stay where they are
  std::unique_ptr<Channel> makeChannel(const FieldAt& of) const;
  std::size_t channelOf(const FieldAt& of) const;  // what it is made from; channels_.size(): nothing yet
  void dropOthers(const std::vector<FieldAt>& wanted);
  std::size_t channelBytes() const;
  bool fitsWhole(std::size_t budgetBytes) const;
  void makeWhole(std::size_t budgetBytes);
  void makeBricks(std::size_t budgetBytes);
  const TexelSource& sourceOf(const FieldAt& of) const;
  // What a cubic field needs; makes it where nobody has (see volume/field/cubic_fields.h: takes long).
  const volume::CubicField& cubic(scene::Field field) const;
  SurfaceBlocks& blocksOf(scene::Field field);  // from then on those of the last picture
  SurfaceBlocks& surface() { return *surfaces_.back(); }
  const SurfaceBlocks& surface() const { return *surfaces_.back(); }

  GlPtr gl_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  Channels channels_;                    // the samples are the first
  std::optional<scene::Memory> layout_;  // by which textures of all channels are made
  std::unique_ptr<PartBoxes> parts_;     // none: boxes of the whole volume are known
  std::optional<Bricks> bricks_;
  std::size_t bricksMade_ = 0;

  // Of fields of hits, that of the last picture last: pictures at rest may have another than moving ones.
  static constexpr std::size_t kKeptFields = 2;
  std::vector<std::unique_ptr<SurfaceBlocks>> surfaces_;
};

}  // namespace isolux::render
