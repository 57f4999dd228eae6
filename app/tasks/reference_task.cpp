#include "app/tasks/reference_task.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include <glm/common.hpp>

#include "app/files/reference_image.h"
#include "base/color.h"
#include "gi/light_scene.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::app {

namespace {

constexpr double whiteNoise = 0.1;  // of noiseImage()

bool isKnown(const gi::ReferenceImage& image, std::size_t pixel) {
  return image.hit[pixel] != 0 && image.samples[pixel] >= 2 && std::isfinite(image.variance[pixel]);
}

double meanLuminance(const gi::ReferenceImage& image) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    if (image.hit[i] == 0 || std::isnan(image.irradiance[i].x)) continue;
    sum += base::luminance(glm::dvec3(image.irradiance[i]));
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

render::ColorImage blank(glm::ivec2 size) {
  return {size, std::vector<std::uint8_t>(4 * volume::Extent2{size}.count(), 255)};
}

std::size_t byteAt(const render::ColorImage& image, int x, int y) {
  return 4 * volume::Extent2{image.size}.index(x, y);
}

RoundPointer roundOf(gi::ReferenceImage image, const scene::Scene& scene) {
  auto round = std::make_shared<ReferenceRound>();
  round->picture = reduced(app::screenImage(image, scene), previewPixels);
  round->noise = reduced(noiseImage(image), previewPixels);
  round->noisePart = noiseOf(image);
  round->image = std::move(image);
  return round;
}

}  // namespace

std::unique_ptr<ReferenceTask> referenceTask(std::shared_ptr<const volume::PreparedVolume> volume,
                                             scene::Scene resolved, glm::ivec2 size, std::uint32_t samples,
                                             std::optional<int> threads) {
  const int used = threads.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  const auto work = [volume = std::move(volume), resolved = std::move(resolved), size, samples, used](
                        base::Progress& progress, const auto& tell) {
    progress.report(0.0, "preparing");
    const auto environment = gi::loadEnvironment(resolved.light.environment);
    const auto tracer = gi::lightTracerOf(resolved, volume, progress);
    gi::Reference picture(volume, tracer, environment, resolved, {size, used}, progress);
    double done = 0.0;
    for (const std::uint32_t round : gi::referenceRounds(samples)) {
      const double to = static_cast<double>(round) / samples;
      const bool whole = picture.refineTo(round, progress, done, to);
      RoundPointer made = roundOf(picture.image(), resolved);
      tell([&](RoundPointer& latest) { latest = std::move(made); });
      if (!whole) return;
      done = to;
    }
  };
  return ReferenceTask::start({"", "trace the image"}, work);
}

render::ColorImage noiseImage(const gi::ReferenceImage& image) {
  render::ColorImage screen = blank(image.size);
  const double mean = meanLuminance(image);
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    const double error = isKnown(image, i) && mean > 0.0 ? std::sqrt(image.variance[i]) / mean : 0.0;
    std::fill_n(screen.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                base::screenByte(error / whiteNoise));
  }
  return screen;
}

std::optional<double> noiseOf(const gi::ReferenceImage& image) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    if (!isKnown(image, i)) continue;
    sum += static_cast<double>(image.variance[i]);
    ++count;
  }
  const double mean = meanLuminance(image);
  if (count == 0 || !(mean > 0.0)) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(count)) / mean;
}

render::ColorImage reduced(const render::ColorImage& image, int longest) {
  const int factor = (std::max(image.size.x, image.size.y) + longest - 1) / longest;
  if (factor <= 1) return image;
  render::ColorImage small = blank((image.size + (factor - 1)) / factor);
  for (int y = 0; y < small.size.y; ++y)
    for (int x = 0; x < small.size.x; ++x) {
      const glm::ivec2 from = factor * glm::ivec2(x, y), to = glm::min(from + factor, image.size);
      const int pixels = (to.x - from.x) * (to.y - from.y);
      glm::ivec3 sum(pixels / 2);  // rounds to the nearest
      for (int j = from.y; j < to.y; ++j)
        for (int i = from.x; i < to.x; ++i) {
          const std::uint8_t* pixel = &image.rgba[byteAt(image, i, j)];
          sum += glm::ivec3(pixel[0], pixel[1], pixel[2]);
        }
      std::uint8_t* target = &small.rgba[byteAt(small, x, y)];
      for (int c = 0; c < 3; ++c) target[c] = static_cast<std::uint8_t>(sum[c] / pixels);
    }
  return small;
}

}  // namespace isolux::app
