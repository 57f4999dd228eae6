// Computes how the irradiance of an unoccluded sky depends on the normal.
//
// Baked irradiance is filtered and interpolated as a fraction of it, because this fraction varies little on
// curved surfaces. Uses nine spherical harmonics (Ramamoorthi & Hanrahan 2001), each channel divided by its
// mean over all normals. Values are at least kLeastOpenSky: below it, nine terms are inaccurate and the
// fraction would be large.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace isolux::gi {

inline constexpr float kLeastOpenSky = 0.2f;  // light_lattice.glsl has the same number

class OpenSky {
 public:
  OpenSky() = default;  // the same for all normals
  // Takes PictureLight::irradianceSh. A channel without light is the same for all normals.
  explicit OpenSky(const std::array<glm::vec3, 9>& irradianceSh);

  glm::vec3 at(glm::vec3 normal) const;
  glm::vec3 perMean() const { return perMean_; }  // 1 / mean irradiance; 0 for a channel without light
  bool nearly(const OpenSky& other) const;        // equal except for rounding

 private:
  std::array<glm::vec3, 9> harmonics_{};
  glm::vec3 perMean_{0.0f};
};

}  // namespace isolux::gi
