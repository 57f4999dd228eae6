#include "scene/rules/whole_voxels.h"

#include "scene/rules/needs.h"

namespace isolux::scene {

std::optional<std::string> needsWholeVoxels(const Scene& resolved) {
  const Derivatives& derivatives = resolved.derivatives;
  if (resolved.hit.field != Field::trilinear) return "hits of a cubic field: hit.field=trilinear does not";
  if (mayRefineHits(resolved) && resolved.picture.restHits == StillField::cubic_interpolating)
    return "hits of the spline at rest: picture.rest_hits=same does not";
  if (needsGradient(resolved) && derivatives.field == Field::cubic_interpolating)
    return "derivatives of the interpolating spline: derivatives.field=cubic does not";
  if (needsGradient(resolved) && derivatives.normalScale.value_or(0.0) > 0.0)
    return "normals at a scale: derivatives.normal_scale=0 does not";
  if (needsSecondDerivatives(resolved) && derivatives.scale.value_or(0.0) > 0.0)
    return "curvature at a scale: derivatives.scale=0 does not";
  if (usesGi(resolved)) return "global illumination: another look.mode or look.shading does not";
  if (!(resolved.pieces == Pieces())) return "hiding pieces: pieces. at its defaults does not";
  if (showsCutFaces(resolved)) return "faces of cuts with values: clip.cap=none does not";
  if (needsEdge(resolved)) return "edges: another look.mode does not";
  if (showsSecondVolume(resolved)) return "colours of a second volume: an empty color.volume does not";
  return std::nullopt;
}

}  // namespace isolux::scene
