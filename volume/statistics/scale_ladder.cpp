#include "volume/statistics/scale_ladder.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/quantiles.h"
#include "volume/field/curvature.h"
#include "volume/field/fill_missing.h"
#include "volume/statistics/interpolated_slices.h"

namespace isolux::volume {

namespace {

constexpr double kClearSlope = 0.25;        // of the median
constexpr double kFirstVoxels = 0.7071068;  // 1 / sqrt 3 is what the spline smooths by
constexpr int kScales = 6;                  // above 0
// Squares of all elements of a tangential tensor: two pure derivatives and twice a mixed one.
constexpr double kTensorNoise = 8.0 / 3.0;
constexpr std::size_t kVoxelStep = 2, kTwoVoxelsStep = 4;
constexpr std::size_t kWeightStep = kVoxelStep;  // whose slopes weight points
constexpr double kUnknown = 0.5;                 // a confidence below
constexpr double kOnSlice = 0.97;                // cosine: surfaces along slices cross none

double squareSum(const glm::dmat3& m) {
  return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
}

}  // namespace

ScaleLadder::ScaleLadder(const Grid& grid, std::vector<glm::dvec3> points, const glm::dvec3& noiseBlur)
    : grid_(grid), points_(std::move(points)), noiseBlur_(noiseBlur), scalesMm_{0.0} {
  const double least = grid.geometry().leastSpacingMm();
  for (int i = 0; i < kScales; ++i) scalesMm_.push_back(kFirstVoxels * least * std::pow(2.0, 0.5 * i));
}

void ScaleLadder::fill(base::Progress& progress) {
  auto room = base::machineMemory().tryReserve(grid_.geometry().voxelCount() * sizeof(float));
  if (!room) return;
  held_ = std::move(*room);
  filled_ = std::get<std::vector<float>>(grid_.voxels());
  fillMissing(filled_, grid_.dims(), progress, {});
}

void ScaleLadder::addScale(base::Progress& progress) {
  const GridGeometry& geometry = grid_.geometry();
  const std::size_t i = steps_.size();
  if (i == 1 && grid_.missingCount() > 0) fill(progress);
  Step step;
  std::vector<double> slopes;
  for (const PointDerivatives& d :
       derivativesAtScale(grid_, points_, scalesMm_[i], filled_.empty() ? nullptr : &filled_)) {
    AtPoint at;
    const double slope = glm::length(d.gradient);
    if (slope > 0.0 && std::isfinite(slope)) {
      at.slope = slope;
      at.normal = d.gradient / slope;
      const glm::dmat3 tangential = glm::dmat3(1.0) - glm::outerProduct(at.normal, at.normal);
      at.shape = tangential * d.hessian * tangential * (1.0 / slope);
      slopes.push_back(slope);
    }
    step.points.push_back(at);
  }
  if (!slopes.empty()) step.medianSlope = base::quantile(slopes, 0.5);
  const glm::dvec3 smoothing = smoothingAtScale(geometry, scalesMm_[i]);
  step.noise = pointNoise(geometry, smoothing, noiseBlur_);
  if (i + 1 < scalesMm_.size())
    step.noiseWithNext =
        pointNoise(geometry, 0.5 * (smoothing + smoothingAtScale(geometry, scalesMm_[i + 1])), noiseBlur_);
  steps_.push_back(std::move(step));
}

std::vector<char> ScaleLadder::clearPoints() const {
  std::vector<char> clear(points_.size(), 1);
  for (const Step& step : steps_)
    for (std::size_t k = 0; k < points_.size(); ++k)
      if (!(step.points[k].slope > kClearSlope * step.medianSlope)) clear[k] = 0;
  return clear;
}

ScaleLadder::Measures ScaleLadder::measures() const {
  return measuresOf(clearPoints());
}

ScaleLadder::Measures ScaleLadder::evenMeasures() const {
  std::vector<char> chosen = clearPoints();
  std::vector<double> changes(points_.size()), clear;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!chosen[k]) continue;
    changes[k] = squareSum(steps_[kTwoVoxelsStep].points[k].shape - steps_[kVoxelStep].points[k].shape);
    clear.push_back(changes[k]);
  }
  if (!clear.empty()) {
    const double middle = base::quantile(clear, 0.5);
    for (std::size_t k = 0; k < points_.size(); ++k) chosen[k] = chosen[k] && changes[k] <= middle;
  }
  return measuresOf(chosen);
}

