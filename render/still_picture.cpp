#include "render/still_picture.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <glm/common.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "render/passes/gloss_passes.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/passes.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

// Up to so many rays are one frame, if its images fit into their budget; more are drawn in tiles of kTileRays
// per axis, margins included, or smaller ones.
constexpr std::int64_t kMostRays = std::int64_t{4096} * 4096;
constexpr int kLongestFrame = 8192;  // rays on an axis, within what every driver of GL 4.5 takes
constexpr int kTileRays = 2048, kLargeTileRays = 4096;  // large: where margins would fill half of a tile

// Pixels around a tile that its own pixels read.
int marginOf(const scene::Scene& scene, const FrameRequest& request) {
  if (!request.color) return 0;
  double margin = 2.0;
  margin += reachOfLines(scene, request.size.y * request.supersampling) / request.supersampling;
  if (scene::showsFlow(scene))
    margin += std::max(0.5 * scene.flow.length, scene.flow.grain) * request.pixelRatio + 2.0;
  if (scene::showsGloss(scene)) margin += reachOfGloss();
  return static_cast<int>(std::ceil(margin));
}

// The whole, in as many pixels as it has cells of occlusion.
FrameRequest beforeTiles(FrameRequest request) {
  request.size = occlusionCells(request);
  request.supersampling = 1;
  request.beforeTiles = true;
  request.linear = false;
  request.aovs.clear();
  return request;
}

struct Tiling {
  int step = 0, margin = 0;  // pixels; step 0: one frame
};

// How many rays' images fit into the budget, if each is freed after its last reader.
std::int64_t mostRays(const scene::Scene& scene, const FrameRequest& request, std::size_t imageBudget) {
  const std::vector<PassDeclaration> passes = declarePasses(scene, request, 1);
  const int bytes = std::max(peakBytesPerRay(passes, wantedImages(request, scene)), 1);
  return static_cast<std::int64_t>(
      std::min(imageBudget / static_cast<std::size_t>(bytes), static_cast<std::size_t>(kMostRays)));
}

// A tile has at least as much in the middle as in a margin: otherwise little of it would be new.
Tiling tilingOf(const scene::Scene& scene, const FrameRequest& request, std::size_t imageBudget) {
  const glm::ivec2 rays = request.size * request.supersampling;
  const std::int64_t most = mostRays(scene, request, imageBudget);
  if (std::int64_t{rays.x} * rays.y <= most && std::max(rays.x, rays.y) <= kLongestFrame) return {};
  const int margin = marginOf(scene, request);
  const int wanted = 4 * margin * request.supersampling > kTileRays ? kLargeTileRays : kTileRays;
  const int fitting = static_cast<int>(std::sqrt(static_cast<double>(most)));
  const int tile = std::min(wanted, fitting) / request.supersampling;
  const Tiling tiling{std::max({tile - 2 * margin, margin, 64}), margin};
  return tiling.step < std::max(request.size.x, request.size.y) ? tiling : Tiling{};
}

// The part of the tile's image that is new: what lies in the picture without its margin.
Tile partOf(const FrameRequest& tile, const Tiling& tiling, glm::ivec2 whole) {
  if (!tile.tile) return {glm::ivec2(0), whole};
  const glm::ivec2 low = tile.tile->origin, high = low + tile.tile->size;
  const auto inner = [&](int edge, int border, int towards) {
    return edge == border ? edge : edge + towards * tiling.margin;
  };
  const glm::ivec2 from(inner(low.x, 0, 1), inner(low.y, 0, 1));
  const glm::ivec2 to(inner(high.x, whole.x, -1), inner(high.y, whole.y, -1));
  return {from, to - from};
}

// Copies the part out of a tile's image into the picture's; both have row 0 at the top.
template <class Value>
void paste(const std::vector<Value>& from, const Tile& tile, const Tile& part, int channels, glm::ivec2 whole,
           std::vector<Value>& to) {
  const auto row = static_cast<std::ptrdiff_t>(part.size.x) * channels;
  for (int y = 0; y < part.size.y; ++y) {
    const std::ptrdiff_t source = tile.origin.y + tile.size.y - 1 - (part.origin.y + y);
    const std::ptrdiff_t target = whole.y - 1 - (part.origin.y + y);
    std::copy_n(from.begin() + (source * tile.size.x + part.origin.x - tile.origin.x) * channels, row,
                to.begin() + (target * whole.x + part.origin.x) * channels);
  }
}

std::size_t pixelsOf(glm::ivec2 size) {
  return volume::Extent2{size}.count();
}

class Collector {
 public:
  explicit Collector(const FrameRequest& request)
      : request_(request),
        held_(base::machineMemory().reserve(bytesOf(request), "the finished image",
                                            "a smaller image needs less")) {
    if (request.color)
      still_.color = {request.size, std::vector<std::uint8_t>(4 * pixelsOf(request.size)), false};
    if (request.linear) still_.linear = {request.size, std::vector<float>(4 * pixelsOf(request.size)), false};
  }

