// The curves in which an isosurface meets a plane: of the reconstruction itself, not of pixels.
//
// Points lie on f = isovalue, within 1e-9 voxels or what rounding of the values allows, and at most 0.63
// voxels apart; between two of them the curve is drawn straight. Features smaller than 1/64 voxel may be
// missed (cell_curve.h). Closed curves end where they begin; others end at the volume's border, beside
// missing voxels, and beside hidden pieces.
#pragma once

#include <vector>

#include "volume/slice/slice_values.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

struct SliceCurve {
  std::vector<glm::dvec3> points;  // voxel coordinates; of a closed curve the first is not repeated
  bool closed = false;
};

struct SliceCurves {
  std::vector<SliceCurve> curves;
  base::MemoryBudget::Held held{};
};

// In the whole plane, whatever part of it the picture shows. isovalue: data units. Curves of hidden pieces
// are left out. Multithreaded. Throws Error: interrupted; memory.
SliceCurves sliceContours(const SliceField& field, const SlicePlane& plane, double isovalue,
                          const HiddenPieces& hidden, base::Progress& progress);

}  // namespace isolux::volume
