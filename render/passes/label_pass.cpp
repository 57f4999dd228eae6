#include "render/passes/label_pass.h"

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/gl/constants.h"
#include "scene/rules/needs.h"
#include "volume/labels/shown_labels.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::render {

namespace {

constexpr float kNone[4] = {kNoValue, kNoValue, kNoValue, kNoValue};

using LabelColors = std::unordered_map<int, glm::vec4>;

// The labels of a surface, with its colour or theirs.
struct LabelsOfSurface {
  std::shared_ptr<const volume::ShownLabels> labels;
  LabelColors colors;

  LabelsOfSurface(std::shared_ptr<const volume::ShownLabels> of, const Surface& surface)
      : labels(std::move(of)) {
    for (const int label : labels->mask.labels)
      colors[label] = glm::vec4(
          surface.labelColors ? volume::labelColor(labels->table.get(), label) : glm::vec3(surface.albedo),
          static_cast<float>(label));
  }
  glm::vec4 at(const glm::dvec3& voxel) const {
    const std::optional<int> label = volume::labelAt(*labels, voxel);
    return label ? colors.at(*label) : glm::vec4(kNoValue);
  }
};

void declareLabels(Declaring& d) {
  d.reads(image::surface).writes(image::label, 16).volume();
  if (d.asked.volume.hasLabels) d.settings({"surfaces.#.label_colors", "surfaces.#.albedo"});
}

void lookUpLabels(FrameState& frame) {
  Target& target = frame.target(image::label, {GL_RGBA32F});
  frame.clear(target, {kNone});
  if (frame.empty() || !frame.volume->prepared()->labels) return;
  std::vector<LabelsOfSurface> surfaces;
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i)
    surfaces.emplace_back(frame.volumeOf(i).prepared()->labels, frame.surfaces[i]);
  for (const volume::Rectangle& part : frame.area().rectangles()) {
    const std::vector<float> points = frame.image(image::surface).readFloats(4, part);
    const std::vector<float> infos = frame.image(image::surface, 1).readFloats(2, part);
    std::vector<glm::vec4> texels(points.size() / 4, glm::vec4(kNoValue));
    volume::parallelRanges(texels.size(), 1024, [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        if (frame.request.stop.stop_requested()) return;
        const float* const p = &points[4 * i];
        if (p[3] < 0.0f) continue;
        const auto surface = static_cast<std::size_t>(volume::HitInfo::of(infos[2 * i + 1]).surface());
        if (surface < surfaces.size()) texels[i] = surfaces[surface].at({p[0], p[1], p[2]});
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
