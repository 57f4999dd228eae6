// What properties are tried on: a volume of a random field, an isovalue and a camera; with a text of one line
// that makes the same again, and with simpler ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "tests/properties/field_terms.h"
#include "volume/cast/picture_rays.h"
#include "volume/grid.h"
#include "volume/hit/cell_walk.h"

namespace isolux::test {

// Member by member what the text says, in its order.
struct PropertyCase {
  FieldTerm field{"const", {0.0}, {}};
  double offset = 0.0, scale = 1.0;  // stored = offset + scale * field, at most 1e37
  glm::ivec3 dims{2};                // 2 to 24; GL also draws 1
  std::string type = "float32";      // integers: the field's range brought to theirs, missing voxels 0
  double slope = 1.0, intercept = 0.0;
  glm::dvec3 spacing{1.0};  // mm
  int turn = 0;             // number of a rotation of the grid; odd ones are oblique
  bool leftHanded = false;
  bool ofVoxel = false;   // isovalue: that of a voxel, exactly,
  double isovalue = 0.5;  // of this number; or this part of the range
  glm::dvec3 eye{0.5, 0.5, -3.0}, target{0.5}, up{0.0, 1.0, 0.0};  // parts of the volume's extent; world
  double fov = 40.0;
  bool orthographic = false;
  glm::ivec2 picture{16, 12};
  std::uint64_t seed = 0;  // of what a property draws

  volume::Grid grid() const;
  double isovalueIn(const volume::Grid& grid) const;  // data units
  scene::Camera camera(const volume::GridGeometry& geometry) const;
};

PropertyCase randomCase(std::uint64_t seed);
std::string textOf(const PropertyCase& made);
// Throws std::invalid_argument.
PropertyCase parseCase(std::string_view text);
// Simpler in one thing each, the simplest first: terms dropped, axes halved, camera along an axis ...
std::vector<PropertyCase> simplerCases(const PropertyCase& made);

// The rays of a camera, voxel space, as the renderer has them (render/passes/view_uniforms.h): rays of far
// eyes start before the volume.
volume::PictureRays raysOf(const scene::Camera& camera, const volume::GridGeometry& geometry,
                           glm::ivec2 picture);
// The ray through a point of the picture in double precision; fragments count from its lower left corner.
volume::Ray rayThrough(const volume::PictureRays& rays, glm::dvec2 fragment);
// How far beside it a ray of floats may lie up to t: ten roundings of the largest number along each axis,
// voxels.
double roundingOf(const volume::PictureRays& rays, glm::ivec3 dims, double t);

}  // namespace isolux::test
