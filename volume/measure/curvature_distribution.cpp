#include "volume/measure/curvature_distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/memory_budget.h"
#include "base/numbers.h"
#include "scene/looks.h"
#include "volume/derived/shape_field.h"
#include "volume/field/curvature.h"
#include "volume/measure/surface_sums.h"

namespace isolux::volume {

namespace {

using scene::LookMode;

constexpr LookMode kMeasures[] = {LookMode::kappa1,         LookMode::kappa2,
                                  LookMode::mean_curvature, LookMode::gaussian_curvature,
                                  LookMode::shape_index,    LookMode::curvedness};
constexpr double kClearDeviations = 3.0;
constexpr double kInward = 1e-3;  // voxels from the surface: where its piece is asked for
constexpr double kTails = 0.025;  // of the area that counts, at each end, is beyond the bins
constexpr double kBins = 60.0;    // about so many

// A point of the surface that stands for the area about it: one in each cell, or for each piece in it.
struct SurfacePatch {
  glm::dvec3 voxel{0.0};  // on the trilinear surface
  double areaMm2 = 0.0;
  std::uint32_t piece = Pieces::kNone;
};

// The piece of all inside corners; kNone where there are several.
std::uint32_t onlyPiece(const Pieces& pieces, glm::ivec3 cell, const CellCorners& corners) {
  std::uint32_t one = Pieces::kNone;
  for (std::size_t i = 0; i < 8; ++i) {
    if (!(corners[i] >= 0.0)) continue;
    const std::uint32_t id = pieces.ofVoxel(cell + cornerStep(i));
    if (one != Pieces::kNone && id != one) return Pieces::kNone;
    one = id;
  }
  return one;
}

// Of the points of one piece: that nearest to their middle, with the area of all.
SurfacePatch patchOf(const std::vector<CellPoint>& points, const std::vector<std::uint32_t>& pieceOfPoint,
                     std::uint32_t piece) {
  SurfacePatch patch{{}, 0.0, piece};
  glm::dvec3 middle(0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (pieceOfPoint[i] == piece) {
      middle += points[i].area * points[i].local;
      patch.areaMm2 += points[i].area;
    }
  middle /= patch.areaMm2;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 away = points[i].local - middle;
    if (pieceOfPoint[i] != piece || !(glm::dot(away, away) < nearest)) continue;
    nearest = glm::dot(away, away);
    patch.voxel = points[i].local;
  }
  return patch;
}

// Returns those of the blocks with these y and z, in the order of their cells.
std::vector<SurfacePatch> patchesOfRow(const Pieces& pieces, const MinMaxBlocks& blocks, int blockY,
                                       int blockZ) {
  const CellMetric metric{glm::dmat3(pieces.grid().geometry().worldFromVoxel)};
  const double sign = pieces.inside() == scene::Inside::above ? 1.0 : -1.0;
  std::vector<SurfacePatch> patches;
  std::vector<CellPoint> points;
  std::vector<std::uint32_t> pieceOfPoint;
  const auto addCell = [&](glm::ivec3 cell, const CellCorners& corners) {
    points.clear();
    measureCell(corners, metric, &points);
    std::erase_if(points, [](const CellPoint& point) { return !(point.area > 0.0); });
    if (points.empty()) return;
    pieceOfPoint.assign(points.size(), onlyPiece(pieces, cell, corners));
    if (pieceOfPoint[0] == Pieces::kNone)
      for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& gradient = points[i].gradient;
        const double length = glm::length(gradient);
        const glm::dvec3 inward = length > 0.0 ? gradient * (kInward / length) : glm::dvec3(0.0);
        const glm::dvec3 local = glm::clamp(points[i].local + inward, 0.0, 1.0);
        pieceOfPoint[i] = pieces.ofPoint(glm::dvec3(cell) + local);
      }
    for (const std::uint32_t piece : std::set(pieceOfPoint.begin(), pieceOfPoint.end())) {
      patches.push_back(patchOf(points, pieceOfPoint, piece));
      patches.back().voxel += glm::dvec3(cell);
    }
  };
  visitCrossedCells(pieces.grid(), blocks, pieces.isovalue(), sign, blockY, blockZ, addCell);
  return patches;
}

struct CurvedArea {
  double areaMm2 = 0.0, kappa1 = 0.0, kappa2 = 0.0,
         noise = 0.0;  // noise: standard deviation of a normal curvature
  bool known = false;
  bool clear() const { return std::max(std::abs(kappa1), std::abs(kappa2)) > kClearDeviations * noise; }
};

// Curvature at the patches that count.
class PatchCurvature {
 public:
  PatchCurvature(const PreparedVolume& volume, const scene::Scene& resolved, const CurvaturePart& part,
                 base::Progress& progress)
      : geometry_(volume.grid().geometry()),
        part_(part),
        outward_(resolved.isosurface.inside == scene::Inside::above ? -1.0 : 1.0),
        shape_(volume.grid(), *volume.cubicFields, resolved.derivatives.field,
               resolved.derivatives.scale.value_or(0.0), progress),
        scale_(curvatureScale(geometry_, resolved.derivatives.field, resolved.derivatives.noise.value_or(0.0),
                              volume.derivativeChoices->noise(progress).correlation, shape_.scaleMm())) {}

