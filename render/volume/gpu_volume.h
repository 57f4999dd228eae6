// Provides a volume to the passes: its textures, and the blocks that contain the isosurface.
//
// Positions are voxel coordinates. A texture stores texels: stored = texel * scale + offset
// (volume_texture.h).
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/volume/bricks.h"
#include "render/volume/part_boxes.h"
#include "render/volume/surface_blocks.h"
#include "render/volume/volume_texture.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"
#include "volume/edge/edge_walk.h"
#include "volume/field/scaled_field.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/skip/box_bounds.h"
#include "volume/statistics/curvature_statistics.h"
#include "volume/statistics/visible_points.h"

namespace isolux::render {

// The data that a lookup reads: a field, at a scale σ (mm) if that is above 0 (volume/field/scaled_field.h).
struct FieldAt {
  scene::Field field = scene::Field::trilinear;
  double scaleMm = 0.0;
  bool operator==(const FieldAt&) const = default;
};

class GpuVolume {
 public:
  // Uploads nothing yet. Throws base::Error{memory} if the driver cannot draw as many blocks.
  GpuVolume(GlPtr gl, std::shared_ptr<const volume::PreparedVolume> volume);

  const volume::Grid& grid() const { return volume_->grid(); }
  const std::shared_ptr<const volume::PreparedVolume>& prepared() const { return volume_; }
  bool hasCells() const;  // an axis of one voxel has no cells and no surface

  // Creates the missing textures for these fields, one each or as bricks (memory.layout), and uploads whole
  // textures. memory.gpu_budget_mb limits all textures together. Throws base::Error{memory}.
  void require(const std::vector<FieldAt>& fields, const scene::Memory& memory);
  // As require(), without textures, if nothing on the GPU reads voxels. Textures for other fields stay until
  // something new is created.
  void requireFields(const std::vector<FieldAt>& fields);
  // Returns the bricks, or null if the volume is one texture.
  Bricks* bricks() { return bricks_ ? &*bricks_ : nullptr; }
  const Bricks* bricks() const { return bricks_ ? &*bricks_ : nullptr; }
  std::size_t bricksMade() const { return bricksMade_; }  // number of times; resident bricks are then lost
  // Returns the number of bricks with an active block: those that images of these isosurfaces can need.
  std::size_t activeBricks() const { return surfaces_.empty() || !hasCells() ? 0 : surface().activeBricks(); }

  // Sets uVolume and uDims, and uField, uFieldPerVolume for the texture that the field is made from. Uses
  // texture units 0 and 1, and 15 for bricks.
  void bind(Program& program, const FieldAt& of) const;
  // Return a value in data units as a texel of uVolume, or of the texture that `field` is made from.
  double texelOf(double value, scene::Field field = scene::Field::trilinear) const;
  double dataUnitsPerTexel(scene::Field field = scene::Field::trilinear) const;

  glm::dvec3 noiseBlur() const;  // scene::NoiseModel; estimated at the first call
  // Returns the curvature statistics of the surface of `value` (data units) with these derivatives; all 0
  // without a surface.
  volume::CurvatureStatistics curvatureStatistics(const FieldAt& of, double value, double outward,
                                                  const volume::HiddenPieces& hidden) const;

  std::vector<volume::VisiblePoint> visiblePoints(double value) const;  // of that surface
  // Returns the offsets of edges from the surface of `value` over visible points, mm.
  volume::Quantiles edgeOffsets(const FieldAt& of, const volume::EdgeSearch<double>& search,
                                double value) const;

  // Returns false if no cell of this field can contain a surface of one of `values` (data units).
  bool mayCross(scene::Field field, const std::vector<double>& values) const;
  // The hidden components of its surfaces; empty if all are shown.
  const std::vector<volume::HiddenOfSurface>& hidden() const { return hidden_; }
  void setHidden(std::vector<volume::HiddenOfSurface> hidden) { hidden_ = std::move(hidden); }
  // Activates the blocks that the surfaces of `values` (data units) of this field can cross, and uploads the
  // masks of their sub-blocks. Takes time proportional to the change. The masks ignore hidden components.
  void activate(scene::Field field, const std::vector<double>& values);
  std::size_t activeBlocks() const { return surfaces_.empty() ? 0 : surface().active().activeCount(); }
  // Returns the blocks of the active surfaces. Requires activate().
  SurfaceBlocks& surface() { return *surfaces_.back(); }
  const SurfaceBlocks& surface() const { return *surfaces_.back(); }
  // Returns the coefficients of the field's B-spline; null: the samples themselves.
  const volume::Coefficients* coefficients(scene::Field field) const;
  // Returns null if the scale is 0 or was not required.
  const volume::ScaledField* scaled(const FieldAt& of) const;
  // Returns the bytes of sub-block masks in main memory and, once shaders have used them, of their texture.
  std::size_t blockBytes() const { return surfaces_.empty() ? 0 : surface().bytes(); }
  std::size_t bytes() const;

 private:
  // One texture, or one channel of the bricks: the samples, or the coefficients of a field.
  struct Channel {
    Channel(const FieldAt& field, std::shared_ptr<const volume::ScaledField> kept, TexelSource texels)
        : of(field), scaled(std::move(kept)), source(std::move(texels)) {}
    FieldAt of;
    std::shared_ptr<const volume::ScaledField> scaled;  // whose coefficients they are; null: the scale is 0
    TexelSource source;
    Texture whole;  // none: the volume is in bricks, or only in main memory
  };
  using Channels = std::vector<std::unique_ptr<Channel>>;  // their sources do not move
  std::unique_ptr<Channel> makeChannel(const FieldAt& of) const;
  std::size_t channelOf(const FieldAt& of) const;  // what the field is made from; channels_.size(): none yet
  void dropOthers(const std::vector<FieldAt>& wanted);
  std::size_t channelBytes() const;
  bool fitsWhole(std::size_t budgetBytes) const;
  void makeWhole(std::size_t budgetBytes);
  void makeBricks(std::size_t budgetBytes);
  const TexelSource& sourceOf(const FieldAt& of) const;
  // Returns the data of a cubic field; computes them at the first call (see volume/derived/cubic_fields.h:
  // takes long).
  const volume::CubicField& cubic(scene::Field field) const;
  SurfaceBlocks& blocksOf(scene::Field field);  // becomes the last used

  GlPtr gl_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  std::vector<volume::HiddenOfSurface> hidden_;
  Channels channels_;                    // the samples are the first
  std::optional<scene::Memory> layout_;  // with which the textures of all channels were created
  std::unique_ptr<PartBoxes> parts_;     // null: sub-blocks of the whole volume are known
  std::optional<Bricks> bricks_;
  std::size_t bricksMade_ = 0;

  // Holds the blocks of the last fields of hits, the latest last: idle and interactive frames may differ.
  static constexpr std::size_t kKeptFields = 2;
  std::vector<std::unique_ptr<SurfaceBlocks>> surfaces_;
};

}  // namespace isolux::render
