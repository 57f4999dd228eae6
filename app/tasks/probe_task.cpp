#include "app/tasks/probe_task.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/color.h"
#include "gi/light_scene.h"

namespace isolux::app {

namespace {

constexpr int mostColumns = 512;

ProbeThumbnail thumbnailOf(const gi::Environment& environment) {
  ProbeThumbnail small;
  const glm::ivec2 from(environment.width(), environment.height());
  small.size = {std::min(from.x, mostColumns), std::clamp(from.y, 1, mostColumns / 2)};
  small.meanLuminance = base::luminance(environment.mean());
  small.badPixels = environment.badPixels();
  small.pixels.reserve(volume::Extent2{small.size}.count());
  const auto first = [](int i, int count, int of) {
    return static_cast<int>(static_cast<std::int64_t>(i) * of / count);
  };
  for (int y = 0; y < small.size.y; ++y) {
    const int top = first(y, small.size.y, from.y),
              bottom = std::max(first(y + 1, small.size.y, from.y), top + 1);
    for (int x = 0; x < small.size.x; ++x) {
      const int left = first(x, small.size.x, from.x),
                right = std::max(first(x + 1, small.size.x, from.x), left + 1);
      glm::dvec3 sum(0.0);
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
          sum += glm::dvec3(environment.pixels()[volume::Extent2{from}.index(column, row)]);
      small.pixels.emplace_back(sum / static_cast<double>((bottom - top) * (right - left)));
    }
  }
  return small;
}

}  // namespace

glm::vec3 ProbeThumbnail::at(glm::dvec3 direction) const {
  if (pixels.empty()) return glm::vec3(0.0F);
  const double column = (std::atan2(direction.x, direction.y) / (2.0 * std::numbers::pi) + 0.5) * size.x;
  const double row = std::acos(std::clamp(direction.z, -1.0, 1.0)) / std::numbers::pi * size.y;
  const int x = std::clamp(static_cast<int>(column), 0, size.x - 1);
  const int y = std::clamp(static_cast<int>(row), 0, size.y - 1);
  return pixels[volume::Extent2{size}.index(x, y)];
}

std::unique_ptr<ProbeTask> probeTask(scene::Environment environment) {
  const std::string file = environment.file;
  return ProbeTask::start({file, "load the environment map"},
                          [environment = std::move(environment)](base::Progress&) {
                            return thumbnailOf(*gi::loadEnvironment(environment));
                          });
}

}  // namespace isolux::app
