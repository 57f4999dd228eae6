// How strongly an isosurface is curved as a whole, independent of any view: automatic ranges of colour maps.
#pragma once

#include <map>

#include "scene/looks.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

// Robust bounds of a quantity over the surface: the 5 %, 50 % and 95 % quantiles.
struct Quantiles {
  double low = 0.0, median = 0.0, high = 0.0;
};

struct CurvatureStatistics {
  std::size_t samples = 0;                        // 0 where there is no surface
  std::map<scene::LookMode, Quantiles> measures;  // of each look's measure (scene/looks.h)

  // Zeros where there is no surface.
  Quantiles of(scene::LookMode look) const;
};

// Over many points that can be seen (visible_points.h) of what is not `hidden`: folds that nobody looks into
// bend more, and would make ranges several times too wide. `blocks` are those of the samples. Curvature is
// that of the B-spline of the samples, or of the `coefficients` or the field at a scale where given;
// `outward` as in volume/field/curvature.h. Some milliseconds.
CurvatureStatistics curvatureStatistics(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        double outward = -1.0, const Coefficients* coefficients = nullptr,
                                        const ScaledField* scaled = nullptr, const HiddenPieces& hidden = {});

}  // namespace isolux::volume
