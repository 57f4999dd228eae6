// What of a cell lies within a box of the world.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/measure/cell_measure.h"

namespace isolux::volume {

struct WorldBox {
  glm::dvec3 lowMm{0.0}, highMm{0.0};
};

struct BoxPart {
  CellMeasure measure;
  double unsureVolume = 0.0, unsureArea = 0.0;  // at most so much is on the wrong side of a wall
};

class BoxWalls {
 public:
  enum class Side { outside, cut, inside };

  BoxWalls(const GridGeometry& geometry, const WorldBox& box);

  // Of the cells between two corners, voxel coordinates. `cut` may stand for outside.
  Side side(glm::dvec3 low, glm::dvec3 high) const;
  // Exact where the grid's axes are those of the world, else in parts of 1/16 of the cell, of which those
  // that a wall cuts count where their middles are inside. Appends points of the surface.
  BoxPart measure(glm::ivec3 cell, const CellCorners& corners, const CellMetric& metric,
                  std::vector<CellPoint>& points) const;

 private:
  void addPart(glm::ivec3 cell, const CellCorners& corners, const CellMetric& metric, glm::dvec3 low,
               double size, BoxPart& part, std::vector<CellPoint>& points) const;

  GridGeometry geometry_;
  WorldBox box_;
  bool aligned_;
  glm::dvec3 lowVoxel_{0.0}, highVoxel_{0.0};  // of the box, where aligned
};

}  // namespace isolux::volume
