#include "scene/named_camera.h"

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "base/words.h"

namespace isolux::scene {

namespace {

// The unit vector of "+x", "x", "-x", ...; 0 for any other word.
glm::dvec3 axisNamed(const std::string& word) {
  const bool isSigned = word.size() == 2 && (word[0] == '+' || word[0] == '-');
  glm::dvec3 axis(0.0);
  if ((word.size() == 1 || isSigned) && word.back() >= 'x' && word.back() <= 'z')
    axis[word.back() - 'x'] = word[0] == '-' ? -1.0 : 1.0;
  return axis;
}

// Rodrigues' formula, about a unit axis.
glm::dvec3 turnedVector(glm::dvec3 v, glm::dvec3 axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1.0 - c));
}

}  // namespace

StandardView standardViewNamed(std::string_view name, WorldAxes axes) {
  const std::string word = base::lowerCase(std::string(name));
  const glm::dvec3 axis = axisNamed(word);
  std::vector<std::string> known;
  for (int i = 0; i < standardViewCount; ++i) {
    const auto view = static_cast<StandardView>(i);
    const glm::dvec3 side = frameOf(standardView({}, view, axes, glm::dvec3(-1.0), glm::dvec3(1.0))).back;
    known.push_back(base::lowerCase(standardViewName(view, WorldAxes::anatomical)));
    if (word == known.back() || glm::dot(side, axis) > 0.9) return view;
  }
  const std::string meant = base::nearest(word, known);
  base::throwUsage(
      "", "--view",
      "unknown view \"" + std::string(name) +
          "\"; choose one of left, right, anterior, posterior, superior, inferior, +x, -x, +y, -y, +z, -z" +
          (meant.empty() ? "" : "; did you mean " + meant + "?"));
}

Camera turnedAbout(const Camera& camera, glm::dvec3 axis, double degrees) {
  const double length = glm::length(axis);
  if (!std::isfinite(degrees) || !(length > 0.0) || !std::isfinite(length)) return camera;
  const CameraFrame frame = frameOf(camera);
  const double radians = glm::radians(degrees);
  Camera result = camera;
  result.target = frame.eye - frame.back * frame.distance;
  result.eye = *result.target + turnedVector(frame.back, axis / length, radians) * frame.distance;
  result.up = turnedVector(camera.up.value_or(frame.up), axis / length, radians);
  return result;
}

Camera turned(const Camera& camera, double azimuthDegrees, double elevationDegrees) {
  Camera result = camera;
  if (azimuthDegrees != 0.0)
    result = turnedAbout(camera, camera.up.value_or(frameOf(camera).up), azimuthDegrees);
  if (elevationDegrees != 0.0) result = orbited(result, 0.0, glm::radians(elevationDegrees));
  return result;
}

}  // namespace isolux::scene
