// Computes and applies differences between scenes, for undo, redo, recordings and --set.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// The path of a setting and its new value.
struct SceneChange {
  std::string path;
  nlohmann::json value;
  bool operator==(const SceneChange&) const = default;
};
struct SceneDiff {
  std::string name;  // what the user did: "Rotate", "Set isovalue"
  std::vector<SceneChange> changes;
  bool operator==(const SceneDiff&) const = default;
};
SceneDiff difference(const Scene& from, const Scene& to, std::string name);
Scene applied(Scene scene, const SceneDiff& diff);

}  // namespace isolux::scene
