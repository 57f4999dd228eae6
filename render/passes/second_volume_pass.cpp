#include "render/passes/second_volume_pass.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/number_text.h"
#include "render/gl/constants.h"
#include "scene/color_maps.h"
#include "volume/color/second_values.h"
#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/statistics/visible_points.h"

namespace isolux::render {

namespace {

using volume::SecondValue;
using volume::SecondValues;

// Of surface points and the gradients beside them, as images have them.
class SecondAtPoints {
 public:
  explicit SecondAtPoints(const FrameState& frame)
      : values_(frame.second, frame.scene->color.field),
        worldFromVoxel_(frame.volume->grid().geometry().worldFromVoxel),
        inward_(-frame.outward()),
        belowMm_(frame.scene->color.below) {}

  std::optional<SecondValue> at(const glm::dvec3& voxel, const glm::dvec3& worldGradient) const {
    const glm::dvec3 world(worldFromVoxel_ * glm::dvec4(voxel, 1.0));
    const double steep = glm::length(worldGradient);
    if (!(belowMm_ > 0.0) || !(steep > 0.0)) return values_.at(world);
    return values_.largestBelow(world, worldGradient * (inward_ / steep), belowMm_);
  }

 private:
  SecondValues values_;
  glm::dmat4 worldFromVoxel_;
  double inward_;  // times the gradient
  double belowMm_;
};

glm::vec4 texelOf(const std::optional<SecondValue>& value) {
  if (!value) return {kNoValue, 0.0f, 0.0f, 0.0f};
  return {static_cast<float>(value->value), glm::vec3(value->gradient)};
}

// Of a rectangle of the picture, row by row.
std::vector<glm::vec4> texelsOf(const FrameState& frame, const SecondAtPoints& second,
                                const volume::Rectangle& part) {
  const std::vector<float> points = frame.image(image::surface).readFloats(4, part);
  std::vector<float> gradients;
  if (frame.scene->color.below > 0.0) gradients = frame.gradientImage().readFloats(4, part);
  std::vector<glm::vec4> texels(points.size() / 4);
  volume::parallelRanges(texels.size(), 1024, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if (frame.request.stop.stop_requested()) return;
      const float* const p = &points[4 * i];
      const float* const g = gradients.empty() ? nullptr : &gradients[4 * i];
      texels[i] =
          p[3] < 0.0f
              ? texelOf(std::nullopt)
              : texelOf(second.at({p[0], p[1], p[2]}, g ? glm::dvec3(g[0], g[1], g[2]) : glm::dvec3(0.0)));
    }
  });
  return texels;
}

void declareSecondVolume(Declaring& d) {
  d.reads(image::surface).writes(image::second, 16).second();
  if (d.asked.volume.second != 0 && d.asked.scene.color.below > 0.0)
    d.reads(image::gradient).settings({"isosurface.inside"});
}

void lookUpSecondVolume(FrameState& frame) {
  Target& target = frame.target(image::second, {GL_RGBA32F});
  const float none[4] = {kNoValue, 0.0f, 0.0f, 0.0f};
  frame.clear(target, {none});
  if (frame.empty() || !frame.second) return;
  const SecondAtPoints second(frame);
  for (const volume::Rectangle& part : frame.area().rectangles())
    target.images[0].write(GL_RGBA, GL_FLOAT, texelsOf(frame, second, part).data(), part);
}

}  // namespace

Pass secondVolumePass() {
  const Pass::Kind ofCrossing{.ofCrossing = true};
  const LookInput input{image::second, "SECOND", {"uSecond"}, scene::showsSecondVolume};
  return {"second volume", declareSecondVolume, lookUpSecondVolume, input, ofCrossing, Pass::Cpu::always};
}

bool readsSecondRange(const scene::Scene& scene) {
  return scene::showsSecondVolume(scene) && (!scene.color.low || !scene.color.high);
}

glm::dvec2 automaticSecondRange(const FrameState& frame) {
  if (!frame.second || frame.empty()) return {0.0, 1.0};
  const SecondAtPoints second(frame);
  std::vector<double> values;
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i) {
    const GpuVolume& volume = frame.volumeOf(i);
    const volume::Grid& grid = volume.grid();
    for (const volume::VisiblePoint& point : volume.visiblePoints(frame.surfaces[i].value)) {
      const glm::dvec3 gradient =
          volume::worldGradient(grid.geometry(), volume::sampleTrilinear(grid, point.voxel).gradient);
      if (const std::optional<SecondValue> value = second.at(point.voxel, gradient))
        values.push_back(value->value);
    }
  }
  const std::optional<volume::Quantiles> range = volume::rangeOf(values);
  return range ? glm::dvec2(range->low, range->high) : glm::dvec2(0.0, 1.0);
}

glm::dvec2 secondRange(const FrameState& frame) {
  const scene::ColorVolume& color = frame.scene->color;
  return {color.low.value_or(frame.secondRange.x), color.high.value_or(frame.secondRange.y)};
}

void addSecondRange(const FrameState& frame, std::map<std::string, double>& found) {
  if (!scene::showsSecondVolume(*frame.scene)) return;
  const glm::dvec2 range = secondRange(frame);
  if (!frame.scene->color.low) found["color.low"] = range.x;
  if (!frame.scene->color.high) found["color.high"] = range.y;
}

std::vector<glm::vec3> secondColors(const scene::Scene& scene) {
  return scene::colorMapSamples(scene.color.map, kSecondColors, scene::LookColors::sequential);
}

Legend secondLegend(const FrameState& frame) {
  const scene::ColorVolume& color = frame.scene->color;
  const glm::dvec2 range = secondRange(frame);
  Legend legend;
  legend.quantity = frame.second->volume.name;
  legend.unit = frame.second->volume.unit;
  legend.low = range.x;
  legend.high = range.y;
  if (color.below > 0.0) legend.note = "largest within " + base::shortText(color.below, 2) + " mm";
  legend.colors = secondColors(*frame.scene);
  return legend;
}

}  // namespace isolux::render
