#include "app/light/light_thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/color.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/built_in_light.h"

namespace isolux::app {

namespace {

constexpr int order = 3;           // of the irradiance
constexpr double radius = 0.74;    // of half the width
constexpr double brightest = 0.9;  // linear, of the ball

// E of a normal, with nothing in the light's way (Ramamoorthi & Hanrahan 2001).
class Irradiance {
 public:
  explicit Irradiance(const gi::Environment& environment) : coefficients_(environment.project(order)) {
    for (int l = 0, i = 0; l < order; ++l)
      for (; i < gi::shTerms(l + 1); ++i) coefficients_[static_cast<std::size_t>(i)] *= gi::clampedCosine(l);
  }
  glm::dvec3 at(const glm::dvec3& normal) const {
    std::array<double, gi::shTerms(order)> basis{};
    gi::evaluateSh(order, normal, basis.data());
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < basis.size(); ++i) sum += basis[i] * coefficients_[i];
    return glm::max(sum, glm::dvec3(0.0));
  }

 private:
  std::vector<glm::dvec3> coefficients_;
};

}  // namespace

render::ColorImage litBall(scene::BuiltInLight light, int pixels) {
  const Irradiance irradiance(gi::builtInEnvironment(light));
  constexpr int perAxis = 3;  // samples of a pixel
  const int samples = perAxis * pixels;
  const auto placeOf = [&](int i) { return (i + 0.5) / samples * 2.0 - 1.0; };
  double most = 1e-9;
  const volume::Extent2 extent{glm::ivec2(pixels)};
  std::vector<glm::dvec3> linear(extent.count(), glm::dvec3(0.0));
  std::vector<double> covered(linear.size(), 0.0);
  for (int y = 0; y < samples; ++y)
    for (int x = 0; x < samples; ++x) {
      const double u = placeOf(x) / radius, w = -placeOf(y) / radius, rest = 1.0 - u * u - w * w;
      if (rest <= 0.0) continue;
      const glm::dvec3 lit = irradiance.at({u, -std::sqrt(rest), w});
      const std::size_t pixel = extent.index(x / perAxis, y / perAxis);
      linear[pixel] += lit / double(perAxis * perAxis);
      covered[pixel] += 1.0 / (perAxis * perAxis);
      most = std::max(most, base::luminance(lit));
    }
  render::ColorImage image;
  image.size = glm::ivec2(pixels);
  image.rgba.reserve(4 * linear.size());
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const std::size_t pixel = extent.index(x, y);
      // Behind the ball the light's own colours, quieter than the ball.
      const glm::dvec3 d =
          glm::normalize(glm::dvec3(0.7 * placeOf(perAxis * x + 1), 1.0, -0.7 * placeOf(perAxis * y + 1)));
      const glm::dvec3 backdrop = 0.35 * gi::builtInRadiance(light, d) / most;
      const glm::dvec3 color = brightest / most * linear[pixel] + (1.0 - covered[pixel]) * backdrop;
      for (int c = 0; c < 3; ++c) image.rgba.push_back(base::screenByte(color[c]));
      image.rgba.push_back(255);
    }
  return image;
}

}  // namespace isolux::app
