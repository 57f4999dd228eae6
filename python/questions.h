// What is asked of a volume in double precision: first hits of rays, values and derivatives at points, area
// and enclosed volume.
//
// Points and directions are rows of x, y, z in world mm; answers are in their order, NaN where there is none.
#pragma once

#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "python/core.h"

namespace isolux::python {

struct Hits {
  std::vector<double> t;             // mm from the origin
  std::vector<glm::dvec3> position;  // world mm
  std::vector<glm::dvec3> normal;    // outward, of the smoothing spline
  std::vector<double> error;         // of t, mm: what sampling and the noise of the voxels make of it
  std::vector<double> valueError;    // |f - isovalue| at the hit, data units
  std::vector<std::uint8_t> entering;
};
// The trilinear isosurface of the scene, as its cuts leave it. Directions need not be unit; zero or not
// finite ones hit nothing.
Hits hits(Core& core, const app::SceneOptions& options, std::vector<glm::dvec3> origins,
          std::vector<glm::dvec3> directions, const pybind11::object& told);

struct Probed {
  std::vector<double> value;
  std::vector<glm::dvec3> gradient, normal;
  std::vector<glm::dmat3> hessian;
  std::vector<glm::dvec2> kappa;
  std::vector<double> confidence;
  double scaleMm = 0.0;
};
Probed probe(Core& core, const app::SceneOptions& options, std::vector<glm::dvec3> points,
             const pybind11::object& told);

// The JSON of `isolux measure --json`, without what is measured between points. `anyway`: also where lengths
// are doubtful. Throws Error{usage} where there is no surface, Error{input} of doubtful lengths.
std::string measure(Core& core, const app::SceneOptions& options, bool anyway, const pybind11::object& told);

// The JSON of `isolux measure --labels --json`. `smoothing`: voxels. Throws Error{usage} where that is not
// from 0 to 2, Error{input} of values that are no labels and of doubtful lengths.
std::string measureLabels(Core& core, double smoothing, bool anyway, const pybind11::object& told);

}  // namespace isolux::python
