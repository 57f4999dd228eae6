#include "gi/harmonics/open_sky.h"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "gi/harmonics/spherical_harmonics.h"

namespace isolux::gi {

OpenSky::OpenSky(const std::array<glm::vec3, 9>& irradianceSh) {
  const float constantHarmonic = std::sqrt(0.25f / std::numbers::pi_v<float>);
  for (int c = 0; c < 3; ++c) {
    const float mean = constantHarmonic * irradianceSh[0][c];
    if (mean > 0.0f) perMean_[c] = 1.0f / mean;
  }
  for (std::size_t i = 0; i < harmonics_.size(); ++i) harmonics_[i] = perMean_ * irradianceSh[i];
}

glm::vec3 OpenSky::at(glm::vec3 normal) const {
  float basis[9];
  evaluateSh(3, normal, basis);
  glm::vec3 sky(0.0f);
  for (std::size_t i = 0; i < harmonics_.size(); ++i) sky += basis[i] * harmonics_[i];
  return glm::max(sky, glm::vec3(kLeastOpenSky));
}

bool OpenSky::nearly(const OpenSky& other) const {
  constexpr float rounding = 1e-4f;
  for (std::size_t i = 0; i < harmonics_.size(); ++i)
    if (glm::length(harmonics_[i] - other.harmonics_[i]) > rounding) return false;
  return true;
}

}  // namespace isolux::gi
