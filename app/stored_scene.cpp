#include "app/stored_scene.h"

#include <algorithm>

#include "scene/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

bool namesFile(const std::string& path) {
  return !path.empty() && !path.starts_with("phantom:");
}

fs::path absoluteFolder(const fs::path& folder) {
  return fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal();
}

}  // namespace

bool isStoredPath(std::string_view setting) {
  return setting == "source.path" || setting == "source.csg_path" || setting == "light.environment.file";
}

std::string storedSourcePath(const std::string& path, const fs::path& folder) {
  if (!namesFile(path)) return path;
  const fs::path file = fs::absolute(path).lexically_normal();
  const fs::path relative = file.lexically_relative(absoluteFolder(folder));
  if (relative.empty() || *relative.begin() == "..") return file.string();
  return relative.string();
}

std::string sourcePathFromStored(const std::string& stored, const fs::path& folder) {
  if (!namesFile(stored)) return stored;
  return (absoluteFolder(folder) / stored).lexically_normal().string();
}

json storedScene(const scene::Scene& scene, const fs::path& folder) {
  scene::Scene stored = scene;
  stored.source.path = storedSourcePath(scene.source.path, folder);
  stored.source.csgPath = storedSourcePath(scene.source.csgPath, folder);
  return scene::toJson(stored);
}

scene::Scene sceneFromStored(const json& stored, const std::string& file, const std::string& place,
                             const fs::path& folder) {
  try {
    scene::Scene scene = scene::fromJson(stored);
    scene.source.path = sourcePathFromStored(scene.source.path, folder);
    scene.source.csgPath = sourcePathFromStored(scene.source.csgPath, folder);
    return scene;
  } catch (const scene::Error& error) {
    std::string where = place;
    if (!error.place().empty()) where += (where.empty() ? "" : ".") + error.place();
    scene::throwInput(file, where, error.reason());
  }
}

void checkKeys(const json& stored, std::initializer_list<std::string_view> known, const std::string& file,
               const std::string& place) {
  if (!stored.is_object()) scene::throwInput(file, place, "a JSON object was expected");
  for (const auto& [key, value] : stored.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      scene::throwInput(file, place.empty() ? key : place + ", " + key, "unknown key");
}

json parseJson(const std::string& text, const std::string& file, const std::string& place) {
  const std::string before = place.empty() ? "" : place + ", ";
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    scene::throwInput(file, before + "byte " + std::to_string(error.byte), "is not valid JSON");
  } catch (const json::exception&) {  // a number too large for a double
    scene::throwInput(file, place, "holds a number that is out of range");
  }
}

}  // namespace isolux::app
