// isolux settings [WORD] [--markdown|--json]: every setting, from the one list.
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/report/settings_report.h"

namespace isolux::app {

namespace {

struct SettingsOptions {
  std::string word;
  bool markdown = false, json = false;
};

}  // namespace

Command makeSettings(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("settings", "List every setting: path, type, default, range, unit, meaning");
  auto options = std::make_shared<SettingsOptions>();
  parser->add_option("WORD", options->word, "Only settings whose path or description contains this");
  CLI::Option* const markdown = parser->add_flag("--markdown", options->markdown,
                                                 "Print all settings as the page docs/reference/settings.md");
  parser->add_flag("--json", options->json, "Print a JSON list")->excludes(markdown);
  parser->footer("Examples:\n  isolux settings camera\n  isolux settings --json > settings.json");
  return {parser, [options](base::Progress&) {
            if (options->markdown)
              printSettingsPage(std::cout);
            else if (options->json)
              std::cout << jsonText(settingsJson(options->word));
            else
              printSettings(std::cout, options->word);
          }};
}

}  // namespace isolux::app