  double scaleMm() const { return shape_.scaleMm(); }
  bool counts(const SurfacePatch& patch) const {
    if (!part_.shown.empty() && !(patch.piece < part_.shown.size() && part_.shown[patch.piece])) return false;
    if (!part_.box) return true;
    const glm::dvec3 world = geometry_.worldOf(patch.voxel);
    return glm::all(glm::lessThanEqual(part_.box->lowMm, world)) &&
           glm::all(glm::lessThanEqual(world, part_.box->highMm));
  }
  CurvedArea at(const SurfacePatch& patch) const {
    const FieldSample sample = shape_.atVoxel(patch.voxel);
    const PrincipalCurvature curvature = principalCurvature(sample.gradient, sample.hessian, outward_);
    CurvedArea area{patch.areaMm2, curvature.kappa1, curvature.kappa2, 0.0,
                    curvature.normal != glm::dvec3(0.0)};
    if (area.known) area.noise = scale_.hessianNoise / glm::length(sample.gradient);
    return area;
  }

 private:
  const GridGeometry& geometry_;
  const CurvaturePart& part_;
  double outward_;
  ShapeField shape_;
  CurvatureScale scale_;
};

std::vector<CurvedArea> curvedAreas(const PatchCurvature& curver, const PreparedVolume& volume,
                                    const Pieces& pieces, base::MemoryBudget::Held& held,
                                    base::Progress& progress) {
  struct Row {
    base::MemoryBudget::Held held;
    std::vector<CurvedArea> areas;
  };
  std::vector<Row> rows =
      ofBlockRows(*volume.blocks, "measuring curvature", progress, [&](int blockY, int blockZ) {
        std::vector<SurfacePatch> patches = patchesOfRow(pieces, *volume.blocks, blockY, blockZ);
        std::erase_if(patches, [&](const SurfacePatch& patch) { return !curver.counts(patch); });
        // Once for the row, once for all together.
        Row row{
            base::machineMemory().reserve(2 * patches.size() * sizeof(CurvedArea),
                                          "the curvature of a surface", "a part of it (--box) needs less"),
            {}};
        row.areas.reserve(patches.size());
        for (const SurfacePatch& patch : patches) {
          if (progress.stopRequested()) break;
          row.areas.push_back(curver.at(patch));
        }
        return row;
      });
  std::vector<CurvedArea> areas;
  for (Row& row : rows) {
    areas.insert(areas.end(), row.areas.begin(), row.areas.end());
    held.add(std::move(row.held));
  }
  return areas;
}

struct WeightedValue {
  double value, areaMm2;
  bool clear;
};

// The value below which this part of the area lies.
double weightedQuantile(const std::vector<WeightedValue>& sorted, double areaMm2, double part) {
  double sum = 0.0;
  for (const WeightedValue& entry : sorted)
    if ((sum += entry.areaMm2) >= part * areaMm2) return entry.value;
  return sorted.back().value;
}

void fillBins(CurvatureHistogram& histogram, const std::vector<WeightedValue>& sorted, double from,
              double to) {
  if (!(to > from)) {  // all the same, as far as numbers tell
    const double half = from != 0.0 ? 0.01 * std::abs(from) : 0.01;
    from -= half, to += half;
  }
  histogram.step = base::niceAbove((to - from) / kBins);
  const double first = std::floor(from / histogram.step), last = std::ceil(to / histogram.step);
  histogram.low = first * histogram.step;
  const auto bins = static_cast<std::size_t>(std::max(1.0, last - first));
  histogram.areasMm2.assign(bins, 0.0);
  histogram.clearMm2.assign(bins, 0.0);
  for (const WeightedValue& entry : sorted) {
    const double place = (entry.value - histogram.low) / histogram.step;
    if (place < 0.0) {
      histogram.belowMm2 += entry.areaMm2;
    } else if (entry.value > histogram.low + static_cast<double>(bins) * histogram.step) {
      histogram.aboveMm2 += entry.areaMm2;
    } else {
      const std::size_t bin = std::min(static_cast<std::size_t>(place), bins - 1);
      histogram.areasMm2[bin] += entry.areaMm2;
      if (entry.clear) histogram.clearMm2[bin] += entry.areaMm2;
    }
  }
}

CurvatureHistogram histogramOf(LookMode measure, const std::vector<CurvedArea>& areas) {
  const scene::LookInfo& look = scene::lookInfo(measure);
  const bool ofShape = measure == LookMode::shape_index;
  CurvatureHistogram histogram{.measure = measure};
  std::vector<WeightedValue> values;
  for (const CurvedArea& area : areas)
    if (area.known && (!ofShape || area.clear()))
      values.push_back({look.measure(area.kappa1, area.kappa2), area.areaMm2, area.clear()});
  if (values.empty()) return histogram;
  double sum = 0.0;
  for (const WeightedValue& entry : values) {
    histogram.areaMm2 += entry.areaMm2;
    sum += entry.areaMm2 * entry.value;
  }
  histogram.mean = sum / histogram.areaMm2;
  double squares = 0.0;
  for (const WeightedValue& entry : values)
    squares += entry.areaMm2 * (entry.value - histogram.mean) * (entry.value - histogram.mean);
  histogram.deviation = std::sqrt(squares / histogram.areaMm2);
  std::ranges::sort(values, {}, &WeightedValue::value);
  const auto quantile = [&](double part) { return weightedQuantile(values, histogram.areaMm2, part); };
  histogram.low5 = quantile(0.05);
  histogram.low25 = quantile(0.25);
  histogram.median = quantile(0.5);
  histogram.high75 = quantile(0.75);
  histogram.high95 = quantile(0.95);
  const bool unit = look.range == scene::LookRange::unit;
  fillBins(histogram, values, unit ? -1.0 : quantile(kTails), unit ? 1.0 : quantile(1.0 - kTails));
  return histogram;
}

}  // namespace

