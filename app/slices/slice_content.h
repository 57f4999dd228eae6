// What a scene shows on a plane: values and isocontours. Takes long: never on the window's thread.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/slice/slice_contours.h"
#include "volume/slice/slice_values.h"
#include "volume/statistics/grey_window.h"

namespace isolux::app {

struct SurfaceOnSlice {
  double isovalue = 0.0;  // data units
  glm::dvec3 color{1.0};  // linear RGB
  volume::SliceCurves curves;
};

struct SliceContent {
  volume::SlicePlane plane;
  volume::SliceValues values;
  volume::GreyWindow window;
  std::vector<SurfaceOnSlice> surfaces;                 // that are shown, the first one first
  std::optional<std::pair<double, double>> band{};      // data units: slice.noise_band
  std::shared_ptr<const volume::ShownLabels> labels{};  // the values are labels, each of the nearest voxel
};

// `scene`: resolved. Of a thick slab contours are those on the plane itself. Where noise is asked for and not
// known it is measured. Throws Error: interrupted; memory.
SliceContent sliceContent(const volume::PreparedVolume& prepared, const scene::Scene& scene,
                          const volume::SlicePlane& plane, base::Progress& progress);

// Where the three slices meet: slice.position, or the centre of the volume's domain. World mm.
glm::dvec3 slicePosition(const scene::Scene& scene, const volume::GridGeometry& geometry);

}  // namespace isolux::app
