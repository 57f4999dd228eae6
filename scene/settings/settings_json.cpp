// Scenes as JSON, assignments from the command line, and named changes: all made from settings().
#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/words.h"
#include "scene/settings/assignment.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/scene_list.h"
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
    for (const SceneList& list : sceneLists()) names.push_back(list.path);
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

const SceneList* listNamed(std::string_view name) {
  const auto found = std::ranges::find(sceneLists(), name, &SceneList::path);
  return found == sceneLists().end() ? nullptr : &*found;
}

// Whether the path is that of a whole item: "lamps.key".
bool isItemOf(const SceneList& list, std::string_view path) {
  return listOfPath(path) == &list && std::ranges::count(path, '.') == 1 && !path.ends_with(".order");
}

// Of items: those that go, those that come, fields of those that stay, the order.
void addItemChanges(const SceneList& list, const Scene& from, const Scene& to,
                    std::vector<SceneChange>& changes) {
  const std::vector<std::string> before = list.ids(from), after = list.ids(to);
  std::vector<std::string> order;  // as it is when those have gone and come
  const auto isIn = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::ranges::find(ids, id) != ids.end();
  };
  for (const std::string& id : before) {
    if (isIn(after, id))
      order.push_back(id);
    else
      changes.push_back({list.path + '.' + id, nullptr});
  }
  std::vector<std::string> sorted = after;  // new ones come in this order, as JSON keeps them
  std::ranges::sort(sorted);
  for (const std::string& id : sorted) {
    const std::string path = list.path + '.' + id;
    if (!isIn(before, id)) {
      order.push_back(id);
      changes.push_back({path, setting(path).get(to)});
      continue;
    }
    for (std::size_t field = 0; field < list.fields.size(); ++field) {
      json value = list.get(to, id, field);
      if (!(value == list.get(from, id, field)))
        changes.push_back(
            {path + '.' + std::string(nameOfField(list, list.fields[field])), std::move(value)});
    }
  }
  if (order != after) changes.push_back({list.path + ".order", after});
}

// The field by which a user would make the item: the joiner where it says something.
const std::string& makerOf(const SceneList& list, const Scene& scene, const std::string& id) {
  const auto isJoiner = [&](const SettingInfo& field) { return nameOfField(list, field) == list.joiner; };
  const auto joiner = std::ranges::find_if(list.fields, isJoiner);
  if (joiner == list.fields.end()) return list.maker;
  const auto field = static_cast<std::size_t>(joiner - list.fields.begin());
  return list.get(scene, id, field) == list.get(scene, "", field) ? list.maker : list.joiner;
}

// Assigns the items of a list to `made` by their fields, as a user would, or all at once where that gives
// others.
void assignItemsOf(const SceneList& list, const Scene& scene, Scene& made,
                   std::vector<SceneChange>& changes) {
  const Scene before = made;
  const std::size_t first = changes.size();
  const auto assign = [&](const std::string& path) {
    json value = setting(path).get(scene);
    if (value == setting(path).get(made)) return;
    setting(path).set(made, value);
    changes.push_back({path, std::move(value)});
  };
  const auto isThere = [&](const std::string& id) {
    return positionOf(made, list.path + '.' + id).has_value();
  };
  std::vector<std::string> ids = list.ids(scene);
  std::ranges::stable_partition(ids, isThere);  // those that are there first: then nothing takes their place
  for (const std::string& id : ids) {
    const std::string item = list.path + '.' + id + '.';
    if (!isThere(id)) {
      const std::string maker = item + makerOf(list, scene, id);
      setting(maker).set(made, setting(maker).get(scene));
      changes.push_back({maker, setting(maker).get(scene)});
    }
    for (const SettingInfo& field : list.fields) assign(item + std::string(nameOfField(list, field)));
  }
  if (list.ids(made).size() == ids.size() && list.ids(made) != list.ids(scene)) assign(list.path + ".order");
  if (setting(list.path).get(made) == setting(list.path).get(scene)) return;
  made = before;
  changes.resize(first);
  assign(list.path);
}

}  // namespace

void applyAssignment(Scene& scene, std::string_view assignment) {
  if (assignment.find('=') == std::string_view::npos)
    base::throwUsage("", std::string(assignment), "expected PATH=VALUE");
  const Setting target = setting(pathOf(assignment));
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
  for (const SceneList& list : sceneLists()) result[list.path] = setting(list.path).get(scene);
  return result;
}

Scene fromJson(const nlohmann::json& json) {
  Scene scene;
  if (!json.is_object()) base::throwUsage("", "", "the scene must be a JSON object");
  for (const auto& [group, members] : json.items()) {
    if (const SceneList* const list = listNamed(group)) {
      setting(list->path).set(scene, members);
      continue;
    }
    if (patternOf(group + ".shown") == group + ".shown") checkGroup(group);  // else numbered, of before lists
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
  for (const SceneList& list : sceneLists()) addItemChanges(list, from, to, diff.changes);
  return diff;
}

std::vector<SceneChange> assignmentsOf(const Scene& scene) {
  std::vector<SceneChange> changes;
  for (const Setting& s : settings())
    if (nlohmann::json value = s.get(scene); !(value == s.defaultValue())) changes.push_back({s.path, value});
  Scene made;
  for (const SceneList& list : sceneLists()) assignItemsOf(list, scene, made, changes);
  return changes;
}

Scene applied(Scene scene, const SceneDiff& diff) {
  // Items come and go at once: on the way no list may be too long or too short.
  for (const SceneList& list : sceneLists()) {
    std::vector<std::string> ids = list.ids(scene), made;
    for (const SceneChange& change : diff.changes) {
      if (!isItemOf(list, change.path)) continue;
      const std::string id = change.path.substr(list.path.size() + 1);
      if (change.value.is_null())
        std::erase(ids, id);
      else if (std::ranges::find(ids, id) == ids.end())
        made.push_back(id);
    }
    std::ranges::sort(made);
    ids.insert(ids.end(), made.begin(), made.end());
    if (ids != list.ids(scene)) arrangeChecked(list, scene, ids);
  }
  for (const SceneChange& change : diff.changes) {
    const bool gone = change.value.is_null() && setting(change.path).type == SettingType::item;
    if (!gone && !isHostSetting(change.path)) setting(change.path).set(scene, change.value);
  }
  return scene;
}

}  // namespace isolux::scene
