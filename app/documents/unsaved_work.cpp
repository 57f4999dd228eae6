#include "app/documents/unsaved_work.h"

#include <algorithm>
#include <array>

#include "scene/settings/scene_diff.h"

namespace isolux::app {

UnsavedWork unsavedWork(const scene::Scene& saved, const scene::Scene& now) {
  const scene::SceneDiff diff = scene::difference(saved, now, "");
  if (diff.changes.empty()) return UnsavedWork::none;
  const bool viewOnly = std::ranges::all_of(diff.changes, [](const scene::SceneChange& change) {
    constexpr std::array words{"picture.letters", "picture.scale_bar",   "picture.isovalue",
                               "picture.caveats", "picture.transparent", "picture.pixel_ratio"};
    return change.path.starts_with("camera.") || change.path == "flow.time" ||
           std::ranges::find(words, change.path) != words.end();
  });
  return viewOnly ? UnsavedWork::view : UnsavedWork::work;
}

bool asksBeforeDiscarding(UnsavedWork unsaved, bool hasSessionFile) {
  return unsaved == UnsavedWork::work || (unsaved == UnsavedWork::view && hasSessionFile);
}

}  // namespace isolux::app
