#include "app/documents/stored_scene.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "app/documents/anonymous.h"
#include "app/documents/path_text.h"
#include "app/documents/places.h"
#include "base/error.h"
#include "scene/settings/scene_list.h"
#include "volume/labels/shown_labels.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/step_files.h"

namespace isolux::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 5> pathSettings{"source.path", "source.csg_path", "source.label_names",
                                                       "light.environment.file", "color.volume"};

bool namesFile(const std::string& path) {
  return !path.empty() && !path.starts_with("phantom:");
}

void addMissing(json& stored, const json& members) {
  if (!stored.is_object()) return;
  for (const auto& [key, value] : members.items()) {
    if (!stored.contains(key))
      stored[key] = value;
    else if (value.is_object())
      addMissing(stored[key], value);
  }
}

// Whether a further isosurface of before there was a list is switched off, with nothing set but an isovalue.
bool isUntouched(const std::string& group, const json& members) {
  if (!members.is_object()) return false;
  json others = members;
  others.erase("value");
  scene::Scene scene;
  try {
    for (const auto& [name, value] : others.items()) scene::setting(group + '.' + name).set(scene, value);
  } catch (const base::Error&) {
    return false;  // refused where the scene is read
  }
  return scene == scene::Scene{};
}

fs::path absoluteFolder(const fs::path& folder) {
  return fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal();
}

// Relative to `folder` where it lies below that.
std::string relativePath(const std::string& path, const fs::path& folder) {
  if (!namesFile(path)) return path;
  const fs::path file = fs::absolute(path).lexically_normal();
  const fs::path relative = file.lexically_relative(absoluteFolder(folder));
  if (relative.empty() || *relative.begin() == "..") return file.string();
  return relative.string();
}

// "line 3, column 5" of the byte, counted from 1, behind which nothing was understood.
std::string placeOfByte(const std::string& text, std::size_t byte, const std::string& place) {
  const std::string_view before = std::string_view(text).substr(0, byte > 0 ? byte - 1 : 0);
  const std::size_t newline = before.rfind('\n');
  const std::string column =
      "column " + std::to_string(before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1);
  if (!place.empty()) return place + ", " + column;
  return "line " + std::to_string(std::ranges::count(before, '\n') + 1) + ", " + column;
}

// Refuses an object with two equal keys, of which a parser takes either.
class TwiceGuard {
 public:
  explicit TwiceGuard(const std::string& file) : file_(file) {}
  bool operator()(int, json::parse_event_t event, const json& parsed) {
    if (event == json::parse_event_t::object_start) keys_.emplace_back();
    if (event == json::parse_event_t::object_end) keys_.pop_back();
    if (event == json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second)
      base::throwInput(file_, parsed.get<std::string>(), "is there twice in one object");
    return true;
  }

