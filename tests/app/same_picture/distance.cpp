#include "tests/app/same_picture/distance.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "tests/render/picture_difference.h"
#include "tests/support/picture_flip.h"

namespace isolux::test {

namespace {

constexpr double kSameHit = 0.01;  // voxels

glm::dvec3 vectorAt(const render::AovImage& image, std::size_t pixel) {
  const float* v = &image.values[3 * pixel];
  return {v[0], v[1], v[2]};
}

bool sameBytes(const render::AovImage& a, const render::AovImage& b) {
  return a.values.size() == b.values.size() &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

}  // namespace

WayDistance distanceOf(const render::ColorImage& a, const render::ColorImage& b) {
  const PictureDifference colors = differenceOf(a, b);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) differing += std::memcmp(&a.rgba[i], &b.rgba[i], 4) != 0;
  return {.differing = 4.0 * static_cast<double>(differing) / static_cast<double>(a.rgba.size()),
          .visible = colors.visible,
          .steps = colors.largest,
          .flip = flipOf(a, b)};
}

WayDistance distanceOf(const DrawnWay& a, const DrawnWay& b) {
  WayDistance distance = distanceOf(a.color, b.color);
  const std::size_t pixels = a.hit.values.size();
  std::size_t elsewhere = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (a.hit.values[i] == 0.0f && b.hit.values[i] == 0.0f) continue;
    const double apart = a.hit.values[i] == b.hit.values[i]
                             ? glm::distance(vectorAt(a.voxel, i), vectorAt(b.voxel, i))
                             : INFINITY;
    if (!(apart <= kSameHit)) {
      ++elsewhere;
      continue;
    }
    distance.voxels = std::max(distance.voxels, apart);
    const glm::dvec3 one = vectorAt(a.normal, i), other = vectorAt(b.normal, i);
    const double angle = std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
    distance.degrees = std::max(distance.degrees, glm::degrees(angle));
  }
  distance.elsewhere = static_cast<double>(elsewhere) / static_cast<double>(pixels);
  return distance;
}

bool keeps(const WayDistance& distance, const WayBound& bound) {
  return distance.elsewhere <= bound.elsewhere && distance.voxels <= bound.voxels &&
         distance.degrees <= bound.degrees && distance.differing <= bound.differing &&
         distance.visible <= bound.visible && distance.flip <= bound.flip;
}

bool isIdentical(const DrawnWay& a, const DrawnWay& b) {
  return a.color.rgba == b.color.rgba && sameBytes(a.hit, b.hit) && sameBytes(a.voxel, b.voxel) &&
         sameBytes(a.normal, b.normal);
}

std::ostream& operator<<(std::ostream& out, const WayDistance& distance) {
  return out << std::setprecision(3) << "hits elsewhere " << 100.0 * distance.elsewhere << " %, others "
             << distance.voxels << " voxels, normals " << distance.degrees << " degrees, colours "
             << 100.0 * distance.differing << " %, visibly " << 100.0 * distance.visible << " %, at most "
             << distance.steps << " steps, FLIP " << distance.flip;
}

}  // namespace isolux::test
