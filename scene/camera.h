// Camera arithmetic: pure functions from a resolved Camera to another, and to rays. All lengths in mm.
#pragma once

#include <array>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// Orthonormal, right-handed: right x up = back.
struct CameraFrame {
  glm::dvec3 eye, right, up, back;
  double distance;    // eye to target, mm
  double halfHeight;  // of the image plane at unit distance (perspective), or in mm (orthographic)
  Projection projection;
};
// Never NaN: a degenerate up or a target on the eye is replaced by the nearest sensible frame.
CameraFrame frameOf(const Camera& camera);

// A ray through a point of the picture; ndc in [-1, 1], y up; aspect = width / height.
struct Ray {
  glm::dvec3 origin, direction;  // mm; unit direction
};
Ray rayThrough(const CameraFrame& frame, glm::dvec2 ndc, double aspect);

// Mouse gestures. Angles in radians; fractions are of the viewport's height.
Camera orbited(const Camera& camera, double yaw, double pitch);      // about the target, in camera axes
Camera rolled(const Camera& camera, double angle);                   // about the view direction
Camera panned(const Camera& camera, glm::dvec2 fractionOfHeight);    // the picture follows the pointer
Camera zoomed(const Camera& camera, double factor);                  // > 1: nearer (smaller distance)

// Anatomical standard views, named by the side the viewer stands on.
enum class StandardView { anterior, posterior, left, right, superior, inferior };
constexpr std::array<std::string_view, 6> standardViewNames{"Anterior", "Posterior", "Left",
                                                            "Right",    "Superior",  "Inferior"};
// Radiological habit: patient left at the viewer's right in the anterior, superior and inferior views;
// superior up, except anterior up in the superior and inferior views. Fits the box, keeps fov and projection.
Camera standardView(const Camera& camera, StandardView view, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);
// Same direction and up, moved so that the box fits.
Camera fitted(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);

// The anatomical letters (L R A P S I, up to two: "LA") at the picture's left, right, top and bottom edge.
struct EdgeLetters {
  std::string left, right, top, bottom;
};
EdgeLetters edgeLetters(const CameraFrame& frame);

}  // namespace isolux::scene
