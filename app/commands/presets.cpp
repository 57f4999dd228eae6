// isolux presets [PATH]: the presets there are, which apply to a volume, and new ones from a scene.
#include <iostream>

#include "app/commands/command.h"
#include "app/presets/preset_list.h"
#include "base/error.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct PresetsOptions {
  std::string path, save, title;
  bool json = false, overwrite = false;
  std::shared_ptr<SceneOptions> scene;
};

ordered_json presetJson(const Preset& preset, const volume::PreparedVolume* volume) {
  ordered_json json = ordered_json::parse(presetText(preset));
  json.erase("isolux_preset");
  json["file"] = preset.file.empty() ? ordered_json(nullptr) : ordered_json(preset.file.string());
  if (volume == nullptr) return json;
  const std::string reason = whyNot(preset, *volume);
  json["applies"] = reason.empty();
  json["reason"] = reason;
  return json;
}

void printPreset(const Preset& preset, const volume::PreparedVolume* volume, std::ostream& out) {
  printRow(out, preset.name, preset.title + ": " + preset.meaning);
  if (volume == nullptr) return;
  if (const std::string reason = whyNot(preset, *volume); !reason.empty())
    printRow(out, "", "does not apply: " + reason);
}

void listPresets(const PresetsOptions& options, base::Progress& progress) {
  std::shared_ptr<const volume::PreparedVolume> prepared;
  if (!options.path.empty() || !options.scene->session.empty())
    prepared = loadWithProgressBar(sceneOf(options.path, *options.scene).source, progress);
  std::vector<std::string> warnings;
  std::vector<Preset> presets(builtInPresets().begin(), builtInPresets().end());
  for (Preset& own : ownPresets(warnings)) presets.push_back(std::move(own));
  ordered_json list = ordered_json::array();
  for (const Preset& preset : presets) {
    if (options.json)
      list.push_back(presetJson(preset, prepared.get()));
    else
      printPreset(preset, prepared.get(), std::cout);
  }
  if (options.json) std::cout << jsonText(list);
  for (const std::string& warning : warnings) printNote(warning);
}

// With a volume its isovalues are kept in its terms.
void keepPreset(const PresetsOptions& options, base::Progress& progress) {
  std::shared_ptr<const volume::PreparedVolume> prepared;
  if (!options.path.empty())
    prepared = loadWithProgressBar(sceneOf(options.path, *options.scene).source, progress);
  const scene::Scene scene =
      prepared ? sceneOf(options.path, *options.scene, *prepared) : sceneOf(options.path, *options.scene);
  const std::string name = presetNameOf(options.save);
  const Preset preset =
      presetOf(scene, name, options.title.empty() ? options.save : options.title, prepared.get());
  if (preset.settings.empty())
    base::throwUsage("", "--save", "every setting has its default value; set some with --session or --set");
  std::cout << savePreset(preset, options.overwrite).string() << '\n';
}

}  // namespace

Command makePresets(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("presets", "List presets, show which apply to a volume, or save your own");
  auto options = std::make_shared<PresetsOptions>();
  parser->add_option("PATH", options->path,
                     "Show which presets apply to this volume, and why the others do not");
  CLI::Option* const json =
      parser->add_flag("--json", options->json, "Print a JSON list (docs/reference/file-formats-isolux.md)");
  CLI::Option* const save =
      addOption(*parser, "--save", options->save, "NAME",
                "Save the settings of --session, --set and their short forms as a preset, and print its file")
          ->excludes(json);
  addOption(*parser, "--title", options->title, "TEXT",
            "Title of the saved preset in menus; default: its name")
      ->needs(save);
  parser->add_flag("--overwrite", options->overwrite, "Replace your own preset of this name")->needs(save);
  options->scene = addSceneOptions(*parser);
  parser->footer(
      "Apply a preset with `isolux render PATH --preset NAME` or from the window's menu Presets. Examples:\n"
      "  isolux presets ct.nii.gz\n"
      "  isolux presets --save \"my bone\" --session skull.isolux\n"
      "  isolux presets --save soft --set look.mode=gi --set look.ambient=0.3");
  return {parser, [options](base::Progress& progress) {
            if (options->save.empty())
              listPresets(*options, progress);
            else
              keepPreset(*options, progress);
          }};
}

}  // namespace isolux::app