CurvatureDistribution curvatureDistribution(const PreparedVolume& volume, const scene::Scene& resolved,
                                            const Pieces& pieces, const CurvaturePart& part,
                                            base::Progress& progress) {
  CurvatureDistribution out;
  if (volume.blocks->count() == 0) return out;
  const PatchCurvature curver(volume, resolved, part, progress);
  out.scaleMm = curver.scaleMm();
  base::MemoryBudget::Held held;
  const std::vector<CurvedArea> areas = curvedAreas(curver, volume, pieces, held, progress);
  double noise2 = 0.0;
  for (const CurvedArea& area : areas) {
    if (!area.known) {
      out.unknownMm2 += area.areaMm2;
      continue;
    }
    out.areaMm2 += area.areaMm2;
    if (area.clear()) out.clearMm2 += area.areaMm2;
    noise2 += area.areaMm2 * area.noise * area.noise;
    out.meanIntegralMm += area.areaMm2 * 0.5 * (area.kappa1 + area.kappa2);
    out.gaussianIntegral += area.areaMm2 * area.kappa1 * area.kappa2;
  }
  if (out.areaMm2 > 0.0) out.noise = std::sqrt(noise2 / out.areaMm2);
  for (const LookMode measure : kMeasures) {
    progress.throwIfStopped();
    out.measures.push_back(histogramOf(measure, areas));
  }
  return out;
}

}  // namespace isolux::volume
