// One slice with its letters, drawn on a background thread.
#pragma once

#include <memory>

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
  // Holds what the slice shows of a resolved Scene; all else is as in a new one. slice.position is left out:
  // the plane has it.
  scene::Scene scene;
  // A draft has one value for so many pixels of a row and of a column, and between them what lies between the
  // values; letters and place are those of the full picture. 1: no draft.
  int coarse = 1;
  double pixelRatio = 1.0;  // pixels of one of a screen at 100 %: texts and curves are so much larger
  bool operator==(const SliceOrder&) const = default;
};
SliceOrder sliceOrder(std::shared_ptr<const volume::PreparedVolume> volume, const volume::SlicePlane& plane,
                      const scene::Scene& resolved);

struct DrawnSlice {
  render::ColorImage picture;
  double milliseconds = 0.0;  // that it took
};
using SliceTask = base::Task<DrawnSlice>;
std::unique_ptr<SliceTask> sliceTask(SliceOrder asked);

}  // namespace isolux::app