  void add(Renderer& renderer, const Tile& tile, const Tile& part) {
    const glm::ivec2 whole = request_.size;
    if (request_.color) addPart(renderer.readColor(), tile, part, still_.color);
    if (request_.linear) addPart(renderer.readLinearPicture(), tile, part, still_.linear);
    for (std::size_t i = 0; i < request_.aovs.size(); ++i) {
      const AovImage image = renderer.readAov(request_.aovs[i]);
      if (still_.aovs.size() <= i)
        still_.aovs.push_back(
            {image.aov, whole, image.channels,
             std::vector<float>(pixelsOf(whole) * static_cast<std::size_t>(image.channels))});
      paste(image.values, tile, part, image.channels, whole, still_.aovs[i].values);
    }
  }

  void add(const FrameReport& report, double share) {
    FrameReport& sum = still_.report;
    if (sum.passes.empty()) {
      sum = report;
      sum.bricks.missing *= share;
      return;
    }
    for (std::size_t i = 0; i < std::min(sum.passes.size(), report.passes.size()); ++i) {
      sum.passes[i].milliseconds += report.passes[i].milliseconds;
      if (report.passes[i].state == PassState::ran) sum.passes[i].state = PassState::ran;
    }
    if (!report.empty) sum.empty.reset();
    sum.milliseconds += report.milliseconds;
    sum.bricks.missing += report.bricks.missing * share;
    sum.bricks.uploaded += report.bricks.uploaded;
    sum.bricks.evicted += report.bricks.evicted;
    sum.light.uploaded += report.light.uploaded;
    sum.imageBytes = std::max(sum.imageBytes, report.imageBytes);
    sum.gpuBytes = std::max(sum.gpuBytes, report.gpuBytes);
    sum.surfaceChanged = sum.surfaceChanged || report.surfaceChanged;
    sum.glErrors.insert(sum.glErrors.end(), report.glErrors.begin(), report.glErrors.end());
  }

  StillPicture take() { return std::move(still_); }

 private:
  template <class Image>
  static void addPart(const Image& from, const Tile& tile, const Tile& part, Image& whole) {
    whole.transparent = from.transparent;
    paste(from.rgba, tile, part, 4, whole.size, whole.rgba);
  }

  static std::size_t bytesOf(const FrameRequest& request) {
    std::size_t perPixel = request.color ? 4 : 0;
    if (request.linear) perPixel += 4 * sizeof(float);
    for (const AovInfo& info : aovs())
      if (std::find(request.aovs.begin(), request.aovs.end(), info.aov) != request.aovs.end())
        perPixel += info.channels.size() * sizeof(float);
    return perPixel * pixelsOf(request.size);
  }

  FrameRequest request_;
  base::MemoryBudget::Held held_;  // of still_, while it is drawn
  StillPicture still_;
};

}  // namespace

std::vector<FrameRequest> tilesOf(const scene::Scene& resolved, const FrameRequest& request,
                                  std::size_t imageBudget) {
  const Tiling tiling = tilingOf(resolved, request, imageBudget);
  if (tiling.step == 0) return {request};
  std::vector<FrameRequest> tiles;
  for (int y = 0; y < request.size.y; y += tiling.step)
    for (int x = 0; x < request.size.x; x += tiling.step) {
      const glm::ivec2 low = glm::max(glm::ivec2(x, y) - tiling.margin, glm::ivec2(0));
      const glm::ivec2 high = glm::min(glm::ivec2(x, y) + tiling.step + tiling.margin, request.size);
      tiles.push_back(request);
      tiles.back().tile = Tile{low, high - low};
    }
  return tiles;
}

StillPicture drawStill(Renderer& renderer, const scene::Scene& resolved, const FrameRequest& request,
                       base::Progress& progress) try {
  Collector collector(request);
  const std::size_t imageBudget = renderer.imageBudget();
  const Tiling tiling = tilingOf(resolved, request, imageBudget);
  const std::vector<FrameRequest> tiles = tilesOf(resolved, request, imageBudget);
  if (tiles.size() > 1 && scene::showsOcclusion(resolved)) renderer.render(resolved, beforeTiles(request));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    progress.throwIfStopped();
    if (tiles.size() > 1)
      progress.report(static_cast<double>(i) / static_cast<double>(tiles.size()), "drawing");
    const Tile tile = tiles[i].tile.value_or(Tile{glm::ivec2(0), request.size});
    const Tile part = partOf(tiles[i], tiling, request.size);
    const FrameReport& report = renderer.render(resolved, tiles[i]);
    collector.add(report,
                  static_cast<double>(pixelsOf(part.size)) / static_cast<double>(pixelsOf(request.size)));
    collector.add(renderer, tile, part);
  }
  return collector.take();
} catch (const std::bad_alloc&) {
  throw base::Error(base::ErrorKind::memory, "", "picture",
                    "not enough memory for " + std::to_string(request.size.x) + "x" +
                        std::to_string(request.size.y) + " pixels: ask for fewer");
}

}  // namespace isolux::render
