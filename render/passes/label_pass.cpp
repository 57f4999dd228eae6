#include "render/passes/label_pass.h"

#include <unordered_map>
#include <vector>

#include "render/gl/constants.h"
#include "scene/rules/needs.h"
#include "volume/labels/shown_labels.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::render {

namespace {

constexpr float kNone[4] = {kNoValue, kNoValue, kNoValue, kNoValue};

using LabelColors = std::unordered_map<int, glm::vec4>;

LabelColors colorsOf(const volume::ShownLabels& labels) {
  LabelColors colors;
  for (const int label : labels.mask.labels)
    colors[label] = glm::vec4(volume::labelColor(labels.table.get(), label), static_cast<float>(label));
  return colors;
}

void declareLabels(Declaring& d) {
  d.reads(image::surface).writes(image::label, 16).volume();
}

void lookUpLabels(FrameState& frame) {
  Target& target = frame.target(image::label, {GL_RGBA32F});
  frame.clear(target, {kNone});
  if (frame.empty() || !frame.labels) return;
  const LabelColors colors = colorsOf(*frame.labels);
  for (const volume::Rectangle& part : frame.area().rectangles()) {
    const std::vector<float> points = frame.image(image::surface).readFloats(4, part);
    std::vector<glm::vec4> texels(points.size() / 4, glm::vec4(kNoValue));
    volume::parallelRanges(texels.size(), 1024, [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        if (frame.request.stop.stop_requested()) return;
        const float* const p = &points[4 * i];
        if (p[3] < 0.0f) continue;
        if (const std::optional<int> label = volume::labelAt(*frame.labels, {p[0], p[1], p[2]}))
          texels[i] = colors.at(*label);
      }
    });
    target.images[0].write(GL_RGBA, GL_FLOAT, texels.data(), part);
  }
}

}  // namespace

Pass labelPass() {
  const Pass::Kind ofCrossing{.ofCrossing = true};
  const LookInput input{image::label, "LABELS", {"uLabel"}, scene::showsLabels};
  return {"label", declareLabels, lookUpLabels, input, ofCrossing, Pass::Cpu::always};
}

}  // namespace isolux::render
