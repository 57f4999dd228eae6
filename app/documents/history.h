// Undo and redo: a stack of named Scene diffs. Continuous gestures (a drag) merge into one step.
//
// A value: a copy shares its steps, which never change, so that another thread may write it to disk.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/settings/scene_diff.h"

namespace isolux::app {

class History {
 public:
  struct Step {
    scene::SceneDiff back, forth;  // of one name
  };
  using Steps = std::vector<std::shared_ptr<const Step>>;

  explicit History(scene::Scene scene = {}) : scene_(std::move(scene)) {}
  // As it was kept: steps[0, position) are applied in `scene`. Throws base::Error when a step does not fit
  // the settings, std::invalid_argument when position is beyond the steps.
  History(scene::Scene scene, Steps steps, std::size_t position);

  const scene::Scene& scene() const { return scene_; }
  // Makes `next` current as one step named `name`. With the same non-empty `mergeKey` as the last edit, and
  // no seal() between, it replaces that step's result instead of adding a step. Returns the diff (empty:
  // nothing changed).
  scene::SceneDiff edit(const scene::Scene& next, const std::string& name, const std::string& mergeKey = "");
  const std::string& mergeKey() const { return mergeKey_; }  // of the gesture that goes on; "": none
  void seal() { mergeKey_.clear(); }                         // end of a gesture
  void reset(scene::Scene scene);                            // a new document: history empty

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < steps_.size(); }
  std::string undoName() const;  // "" when there is nothing
  std::string redoName() const;
  scene::SceneDiff undo();  // the diff that was applied to scene(), for recordings
  scene::SceneDiff redo();

  const Steps& steps() const { return steps_; }
  std::size_t position() const { return position_; }  // steps before it are applied

 private:
  scene::Scene scene_;
  Steps steps_;
  std::size_t position_ = 0;  // steps_[0, position_) are applied
  std::string mergeKey_;
};

}  // namespace isolux::app
