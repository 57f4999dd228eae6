#include "app/presets/preset_list.h"

#include <algorithm>
#include <cctype>

#include "app/files/files.h"
#include "app/files/state_folder.h"
#include "app/presets/built_in_preset_texts.h"
#include "base/error.h"
#include "base/words.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::Error;

namespace {

constexpr std::size_t kLongestPreset = std::size_t{1} << 20;  // bytes

std::vector<Preset> parsedPresets() {
  std::vector<Preset> presets;
  for (const char* text : kBuiltInPresetTexts) {
    presets.push_back(parsePreset(text, "a preset of the program"));
    presets.back().file.clear();
  }
  return presets;
}

}  // namespace

std::span<const Preset> builtInPresets() {
  static const std::vector<Preset> presets = parsedPresets();
  return presets;
}

fs::path presetFolder() {
  const fs::path folder = configFolder();
  return folder.empty() ? folder : folder / "presets";
}

std::vector<Preset> ownPresets(std::vector<std::string>& warnings) {
  std::vector<Preset> presets;
  std::error_code ignored;
  const fs::path folder = presetFolder();
  if (folder.empty()) return presets;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    if (ignored || !entry->path().string().ends_with(kPresetExtension)) continue;
    try {
      presets.push_back(parsePreset(readTextFile(entry->path(), kLongestPreset), entry->path()));
    } catch (const Error& error) {
      warnings.emplace_back(error.what());
    }
  }
  std::ranges::sort(presets, [](const Preset& a, const Preset& b) { return a.name < b.name; });
  std::ranges::sort(warnings);
  return presets;
}

bool isPresetFile(const std::string& nameOrFile) {
  return nameOrFile.find('/') != std::string::npos || nameOrFile.ends_with(".json");
}

Preset findPreset(const std::string& nameOrFile) {
  if (isPresetFile(nameOrFile)) return parsePreset(readTextFile(nameOrFile, kLongestPreset), nameOrFile);
  std::vector<std::string> ignored, known;
  std::vector<Preset> presets = ownPresets(ignored);
  presets.insert(presets.end(), builtInPresets().begin(), builtInPresets().end());
  for (const Preset& preset : presets) {
    if (preset.name == nameOrFile) return preset;
    known.push_back(preset.name);
  }
  base::throwUsage("", "--preset",
                   '"' + nameOrFile + "\" is not a preset" +
                       base::didYouMean(nameOrFile, known, "; `isolux presets` lists them"));
}

std::string presetNameOf(const std::string& title) {
  std::string name;
  for (const char letter : title) {
    const auto c = static_cast<unsigned char>(letter);
    if (c >= 128 || std::isalnum(c))
      name += c >= 128 ? letter : static_cast<char>(std::tolower(c));
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

fs::path ownPresetFile(const std::string& name) {
  return presetFolder() / (name + kPresetExtension);
}

fs::path savePreset(const Preset& preset, bool overwrite) {
  if (preset.name.empty() || presetNameOf(preset.name).empty())
    base::throwUsage("", "preset", "needs a name with a letter or digit");
  const auto builtIn = builtInPresets();
  if (std::ranges::find(builtIn, preset.name, &Preset::name) != builtIn.end())
    base::throwUsage("", preset.name, "is a preset of the program; take another name");
  const fs::path folder = presetFolder();
  if (folder.empty()) base::throwInput("", "", "no home folder for presets");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) base::throwInput(folder.string(), "", "cannot be made: " + error.message());
  const fs::path file = ownPresetFile(preset.name);
  if (!overwrite && fs::exists(file, error))
    base::throwUsage(file.string(), "", "is there already; --overwrite replaces it");
  const std::string text = presetText(preset);
  parsePreset(text, file);  // nothing is kept that could not be read again
  writeTextFile(file, text);
  return file;
}

}  // namespace isolux::app
