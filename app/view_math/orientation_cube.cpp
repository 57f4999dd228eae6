#include "app/view_math/orientation_cube.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace isolux::app {

namespace {

struct CubeSide {
  scene::StandardView view;
  glm::dvec3 normal, right, up;  // the letter stands upright along `up`
};

// As in the standard views: the sides round `up` stand on it, its own ends lean to the front.
std::array<CubeSide, 6> cubeSides(scene::WorldAxes axes) {
  using scene::StandardView;
  const glm::dvec3 x(1.0, 0.0, 0.0), up = upOf(axes), front = frontOf(axes);
  return {{{StandardView::left, x, -front, up},
           {StandardView::right, -x, front, up},
           {StandardView::posterior, -front, -x, up},
           {StandardView::anterior, front, x, up},
           {StandardView::superior, up, x, -front},
           {StandardView::inferior, -up, x, front}}};
}

}  // namespace

std::vector<CubeFace> cubeFaces(const scene::CameraFrame& frame, scene::WorldAxes axes, double halfEdge) {
  constexpr double edgeOn = 0.01;
  const auto onScreen = [&](glm::dvec3 v) {
    return halfEdge * glm::dvec2(glm::dot(v, frame.right), -glm::dot(v, frame.up));
  };
  std::vector<CubeFace> faces;
  for (const CubeSide& side : cubeSides(axes)) {
    const double facing = glm::dot(side.normal, frame.back);
    if (facing <= edgeOn) continue;
    // Letters of the top and bottom face stand whichever way is upright for the viewer.
    const double upright = glm::dot(side.up, frame.up) < 0.0 ? -1.0 : 1.0;
    const glm::dvec2 n = onScreen(side.normal), r = upright * onScreen(side.right),
                     u = upright * onScreen(side.up);
    faces.push_back({side.view,
                     axisEnd(axes, side.normal),
                     facing,
                     {n - r - u, n + r - u, n + r + u, n - r + u},
                     n,
                     r,
                     u});
  }
  return faces;
}

std::optional<scene::StandardView> faceAt(const std::vector<CubeFace>& faces, glm::dvec2 fromMiddle) {
  for (const CubeFace& face : faces) {
    const glm::dvec2 d = fromMiddle - face.middle;
    const double area = face.right.x * face.up.y - face.right.y * face.up.x;
    if (area == 0.0) continue;
    const double a = (d.x * face.up.y - d.y * face.up.x) / area,
                 b = (face.right.x * d.y - face.right.y * d.x) / area;
    if (std::abs(a) <= 1.0 && std::abs(b) <= 1.0) return face.view;
  }
  return std::nullopt;
}

}  // namespace isolux::app
