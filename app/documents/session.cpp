#include "app/documents/session.h"

#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/version.h"
#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;
using nlohmann::json;

namespace {

constexpr std::size_t longestSession = std::size_t{16} << 20;  // bytes
constexpr std::string_view versionKey = "isolux_session";

// Version 1 was flat: {"isolux_session": 1, "settings": {"isosurface.value": 300, ...}}.
json upgradeFrom1(json session, const std::string& file) {
  checkKeys(session, {versionKey, "program", "settings"}, file, "");
  json nested = json::object();
  if (session.contains("settings")) {
    json& flat = session["settings"];
    if (!flat.is_object()) throwInput(file, "settings", "must be a JSON object");
    for (auto& [path, value] : flat.items()) {
      const auto dot = path.find('.');
      if (dot == std::string::npos || path.find('.', dot + 1) != std::string::npos)
        throwInput(file, "settings." + path, "unknown setting");
      nested[path.substr(0, dot)][path.substr(dot + 1)] = std::move(value);
    }
    session.erase("settings");
  }
  session["scene"] = std::move(nested);
  return session;
}

int versionOf(const json& session, const std::string& file) {
  const auto found = session.find(versionKey);
  if (found == session.end()) throwInput(file, "", "is not a session: \"isolux_session\" is missing");
  const std::string place(versionKey);
  if (!found->is_number_integer()) throwInput(file, place, "the version must be a whole number");
  const bool unsignedValue = found->is_number_unsigned();
  if (unsignedValue ? found->get<std::uint64_t>() < 1 : found->get<std::int64_t>() < 1)
    throwInput(file, place, "the version must be 1 or more");
  if (found->get<std::uint64_t>() > std::uint64_t{sessionVersion})
    throwInput(file, place,
               "version " + found->dump() + " was written by a newer Isolux; this one (" +
                   std::string(version()) + ") reads up to version " + std::to_string(sessionVersion));
  return found->get<int>();
}

std::string textOf(json session) {
  session[std::string(versionKey)] = sessionVersion;
  session["program"] = version();
  return session.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string sessionText(const scene::Scene& scene, const fs::path& folder) {
  return textOf({{"scene", storedScene(scene, folder)}});
}

std::string pictureSessionText(const scene::Scene& scene, const fs::path& folder,
                               const volume::Patient& patient) {
  SharedScene shared = sharedScene(scene, folder, patient);
  json session{{"scene", std::move(shared.scene)}};
  if (!shared.places.empty()) session["places"] = std::move(shared.places);
  return textOf(std::move(session));
}

// "accuracy" (app/documents/session_accuracy.h) is no setting: it is passed over.
scene::Scene parseSession(const std::string& text, const std::string& file, const StoredFolders& folders) {
  json session = parseJson(text, file, "");
  if (!session.is_object()) throwInput(file, "", "is not a session: it should be a JSON object");
  const int written = versionOf(session, file);
  if (written == 1) session = upgradeFrom1(std::move(session), file);
  if (written <= 2)
    checkKeys(session, {versionKey, "program", "scene"}, file, "");
  else if (written <= 4)
    checkKeys(session, {versionKey, "program", "scene", "places"}, file, "");
  else
    checkKeys(session, {versionKey, "program", "scene", "places", "accuracy"}, file, "");
  if (written < sessionVersion)
    session["scene"] = sceneOfVersion(written, session.value("scene", json::object()));
  const auto found = session.find("scene");
  scene::Scene scene =
      found == session.end() ? scene::Scene{} : sceneFromStored(*found, file, "scene", folders);
  if (const auto places = session.find("places"); places != session.end()) applyPlaces(scene, *places, file);
  return scene;
}

void saveSession(const scene::Scene& scene, const fs::path& file) {
  writeTextFile(file, sessionText(scene, file.parent_path()));
}

scene::Scene loadSession(const fs::path& file) {
  const bool picture = looksLikePicture(readBeginning(file, 8));
  const std::string text = picture ? readSessionText(file) : readTextFile(file, longestSession);
  if (picture && text.empty()) throwInput(file.string(), "", "this image has no session");
  if (text.size() > longestSession) throwInput(file.string(), "", "the session in this image is too long");
  return parseSession(text, file.string(), foldersOf(file));
}

bool isSession(const fs::path& file) {
  constexpr std::size_t searched = std::size_t{1} << 20;
  const std::string beginning = readBeginning(file, searched);
  if (looksLikePicture(beginning)) {
    try {
      return !readSessionText(file).empty();
    } catch (const base::Error&) {
      return false;  // a broken picture: some other reader has a better message
    }
  }
  const auto first = beginning.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  if (file.extension() == ".isolux") return true;
  return beginning[first] == '{' && beginning.find(versionKey) != std::string::npos;
}

}  // namespace isolux::app
