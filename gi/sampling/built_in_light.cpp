#include "gi/sampling/built_in_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/portable_math.h"

namespace isolux::gi {

namespace {

// 1.4 degrees a pixel: nothing in these lights is sharper than a few.
constexpr int kHeight = 128, kWidth = 2 * kHeight;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// As the viewer of the front sees it: 0 is behind their back, -90 at their left; above the horizon.
glm::dvec3 toward(double azimuth, double elevation) {
  const double a = radians(azimuth), e = radians(elevation);
  return {base::portableCos(e) * base::portableSin(a), -base::portableCos(e) * base::portableCos(a),
          base::portableSin(e)};
}

glm::dvec3 mixed(const glm::dvec3& a, const glm::dvec3& b, double t) {
  return a + t * (b - a);
}

// 1 within the disc of this radius, falling to 0 over its soft edge. Degrees.
double disc(const glm::dvec3& direction, const glm::dvec3& centre, double radius, double edge) {
  const double cosine = std::clamp(glm::dot(direction, centre), -1.0, 1.0);
  return 1.0 - glm::smoothstep(radians(radius - edge), radians(radius + edge), base::portableAcos(cosine));
}

// 1 within a rectangle that faces the volume, seen from its middle: half its width and height in tangents.
double panel(const glm::dvec3& direction, const glm::dvec3& centre, glm::dvec2 half, double edge) {
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), centre));
  const glm::dvec3 up = glm::cross(centre, right);
  const double ahead = glm::dot(direction, centre);
  if (ahead <= 0.0) return 0.0;
  const double x = std::abs(glm::dot(direction, right)) / ahead,
               y = std::abs(glm::dot(direction, up)) / ahead;
  return (1.0 - glm::smoothstep(half.x - edge, half.x + edge, x)) *
         (1.0 - glm::smoothstep(half.y - edge, half.y + edge, y));
}

// Dark floor, brighter toward the horizon, and a backdrop above it.
glm::dvec3 gradient(double z, const glm::dvec3& floor, const glm::dvec3& horizon, const glm::dvec3& zenith) {
  return z < 0.0 ? mixed(horizon, floor, glm::smoothstep(0.0, 0.5, -z))
                 : mixed(horizon, zenith, glm::smoothstep(0.0, 1.0, z));
}

// A large soft key high at the left, a weak fill at the right, a rim light from behind, and what the floor
// returns.
glm::dvec3 studio(const glm::dvec3& d, const glm::dvec3& floor) {
  static const glm::dvec3 key = toward(-60.0, 40.0), fill = toward(50.0, 2.0), rim = toward(124.0, 30.0);
  glm::dvec3 light = gradient(d.z, floor, {0.06, 0.066, 0.075}, {0.085, 0.10, 0.125});
  light += panel(d, key, {0.42, 0.42}, 0.10) * glm::dvec3(7.2, 6.8, 6.3);
  light += disc(d, fill, 24.0, 14.0) * glm::dvec3(0.26, 0.36, 0.50);
  light += disc(d, rim, 12.0, 4.0) * glm::dvec3(6.2, 7.0, 8.2);
  return light;
}

// A room with one tall window of four panes at the left; its light comes back from floor and walls.
glm::dvec3 window(const glm::dvec3& d) {
  static const glm::dvec3 pane = toward(-62.0, 20.0);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), pane));
  glm::dvec3 light = gradient(d.z, {0.16, 0.12, 0.085}, {0.13, 0.115, 0.10}, {0.15, 0.145, 0.14});
  light += disc(d, toward(118.0, 5.0), 45.0, 40.0) * glm::dvec3(0.20, 0.18, 0.155);   // the wall it shines on
  light += disc(d, toward(-40.0, -55.0), 30.0, 25.0) * glm::dvec3(0.30, 0.24, 0.18);  // the floor before it
  const double ahead = std::max(glm::dot(d, pane), 1e-6);
  const double x = std::abs(glm::dot(d, right)) / ahead;
  const double y = std::abs(glm::dot(d, glm::cross(pane, right))) / ahead;
  const double bars = glm::smoothstep(0.02, 0.05, x) * glm::smoothstep(0.02, 0.05, y);
  light += bars * panel(d, pane, {0.44, 0.66}, 0.03) * glm::dvec3(3.7, 4.2, 4.8);
  return light;
}

