#include "volume/measure/surface_measure.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "volume/field/noise_gain.h"
#include "volume/measure/box_part.h"
#include "volume/measure/sampling_error.h"
#include "volume/parallel_steps.h"

namespace isolux::volume {

namespace {

// What sampling costs is up to so many times the estimate: about once where the object is smooth, twice at
// its edges, most where steps of one voxel meet slices of six (docs/numerics.md).
constexpr double kSamplingSafety = 3.5;
constexpr double kSigmas = 2.0;  // of noise and of what is random from cell to cell
constexpr std::size_t kFewCells =
    30000;  // up to here all nodes of the quadrature are looked at, else one a cell

struct SurfaceSums {
  CellMeasure measure;
  SamplingShift shift;
  double cutVolume = 0.0, cutArea = 0.0;  // of parts of cells of which a box's wall was not resolved
  double perGradient2 = 0.0;              // integral of 1 / |g|^2, mm^2 (mm / data unit)^2
  std::size_t cells = 0;
  bool meetsMissing = false;

  SurfaceSums& operator+=(const SurfaceSums& o) {
    measure += o.measure;
    shift += o.shift;
    cutVolume += o.cutVolume;
    cutArea += o.cutArea;
    perGradient2 += o.perGradient2;
    cells += o.cells;
    meetsMissing = meetsMissing || o.meetsMissing;
    return *this;
  }
};

// One row of blocks along x, by one thread.
class BlockRow {
 public:
  BlockRow(const Grid& grid, const MinMaxBlocks& blocks, const SurfaceQuestion& question, bool allNodes)
      : grid_(grid),
        blocks_(blocks),
        question_(question),
        allNodes_(allNodes),
        sign_(question.inside == scene::Inside::above ? 1.0 : -1.0),
        metric_(glm::dmat3(grid.geometry().worldFromVoxel)),
        shifts_(grid, question.isovalue, sign_) {
    if (question.box) walls_.emplace(grid.geometry(), *question.box);
  }

  SurfaceSums measure(int blockY, int blockZ) {
    sums_ = {};
    for (int x = 0; x < blocks_.dims().x; ++x) addBlock({x, blockY, blockZ});
    return sums_;
  }

 private:
  void addBlock(glm::ivec3 block);
  template <class T>
  void addCells(const std::vector<T>& voxels, glm::ivec3 low, glm::ivec3 high);
  void addCell(glm::ivec3 cell, const CellCorners& corners, bool crossed);
  void addPoints(glm::ivec3 cell);

