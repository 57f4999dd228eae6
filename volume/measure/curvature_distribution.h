// How an isosurface, or pieces of it, is curved: what parts of its area have which curvature.
//
// Curvature is that of the field that derivatives are taken of, at its scale (volume/derived/shape_field.h),
// at points of the trilinear surface, about one in each cell and piece, that stand for the area of the
// surface there. Noise makes a surface rough, and its distribution wider by the `noise` that is stated; what
// is not above three deviations of it in either principal curvature is not told from flat.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "scene/choices.h"
#include "scene/noise.h"
#include "scene/scene.h"
#include "volume/measure/box_part.h"
#include "volume/pieces/pieces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

// Of one measure (scene/looks.h), in its unit: powers of 1/mm, or none.
struct CurvatureHistogram {
  scene::LookMode measure = scene::LookMode::kappa1;
  double areaMm2 = 0.0;                // that counts: of the shape index what is clear of noise, else all
  double mean = 0.0, deviation = 0.0;  // of the area that counts; 0 where there is none
  double low5 = 0.0, low25 = 0.0, median = 0.0, high75 = 0.0, high95 = 0.0;  // of parts of it, in %
  double low = 0.0, step = 0.0;                                              // the first bin begins at `low`
  std::vector<double> areasMm2{}, clearMm2{};  // of each bin: what counts, and what of that is clear of noise
  double belowMm2 = 0.0, aboveMm2 = 0.0;       // beyond the bins
};

struct CurvatureDistribution {
  double areaMm2 = 0.0;     // whose curvature is known
  double unknownMm2 = 0.0;  // where the gradient vanishes or voxels are missing
  double clearMm2 = 0.0;    // where a principal curvature is above three deviations of its noise
  double noise = 0.0;       // 1/mm: root mean square over the area of what noise makes of a normal curvature
  double scaleMm = 0.0;     // of the derivatives
  double meanIntegralMm = 0.0;    // of the mean curvature over the area
  double gaussianIntegral = 0.0;  // of the Gaussian curvature: 4 pi for each closed surface without holes
  std::vector<CurvatureHistogram>
      measures;  // kappa1, kappa2, mean and Gaussian curvature, shape index, curvedness
};

// Which part of the surface of `pieces` counts.
struct CurvaturePart {
  std::vector<bool> shown;        // of the pieces; empty: all
  std::optional<WorldBox> box{};  // only what lies within
};

// `resolved`: derivatives.scale and .noise are filled in (DerivativeChoices::complete); `pieces` are of the
// volume. The same for any number of threads. Throws Error{interrupted, memory}.
CurvatureDistribution curvatureDistribution(const PreparedVolume& volume, const scene::Scene& resolved,
                                            const Pieces& pieces, const CurvaturePart& part,
                                            base::Progress& progress);

}  // namespace isolux::volume
