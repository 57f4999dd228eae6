#include "scene/rules/quality.h"

#include <algorithm>

#include "scene/settings/setting_value.h"
#include "scene/settings/settings.h"

namespace isolux::scene {

std::span<const Quality> qualities() {
  static const std::vector<Quality> list = {
      {"draft",
       "Draft",
       "One ray per pixel, 16 light paths per texel",
       {"picture.supersampling=1", "gi.samples=16", "picture.rest_hits=same"}},
      {"screen",
       "Screen",
       "2 × 2 rays per pixel, 100 light paths per texel",
       {"picture.supersampling=2", "gi.samples=100", "picture.rest_hits=auto"}},
      {"print",
       "Print",
       "4 × 4 rays per pixel, 400 light paths per texel, exact hits",
       {"picture.supersampling=4", "gi.samples=400", "picture.rest_hits=auto", "hit.method=exact"}}};
  return list;
}

const Quality& quality(std::string_view name) {
  const std::span<const Quality> list = qualities();
  const auto found = std::ranges::find_if(list, [&](const Quality& q) { return q.name == name; });
  if (found == list.end()) refuse("--quality", "unknown quality; choose draft, screen or print");
  return *found;
}

Scene withQuality(Scene scene, const Quality& quality) {
  for (const std::string& assignment : quality.assignments) applyAssignment(scene, assignment);
  return scene;
}

}  // namespace isolux::scene