 private:
  const std::string& file_;
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

bool isStoredPath(std::string_view setting) {
  return std::ranges::find(pathSettings, setting) != pathSettings.end();
}

StoredFolders foldersOf(const fs::path& file) {
  StoredFolders folders{absoluteFolder(file.parent_path())};
  std::error_code error;
  const fs::path target = fs::canonical(file, error).parent_path();
  if (!error && target != folders.front()) folders.push_back(target);
  return folders;
}

std::string storedPath(const std::string& path, const fs::path& folder) {
  return pathText(relativePath(path, folder));
}

std::string pathFromStored(const std::string& text, const StoredFolders& folders) {
  if (!namesFile(text)) return text;
  const std::string stored = pathOfText(text);
  std::vector<fs::path> candidates;
  for (const fs::path& folder : folders)
    candidates.push_back((absoluteFolder(folder) / stored).lexically_normal());
  std::error_code ignored;
  const auto found = std::ranges::find_if(candidates, [&](const fs::path& candidate) {
    return fs::exists(candidate, ignored) || volume::hdf5PathOf(candidate.string()) ||
           !volume::stepFiles(candidate.string()).empty();
  });
  return (found == candidates.end() ? candidates.front() : *found).string();
}

json storedScene(const scene::Scene& scene, const fs::path& folder) {
  scene::Scene stored = scene;
  for (const std::string_view path : pathSettings) {
    const scene::Setting& setting = scene::setting(path);
    setting.set(stored, storedPath(setting.get(scene).get<std::string>(), folder));
  }
  return scene::toJson(stored);
}

SharedScene sharedScene(const scene::Scene& scene, const fs::path& folder, const volume::Patient& patient) {
  SharedScene shared{{}, json::object()};
  scene::Scene named = withoutPatient(scene, patient);
  for (const std::string_view path : pathSettings) {
    const scene::Setting& setting = scene::setting(path);
    const std::string whole = setting.get(scene).get<std::string>();
    const fs::path stored = relativePath(whole, folder);
    const std::string plain = stored.is_absolute() ? stored.filename().string() : stored.string();
    const std::string name = namesFile(plain) ? withoutPatient(plain, patient) : plain;
    setting.set(named, pathText(name));
    if (name == stored.string()) continue;
    const std::string token = placeToken(fs::absolute(whole).lexically_normal());
    if (!token.empty()) shared.places[std::string(path)] = token;
  }
  shared.scene = scene::toJson(named);
  return shared;
}

void applyPlaces(scene::Scene& scene, const json& places, const std::string& file) {
  checkKeys(places, {pathSettings[0], pathSettings[1], pathSettings[2], pathSettings[3]}, file, "places");
  for (const auto& [path, token] : places.items()) {
    if (!token.is_string()) base::throwInput(file, "places, " + path, "must be a text");
    const scene::Setting& setting = scene::setting(path);
    const fs::path known = placeOf(token.get<std::string>());
    const fs::path named = setting.get(scene).get<std::string>();
    const bool hidden = named.string().find(kAnonymous) != std::string::npos;
    if (!known.empty() && (hidden || known.filename() == named.filename()))
      setting.set(scene, known.string());
  }
}

scene::Scene sceneFromStored(const json& stored, const std::string& file, const std::string& place,
                             const StoredFolders& folders) {
  try {
    scene::Scene scene = scene::fromJson(stored);
    for (const std::string_view path : pathSettings) {
      const scene::Setting& setting = scene::setting(path);
      setting.set(scene, pathFromStored(setting.get(scene).get<std::string>(), folders));
    }
    return scene;
  } catch (const base::Error& error) {
    std::string where = place;
    if (!error.place().empty()) where += (where.empty() ? "" : ".") + error.place();
    base::throwInput(file, where, error.reason());
  }
}

json sceneOfVersion(int written, json stored) {
  const auto rename = [&](const char* pointer, const char* then, const char* now) {
    const json::json_pointer place(pointer);
    if (stored.contains(place) && stored[place] == then) stored[place] = now;
  };
  if (written <= 3)  // before built-in lights, and exposure by the surface
    addMissing(stored, {{"light", {{"environment", {{"constant", {1.0, 1.0, 1.0}}}}}},
                        {"picture", {{"metering", "lights"}}}});
  if (written <= 4)  // before derivatives at a scale, hits at rest, and outlines that go with tone
    addMissing(stored,
               {{"derivatives", {{"scale", 0.0}, {"normal_scale", 0.0}}},
                {"picture", {{"rest_hits", "same"}}},
                {"look",
                 {{"contours", 0.0}, {"tone_cool", {0.08, 0.12, 0.35}}, {"tone_warm", {0.95, 0.72, 0.38}}}}});
  if (written <= 6)  // before cameras framed the surface, and isovalues were of the whole object
    addMissing(stored, {{"camera", {{"frames", "volume"}}}, {"isosurface", {{"suggestion", "contrast"}}}});
  if (written <= 7)  // before looks were lit by more than a key light
    addMissing(stored, {{"light", {{"setup", "key"}, {"direction", {-0.5, 0.7, 0.9}}}},
                        {"look", {{"ambient_variation", 0.0}}}});
  if (written <= 8) {  // before the tone curve
    addMissing(stored, {{"picture", {{"curve", "linear"}, {"metering", "surface"}}},
                        {"light", {{"environment", {{"builtin", "studio"}}}}}});
    rename("/picture/metering", "surface", "brightness");
    rename("/light/environment/builtin", "studio", "dark_studio");
  }
  if (written <=
      9)  // before surfaces were a list, and pictures carried isovalues of those that nobody had made
    for (const char* group : {"isosurface2", "isosurface3", "isosurface4"})
      if (stored.contains(group) && isUntouched(group, stored[group])) stored.erase(group);
  if (written <= 9)  // before the surfaces of labels
    addMissing(stored, {{"source", {{"labels", scene::kLabelsAsValues}}}});
  return stored;
}

void checkKeys(const json& stored, std::initializer_list<std::string_view> known, const std::string& file,
               const std::string& place) {
  if (!stored.is_object()) base::throwInput(file, place, "a JSON object was expected");
  for (const auto& [key, value] : stored.items())
    if (std::ranges::find(known, key) == known.end())
      base::throwInput(file, place.empty() ? key : std::string(place).append(", ").append(key),
                       "unknown key");
}

json parseJson(const std::string& text, const std::string& file, const std::string& place) {
  try {
    TwiceGuard guard(file);
    return json::parse(text, std::ref(guard));
  } catch (const json::parse_error& error) {
    base::throwInput(file, placeOfByte(text, error.byte, place), "is not valid JSON");
  } catch (const json::exception&) {  // a number too large for a double
    base::throwInput(file, place, "holds a number that is out of range");
  }
}

}  // namespace isolux::app
