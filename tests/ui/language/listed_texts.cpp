#include "tests/ui/language/listed_texts.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "app/marks/mark_kinds.h"
#include "app/presets/preset_list.h"
#include "app/study/quality_settings.h"
#include "render/graph/frame.h"
#include "scene/camera.h"
#include "scene/looks.h"
#include "scene/rules/quality.h"
#include "scene/rules/relevance.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/settings.h"
#include "tests/support/paths.h"
#include "ui/language/number_text.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/panels/panel_layout.h"
#include "ui/window/main_window.h"
#include "volume/phantom/phantom.h"
#include "volume/read/reader.h"

namespace isolux::test {

namespace {

namespace fs = std::filesystem;
using Texts = std::set<std::pair<std::string, std::string>>;

class Collector {
 public:
  void add(const char* context, std::string_view text) {
    if (!text.empty()) texts_.emplace(context, text);
  }
  void add(const char* context, const char* text) { add(context, std::string_view(text)); }
  void add(const char* context, const QString& text) { add(context, std::string_view(text.toStdString())); }
  void addWords(std::string_view identifier) {
    add(ui::texts::words, ui::plainWordsOf(QString::fromStdString(std::string(identifier))));
  }
  Texts take() { return std::move(texts_); }

 private:
  Texts texts_;
};

void addSetting(Collector& all, const scene::SettingInfo& setting) {
  all.add(ui::texts::settings, setting.meaning);
  all.add(ui::texts::units, setting.unit);
  if (setting.unit.starts_with("1/")) all.add(ui::texts::units, setting.unit.substr(1));  // "5 /s"
  all.add(ui::texts::words, ui::plainNameOf(setting));
  for (const std::string& choice : setting.choices) all.addWords(choice);
}

void addQualities(Collector& all) {
  for (const app::QualitySetting& quality : app::qualitySettings()) {
    all.addWords(quality.label);
    for (const std::string& value : quality.values)
      if (!std::isdigit(static_cast<unsigned char>(value.front()))) all.addWords(value);
  }
}

void addSettings(Collector& all) {
  for (const scene::Setting& setting : scene::settings()) {
    addSetting(all, setting);
    all.add(ui::texts::words, ui::labelOf(setting).text);
  }
  for (const scene::SceneList& list : scene::sceneLists()) {
    for (const scene::SettingInfo& field : list.fields) {
      addSetting(all, field);
      all.add(ui::texts::words, ui::labelOf(field).text);
    }
  }
  for (const scene::HostSetting& setting : scene::hostSettings()) addSetting(all, setting);
  for (const std::string_view reason : scene::inactiveReasons()) all.add(ui::texts::reasons, reason);
  for (const ui::PanelGroup& group : ui::panelGroups()) all.add("QObject", group.title);
}

void addWhatIsShown(Collector& all) {
  for (const scene::Quality& quality : scene::qualities()) {
    all.add(ui::texts::qualities, quality.title);
    all.add(ui::texts::qualities, quality.meaning);
  }
  for (const scene::LookInfo& look : scene::looks()) {
    all.addWords(look.name);
    all.add(ui::texts::looks, look.meaning);
  }
  for (const volume::PhantomInfo& phantom : volume::phantoms()) {
    all.addWords(phantom.name);
    all.add(ui::texts::phantoms, phantom.meaning);
  }
  for (const app::Preset& preset : app::builtInPresets()) {
    all.add(ui::texts::presets, preset.title);
    all.add(ui::texts::presets, preset.meaning);
  }
  for (const std::string& reason : app::needReasons()) all.add(ui::texts::presets, reason);
  for (const app::MarkKindInfo& kind : app::markKinds()) {
    all.add(ui::texts::marks, kind.name);
    all.add(ui::texts::marks, kind.title);
    all.add(ui::texts::marks, QString(kind.title).toLower());
  }
}

void addOfTheWindow(Collector& all) {
  for (int i = 0; i < scene::standardViewCount; ++i)
    for (const auto axes : {scene::WorldAxes::anatomical, scene::WorldAxes::yUp, scene::WorldAxes::zUp})
      all.add(ui::texts::views, scene::standardViewName(static_cast<scene::StandardView>(i), axes));
  for (const auto state : {render::PassState::ran, render::PassState::cached, render::PassState::skipped})
    all.add(ui::texts::passes, render::nameOf(state));
  for (const std::string& filter : volume::fileFilters())
    all.add(ui::texts::files, filter.substr(0, filter.rfind(" (")));
  for (const QString& cell : ui::cellsOf(ui::MainWindow::helpText())) all.add(ui::texts::help, cell);
}

// What jobs of the window say while they work: progress.report(0.3, "building blocks").
void addStages(Collector& all) {
  const std::regex report(R"rx(report\([^;"]*"([^"]+)"\))rx");
  std::size_t found = 0;
  for (const char* folder : {"volume", "readers", "app/tasks"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOLUX_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      const std::string source = text.str();
      for (std::sregex_iterator match(source.begin(), source.end(), report), end; match != end; ++match) {
        all.addWords((*match)[1].str());
        all.add(ui::texts::words, (*match)[1].str());
        ++found;
      }
    }
  if (found == 0) throw std::runtime_error("no stages of progress found in " ISOLUX_SOURCE_DIR);
}

}  // namespace

Texts listedTexts() {
  Collector all;
  addSettings(all);
  addQualities(all);
  addWhatIsShown(all);
  addOfTheWindow(all);
  addStages(all);
  return all.take();
}

}  // namespace isolux::test
