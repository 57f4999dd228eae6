#include "app/documents/unsaved_work.h"

#include <algorithm>

#include "scene/settings.h"

namespace isolux::app {

UnsavedWork unsavedWork(const scene::Scene& saved, const scene::Scene& now) {
  const scene::SceneDiff diff = scene::difference(saved, now, "");
  if (diff.changes.empty()) return UnsavedWork::none;
  const bool viewOnly =
      std::all_of(diff.changes.begin(), diff.changes.end(), [](const scene::SceneChange& change) {
        return change.path.starts_with("camera.") || change.path == "flow.time";
      });
  return viewOnly ? UnsavedWork::view : UnsavedWork::work;
}

bool asksBeforeDiscarding(UnsavedWork unsaved, bool hasSessionFile) {
  return unsaved == UnsavedWork::work || (unsaved == UnsavedWork::view && hasSessionFile);
}

}  // namespace isolux::app
