// Scenes as they stand in sessions and recordings: JSON, with the paths of volumes and light probes relative
// to the file's folder when they lie below it, so that a folder can be moved or given away as a whole.
//
// Errors: base::Error{input} with the file and the JSON path.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/settings/settings.h"
#include "volume/read/input/patient.h"

namespace isolux::app {

// The settings that name files: volumes and light probes.
bool isStoredPath(std::string_view setting);

// The folders that a relative path may start from, the first that holds the file counts; if none does, the
// first.
using StoredFolders = std::vector<std::filesystem::path>;
// Of a session or recording: its own folder; of a link, also that of what it points to.
StoredFolders foldersOf(const std::filesystem::path& file);

// "phantom:..." and "" stay as they are. `folder` empty: the current one.
std::string storedPath(const std::string& path, const std::filesystem::path& folder);
std::string pathFromStored(const std::string& stored, const StoredFolders& folders);

nlohmann::json storedScene(const scene::Scene& scene, const std::filesystem::path& folder);

// As it stands in pictures, which are shared: a file outside `folder` is named without its own folder.
struct SharedScene {
  nlohmann::json scene;
  nlohmann::json
      places;  // {"source.path": token, ...}: where such files lie, for this machine (app/documents/places.h)
};
// What names the patient is hidden (app/documents/anonymous.h), in the names of files, too.
SharedScene sharedScene(const scene::Scene& scene, const std::filesystem::path& folder,
                        const volume::Patient& patient = {});
// The paths of `scene`, as sceneFromStored() read them, where this machine knows them better from `places`.
// Throws base::Error{input} naming `file`.
void applyPlaces(scene::Scene& scene, const nlohmann::json& places, const std::string& file);

// `place` stands before each JSON path in messages ("scene").
scene::Scene sceneFromStored(const nlohmann::json& stored, const std::string& file, const std::string& place,
                             const StoredFolders& folders);

// A stored scene of before there were built-in lights and exposure by the surface, which left unsaid what
// there was no choice of: a white sky, and exposure by the lights.
nlohmann::json lightAsBefore(nlohmann::json stored);

// Of before there were derivatives at a scale, hits of pictures at rest, and outlines that go with tone: none
// of them, and the colours of tone as they were.
nlohmann::json derivativesAsBefore(nlohmann::json stored);

// Keeps what a stored scene meant before automatic cameras framed the surface and automatic isovalues were
// those of the whole object.
nlohmann::json firstPictureAsBefore(nlohmann::json stored);

// Keeps what a stored scene meant before looks were lit by more than a key light.
nlohmann::json looksAsBefore(nlohmann::json stored);

// Keeps what a stored scene meant before pictures had a tone curve.
nlohmann::json exposureAsBefore(nlohmann::json stored);

// `stored` must be an object with no other keys than the `known` ones; `place` as above.
void checkKeys(const nlohmann::json& stored, std::initializer_list<std::string_view> known,
               const std::string& file, const std::string& place);

// Parses. Throws base::Error{input} with line and column of a fault, or the column behind `place` ("line 3")
// of a text of one line; also where an object has two equal keys.
nlohmann::json parseJson(const std::string& text, const std::string& file, const std::string& place);

}  // namespace isolux::app