double ScaleLadder::unknownShare(double noise) const {
  const CurvatureScale scale = curvatureScale(grid_.geometry(), scene::Field::cubic, noise, noiseBlur_);
  std::size_t count = 0, unknown = 0;
  for (const AtPoint& at : steps_[0].points) {
    if (at.slope == 0.0) continue;
    ++count;
    const double sum = at.shape[0][0] + at.shape[1][1] + at.shape[2][2];
    const double difference = std::sqrt(std::max(0.0, 2.0 * squareSum(at.shape) - sum * sum));
    const PrincipalCurvature curvature{
        .kappa1 = 0.5 * (sum + difference), .kappa2 = 0.5 * (sum - difference), .normal = at.normal};
    if (!(curvatureConfidence(curvature, at.slope * at.normal, scale) >= kUnknown)) ++unknown;
  }
  return count > 0 ? static_cast<double>(unknown) / static_cast<double>(count) : 0.0;
}

double ScaleLadder::repetition(int axis, double period) const {
  const std::vector<char> clear = clearPoints();
  const glm::dvec3 across =
      glm::normalize(glm::transpose(glm::dmat3(grid_.geometry().voxelFromWorld()))[axis]);
  std::vector<double> bends, sizes, positions;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const AtPoint& smooth = steps_[kVoxelStep].points[k];
    const double cosine = glm::dot(smooth.normal, across);
    if (!clear[k] || std::abs(cosine) > kOnSlice) continue;
    const glm::dvec3 up = glm::normalize(across - cosine * smooth.normal);
    const double bend = glm::dot(up, (steps_[0].points[k].shape - smooth.shape) * up);
    bends.push_back(cosine < 0.0 ? -bend : bend);
    sizes.push_back(std::abs(bend));
    positions.push_back(points_[k][axis]);
  }
  if (bends.empty()) return 0.0;
  const double most = 2.0 * base::median(sizes);
  for (double& bend : bends) bend = std::clamp(bend, -most, most);
  return powerAt(bends, positions, 1.0 / period);
}

ScaleLadder::Measures ScaleLadder::measuresOf(const std::vector<char>& chosen) const {
  Measures sums;
  const std::size_t count = steps_.size();
  sums.curvature.resize(count);
  sums.normal.resize(count);
  sums.meanSquareCurvature.resize(count);
  if (count == 0) return sums;
  const std::vector<AtPoint>& weighting = steps_[std::min(kWeightStep, count - 1)].points;
  double weights = 0.0;
  for (std::size_t k = 0; k < points_.size(); ++k)
    if (chosen[k]) weights += weighting[k].slope * weighting[k].slope;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (!chosen[k]) continue;
    ++sums.points;
    const double weight = weighting[k].slope * weighting[k].slope / weights;
    for (std::size_t i = 0; i < count; ++i) {
      const AtPoint& a = steps_[i].points[k];
      const PointNoise& noise = steps_[i].noise;
      sums.meanSquareCurvature[i] += weight * squareSum(a.shape);
      const double inverse = weight / (a.slope * a.slope);
      sums.curvature[i].noise += kTensorNoise * noise.hessian * inverse;
      sums.normal[i].noise += 2.0 * noise.gradient * inverse;
      if (i + 1 == count) continue;
      const AtPoint& b = steps_[i + 1].points[k];
      const PointNoise &next = steps_[i + 1].noise, &both = steps_[i].noiseWithNext;
      const auto ofNoise = [&](double PointNoise::*which) {
        return noise.*which / (a.slope * a.slope) + next.*which / (b.slope * b.slope) -
               2.0 * (both.*which) / (a.slope * b.slope);
      };
      sums.curvature[i].change += weight * squareSum(b.shape - a.shape);
      sums.curvature[i].changeOfNoise += weight * kTensorNoise * ofNoise(&PointNoise::hessian);
      const glm::dvec3 turn = b.normal - a.normal;
      sums.normal[i].change += weight * glm::dot(turn, turn);
      sums.normal[i].changeOfNoise += weight * 2.0 * ofNoise(&PointNoise::gradient);
    }
  }
  return sums;
}

}  // namespace isolux::volume
