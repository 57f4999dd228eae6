#include "app/error_budget/work.h"

namespace isolux::app {

namespace {

using scene::Field;

constexpr double kSampledBase = 0.6, kSample = 0.06;
constexpr double kNearPart = 0.35;  // of the samples of a ray, when all are as dense as near ones
constexpr double kRefinement = 0.008;
constexpr double kExactOnProcessor = 0.3;
constexpr double kSplineByShader = 11.0, kSplineOnProcessor = 3.3;  // times the trilinear field's hit
constexpr double kTrilinearGradient = 0.1, kTrilinearHessian = 0.13, kGradient = 0.45, kHessian = 0.5;
constexpr double kInterpolating = 1.2;                     // times the other spline's derivatives
constexpr double kFastGradient = 1.1, kFastHessian = 3.0;  // times exact fetches
constexpr double kDerivativesOnProcessor = 0.4;
constexpr double kPath = 2.5;

}  // namespace

double hitWork(const scene::Hit& hit, bool processor) {
  const bool spline = hit.field != Field::trilinear;
  if (hit.method == scene::HitMethod::exact)
    return processor ? kExactOnProcessor * (spline ? kSplineOnProcessor : 1.0)
           : spline  ? kSplineByShader
                     : 1.0;
  const double samples = hit.rate * (1.0 + kNearPart * (hit.nearFactor - 1.0));
  return (spline ? kSplineByShader : 1.0) *
         (kSampledBase + kSample * samples + kRefinement * hit.refinements);
}

double derivativeWork(const scene::Derivatives& derivatives, bool second, bool processor) {
  const bool trilinear = derivatives.field == Field::trilinear;
  double work = second      ? (trilinear ? kTrilinearHessian : kHessian)
                : trilinear ? kTrilinearGradient
                            : kGradient;
  if (derivatives.field == Field::cubic_interpolating) work *= kInterpolating;
  if (!trilinear && derivatives.fetch == scene::Fetch::fast)
    return work * (second ? kFastHessian : kFastGradient);
  return processor ? kDerivativesOnProcessor * work : work;
}

double lightWork(const scene::Gi& gi) {
  return kPath * gi.samples * gi.latticeScale * gi.latticeScale;
}

}  // namespace isolux::app
