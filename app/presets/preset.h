// A preset: a name for what is shown, and the settings that show it. docs/reference/file-formats-isolux.md
// has the form of the files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// A requirement of a preset on the kind of data (volume::FoundKind).
enum class PresetNeed {
  hounsfield,      // a CT, and Hounsfield units can be told from its values
  not_hounsfield,  // no CT
  patient,         // a scan of a patient: a CT, an MR scan, or what its file states the place of
  no_patient,      // no such scan
  distance,        // values are a signed distance, mm
  microscopy,      // of a microscope, or nothing says what it is
  simulation,      // computed, or nothing says what it is
  white_matter     // a T1 scan of a brain, bare or in its head (volume::whiteMatterOf)
};

struct Preset {
  std::string name;     // lower case letters, those beyond ASCII, digits, '_' and '-': what --preset takes
  std::string title;    // "CT bone"
  std::string meaning;  // one sentence: what it shows
  std::vector<PresetNeed> needs;
  // Setting path to its value, or, of settings in data units, to where that lies in the volume: {"hu": 300},
  // {"quantile": 0.99} of its voxels, or {"between": 0.3} of the way from the clearest border
  // (volume::contrastIsovalue) to the largest value, {"between": -0.3} to the least; {"white_matter": 0.5}
  // from the border between grey and white matter to the mean of the white (where none is found the border
  // itself of "between").
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  std::filesystem::path file{};  // empty: comes with the program
};

constexpr int kPresetVersion = 1;
constexpr const char* kPresetExtension = ".isolux-preset.json";

// `file` is for messages. Throws base::Error{input} with the place of the fault: an unknown key, path or
// need, a value out of range, a setting that belongs to one volume (belongsToVolume()).
Preset parsePreset(const std::string& text, const std::filesystem::path& file);
std::string presetText(const Preset& preset);

// Settings that no preset has: files, points of the world, the camera, marks.
bool belongsToVolume(const std::string& path);
// Settings that are at their defaults under a preset that does not name them: surfaces, look, flow, how many
// pieces.
bool resetByPreset(const std::string& path);

// All that whyNot() can answer, for who translates.
std::vector<std::string> needReasons();
// Why the preset says nothing of this volume, a clause; empty: it applies. Needs of Hounsfield units do not
// count, nor that of white matter, where `isovalueGiven`: somebody says the isovalue himself.
std::string whyNot(const Preset& preset, const volume::PreparedVolume& volume, bool isovalueGiven = false);

// The scene with the preset's settings, the others that presets are made of at their defaults; camera, cuts,
// marks and source stay, and so does a background that no preset of the program has made. shift: added to the
// isovalues of the preset, data units; of a preset that leaves the isovalue automatic, to the suggested one.
// The same for the same volume, always. Does not ask whyNot().
scene::Scene withPreset(const scene::Scene& scene, const Preset& preset, const volume::PreparedVolume& volume,
                        double shift = 0.0);

// What of a scene a preset can hold, as a preset of the user's. With the volume it was made for, isovalues of
// CT are in Hounsfield units and it needs those.
Preset presetOf(const scene::Scene& scene, const std::string& name, const std::string& title,
                const volume::PreparedVolume* volume);

}  // namespace isolux::app
