#include "app/view_math/surface_pick.h"

#include <glm/geometric.hpp>

#include "render/passes/view_uniforms.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "volume/clip/cut_faces.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/hit/exact_hit.h"

namespace isolux::app {

namespace {

std::optional<volume::RayHit> hitOf(const volume::PreparedVolume& volume, scene::Field field, double isovalue,
                                    volume::Ray ray, const volume::HiddenPieces& hidden,
                                    const volume::SurfaceCut& cut) {
  const auto cubic = volume.cubicFields->find(field);
  for (const auto& [begin, end] : cut.segmentsOf(isovalue, ray)) {
    ray.tMinimum = begin;
    ray.tMaximum = end;
    const auto first = volume::firstHitOfField(volume.grid(), cubic ? field : scene::Field::trilinear,
                                               cubic ? cubic->coefficients.get() : nullptr,
                                               cubic ? cubic->blocks : *volume.blocks, isovalue, ray, hidden);
    if (first.hit) return first.hit;
  }
  return std::nullopt;
}

}  // namespace

volume::Ray viewRay(const volume::GridGeometry& geometry, const scene::CameraFrame& frame, glm::dvec2 ndc,
                    double aspect, double startMm) {
  const scene::Ray ray = scene::rayThrough(frame, ndc, aspect);
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  return {glm::dvec3(voxelFromWorld * glm::dvec4(ray.origin, 1.0)),
          glm::dmat3(voxelFromWorld) * ray.direction, startMm};
}

std::optional<Pick> pickSurface(const volume::PreparedVolume& volume, const scene::Scene& resolved,
                                glm::dvec2 ndc, double aspect) {
  const volume::Grid& grid = volume.grid();
  const double startMm = render::ViewUniforms(resolved.camera, aspect, grid.geometry()).rayStartMm;
  volume::Ray ray = viewRay(grid.geometry(), scene::frameOf(resolved.camera), ndc, aspect, startMm);
  const auto hidden = volume::knownHidden(resolved, *volume.pieces);
  const volume::SurfaceCut cut(resolved, grid.geometry());
  if (scene::showsCutFaces(resolved))
    if (const auto face = volume::CutFaces(grid, *volume.cubicFields, resolved, hidden).at(ray))
      ray.tMaximum = face->t;
  std::optional<volume::RayHit> nearest;
  double isovalueHit = 0.0;
  for (const auto& surface : scene::visibleSurfaces(resolved)) {
    const double isovalue = surface.value.value();
    const auto hit =
        hitOf(volume, resolved.hit.field, isovalue, ray, volume::hiddenAt(hidden, isovalue), cut);
    if (!hit || (nearest && hit->t >= nearest->t)) continue;
    nearest = hit;
    isovalueHit = isovalue;
  }
  if (!nearest) return std::nullopt;
  return Pick{grid.geometry().worldOf(nearest->voxel), nearest->voxel,
              volume::sampleTrilinear(grid, nearest->voxel).value, isovalueHit};
}

scene::Camera centredOn(const scene::Camera& resolved, const glm::dvec3& pointMm) {
  const scene::CameraFrame frame = scene::frameOf(resolved);
  scene::Camera camera = resolved;
  const glm::dvec3 shift = pointMm - camera.target.value_or(pointMm);
  camera.eye = frame.eye + shift - glm::dot(shift, frame.back) * frame.back;
  camera.target = pointMm;
  return camera;
}

}  // namespace isolux::app
