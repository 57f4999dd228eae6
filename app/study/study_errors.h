// How far a picture's deferred images are from the same view in double precision: pure functions of images.
//
// Every image has one entry per pixel, row 0 at the top. Depths are millimetres along the ray.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "app/study/light_errors.h"

namespace isolux::app {

// What a ray meets, in double precision.
struct TrueHit {
  bool hit = false;
  double depthMm = 0.0;
  double nextMm = std::numeric_limits<double>::infinity();  // the crossing behind it, where there is one
  double voxelsPerMm = 1.0;                                 // along this ray
  glm::dvec3 voxel{0.0};
  bool fromOutside = true;  // the ray enters the inside here; of the trilinear field
};

// The surface's shape where a ray meets it, in double precision.
struct TrueShape {
  bool hasNormal = false;     // false: no hit, or no gradient
  bool hasCurvature = false;  // and the gradient stands clear of the volume's noise
  glm::dvec3 normal{0.0};     // unit
  double kappa1 = 0.0, kappa2 = 0.0;
};

// A view in double precision.
struct TrueSurface {
  const std::vector<TrueHit>& hits;
  const std::vector<TrueShape>& shapes;
  double flatCurvature = 0.0;  // 1/mm: smaller curvatures are judged as if they were this large
};

// The images of a frame, as render::Renderer::readAov() gives them: NaN where there is none.
struct DrawnImages {
  std::vector<float> hit, depthMm;
  std::vector<float> normal;  // x, y, z
  std::vector<float> kappa;   // kappa1, kappa2, 1/mm
  std::vector<float> confidence{};
};
// The part of the pixels with a hit whose confidence is below 1/2; NaN without a hit.
double unknownShare(const DrawnImages& drawn);

// The distribution of an error over the pixels where it is defined; all NaN where there is no such pixel.
struct Spread {
  std::size_t pixels = 0;
  double median = 0.0, rms = 0.0, most99 = 0.0, maximum = 0.0;  // most99: the 99 % quantile
};
Spread spreadOf(std::vector<double> errors);

// What noise makes of shapes, over points and seeds (app/study/scale_study.h).
struct NoiseErrors {
  Spread normalDegrees;
  Spread curvature;  // as Errors::curvature
};

// How far a whole picture is from the reference picture (app/image_metrics), and its edges alone; NaN where
// there is none.
struct ImageErrors {
  double flip = std::numeric_limits<double>::quiet_NaN();  // mean FLIP
  double rms = flip;                                       // of sRGB values, in parts of the full range
  double edgeRms = flip;                                   // the same over pixels on edges
  std::size_t edgePixels = 0;
};

struct Errors {
  std::size_t pixels = 0;     // of the picture
  std::size_t surface = 0;    // pixels where the truth hits
  std::size_t missed = 0;     // the truth's crossing was not found: nothing, or one further behind
  std::size_t invented = 0;   // a hit where the truth has none, or clearly in front of its first
  std::size_t undecided = 0;  // would be one of these, but the truth's own answer hangs on a rounding
  Spread depthVoxels, depthMm, normalDegrees;
  Spread curvature;     // max |error of kappa1, kappa2| / max(|kappa1|, |kappa2|, flatCurvature)
  NoiseErrors noise;    // of the quality setting of the scale, beside the above
  LightErrors light;    // of quality settings of light, which have nothing of the above
  ImageErrors picture;  // of the scene's look, against the picture of QualitySetting::reference

  double missedPpm() const;  // of the picture's pixels
  double inventedPpm() const;
};

// The longest step between samples that the study measures, voxels: hits farther from the truth's first
// crossing than this are not of that crossing.
inline constexpr double kSameCrossingVoxels = 2.0;

// A hit is of the truth's first crossing when it is nearer to it than to the next one behind, and not
// farther from it than that step.
bool isFirstCrossing(double depthMm, const TrueHit& reference);

// max |error of kappa1, kappa2| / max(|kappa1|, |kappa2|, flatCurvature) of the truth.
double curvatureError(double kappa1, double kappa2, const TrueShape& reference, double flatCurvature);
double angleDegrees(const glm::dvec3& a, const glm::dvec3& b);  // between unit vectors

// `undecided(pixel)`: asked about missed and invented pixels only.
Errors errorsOf(const DrawnImages& drawn, const TrueSurface& reference,
                const std::function<bool(std::size_t)>& undecided);

}  // namespace isolux::app
