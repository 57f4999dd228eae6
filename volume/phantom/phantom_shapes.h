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
  using Vec = glm::vec3;
  // An ellipsoid about c with radii r, or a limb from a to b with radii ra and rb.
  Solid& add(Vec c, Vec r, float blend) { return put({c, c, r, r, blend}); }
  Solid& addLimb(Vec a, Vec b, Vec ra, Vec rb, float blend) { return put({a, b, ra, rb, blend}); }
  Solid& remove(Vec c, Vec r, float blend) { return put({c, c, r, r, blend, true}); }
  Solid& removeLimb(Vec a, Vec b, Vec ra, Vec rb, float blend) { return put({a, b, ra, rb, blend, true}); }
  // The same on both sides of the plane x = 0.
  Solid& addPair(Vec c, Vec r, float blend) { return put({c, c, r, r, blend, false, true}); }
  Solid& addLimbs(Vec a, Vec b, Vec ra, Vec rb, float blend) {
    return put({a, b, ra, rb, blend, false, true});
  }
  Solid& removePair(Vec c, Vec r, float blend) { return put({c, c, r, r, blend, true, true}); }
  Solid& removeLimbs(Vec a, Vec b, Vec ra, Vec rb, float blend) {
    return put({a, b, ra, rb, blend, true, true});
  }

  // Those shapes that matter within `reach` of `centre`: the distance to the result equals that to the whole
  // solid there wherever it lies in [-margin, margin].
  void select(glm::vec3 centre, float reach, float margin, std::vector<const Shape*>& out) const;

 private:
  Solid& put(const Shape& shape) {
    shapes_.push_back(shape);
    return *this;
  }
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
