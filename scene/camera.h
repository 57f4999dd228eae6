// Camera arithmetic: pure functions from a resolved Camera to another, and to rays. All lengths in mm.
#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

// Orthonormal, right-handed: right x up = back. The viewer looks along -back.
struct CameraFrame {
  glm::dvec3 eye, right, up, back;
  double distance;    // eye to target, mm; above 0
  double halfHeight;  // of the image plane at unit distance (perspective), or in mm (orthographic)
  Projection projection;
};
// Never NaN: a degenerate up or a target on the eye is replaced by the nearest sensible frame.
CameraFrame frameOf(const Camera& camera);

// Looks at `target` along -frame.back from `distance` mm, upright as the frame. The distance is 1e-12 to
// 5e12 mm and at least 1e-9 of the target's largest coordinate; the eye stays within the range of its
// setting.
Camera lookingAt(Camera camera, const CameraFrame& frame, glm::dvec3 target, double distance);

// A ray through a point of the picture; ndc in [-1, 1], y up; aspect = width / height. The rays of an
// orthographic camera start on the plane through the eye.
struct Ray {
  glm::dvec3 origin, direction;  // mm; unit direction
};
Ray rayThrough(const CameraFrame& frame, glm::dvec2 ndc, double aspect);

// Mouse gestures. Angles in radians; fractions are of the viewport's height.
// A gesture that is not finite changes nothing; results stay within the ranges of the camera's settings.
Camera orbited(const Camera& camera, double yaw, double pitch);  // eye about the target: yaw right, pitch up
Camera rolled(const Camera& camera, double angle);               // > 0: the picture turns clockwise
Camera panned(const Camera& camera, glm::dvec2 fractionOfHeight);  // the picture moves by this; x right, y up
Camera zoomed(const Camera& camera, double factor);                // > 1: nearer (smaller distance)

// Standard views, named by the side the viewer stands on; where the axes are not anatomical, anterior is the
// front, superior is up, left the viewer's right in the front view.
enum class StandardView { anterior, posterior, left, right, superior, inferior };
constexpr int standardViewCount = 6;
std::string standardViewName(StandardView view, WorldAxes axes);  // "Anterior"; "−Y"
std::string standardViewMark(StandardView view, WorldAxes axes);  // for a button: "A"; "−Y"
// Superior is up, except that anterior is up in the superior and inferior views. So the patient's left is at
// the viewer's right in the anterior and the inferior view (the habit of axial slices), and at the viewer's
// left in the posterior and the superior view (looking down on the head). Other axes: the views from above
// and below are the front view tilted, +X at the right in both. Fits the box, keeps fov and projection.
Camera standardView(const Camera& camera, StandardView view, WorldAxes axes, glm::dvec3 boundsMinMm,
                    glm::dvec3 boundsMaxMm);
// Same direction and up, moved so that the box fits any picture at least as wide as high.
Camera fitted(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm);

// The letters (L R A P S I, up to two, the nearer side first: "LA"; or "+X−Y") at the picture's left, right,
// top and bottom edge.
struct EdgeLetters {
  std::string left, right, top, bottom;
};
EdgeLetters edgeLetters(const CameraFrame& frame, WorldAxes axes);

}  // namespace isolux::scene
