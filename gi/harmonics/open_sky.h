// How the irradiance of a sky with nothing in its way depends on the normal: stored light is filtered and
// interpolated as parts of it, since those change little where a surface bends.
//
// Of nine spherical harmonics (Ramamoorthi & Hanrahan 2001), each channel by its mean over all normals; never
// below kLeastOpenSky, where the nine are no good and a part of little would be much.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace isolux::gi {

inline constexpr float kLeastOpenSky = 0.2f;  // light_lattice.glsl has the same number

class OpenSky {
 public:
  OpenSky() = default;  // the same for all normals
  // PictureLight::irradianceSh. A channel without light is the same for all normals.
  explicit OpenSky(const std::array<glm::vec3, 9>& irradianceSh);

  glm::vec3 at(glm::vec3 normal) const;
  glm::vec3 perMean() const { return perMean_; }  // 1 / mean irradiance; 0 of a channel without light
  bool nearly(const OpenSky& other) const;        // but for rounding

 private:
  std::array<glm::vec3, 9> harmonics_{};
  glm::vec3 perMean_{0.0f};
};

}  // namespace isolux::gi
