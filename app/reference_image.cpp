#include "app/reference_image.h"

#include <limits>
#include <utility>
#include <vector>

#include "app/image_io.h"

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
  add("hit", [&](std::size_t i) { return static_cast<float>(image.hit[i]); });
  writeExr(image.size, channels, file, session);
}

}  // namespace isolux::app
