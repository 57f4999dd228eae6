#include "app/slices/slice_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/color.h"
#include "scene/color_maps.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::app {

namespace {

using Byte3 = std::array<std::uint8_t, 3>;
constexpr int kMapSamples = 256, kMapSteps = 8192;
constexpr double kRim = 1.0, kRimOpacity = 0.55;  // of curves: pixels

Byte3 encodedColor(const glm::dvec3& linear) {
  return {base::screenByte(linear.x), base::screenByte(linear.y), base::screenByte(linear.z)};
}

// As cut faces are coloured (render/passes/cut_faces_pass.h): between samples of the map, in linear light.
// The steps are an eighth of one of the picture's at the least.
std::vector<Byte3> colorTable(scene::ColorMap map) {
  if (map == scene::ColorMap::automatic) map = scene::ColorMap::gray;
  const std::vector<glm::vec3> samples = scene::colorMapSamples(map, kMapSamples);
  std::vector<Byte3> table(kMapSteps);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double at = static_cast<double>(i) * (kMapSamples - 1) / (kMapSteps - 1);
    const auto low = std::min(static_cast<std::size_t>(at), samples.size() - 2);
    table[i] = encodedColor(
        glm::mix(glm::dvec3(samples[low]), glm::dvec3(samples[low + 1]), at - static_cast<double>(low)));
  }
  return table;
}

void blend(std::uint8_t* rgba, const Byte3& color, double opacity) {
  for (std::size_t i = 0; i < 3; ++i)
    rgba[i] = static_cast<std::uint8_t>(std::lround(rgba[i] + opacity * (color[i] - double(rgba[i]))));
}

// As volume::faceColor().
class LabelPaint {
 public:
  explicit LabelPaint(const volume::ShownLabels* labels) {
    if (!labels) return;
    for (const volume::LabelExtent& label : labels->blocks->list()) paint(*labels, label.label);
    paint(*labels, 0);
  }
  Byte3 at(double label) const {
    const auto found = colors_.find(label);
    if (found != colors_.end()) return found->second;
    return encodedColor(glm::dvec3(volume::kHiddenLabel));  // labels beyond 2^24 are rounded in slices
  }

 private:
  void paint(const volume::ShownLabels& labels, int label) {
    colors_[label] = encodedColor(glm::dvec3(volume::faceColor(labels, label)));
  }
  std::unordered_map<double, Byte3> colors_;
};

void paintValues(const SliceContent& content, const scene::Slice& slice, render::ColorImage& image,
                 base::Progress& progress) {
  const std::vector<Byte3> table = colorTable(slice.map);
  const LabelPaint labels(content.labels.get());
  const auto width = static_cast<std::size_t>(image.size.x);
  volume::parallelSteps(static_cast<std::size_t>(image.size.y), progress, {}, [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const double value = content.values.values[i];
      Byte3 color{kNoValue[0], kNoValue[1], kNoValue[2]};
      if (!std::isnan(value) && content.labels)
        color = labels.at(value);
      else if (!std::isnan(value))
        color = table[static_cast<std::size_t>(
            std::lround(std::clamp(content.window.greyOf(value), 0.0, 1.0) * (kMapSteps - 1)))];
      std::uint8_t* const pixel = &image.rgba[4 * i];
      std::ranges::copy(color, pixel);
      pixel[3] = 255;
      if (content.band && value >= content.band->first && value <= content.band->second)
        blend(pixel, {kBand[0], kBand[1], kBand[2]}, 0.5);
    }
  });
}

// Distance of each pixel's centre from the nearest curve, as far as `reach`, pixels.
class CurveDistances {
 public:
  CurveDistances(glm::ivec2 size, double reach)
      : size_(size),
        reach_(reach),
        held_(base::machineMemory().reserve(count() * sizeof(float), "the isocontours of a slice",
                                            "a smaller image needs less")),
        squared_(count(), std::numeric_limits<float>::infinity()) {}

  void add(glm::dvec2 p, glm::dvec2 q) {
    const glm::dvec2 low = glm::ceil(glm::min(p, q) - reach_), high = glm::floor(glm::max(p, q) + reach_);
    const glm::dvec2 last(size_ - 1);
    if (!(low.x <= last.x && low.y <= last.y && high.x >= 0.0 && high.y >= 0.0)) return;
    const glm::ivec2 from(glm::max(low, glm::dvec2(0.0))), to(glm::min(high, last));
    const glm::dvec2 way = q - p;
    const double length2 = glm::dot(way, way);
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        const glm::dvec2 at = glm::dvec2(x, y) - p;
        const double t = length2 > 0.0 ? std::clamp(glm::dot(at, way) / length2, 0.0, 1.0) : 0.0;
        const glm::dvec2 apart = at - t * way;
        float& nearest = squared_[volume::Extent2{size_}.index(x, y)];
        nearest = std::min(nearest, static_cast<float>(glm::dot(apart, apart)));
      }
  }
  std::size_t count() const { return volume::Extent2{size_}.count(); }
  float squared(std::size_t pixel) const { return squared_[pixel]; }

 private:
  glm::ivec2 size_;
  double reach_;
  base::MemoryBudget::Held held_;
  std::vector<float> squared_;
};

void paintCurves(const SurfaceOnSlice& surface, const volume::SlicePlane& plane, double lineWidth,
                 const volume::GridGeometry& geometry, render::ColorImage& image, base::Progress& progress) {
  const double half = 0.5 * lineWidth, reach = half + kRim + 0.5;
  CurveDistances distances(image.size, reach);
  for (const volume::SliceCurve& curve : surface.curves.curves) {
    progress.throwIfStopped();
    const auto pixel = [&](std::size_t i) { return plane.pixelOf(geometry.worldOf(curve.points[i])); };
    const std::size_t count = curve.points.size();
    glm::dvec2 before = pixel(curve.closed ? count - 1 : 0);
    for (std::size_t i = curve.closed ? 0 : 1; i < count; ++i) {
      const glm::dvec2 now = pixel(i);
      distances.add(before, now);
      before = now;
    }
  }
  const Byte3 color = encodedColor(surface.color);
  for (std::size_t i = 0; i < distances.count(); ++i) {
    if (distances.squared(i) > reach * reach) continue;
    const double distance = std::sqrt(distances.squared(i));
    blend(&image.rgba[4 * i], {0, 0, 0}, kRimOpacity * std::clamp(reach - distance, 0.0, 1.0));
    blend(&image.rgba[4 * i], color,
          std::min(1.0, lineWidth) * std::clamp(std::max(half, 0.5) + 0.5 - distance, 0.0, 1.0));
  }
}

}  // namespace

render::ColorImage slicePicture(const SliceContent& content, const scene::Slice& slice,
                                const volume::GridGeometry& geometry, base::Progress& progress) {
  render::ColorImage image{content.plane.size, std::vector<std::uint8_t>(4 * content.values.values.size())};
  paintValues(content, slice, image, progress);
  for (const SurfaceOnSlice& surface : content.surfaces)
    paintCurves(surface, content.plane, slice.contourWidth, geometry, image, progress);
  return image;
}

}  // namespace isolux::app
