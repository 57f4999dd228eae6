// Undo and redo: a stack of named Scene diffs. Continuous gestures (a drag) merge into one step.
#pragma once

#include <string>
#include <vector>

#include "scene/settings.h"

namespace isolux::app {

class History {
 public:
  explicit History(scene::Scene scene = {}) : scene_(std::move(scene)) {}

  const scene::Scene& scene() const { return scene_; }
  // Makes `next` current as one step named `name`. With the same non-empty `mergeKey` as the last edit, and
  // no seal() between, it replaces that step's result instead of adding a step. Returns the diff (empty:
  // nothing changed).
  scene::SceneDiff edit(scene::Scene next, const std::string& name, const std::string& mergeKey = "");
  void seal() { mergeKey_.clear(); }  // end of a gesture
  void reset(scene::Scene scene);     // a new document: history empty

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < steps_.size(); }
  std::string undoName() const;  // "" when there is nothing
  std::string redoName() const;
  scene::SceneDiff undo();  // the diff that was applied to scene(), for recordings
  scene::SceneDiff redo();

 private:
  struct Step {
    scene::SceneDiff back, forth;
  };
  scene::Scene scene_;
  std::vector<Step> steps_;
  std::size_t position_ = 0;  // steps_[0, position_) are applied
  std::string mergeKey_;
};

}  // namespace isolux::app
