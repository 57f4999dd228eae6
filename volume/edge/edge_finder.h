// How far a surface lies from the edge of its object, and how clear its boundary is, at single points: in
// double precision (edge_walk.h has the definitions).
//
// The object's edge is where |grad f| has its nearest maximum along the normal; an isovalue is where somebody
// has put it. Derivatives are those of the field at derivatives.scale, or of the spline of derivatives.field
// at scale 0 (of `trilinear`, which has no second derivatives, the cubic B-spline of the samples).
#pragma once

#include <optional>

#include "scene/noise.h"
#include "scene/scene.h"
#include "volume/edge/edge_walk.h"
#include "volume/field/coefficients.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"

namespace isolux::volume {

struct EdgeQuestion {
  double searchMm = 0.0;      // each way along the normal
  double contrast = 5.0;      // |g| of an edge over the standard deviation of its noise
  double noise = 0.0;         // standard deviation of a voxel, data units
  glm::dvec3 noiseBlur{0.0};  // scene::NoiseModel
  double outward = -1.0;      // of gradients of values: -1 where inside is above the isovalue
};

// Null members are not needed by the field.
struct EdgeField {
  scene::Field field = scene::Field::cubic;
  const Coefficients* coefficients = nullptr;  // of cubic_interpolating at scale 0
  const ScaledField* scaled = nullptr;         // of a scale above 0
};

struct Edge {
  std::optional<double> offsetMm;  // to the edge, along the outward normal; none: no edge within the search
  double strength = 0.0;           // |g| at the point over the standard deviation of its noise
};

// Noise of data that have none: a part of the range of values, below which nothing counts as an edge.
inline constexpr double kLeastEdgeNoise = 1.0 / 4096.0;

// The distance that is searched where edge.search is automatic: 3 of the largest voxel spacing and twice the
// scale.
double automaticEdgeSearch(const GridGeometry& geometry, double scaleMm);

// The question in the terms of the walk, for both precisions.
EdgeSearch<double> edgeSearch(const Grid& grid, scene::Field field, double scaleMm,
                              const EdgeQuestion& question);
EdgeSearch<float> inFloats(const EdgeSearch<double>& search);

class EdgeFinder {
 public:
  // Keeps references to all but the question.
  EdgeFinder(const Grid& grid, const EdgeField& field, const EdgeQuestion& question);
  EdgeFinder(const Grid& grid, const EdgeField& field, const EdgeSearch<double>& search)
      : grid_(grid), field_(field), search_(search) {}
  Edge at(const glm::dvec3& voxel) const;

 private:
  const Grid& grid_;
  EdgeField field_;
  EdgeSearch<double> search_;
};

}  // namespace isolux::volume
