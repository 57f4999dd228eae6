#include "app/files/reference_image.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "app/files/image_io.h"
#include "base/color.h"
#include "scene/rules/tone_curve.h"

namespace isolux::app {

void writeReferenceExr(const gi::ReferenceImage& image, const std::filesystem::path& file,
                       const std::string& session) {
  const std::size_t pixels = image.hit.size();
  std::vector<FloatChannel> channels;
  const auto add = [&](const char* name, const auto& valueOf) {
    FloatChannel channel{name, std::vector<float>(pixels)};
    for (std::size_t i = 0; i < pixels; ++i) channel.values[i] = valueOf(i);
    channels.push_back(std::move(channel));
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (int c = 0; c < 3; ++c)
    add(c == 0 ? "R" : c == 1 ? "G" : "B", [&](std::size_t i) { return image.color[i][c]; });
  for (int c = 0; c < 3; ++c)
    add(c == 0   ? "irradiance.R"
        : c == 1 ? "irradiance.G"
                 : "irradiance.B",
        [&](std::size_t i) { return image.irradiance[i][c]; });
  add("variance", [&](std::size_t i) { return image.variance[i]; });
  add("samples", [&](std::size_t i) { return image.hit[i] ? static_cast<float>(image.samples[i]) : nan; });
  if (!image.ground.empty()) add("ground", [&](std::size_t i) { return image.ground[i]; });
  add("hit", [&](std::size_t i) { return static_cast<float>(image.hit[i]); });
  writeExr(image.size, channels, file, session);
}

render::ColorImage screenImage(const gi::ReferenceImage& image, const scene::Scene& scene) {
  const bool isFilmic = scene.picture.curve != scene::ToneCurve::linear;  // it is lit by global illumination
  render::ColorImage screen{image.size, std::vector<std::uint8_t>(4 * image.hit.size(), 255)};
  for (int y = 0; y < image.size.y; ++y) {
    const glm::dvec3 background =
        glm::mix(scene.look.backgroundTop, scene.look.backgroundBottom, (y + 0.5) / image.size.y);
    for (int x = 0; x < image.size.x; ++x) {
      const std::size_t i = volume::Extent2{image.size}.index(x, y);
      const glm::dvec3 traced(image.color[i]);
      const double ground = image.ground.empty() ? 1.0 : static_cast<double>(image.ground[i]);
      const glm::dvec3 color = std::isnan(traced.x) ? ground * background
                               : isFilmic           ? scene::filmic(traced)
                                                    : traced;
      for (int c = 0; c < 3; ++c)
        screen.rgba[4 * i + static_cast<std::size_t>(c)] = base::screenByte(color[c]);
    }
  }
  return screen;
}

}  // namespace isolux::app
