// Normals and curvature at the points of a mesh, as arrays for a file.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/write/mesh_writer.h"

namespace isolux::volume {

// points: world, mm, on the surface. `resolved`: isosurface.inside and derivatives count, whose scales and
// noise are filled in (DerivativeChoices). normals: unit, outward, of the field at derivatives.normal_scale;
// with curvature kappa1, kappa2 (1/mm) and confidence (volume/field/curvature.h) at derivatives.scale. NaN
// where the field has no gradient. Throws Error{interrupted}.
std::vector<PointArray> surfaceArrays(const PreparedVolume& volume, const scene::Scene& resolved,
                                      std::span<const glm::dvec3> points, bool curvature,
                                      base::Progress& progress);

// color_value: what color.volume has there, or below (color.below), its data units; NaN outside of it. Reads
// that volume where nobody has. Throws Error{input, memory, interrupted}.
PointArray secondValueArray(const PreparedVolume& volume, const scene::Scene& resolved,
                            std::span<const glm::dvec3> points, base::Progress& progress);

}  // namespace isolux::volume
