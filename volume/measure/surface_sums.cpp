#include "volume/measure/surface_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/random.h"
#include "volume/field/noise_gain.h"

namespace isolux::volume {

namespace {

// What sampling costs is up to so many times the estimate: about once where the object is smooth, twice at
// its edges, most where steps of one voxel meet slices of six (docs/explanation/measurement.md).
constexpr double kSamplingSafety = 3.5;
constexpr double kSigmas = 2.0;  // of noise and of what is random from cell to cell
constexpr std::size_t kFewCells = 30000;

// Two standard deviations of what independent noise of the voxels does to the volume, and what it adds to the
// area. A voxel moves the volume by its share of the integral of 1 / |g|; of a surface at random between two
// layers of voxels the squares of the shares sum to 2/3 of (face / |g|)^2 for each face's worth of surface.
void addNoise(const Grid& grid, const SurfaceQuestion& question, const SurfaceSums& sums,
              const CellMetric& metric, SurfaceMeasure& result) {
  const double noise = question.noise.at(question.isovalue);
  if (!(noise > 0.0) || sums.cells == 0) return;
  double together = 1.0;  // voxels whose noise is alike
  for (int axis = 0; axis < 3; ++axis)
    together *= std::max(1.0, 2.0 * std::sqrt(std::numbers::pi) * question.noise.correlation[axis]);
  const double variance = noise * noise * sums.perGradient2 * metric.faceMm2 * together * 2.0 / 3.0;
  result.volumeParts.noise = kSigmas * std::sqrt(variance);
  // Slopes of the noise along the surface, per mm: half their square is what the area gains.
  const glm::dvec3 gain = noiseGain(scene::Field::trilinear, question.noise.correlation).gradient;
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const double slopes = noise * noise *
                        (gain.x / (spacing.x * spacing.x) + gain.y / (spacing.y * spacing.y) +
                         gain.z / (spacing.z * spacing.z)) /
                        3.0;
  result.areaParts.noise = std::min(slopes * sums.perGradient2, sums.measure.area);
}

// Half the distance of slices is the most that a surface across them may be off; of surfaces that lie all
// ways half of that. The area changes with it as a ball's of this area and volume does.
void addSlices(const SurfaceQuestion& question, const SurfaceSums& sums, SurfaceMeasure& result) {
  const double offMm = 0.25 * question.noise.slicesMm, area = sums.measure.area;
  if (offMm == 0.0 || area == 0.0) return;
  result.volumeParts.slices = offMm * area;
  const double radiusMm = 3.0 * std::abs(sums.measure.volume) / area;
  result.areaParts.slices = area * std::min(1.0, 2.0 * offMm / radiusMm);
}

}  // namespace

SurfaceMeasure concluded(const Grid& grid, const SurfaceQuestion& question, const SurfaceSums& sums) {
  const CellMetric metric{glm::dmat3(grid.geometry().worldFromVoxel)};
  SurfaceMeasure result;
  result.areaMm2.value = sums.measure.area;
  result.volumeMm3.value = sums.measure.volume;
  result.volumePerValue = sums.measure.sensitivity;
  result.cells = sums.cells;
  result.meetsMissing = sums.meetsMissing;
  result.meetsBorder = sums.meetsBorder;
  result.areaParts.quadrature = sums.measure.areaError;
  result.volumeParts.quadrature = sums.measure.volumeError;
  result.areaParts.cut = sums.cutArea;
  result.volumeParts.cut = sums.cutVolume;
  // Where voxels are missing the surface is taken to err as elsewhere.
  const SamplingShift& shift = sums.shift;
  const double known = shift.measuredArea > 0.0 ? sums.measure.area / shift.measuredArea : 1.0;
  result.areaParts.sampling =
      kSamplingSafety * known * (shift.area() + kSigmas * std::sqrt(shift.areaSquares));
  result.volumeParts.sampling =
      kSamplingSafety * known * (std::abs(shift.volume) + kSigmas * std::sqrt(shift.volumeSquares));
  addNoise(grid, question, sums, metric, result);
  addSlices(question, sums, result);
  result.areaMm2.error = result.areaParts.sum();
  result.volumeMm3.error = result.volumeParts.sum();
  return result;
}

SurfaceSums& SurfaceSums::operator+=(const SurfaceSums& other) {
  measure += other.measure;
  shift += other.shift;
  cutVolume += other.cutVolume;
  cutArea += other.cutArea;
  perGradient2 += other.perGradient2;
  cells += other.cells;
  meetsBorder = meetsBorder || other.meetsBorder;
  meetsMissing = meetsMissing || other.meetsMissing;
  return *this;
}

CellAccumulator::CellAccumulator(const Grid& grid, const SurfaceQuestion& question, bool allNodes)
    : grid_(grid),
      allNodes_(allNodes),
      sign_(question.inside == scene::Inside::above ? 1.0 : -1.0),
      metric_(glm::dmat3(grid.geometry().worldFromVoxel)),
      shifts_(grid, question.isovalue, sign_) {}

void CellAccumulator::addPoints(glm::ivec3 cell, std::vector<CellPoint>& points, SurfaceSums& sums) const {
  double area = 0.0;
  for (const CellPoint& point : points) {
    const double steepness2 = glm::dot(point.gradient, metric_.gradients * point.gradient);
    if (steepness2 > 0.0) sums.perGradient2 += point.area / steepness2;
    area += point.area;
  }
  SamplingShift shift;
  if (allNodes_) {
    for (const CellPoint& point : points) shift += shifts_.at(cell, point);
  } else {
    double left = area * base::uniformNoise(1, grid_.index(cell.x, cell.y, cell.z));
    std::size_t chosen = 0;
    while (chosen + 1 < points.size() && (left -= points[chosen].area) > 0.0) ++chosen;
    points[chosen].area = area;
    shift = shifts_.at(cell, points[chosen]);
  }
  shift.volumeSquares = shift.volume * shift.volume;
  shift.areaSquares = shift.area() * shift.area();
  sums.shift += shift;
}

bool fewCells(const Grid& grid, const MinMaxBlocks& blocks, double isovalue) {
  std::vector<std::uint8_t> flags;
  const std::size_t active = blocks.activeBlocks(grid.storedIsovalue(isovalue), flags);
  const auto side = static_cast<std::size_t>(blocks.blockCells());
  return active * side * side < kFewCells;
}

}  // namespace isolux::volume
