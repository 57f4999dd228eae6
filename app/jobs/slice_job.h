// One slice with its letters, drawn on a background thread.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "base/task.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/slice/slice_plane.h"

namespace isolux::app {

// What a slice is drawn from. Orders that are equal give the same picture.
struct SliceOrder {
  std::shared_ptr<const volume::PreparedVolume> volume;
  volume::SlicePlane plane;
  // Of a resolved Scene.
  scene::Slice slice;
  scene::Isosurface isosurface;
  std::array<scene::ExtraIsosurface, scene::kExtraIsosurfaces> extraIsosurfaces;
  scene::Pieces pieces;
  std::optional<double> noise;  // derivatives.noise, where there is a noise band
  // A draft has one value for so many pixels of a row and of a column, and between them what lies between the
  // values; letters and place are those of the full picture. 1: no draft.
  int coarse = 1;
  double pixelRatio = 1.0;  // pixels of one of a screen at 100 %: texts and curves are so much larger
  bool operator==(const SliceOrder&) const = default;
};
// slice.position is left out: the plane has it.
SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved);

struct DrawnSlice {
  render::ColorImage picture;
  double milliseconds = 0.0;  // that it took
};
using SliceTask = base::Task<DrawnSlice>;
std::unique_ptr<SliceTask> sliceTask(SliceOrder asked);

}  // namespace isolux::app
