// A dense search along a ray, in double precision: what every finder of first hits must find, whatever its
// rounding.
//
// Knows nothing of cells' cubics. The field is sampled at steps of 1/16 voxel; a crossing is *clear* where
// the field goes from more than a margin on one side of the isovalue to more than that on the other, with no
// missing voxel near the way between. A finder must have found a hit there at the latest.
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/hit/cell_walk.h"

namespace isolux::test {

// A field in double precision, stored units: no slope or intercept rounds anything.
class DoubleField {
 public:
  DoubleField(const volume::Grid& grid, scene::Field field);

  const volume::Grid& grid() const { return grid_; }  // of stored values

  // NaN beside missing voxels.
  double operator()(const glm::dvec3& voxel) const;
  // Its samples lie in [least, most], and so does the field; along an axis it changes by at most their
  // difference per voxel.
  double least() const { return least_; }
  double most() const { return most_; }
  double range() const { return most_ - least_; }
  // The same of the samples within two voxels.
  double rangeAt(const glm::dvec3& voxel) const;
  // Any voxel that a lookup between two points reads, or one `slack` voxels beside, is missing.
  bool missingBetween(const glm::dvec3& a, const glm::dvec3& b, double slack) const;

 private:
  volume::Grid grid_;
  scene::Field field_;
  std::optional<volume::Coefficients> coefficients_;
  double least_, most_;
};

// t behind the first clear crossing, and whether f rises there. `slack`: how far beside the ray a finder's
// own may lie, voxels.
struct ClearCrossing {
  double t;
  bool rises;
};
// `rising`: only those where it rises, or falls.
std::optional<ClearCrossing> firstClearCrossing(const DoubleField& field, double storedIsovalue,
                                                double margin, double slack, const volume::Ray& ray,
                                                std::optional<bool> rising = {});

}  // namespace isolux::test
