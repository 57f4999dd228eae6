#include "app/report/settings_report.h"

#include <cmath>
#include <functional>
#include <iterator>
#include <ostream>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/words.h"
#include "scene/looks.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using scene::SettingInfo;
using scene::SettingType;

std::string typeName(const SettingInfo& setting) {
  static constexpr const char* names[] = {
      "number",        "integer",        "text",          "choice",         "two numbers",
      "three numbers", "four numbers",   "true or false", "list of points", "list of points",
      "list of x,y,z", "list of planes", "list of marks", "item",           "list of ids"};
  static_assert(std::size(names) == static_cast<std::size_t>(SettingType::ids) + 1);
  return names[static_cast<std::size_t>(setting.type)];
}

// Whole numbers without an exponent, others as short as possible.
std::string limitText(double value) {
  return std::abs(value) < 1e9 && value == std::floor(value) ? std::to_string(static_cast<long>(value))
                                                             : base::shortestText(value);
}

// As it is typed after --set PATH=.
std::string valueText(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_array() && !value.empty() && value[0].is_array()) return value.dump();
  if (!value.is_array()) return limitText(value.get<double>());
  return base::joined(value, ",", [](const nlohmann::json& part) { return limitText(part.get<double>()); });
}

std::string allowedText(const SettingInfo& setting) {
  std::string text;
  if (setting.type == SettingType::choice) {
    text = base::joined(setting.choices);
  } else if (setting.type == SettingType::points) {
    text = "[[kappa1,kappa2,r,g,b],...], kappas from -1 to 1, colours from 0 to 1";
  } else if (setting.type == SettingType::color_points) {
    text = "[[position,r,g,b],...] in ascending order, all from 0 to 1";
  } else if (setting.type == SettingType::marks) {
    text = "[{\"kind\": ..., \"name\": ..., \"points\": [[x,y,z],...]},...]";
  } else if (setting.type != SettingType::text && setting.type != SettingType::toggle) {
    text = limitText(setting.minimum) + " to " + limitText(setting.maximum);
  }
  return setting.mayBeAutomatic ? text + ", or auto" : text;
}

bool matches(const SettingInfo& setting, const std::string& word) {
  return setting.path.find(word) != std::string::npos || setting.meaning.find(word) != std::string::npos;
}

// All settings whose path or meaning contains the word, of the scene and then of the machine: each(setting,
// default value, whether it is of the machine).
void forEachSetting(const std::string& word,
                    const std::function<void(const SettingInfo&, const nlohmann::json&, bool)>& each) {
  for (const scene::Setting& setting : scene::settings())
    if (matches(setting, word)) each(setting, setting.defaultValue(), false);
  for (const scene::SceneList& list : scene::sceneLists())
    for (std::size_t field = 0; field < list.fields.size(); ++field)
      if (matches(list.fields[field], word))
        each(list.fields[field], list.get(scene::Scene{}, "", field), false);
  for (const scene::HostSetting& setting : scene::hostSettings())
    if (matches(setting, word)) each(setting, setting.defaultValue(), true);
}

void printLooks(std::ostream& out) {
  out << "\n## Looks\n\nValues of `look.mode`; equations and sources: [looks](../explanation/looks.md).\n\n"
         "| look | shows | unit | shaded by |\n|---|---|---|---|\n";
  for (const scene::LookInfo& look : scene::looks()) {
    const bool own = look.kind == scene::LookKind::shading, raw = look.kind == scene::LookKind::raw;
    out << "| `" << look.name << "` | " << look.meaning << " | " << scene::unitOf(look) << " | "
        << (own   ? "itself"
            : raw ? "nothing"
                  : "`look.shading`")
        << " |\n";
  }
}

// How items of a list are named, for the page.
std::string listNote(const scene::SceneList& list) {
  const std::string item = list.path + ".ID", number = list.firstHadNoNumber ? "" : "1";
  return "Settings of each " + list.noun + " (" + std::to_string(list.least) + " to " +
         std::to_string(list.most) + "). ID: a to z, 0 to 9, `_`, or the position from 1. `" + item + "." +
         list.maker + (list.joiner.empty() ? "" : "` or `." + list.joiner) + "` of a new ID makes a " +
         list.noun + ", `" + item + "=none` removes it, `" + list.path +
         ".order=a,b` orders all. Before session version 10: `" + list.former + number + ".`, `" +
         list.former + "2.`.\n\n";
}

}  // namespace

nlohmann::ordered_json settingsJson(const std::string& word) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  forEachSetting(word, [&](const SettingInfo& setting, const nlohmann::json& byDefault, bool ofMachine) {
    nlohmann::ordered_json entry{{"path", setting.path},
                                 {"type", typeName(setting)},
                                 {"default", byDefault},
                                 {"automatic", setting.mayBeAutomatic},
                                 {"unit", setting.unit},
                                 {"meaning", setting.meaning},
                                 {"of", ofMachine ? "machine" : "scene"}};
    if (setting.type == SettingType::choice) {
      entry["choices"] = setting.choices;
    } else if (setting.type != SettingType::text && setting.type != SettingType::toggle) {
      entry["minimum"] = setting.minimum;
      entry["maximum"] = setting.maximum;
    }
    list.push_back(std::move(entry));
  });
  return list;
}

void printSettings(std::ostream& out, const std::string& word) {
  forEachSetting(word, [&](const SettingInfo& setting, const nlohmann::json& byDefault, bool) {
    out << setting.path << "\n    " << setting.meaning << "\n    " << typeName(setting);
    if (const std::string allowed = allowedText(setting); !allowed.empty()) out << ": " << allowed;
    if (!setting.unit.empty()) out << " (" << setting.unit << ')';
    const std::string value = valueText(byDefault);
    out << "; default " << (value.empty() ? "empty" : value) << '\n';
  });
}

void printSettingsPage(std::ostream& out) {
  out << "# Settings\n\n"
         "Generated by `isolux settings --markdown`; a test compares. Each path is a key of a "
         "[session](file-formats-isolux.md)\n"
         "and an argument of `--set PATH=VALUE`. Vectors are written `x,y,z`.\n";
  std::string title;
  forEachSetting("", [&](const SettingInfo& setting, const nlohmann::json& byDefault, bool ofMachine) {
    const std::string its = ofMachine ? "Host" : setting.path.substr(0, setting.path.rfind('.'));
    if (its != title) {
      out << "\n## " << its << "\n\n";
      if (ofMachine)
        out << "They describe the computer and are not part of a session. `--set` applies them to one run; "
               "the window keeps them per user (Edit, Preferences).\n\n";
      if (const scene::SceneList* const list = scene::listOfPath(setting.path)) out << listNote(*list);
      title = its;
    }
    const std::string value = valueText(byDefault), allowed = allowedText(setting);
    out << "- `" << setting.path << "` (" << (allowed.empty() ? typeName(setting) : allowed)
        << (setting.unit.empty() ? "" : ", " + setting.unit)
        << (value.empty() ? "" : "; default `" + value + "`") << "): " << setting.meaning << '\n';
  });
  printLooks(out);
}

}  // namespace isolux::app
