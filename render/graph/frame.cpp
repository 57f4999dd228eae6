#include "render/graph/frame.h"

#include <sstream>

#include "base/error.h"
#include "base/words.h"

namespace isolux::render {

const char* nameOf(PassState state) {
  switch (state) {
    case PassState::ran:
      return "ran";
    case PassState::cached:
      return "cached";
    case PassState::skipped:
      break;
  }
  return "skipped";
}

void throwIfStopped(const FrameRequest& request) {
  if (request.stop.stop_requested())
    throw base::Error(base::ErrorKind::interrupted, "", "", "the image was stopped");
}

const std::vector<AovInfo>& aovs() {
  static const std::vector<AovInfo> list = {
      {Aov::position, "position", "mm, world", {"x", "y", "z"}},
      {Aov::voxel, "voxel", "voxel coordinates", {"x", "y", "z"}},
      {Aov::depth, "depth", "mm along the ray", {""}},
      {Aov::value_error, "value_error", "data units", {""}},
      {Aov::normal, "normal", "unit vector, world", {"x", "y", "z"}},
      {Aov::gradient, "gradient", "data units per mm, world", {"x", "y", "z"}},
      {Aov::hessian, "hessian", "data units per mm², world", {"xx", "yy", "zz", "xy", "xz", "yz"}},
      {Aov::kappa, "kappa", "1/mm", {"1", "2"}},
      {Aov::direction1, "direction1", "unit vector, world", {"x", "y", "z"}},
      {Aov::direction2, "direction2", "unit vector, world", {"x", "y", "z"}},
      {Aov::flowline_curvature, "flowline_curvature", "1/mm", {""}},
      {Aov::curvature_confidence, "curvature_confidence", "0 to 1", {""}},
      {Aov::scale, "scale", "mm, of the curvature", {""}},
      {Aov::edge_offset, "edge_offset", "mm along the outward normal", {""}},
      {Aov::edge_strength, "edge_strength", "standard deviations of the gradient's noise", {""}},
      {Aov::color_value, "color_value", "data units of color.volume", {""}},
      {Aov::label, "label", "label of the shown label map", {""}},
      {Aov::piece, "piece", "id of the connected piece, 0 is the largest", {""}},
      {Aov::irradiance, "irradiance", "radiance times sr, no exposure of the picture", {"r", "g", "b"}},
      {Aov::hit, "hit", "1 or 0", {""}},
  };
  return list;
}

std::vector<Aov> parseAovList(const std::string& text) {
  std::vector<Aov> list;
  std::istringstream words(text);
  const std::string known = base::joined(aovs(), ", ", &AovInfo::name);
  for (std::string word; std::getline(words, word, ',');) {
    const auto info = std::ranges::find(aovs(), word, &AovInfo::name);
    if (info == aovs().end()) base::throwUsage("", "--aov", "unknown image '" + word + "'; known: " + known);
    list.push_back(info->aov);
  }
  if (list.empty()) base::throwUsage("", "--aov", "no image named; known: " + known);
  return list;
}

}  // namespace isolux::render
