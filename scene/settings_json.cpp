// Scenes as JSON, assignments from the command line, and named changes: all made from settings().
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/suggestion.h"
#include "scene/settings.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// A whole word as a finite number; empty when it is none.
std::optional<double> numberOf(std::string_view word) {
  word = trimmed(word);
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

json numberOrWord(std::string_view word) {
  const std::optional<double> number = numberOf(word);
  return number ? json(*number) : json(std::string(word));
}

// What the words of an assignment mean for this setting; a word that makes no sense stays a word, which
// Setting::set then refuses with the reason.
json valueOf(const Setting& target, std::string_view text) {
  if (target.type == SettingType::text) return std::string(text);
  const std::string_view word = trimmed(text);
  if (target.type == SettingType::choice || (target.mayBeAutomatic && word == "auto"))
    return std::string(word);
  if (target.type == SettingType::points) {
    json list = json::parse(word, nullptr, false);
    return list.is_discarded() ? json(std::string(word)) : list;
  }
  const bool yes = word == "true" || word == "on", no = word == "false" || word == "off";
  if (target.type == SettingType::toggle) {
    if (yes || word == "1") return true;
    if (no || word == "0") return false;
    return std::string(word);
  }
  // A strength from 0 to 1 is also switched by word.
  if (target.type == SettingType::number && target.minimum == 0.0 && target.maximum == 1.0 && (yes || no))
    return yes ? 1.0 : 0.0;
  const std::size_t components = componentsOf(target.type);
  if (components == 0) return numberOrWord(word);
  json list = json::array();
  std::size_t begin = 0;
  while (begin <= word.size() && list.size() <= components) {
    const std::size_t comma = std::min(word.find(',', begin), word.size());
    const std::optional<double> number = numberOf(word.substr(begin, comma - begin));
    if (!number) return std::string(word);
    list.push_back(*number);
    begin = comma + 1;
  }
  return list.size() == components ? list : json(std::string(word));
}

// The groups of the list ("camera"), for telling an unknown key from a group.
void checkGroup(const std::string& name) {
  static const std::vector<std::string> groups = [] {
    std::vector<std::string> names;
    for (const Setting& s : settings()) {
      const std::string group = s.path.substr(0, s.path.find('.'));
      if (names.empty() || names.back() != group) names.push_back(group);
    }
    return names;
  }();
  if (std::find(groups.begin(), groups.end(), name) != groups.end()) return;
  const std::string suggestion = base::nearest(name, groups);
  throw base::Error(base::ErrorKind::usage, "", name.substr(0, 200),
                    suggestion.empty() ? "unknown group of settings"
                                       : "unknown group of settings, did you mean " + suggestion + "?");
}

// The members of a group, and those of the groups within it.
void assignMembers(Scene& scene, const std::string& group, const json& members) {
  for (const auto& [name, value] : members.items()) {
    const std::string path = group + '.' + name;
    const std::span<const Setting> all = settings();
    const bool isGroup = value.is_object() && std::any_of(all.begin(), all.end(), [&](const Setting& s) {
                           return s.path.starts_with(path + '.');
                         });
    if (isGroup)
      assignMembers(scene, path, value);
    else
      setting(path).set(scene, value);
  }
}

}  // namespace

void applyAssignment(Scene& scene, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw base::Error(base::ErrorKind::usage, "", std::string(assignment), "expected PATH=VALUE");
  const Setting& target = setting(trimmed(assignment.substr(0, equals)));
  target.set(scene, valueOf(target, assignment.substr(equals + 1)));
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
  if (!json.is_object()) throw base::Error(base::ErrorKind::usage, "", "", "the scene must be a JSON object");
  for (const auto& [group, members] : json.items()) {
    checkGroup(group);
    if (!members.is_object()) throw base::Error(base::ErrorKind::usage, "", group, "must be a JSON object");
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
  for (const SceneChange& change : diff.changes) setting(change.path).set(scene, change.value);
  return scene;
}

std::string describeChange(const Scene& from, const Scene& to) {
  const SceneDiff diff = difference(from, to, "");
  if (diff.changes.empty()) return {};
  const std::string& first = diff.changes.front().path;
  if (diff.changes.size() == 1) return "Change " + first;
  const std::string group = first.substr(0, first.find('.') + 1);
  const bool sameGroup = std::all_of(diff.changes.begin(), diff.changes.end(),
                                     [&](const SceneChange& c) { return c.path.starts_with(group); });
  if (sameGroup) return "Change " + group.substr(0, group.size() - 1);
  return "Change " + std::to_string(diff.changes.size()) + " settings";
}

}  // namespace isolux::scene
