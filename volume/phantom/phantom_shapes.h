// Blended solids for the head phantom: lists of ellipsoids and tapered, ellipsoidal limbs as signed
// distances.
//
// Lengths in mm; distances are negative inside, exact to first order near the surface. Only + - * / and
// square roots are used, so that results do not depend on the machine's mathematical library.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::volume {

// An ellipsoid with axis-parallel radii that change linearly while its centre moves from a to b.
struct Shape {
  glm::vec3 a, b;
  glm::vec3 radiiA, radiiB;
  float blend = 0.0f;     // width of the smooth transition to what stands before it in the list
  bool remove = false;    // taken away from what stands before it in the list, else added
  bool mirrored = false;  // the shape given for x > 0 is there on both sides
};

// Shapes in the order in which they are added and removed.
class Solid {
 public:
  Solid& add(glm::vec3 centre, glm::vec3 radii, float blend);
  Solid& addLimb(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend);
  Solid& remove(glm::vec3 centre, glm::vec3 radii, float blend);
  Solid& removeLimb(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend);
  // The same on both sides of the plane x = 0.
  Solid& addPair(glm::vec3 centre, glm::vec3 radii, float blend);
  Solid& addLimbs(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend);
  Solid& removePair(glm::vec3 centre, glm::vec3 radii, float blend);
  Solid& removeLimbs(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend);

  // Those shapes that matter within `reach` of `centre`: the distance to the result equals that to the whole
  // solid there wherever it lies in [-margin, margin].
  void select(glm::vec3 centre, float reach, float margin, std::vector<const Shape*>& out) const;

 private:
  std::vector<Shape> shapes_;
};

// Smallest of two with a cubic transition of width k, twice continuously differentiable.
float smoothMinimum(float a, float b, float k);

// Points that are looked at together, one per SIMD lane.
struct PointRow {
  static constexpr int kPoints = 8;
  float x[kPoints], y[kPoints], z[kPoints];
};

// Signed distances of the points to the blended shapes; far outside when there are none. The same bit for
// bit with any instruction set.
void distancesTo(std::span<const Shape* const> shapes, const PointRow& points,
                 float (&distances)[PointRow::kPoints]);

}  // namespace isolux::volume
