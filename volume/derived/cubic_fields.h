// What the cubic fields need of a volume beside its voxels: made once, when something first asks for it, and
// shared by all that draw or trace the volume.
//
// Making takes seconds for large volumes: it belongs on a thread that may wait, never on the one that owns
// the GL context. All members may be called from any thread.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/field/coefficients.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"
#include "volume/skip/box_bounds.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct CubicField {
  std::optional<Coefficients> coefficients;  // of cubic_interpolating; `cubic` takes the voxels
  MinMaxBlocks blocks;                       // of kBlockCells; as the coefficients, without their offset
  BoxBounds boxes;
};

class CubicFields {
 public:
  explicit CubicFields(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}

  // Null for `trilinear`, which needs nothing, and for what is not made yet.
  std::shared_ptr<const CubicField> find(scene::Field field) const;
  // Makes it where it is not there yet. Who asks while another thread is at it makes its own, and one of the
  // two is kept: nobody waits for what may be stopped. Null for `trilinear`. Throws Error{interrupted}.
  std::shared_ptr<const CubicField> make(scene::Field field, base::Progress& progress);

  // The field at a scale, by the same rules; null for `trilinear` and a scale of 0, which need none. The last
  // two that were asked for are kept: those of derivatives.scale and derivatives.normal_scale.
  std::shared_ptr<const ScaledField> find(scene::Field field, double scaleMm) const;
  std::shared_ptr<const ScaledField> make(scene::Field field, double scaleMm, base::Progress& progress);

  // Whether a picture of the scene finds all it needs; and making it. Scales that the scene leaves empty are
  // not chosen here: they count as 0.
  bool readyFor(const scene::Scene& scene) const;
  void makeFor(const scene::Scene& scene, base::Progress& progress);

 private:
  bool forgetOldestScale();  // false: none is kept
  std::shared_ptr<const ScaledField> scaledFound(scene::Field field, double scaleMm) const;  // while locked

  std::shared_ptr<const Grid> grid_;
  mutable std::mutex mutex_;  // held for moments
  std::shared_ptr<const CubicField> cubic_, interpolating_;
  mutable std::vector<std::shared_ptr<const ScaledField>> scaled_;  // the last one asked for is last
};

}  // namespace isolux::volume
