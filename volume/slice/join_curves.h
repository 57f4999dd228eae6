// Pieces of curves, each from one edge to another, as whole curves.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "volume/slice/cell_curve.h"

namespace isolux::volume {

struct JoinedCurve {
  std::vector<glm::dvec2> points;  // (a, b)
  bool closed = false;             // the first point is not repeated
};

// Of each edge at most one piece begins and at most one ends there. Points closer than 1e-9 are one.
std::vector<JoinedCurve> joinedCurves(const std::vector<CurvePiece>& pieces);

}  // namespace isolux::volume
