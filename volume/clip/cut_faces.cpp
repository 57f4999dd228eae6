#include "volume/clip/cut_faces.h"

#include <cmath>

#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {

double CutFaces::Field::valueAt(const Grid& grid, const glm::dvec3& voxel) const {
  if (coefficients() && std::isnan(sampleTrilinear(grid, voxel).value))
    return std::numeric_limits<double>::quiet_NaN();
  return sampleField(grid, field, coefficients(), voxel).value;
}

CutFaces::CutFaces(const Grid& grid, const CubicFields& fields, const scene::Scene& resolved,
                   std::span<const HiddenOfSurface> hidden)
    : grid_(grid),
      cap_(resolved.clip.cap),
      inside_(resolved.isosurface.inside),
      sides_{resolved.hit.field, fields.find(resolved.hit.field)},
      values_{resolved.slice.field, fields.find(resolved.slice.field)} {
  if (!scene::showsCutFaces(resolved)) return;
  cut_ = SurfaceCut(resolved, grid.geometry());
  for (const auto& listed : scene::shownSurfaces(resolved)) {
    const double isovalue = listed.value.value();
    if (!scene::isOpaque(listed) || !cut_.cuts(isovalue)) continue;
    Surface& surface = surfaces_.emplace_back(Surface{isovalue, std::nullopt});
    if (const HiddenPieces pieces = hiddenAt(hidden, isovalue); pieces.voxels)
      surface.shown.emplace(grid, pieces.voxels, isovalue, pieces.inside, sides_.field,
                            sides_.coefficients());
  }
}

bool CutFaces::isInside(const glm::dvec3& voxel) const {
  const double value = sides_.valueAt(grid_, voxel);
  if (std::isnan(value)) return false;
  for (const Surface& surface : surfaces_) {
    if ((value >= surface.isovalue) != (inside_ == scene::Inside::above)) continue;
    if (!surface.shown || !surface.shown->hiddenAt(voxel)) return true;
  }
  return false;
}

std::optional<CutFace> CutFaces::at(const Ray& ray) const {
  if (!cut_.cuts() || !ray.valid()) return std::nullopt;
  const glm::dvec3 last(grid_.dims() - 1);
  const auto domain = ClipRegion::Removed{glm::dvec3(0.0), last}.segmentOf(ray.origin, ray.direction, true);
  for (const auto& [t, end] : cut_.region().segmentsOf(ray.origin, ray.direction)) {
    if (!(t > ray.tMinimum) || t > ray.tMaximum || !domain.holds(t)) continue;
    const glm::dvec3 voxel = glm::clamp(ray.origin + t * ray.direction, glm::dvec3(0.0), last);
    if (cap_ == scene::ClipCap::inside && !isInside(voxel)) continue;
    const double value = values_.valueAt(grid_, voxel);
    if (!std::isnan(value)) return CutFace{t, value};
  }
  return std::nullopt;
}

}  // namespace isolux::volume
