// What a surface, or a part of it, sums up to: by cells, and concluded as measures with errors. Internal to
// this folder.
#pragma once

#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/measure/cell_measure.h"
#include "volume/measure/sampling_error.h"
#include "volume/measure/surface_measure.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SurfaceSums {
  CellMeasure measure;
  SamplingShift shift;
  double cutVolume = 0.0, cutArea = 0.0;  // of parts of cells that may belong elsewhere
  double perGradient2 = 0.0;              // integral of 1 / |g|^2, mm^2 (mm / data unit)^2
  std::size_t cells = 0;                  // that hold the surface
  bool meetsBorder = false, meetsMissing = false;

  SurfaceSums& operator+=(const SurfaceSums& other);
};

SurfaceMeasure concluded(const Grid& grid, const SurfaceQuestion& question, const SurfaceSums& sums);

// What cells of one surface are measured with; for one thread at a time.
class CellAccumulator {
 public:
  // allNodes: look at the sampling error at all nodes of the quadrature, not at one a cell.
  CellAccumulator(const Grid& grid, const SurfaceQuestion& question, bool allNodes);

  double sign() const { return sign_; }  // of values less the isovalue, to be positive inside
  const CellMetric& metric() const { return metric_; }
  // The points of the surface in a cell, with areas that sum to that of it.
  void addPoints(glm::ivec3 cell, std::vector<CellPoint>& points, SurfaceSums& sums) const;

 private:
  const Grid& grid_;
  bool allNodes_;
  double sign_;
  CellMetric metric_;
  SamplingShifts shifts_;
};

// Whether the surface has so few cells that all nodes can be looked at.
bool fewCells(const Grid& grid, const MinMaxBlocks& blocks, double isovalue);

// Calls visit(cell, corners, inside, missing) for the cells from `low` up to `high` that have an inside
// corner, with how many corners are inside and missing (NaN then).
template <class Visit>
void visitCells(const Grid& grid, double isovalue, double sign, glm::ivec3 low, glm::ivec3 high,
                const Visit& visit) {
  grid.visit([&](const auto& voxels) {
    const auto value = [&](std::size_t index) {
      return sign * (grid.valueOfStored(static_cast<double>(voxels[index])) - isovalue);
    };
    for (int z = low.z; z < high.z; ++z)
      for (int y = low.y; y < high.y; ++y) {
        const std::size_t rows[4] = {grid.index(0, y, z), grid.index(0, y + 1, z), grid.index(0, y, z + 1),
                                     grid.index(0, y + 1, z + 1)};
        CellCorners corner{};
        const auto load = [&](int x) {
          for (std::size_t i = 0; i < 4; ++i)
            corner[2 * i + 1] = value(rows[i] + static_cast<std::size_t>(x));
        };
        load(low.x);
        for (int x = low.x; x < high.x; ++x) {
          for (std::size_t i = 0; i < 8; i += 2) corner[i] = corner[i + 1];
          load(x + 1);
          int inside = 0, missing = 0;
          for (const double c : corner) {
            inside += c >= 0.0;
            missing += std::isnan(c);
          }
          if (inside > 0) visit(glm::ivec3(x, y, z), corner, inside, missing);
        }
      }
  });
}

// Returns ofRow(y, z) of each row of blocks along x, layer by layer; on all cores. Throws Error{interrupted}.
template <class OfRow>
auto ofBlockRows(const MinMaxBlocks& blocks, const char* stage, base::Progress& progress,
                 const OfRow& ofRow) {
  const Extent3 extent{blocks.dims()};
  std::vector<decltype(ofRow(0, 0))> rows(extent.rows());
  parallelSteps(rows.size(), progress, {0.0, 1.0, stage}, [&](std::size_t row) {
    const glm::ivec3 first = extent.firstOfRow(row);
    rows[row] = ofRow(first.y, first.z);
  });
  return rows;
}

// Calls visit(cell, corners) for the cells of a row of blocks along x that the surface crosses, but for those
// with a missing corner.
template <class Visit>
void visitCrossedCells(const Grid& grid, const MinMaxBlocks& blocks, double isovalue, double sign, int blockY,
                       int blockZ, const Visit& visit) {
  for (int x = 0; x < blocks.dims().x; ++x) {
    const glm::ivec3 block(x, blockY, blockZ), low = block * blocks.blockCells();
    if (!blocks.active(blocks.index(block), grid.storedIsovalue(isovalue))) continue;
    visitCells(grid, isovalue, sign, low, glm::min(low + blocks.blockCells(), grid.dims() - 1),
               [&](glm::ivec3 cell, const CellCorners& corners, int inside, int missing) {
                 if (missing == 0 && inside < 8) visit(cell, corners);
               });
  }
}

}  // namespace isolux::volume
