#include "scene/rules/environment.h"

#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "base/portable_math.h"

namespace isolux::scene {

namespace {

glm::dquat quaternionOf(const glm::dvec4& wxyz) {
  const double length = glm::length(wxyz);
  if (!(length > 0.0)) return {1.0, 0.0, 0.0, 0.0};
  return {wxyz.x / length, wxyz.y / length, wxyz.z / length, wxyz.w / length};
}

glm::dvec4 wxyzOf(const glm::dquat& q) {
  return {q.w, q.x, q.y, q.z};
}

// The axes that the environment stands by: those of its volume, or the world's z up.
WorldAxes axesOf(const Environment& environment, WorldAxes axes) {
  return kindOf(environment) == EnvironmentKind::builtIn ? axes : WorldAxes::zUp;
}

// From an environment's own axes, z up and seen from -y, to those it stands by.
glm::dquat standing(WorldAxes axes) {
  const glm::dvec3 up = upOf(axes), back = -frontOf(axes);
  return glm::quat_cast(glm::dmat3(glm::cross(back, up), back, up));
}

// Stored light depends on it: the same on every machine.
glm::dquat turnAbout(const glm::dvec3& axis, double degrees) {
  const double half = 0.5 * glm::radians(degrees);
  return {base::portableCos(half), base::portableSin(half) * axis};
}

glm::dquat turned(const Environment& environment, WorldAxes axes) {
  const glm::dvec3 up = upOf(axes), right = glm::cross(up, frontOf(axes));
  return turnAbout(up, environment.azimuth) * turnAbout(right, -environment.elevation);
}

}  // namespace

EnvironmentKind kindOf(const Environment& environment) {
  if (!environment.file.empty()) return EnvironmentKind::file;
  return environment.constant ? EnvironmentKind::oneColor : EnvironmentKind::builtIn;
}

bool hasOneColor(const Environment& environment) {
  return kindOf(environment) == EnvironmentKind::oneColor;
}

void chooseBuiltIn(Environment& environment, BuiltInLight light) {
  environment.file.clear();
  environment.constant.reset();
  environment.builtIn = light;
}

glm::dvec4 rotationOf(const Environment& environment, WorldAxes axes) {
  const WorldAxes own = axesOf(environment, axes);
  const bool plain = environment.azimuth == 0.0 && environment.elevation == 0.0 && own != WorldAxes::yUp;
  if (plain) return environment.rotation;
  return wxyzOf(turned(environment, own) * quaternionOf(environment.rotation) * standing(own));
}

void setRotation(Environment& environment, const glm::dvec4& rotation, WorldAxes axes) {
  const WorldAxes own = axesOf(environment, axes);
  environment.rotation = wxyzOf(glm::conjugate(turned(environment, own)) * quaternionOf(rotation) *
                                glm::conjugate(standing(own)));
}

}  // namespace isolux::scene
