#include "app/slices/slice_content.h"

#include "scene/shown_surfaces.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::app {

namespace {

using scene::Scene;
using volume::PreparedVolume;

std::vector<SurfaceOnSlice> surfacesOnSlice(const Scene& scene) {
  std::vector<SurfaceOnSlice> surfaces;
  for (const auto& surface : scene::visibleSurfaces(scene))
    if (surface.value) surfaces.push_back({*surface.value, surface.albedo, {}});
  return surfaces;
}

std::optional<std::pair<double, double>> noiseBand(const PreparedVolume& prepared, Scene scene,
                                                   base::Progress& progress) {
  if (scene.slice.noiseBand <= 0.0 || !scene.surfaces.front().value) return std::nullopt;
  prepared.derivativeChoices->complete(scene, progress);
  const double reach = scene.slice.noiseBand * scene.derivatives.noise.value_or(0.0);
  return std::pair{*scene.surfaces.front().value - reach, *scene.surfaces.front().value + reach};
}

}  // namespace

glm::dvec3 slicePosition(const Scene& scene, const volume::GridGeometry& geometry) {
  if (scene.slice.position) return *scene.slice.position;
  return geometry.worldOf(0.5 * glm::dvec3(geometry.dims - 1));
}

SliceContent sliceContent(const PreparedVolume& prepared, const Scene& scene, const volume::SlicePlane& plane,
                          base::Progress& progress) {
  // `cubic` takes the voxels themselves; what else CubicFields makes of it no slice needs.
  const auto spline = scene.slice.field == scene::Field::cubic_interpolating
                          ? prepared.cubicFields->make(scene.slice.field, progress)
                          : nullptr;
  const volume::SliceField field{prepared.grid(), scene.slice.field,
                                 spline ? spline->coefficients.get() : nullptr};
  SliceContent content;
  content.plane = plane;
  content.window = volume::greyWindow(scene.slice, prepared.histogram);
  content.band = noiseBand(prepared, scene, progress);
  content.labels = prepared.labels;
  content.values = prepared.labels
                       ? nearestValues(prepared.labels->grid(), plane, progress)
                       : sliceValues(field, plane, {scene.slice.slab, scene.slice.slabMode}, progress);
  if (scene.slice.contourWidth <= 0.0) return content;
  const auto hidden = volume::hiddenOf(scene, *prepared.pieces, progress);
  content.surfaces = surfacesOnSlice(scene);
  for (SurfaceOnSlice& surface : content.surfaces)
    surface.curves =
        sliceContours(field, plane, surface.isovalue, volume::hiddenAt(hidden, surface.isovalue), progress);
  return content;
}

}  // namespace isolux::app
