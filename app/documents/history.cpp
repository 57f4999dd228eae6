#include "app/documents/history.h"
#include "scene/settings/scene_diff.h"

#include <stdexcept>
#include <utility>

namespace isolux::app {

using scene::SceneDiff;

History::History(scene::Scene scene, Steps steps, std::size_t position)
    : scene_(std::move(scene)), steps_(std::move(steps)), position_(position) {
  if (position_ > steps_.size()) throw std::invalid_argument("more steps applied than there are");
  scene::Scene trial = scene_;  // every step once, so that none can throw later
  for (std::size_t i = position_; i-- > 0;) trial = scene::applied(std::move(trial), steps_[i]->back);
  for (const auto& step : steps_) trial = scene::applied(std::move(trial), step->forth);
}

SceneDiff History::edit(const scene::Scene& next, const std::string& name, const std::string& mergeKey) {
  SceneDiff forth = scene::difference(scene_, next, name);
  if (forth.changes.empty()) return forth;
  SceneDiff back = scene::difference(next, scene_, name);
  scene::Scene result =
      scene::applied(scene_, forth);  // throws, before anything changed, for a scene out of range

  const bool merges = !mergeKey.empty() && mergeKey == mergeKey_ && canUndo() && !canRedo();
  if (merges) {
    const scene::Scene origin = scene::applied(scene_, steps_.back()->back);
    Step merged{scene::difference(result, origin, name), scene::difference(origin, result, name)};
    if (merged.forth.changes.empty()) {  // the gesture came back to where it began: not a step
      steps_.pop_back();
      --position_;
      mergeKey_.clear();
    } else {
      steps_.back() = std::make_shared<const Step>(std::move(merged));
    }
  } else {
    steps_.resize(position_);  // what was undone is gone
    steps_.push_back(std::make_shared<const Step>(Step{std::move(back), forth}));
    ++position_;
    mergeKey_ = mergeKey;
  }
  scene_ = std::move(result);
  return forth;
}

void History::reset(scene::Scene scene) {
  scene_ = std::move(scene);
  steps_.clear();
  position_ = 0;
  mergeKey_.clear();
}

std::string History::undoName() const {
  return canUndo() ? steps_[position_ - 1]->back.name : std::string();
}

std::string History::redoName() const {
  return canRedo() ? steps_[position_]->forth.name : std::string();
}

SceneDiff History::undo() {
  if (!canUndo()) return {};
  seal();
  SceneDiff diff = steps_[position_ - 1]->back;
  scene_ = scene::applied(std::move(scene_), diff);
  --position_;
  diff.name = "Undo " + diff.name;
  return diff;
}

SceneDiff History::redo() {
  if (!canRedo()) return {};
  seal();
  SceneDiff diff = steps_[position_]->forth;
  scene_ = scene::applied(std::move(scene_), diff);
  ++position_;
  diff.name = "Redo " + diff.name;
  return diff;
}

}  // namespace isolux::app
