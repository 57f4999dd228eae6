// Scenes as JSON, assignments from the command line, and named changes: all made from settings().
#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/words.h"
#include "scene/settings/assignment.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

// The groups of the list ("camera"), for telling an unknown key from a group.
void checkGroup(const std::string& name) {
  static const std::vector<std::string> groups = [] {
    std::vector<std::string> names;
    const auto add = [&names](const SettingInfo& s) {
      const std::string group = s.path.substr(0, s.path.find('.'));
      if (names.empty() || names.back() != group) names.push_back(group);
    };
    for (const Setting& s : settings()) add(s);
    for (const HostSetting& s : hostSettings()) add(s);
    return names;
  }();
  if (std::ranges::find(groups, name) != groups.end()) return;
  base::throwUsage("", name.substr(0, 200), "unknown group of settings" + base::didYouMean(name, groups, ""));
}

// The members of a group, and those of the groups within it.
void assignMembers(Scene& scene, const std::string& group, const json& members) {
  for (const auto& [name, value] : members.items()) {
    const std::string path = std::string(group).append(1, '.').append(name);
    const std::span<const Setting> all = settings();
    const bool isGroup = value.is_object() && std::ranges::any_of(all, [&](const Setting& s) {
                           return covers(path + '.', s.path);
                         });
    if (isGroup)
      assignMembers(scene, path, value);
    else if (!isHostSetting(path))  // in files of before they left the scene: another user's hardware
      setting(path).set(scene, value);
  }
}

}  // namespace

void applyAssignment(Scene& scene, std::string_view assignment) {
  if (assignment.find('=') == std::string_view::npos)
    base::throwUsage("", std::string(assignment), "expected PATH=VALUE");
  const Setting& target = setting(pathOf(assignment));
  target.set(scene, valueOf(target, assignment));
}

nlohmann::json toJson(const Scene& scene) {
  json result = json::object();
  for (const Setting& s : settings()) {
    json* place = &result;
    std::string_view rest = s.path;
    for (auto dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      place = &(*place)[std::string(rest.substr(0, dot))];
      rest.remove_prefix(dot + 1);
    }
    (*place)[std::string(rest)] = s.get(scene);
  }
  return result;
}

Scene fromJson(const nlohmann::json& json) {
  Scene scene;
  if (!json.is_object()) base::throwUsage("", "", "the scene must be a JSON object");
  for (const auto& [group, members] : json.items()) {
    checkGroup(group);
    if (!members.is_object()) base::throwUsage("", group, "must be a JSON object");
    assignMembers(scene, group, members);
  }
  return scene;
}

SceneDiff difference(const Scene& from, const Scene& to, std::string name) {
  SceneDiff diff{std::move(name), {}};
  for (const Setting& s : settings()) {
    nlohmann::json value = s.get(to);
    // Not !=, which is false for NaN: a NaN must reach applied() and be refused there.
    if (!(value == s.get(from))) diff.changes.push_back({s.path, std::move(value)});
  }
  return diff;
}

Scene applied(Scene scene, const SceneDiff& diff) {
  for (const SceneChange& change : diff.changes)
    if (!isHostSetting(change.path)) setting(change.path).set(scene, change.value);
  return scene;
}

}  // namespace isolux::scene
