// The faces that cuts lay open, as a viewer's rays meet them, and the voxels' values there.
//
// A ray meets a face where it enters the kept region (volume/clip/clip_region.h) within the volume, in front
// of the viewer; where removed boxes let it enter more than once, at the first of these that shows a value.
// With ClipCap::inside the face is there where an opaque isosurface that is cut has its inside; with
// ClipCap::whole wherever the volume has values; with ClipCap::none nowhere. Values are those of slice.field,
// sides those of hit.field; hidden pieces are no inside. Double precision; const members from any thread.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "volume/clip/surface_cut.h"
#include "volume/derived/cubic_fields.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/shown_cells.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

struct CutFace {
  double t = 0.0;      // along the ray, in units of |direction|
  double value = 0.0;  // data units
};

class CutFaces {
 public:
  // None where the scene shows none (scene::showsCutFaces()). `grid`, `fields`: of one volume; they and
  // `hidden` must stay. Fields that the scene reads are made already.
  CutFaces(const Grid& grid, const CubicFields& fields, const scene::Scene& resolved,
           std::span<const HiddenOfSurface> hidden);

  // `ray`: voxel coordinates. The face is at t > ray.tMinimum, and not beyond its tMaximum.
  std::optional<CutFace> at(const Ray& ray) const;
  const SurfaceCut& cut() const { return cut_; }

 private:
  struct Field {
    scene::Field field;
    std::shared_ptr<const CubicField> cubic;
    double valueAt(const Grid& grid, const glm::dvec3& voxel) const;
  };
  struct Surface {
    double isovalue;
    std::optional<ShownCells> shown;  // where some of it is hidden
  };
  bool isInside(const glm::dvec3& voxel) const;

  const Grid& grid_;
  SurfaceCut cut_;
  scene::ClipCap cap_;
  scene::Inside inside_;
  Field sides_, values_;
  std::vector<Surface> surfaces_;  // that are filled
};

}  // namespace isolux::volume