// A closed cloud cover, three times as bright above as at the horizon (Moon & Spencer 1942), with the sun
// behind it and grey ground.
glm::dvec3 overcast(const glm::dvec3& d) {
  static const glm::dvec3 sun = toward(-50.0, 48.0);
  if (d.z < 0.0) return mixed({0.28, 0.29, 0.30}, {0.09, 0.085, 0.075}, glm::smoothstep(0.0, 0.15, -d.z));
  const glm::dvec3 cloud = glm::dvec3(0.80, 0.88, 0.98) * (1.0 + 2.0 * d.z) / 3.0;
  const double veil = glm::smoothstep(0.0, 0.15, d.z) * base::portableExp(5.0 * (glm::dot(d, sun) - 1.0));
  return mixed({0.28, 0.29, 0.30}, cloud, glm::smoothstep(0.0, 0.08, d.z)) +
         veil * glm::dvec3(1.55, 1.50, 1.42);
}

// A low sun at the left under a sky from orange to blue.
glm::dvec3 sunset(const glm::dvec3& d) {
  static const glm::dvec3 sun = toward(-58.0, 14.0);
  const double near = glm::dot(d, sun);
  const glm::dvec3 earth = mixed({0.16, 0.11, 0.09}, {0.05, 0.04, 0.04}, glm::smoothstep(0.0, 0.4, -d.z));
  const glm::dvec3 ground = earth * (1.0 + 0.6 * std::max(near, 0.0));
  const glm::dvec3 glow = mixed({0.26, 0.24, 0.34}, {1.10, 0.50, 0.20}, glm::smoothstep(-0.4, 1.0, near));
  glm::dvec3 sky = mixed(glow, {0.10, 0.18, 0.38}, glm::smoothstep(0.0, 0.7, d.z));
  sky += base::portableExp(14.0 * (near - 1.0)) * glm::dvec3(1.6, 0.75, 0.28);
  sky += disc(d, sun, 6.0, 2.0) * glm::dvec3(112.0, 70.0, 38.0);
  return mixed(ground, sky, glm::smoothstep(-0.07, 0.05, d.z));
}

}  // namespace

glm::dvec3 builtInRadiance(scene::BuiltInLight light, const glm::dvec3& direction) {
  switch (light) {
    case scene::BuiltInLight::studio:
      return studio(direction, {0.14, 0.13, 0.12});  // about a tenth of the key
    case scene::BuiltInLight::window:
      return window(direction);
    case scene::BuiltInLight::overcast:
      return overcast(direction);
    case scene::BuiltInLight::sunset:
      return sunset(direction);
    case scene::BuiltInLight::dark_studio:
      return studio(direction, {0.02, 0.019, 0.018});
  }
  throw std::logic_error("a built-in light without a formula");
}

Environment builtInEnvironment(scene::BuiltInLight light) {
  std::vector<glm::vec3> pixels;
  pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight);
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column) {
      // As in Environment::directionOf().
      const double polar = std::numbers::pi * (row + 0.5) / kHeight;
      const double turn = 2.0 * std::numbers::pi * ((column + 0.5) / kWidth - 0.5);
      pixels.emplace_back(builtInRadiance(
          light, {base::portableSin(polar) * base::portableSin(turn),
                  base::portableSin(polar) * base::portableCos(turn), base::portableCos(polar)}));
    }
  return Environment(kWidth, kHeight, std::move(pixels));
}

}  // namespace isolux::gi
