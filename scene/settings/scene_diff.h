// Computes and applies differences between scenes, for undo, redo, recordings and --set.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// The path of a setting and its new value. An item of a list that is there only once is one change of the
// whole item ("lamps.key", an object or null).
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
// Throws Error that names the path.
Scene applied(Scene scene, const SceneDiff& diff);
// Returns assignments that make the scene from a new one, one after the other: for command lines. Items that
// a name cannot make are in one assignment of their whole list.
std::vector<SceneChange> assignmentsOf(const Scene& scene);

}  // namespace isolux::scene
