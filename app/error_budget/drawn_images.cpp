#include "app/error_budget/drawn_images.h"

#include <algorithm>

namespace isolux::app {

namespace {

constexpr int kStripPixels = 8192;  // by software, with a spline's hits and curvature, less than 50 ms

}  // namespace

std::vector<std::vector<float>> drawnImages(render::Renderer& renderer, const scene::Scene& resolved,
                                            glm::ivec2 size, std::span<const render::Aov> aovs,
                                            base::Progress& progress) {
  render::FrameRequest request{
      .size = size, .color = false, .aovs = {aovs.begin(), aovs.end()}, .stop = progress.token()};
  const int rows = std::clamp(kStripPixels / size.x, 1, size.y);
  std::vector<std::vector<float>> images(aovs.size());
  for (int below = 0; below < size.y; below += rows) {
    request.tile = render::Tile{{0, below}, {size.x, std::min(rows, size.y - below)}};
    renderer.render(resolved, request);
    progress.throwIfStopped();  // of a frame that was stopped nothing may be read
    for (std::size_t i = 0; i < aovs.size(); ++i) {
      const render::AovImage strip = renderer.readAov(aovs[i]);
      images[i].resize(volume::Extent2{size}.count() * static_cast<std::size_t>(strip.channels));
      const int above = size.y - below - request.tile->size.y;  // tiles count rows from below
      std::ranges::copy(strip.values, images[i].begin() + std::ptrdiff_t{above} * size.x * strip.channels);
    }
  }
  return images;
}

}  // namespace isolux::app
