// The presets there are: those of the program, and the user's own.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/presets/preset.h"

namespace isolux::app {

// In the order in which they are offered.
std::span<const Preset> builtInPresets();

// $XDG_CONFIG_HOME/isolux/presets, by default ~/.config/isolux/presets. Not made; empty without a home
// folder.
std::filesystem::path presetFolder();

// The user's own, by name; files that are none are left out and told of in `warnings`, a line each.
std::vector<Preset> ownPresets(std::vector<std::string>& warnings);

// Whether this is a file (with a '/' or the extension .json), not a name.
bool isPresetFile(const std::string& nameOrFile);

// A name (of the user's own first), or a file. Throws base::Error: usage
// for an unknown name, with the nearest; input for a file that is no preset.
Preset findPreset(const std::string& nameOrFile);

// "My bone, 2" -> "my_bone_2"; letters beyond ASCII stay. Empty where no letter or digit is left.
std::string presetNameOf(const std::string& title);

// Where the user's preset of this name is kept.
std::filesystem::path ownPresetFile(const std::string& name);

// Writes the preset into presetFolder(), which is made, and returns the file. Throws base::Error: usage for a
// name that is none or that of a preset of the program, and where its file is there and not to be
// overwritten; input.
std::filesystem::path savePreset(const Preset& preset, bool overwrite = false);

}  // namespace isolux::app