  const Grid& grid_;
  const MinMaxBlocks& blocks_;
  const SurfaceQuestion& question_;
  bool allNodes_;
  double sign_;
  CellMetric metric_;
  SamplingShifts shifts_;
  std::optional<BoxWalls> walls_;
  std::vector<CellPoint> points_;
  SurfaceSums sums_;
};

void BlockRow::addBlock(glm::ivec3 block) {
  const glm::ivec3 low = block * blocks_.blockCells(),
                   high = glm::min(low + blocks_.blockCells(), grid_.dims() - 1);
  const auto isovalue = static_cast<float>(grid_.storedOfValue(question_.isovalue));
  const bool walk = grid_.missingCount() > 0 || question_.keeps ||
                    blocks_.active(blocks_.index(block), isovalue) ||
                    (walls_ && walls_->side(low, high) == BoxWalls::Side::cut);
  if (walk) {
    std::visit([&](const auto& voxels) { addCells(voxels, low, high); }, grid_.voxels());
    return;
  }
  if (walls_ && walls_->side(low, high) == BoxWalls::Side::outside) return;
  if (!(sign_ * (grid_.value(low.x, low.y, low.z) - question_.isovalue) >= 0.0)) return;
  const glm::dvec3 cells(high - low);
  sums_.measure.volume += cells.x * cells.y * cells.z * metric_.cellMm3;
}

template <class T>
void BlockRow::addCells(const std::vector<T>& voxels, glm::ivec3 low, glm::ivec3 high) {
  const auto value = [&](std::size_t index) {
    return sign_ * (grid_.valueOfStored(static_cast<double>(voxels[index])) - question_.isovalue);
  };
  for (int z = low.z; z < high.z; ++z)
    for (int y = low.y; y < high.y; ++y) {
      const std::size_t rows[4] = {grid_.index(0, y, z), grid_.index(0, y + 1, z), grid_.index(0, y, z + 1),
                                   grid_.index(0, y + 1, z + 1)};
      CellCorners corner{};
      const auto load = [&](int x, std::size_t side) {
        for (std::size_t i = 0; i < 4; ++i)
          corner[2 * i + side] = value(rows[i] + static_cast<std::size_t>(x));
      };
      load(low.x, 1);
      for (int x = low.x; x < high.x; ++x) {
        for (std::size_t i = 0; i < 8; i += 2) corner[i] = corner[i + 1];
        load(x + 1, 1);
        int inside = 0, missing = 0;
        for (const double c : corner) {
          inside += c >= 0.0;
          missing += std::isnan(c);
        }
        if (inside == 0) continue;
        if (missing > 0) sums_.meetsMissing = true;
        if (missing == 0 && (!question_.keeps || question_.keeps({x, y, z})))
          addCell({x, y, z}, corner, inside < 8);
      }
    }
}

void BlockRow::addCell(glm::ivec3 cell, const CellCorners& corners, bool crossed) {
  const BoxWalls::Side side = walls_ ? walls_->side(cell, cell + 1) : BoxWalls::Side::inside;
  if (side == BoxWalls::Side::outside) return;
  points_.clear();
  if (side == BoxWalls::Side::cut) {
    const BoxPart part = walls_->measure(cell, corners, metric_, points_);
    sums_.measure += part.measure;
    sums_.cutVolume += part.unsureVolume;
    sums_.cutArea += part.unsureArea;
  } else {
    sums_.measure += measureCell(corners, metric_, crossed ? &points_ : nullptr);
  }
  if (points_.empty()) return;
  ++sums_.cells;
  addPoints(cell);
}

void BlockRow::addPoints(glm::ivec3 cell) {
  double area = 0.0;
  for (const CellPoint& point : points_) {
    const double steepness2 = glm::dot(point.gradient, metric_.gradients * point.gradient);
    if (steepness2 > 0.0) sums_.perGradient2 += point.area / steepness2;
    area += point.area;
  }
  SamplingShift shift;
  if (allNodes_) {
    for (const CellPoint& point : points_) shift += shifts_.at(cell, point);
  } else {
    double left = area * base::uniformNoise(1, grid_.index(cell.x, cell.y, cell.z));
    std::size_t chosen = 0;
    while (chosen + 1 < points_.size() && (left -= points_[chosen].area) > 0.0) ++chosen;
    points_[chosen].area = area;
    shift = shifts_.at(cell, points_[chosen]);
  }
  shift.volumeSquares = shift.volume * shift.volume;
  shift.areaSquares = shift.area() * shift.area();
  sums_.shift += shift;
}

bool borderInside(const Grid& grid, const SurfaceQuestion& question) {
  const glm::ivec3 dims = grid.dims();
  const double sign = question.inside == scene::Inside::above ? 1.0 : -1.0;
  std::optional<BoxWalls> walls;
  if (question.box) walls.emplace(grid.geometry(), *question.box);
  for (int axis = 0; axis < 3; ++axis)
    for (const int plane : {0, dims[axis] - 1}) {
      glm::ivec3 p(0);
      p[axis] = plane;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (p[v] = 0; p[v] < dims[v]; ++p[v])
        for (p[u] = 0; p[u] < dims[u]; ++p[u]) {
          if (!(sign * (grid.value(p.x, p.y, p.z) - question.isovalue) >= 0.0)) continue;
          const glm::ivec3 cell = glm::min(p, dims - 2);
          if (question.keeps && !question.keeps(cell)) continue;
          if (!walls || walls->side(p, p) == BoxWalls::Side::inside) return true;
        }
    }
  return false;
}

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

SurfaceMeasure conclude(const Grid& grid, const SurfaceQuestion& question, const SurfaceSums& sums) {
  const CellMetric metric{glm::dmat3(grid.geometry().worldFromVoxel)};
  SurfaceMeasure result;
  result.areaMm2.value = sums.measure.area;
  result.volumeMm3.value = sums.measure.volume;
  result.volumePerValue = sums.measure.sensitivity;
  result.cells = sums.cells;
  result.meetsMissing = sums.meetsMissing;
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
  result.areaMm2.error = result.areaParts.sum();
  result.volumeMm3.error = result.volumeParts.sum();
  return result;
}

}  // namespace

SurfaceMeasure measureSurface(const Grid& grid, const MinMaxBlocks& blocks, const SurfaceQuestion& question,
                              base::Progress& progress) {
  if (blocks.count() == 0 || std::isnan(question.isovalue)) return {};
  std::vector<std::uint8_t> flags;
  const std::size_t active =
      blocks.activeBlocks(static_cast<float>(grid.storedOfValue(question.isovalue)), flags);
  const auto side = static_cast<std::size_t>(blocks.blockCells());
  const bool allNodes = active * side * side < kFewCells;
  const auto rowsY = static_cast<std::size_t>(blocks.dims().y);
  std::vector<SurfaceSums> rows(rowsY * static_cast<std::size_t>(blocks.dims().z));
  parallelSteps(rows.size(), progress, {0.0, 1.0, "measuring"}, [&](std::size_t row) {
    rows[row] = BlockRow(grid, blocks, question, allNodes)
                    .measure(static_cast<int>(row % rowsY), static_cast<int>(row / rowsY));
  });
  SurfaceSums sums;
  for (const SurfaceSums& row : rows) sums += row;
  SurfaceMeasure result = conclude(grid, question, sums);
  result.meetsBorder = borderInside(grid, question);
  return result;
}

}  // namespace isolux::volume
