// Computes cameras and rays: pure functions from a resolved Camera to another, and to rays. All lengths in
// mm.
#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

// An orthonormal, right-handed frame: right x up = back. The viewer looks along -back.
struct CameraFrame {
  glm::dvec3 eye, right, up, back;
  double distance;    // eye to target, mm; above 0
  double halfHeight;  // of the image plane at unit distance (perspective), or in mm (orthographic)
  Projection projection;
};
// Returns the camera's frame, which is never NaN: a degenerate up or a target at the eye is replaced by the
// nearest sensible frame.
CameraFrame frameOf(const Camera& camera);

// Returns a camera that looks at `target` along -frame.back from `distance` mm, with the frame's up. The
// distance is clamped to 1e-12 to 5e12 mm and to at least 1e-9 of the target's largest coordinate. The eye
// stays within the range of its setting.
Camera lookingAt(Camera camera, const CameraFrame& frame, glm::dvec3 target, double distance);

// A ray through a point of the image; ndc in [-1, 1], y up; aspect = width / height. The rays of an
// orthographic camera start on the plane through the eye.
struct Ray {
  glm::dvec3 origin, direction;  // mm; unit direction
};
Ray rayThrough(const CameraFrame& frame, glm::dvec2 ndc, double aspect);

// Apply mouse gestures. Angles in radians; fractions are of the viewport's height. A gesture that is not
// finite changes nothing; results stay within the ranges of the camera's settings.
Camera orbited(const Camera& camera, double yaw, double pitch);  // eye about the target: yaw right, pitch up
Camera rolled(const Camera& camera, double angle);               // > 0: the image turns clockwise
Camera panned(const Camera& camera, glm::dvec2 fractionOfHeight);  // the image moves by this; x right, y up
Camera zoomed(const Camera& camera, double factor);                // > 1: nearer (smaller distance)

// Standard views, named by the viewer's side. If the axes are not anatomical, anterior is the front, superior
// is up, and left is the viewer's right in the front view.
enum class StandardView { anterior, posterior, left, right, superior, inferior };
constexpr int standardViewCount = 6;
std::string standardViewName(StandardView view, WorldAxes axes);  // "Anterior"; "−Y"
std::string standardViewMark(StandardView view, WorldAxes axes);  // for a button: "A"; "−Y"
// Returns the standard view, fitted to the box; fov and projection stay. Superior is up, except that anterior
// is up in the superior and inferior views. The patient's left is at the viewer's right in the anterior and
// the inferior view (the convention of axial slices). It is at the viewer's left in the posterior and the
// superior view (looking down on the head). With other axes, the views from above and below are the front
// view tilted, +X at the right in both.
Camera standardView(const Camera& camera, StandardView view, WorldAxes axes, glm::dvec3 boundsMinMm,
                    glm::dvec3 boundsMaxMm);
// Returns the camera with the same direction and up, moved so that the box fits any image at least as wide as
// high.
Camera fitted(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);

// The orientation labels at the left, right, top and bottom edge of the image. Each has up to two letters of
// L R A P S I, the nearer side first ("LA"), or axis ends ("+X−Y").
struct EdgeLetters {
  std::string left, right, top, bottom;
};
EdgeLetters edgeLetters(const CameraFrame& frame, WorldAxes axes);

}  // namespace isolux::scene
