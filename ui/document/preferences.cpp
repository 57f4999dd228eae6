#include "ui/document/preferences.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <QSettings>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "ui/theme/theme.h"

namespace isolux::ui {

namespace {

constexpr auto themeKey = "window/theme", scaleKey = "window/scale";
constexpr std::array<const char*, 3> themeNames{"dark", "light", "system"};  // as Theme

QString keyOf(const scene::HostSetting& setting) {
  return "machine/" + QString::fromStdString(setting.path);
}

}  // namespace

scene::HostSettings savedHostSettings() {
  scene::HostSettings host;
  const QSettings kept;
  for (const scene::HostSetting& setting : scene::hostSettings()) {
    const QString text = kept.value(keyOf(setting)).toString();
    if (text.isEmpty()) continue;
    try {
      setting.set(host, nlohmann::json::parse(text.toStdString()));
    } catch (const base::Error&) {  // of another version: the default
    } catch (const nlohmann::json::exception&) {
    }
  }
  return host;
}

void saveHostSettings(const scene::HostSettings& before, const scene::HostSettings& after) {
  QSettings kept;
  for (const scene::HostSetting& setting : scene::hostSettings()) {
    const nlohmann::json value = setting.get(after);
    if (value == setting.get(before)) continue;
    if (value == setting.defaultValue())
      kept.remove(keyOf(setting));
    else
      kept.setValue(keyOf(setting), QString::fromStdString(value.dump()));
  }
}

Theme savedTheme() {
  const QString name = QSettings().value(themeKey).toString();
  for (std::size_t i = 0; i < themeNames.size(); ++i)
    if (name == themeNames[i]) return static_cast<Theme>(i);
  return Theme::dark;
}

void keepTheme(Theme theme) {
  QSettings().setValue(themeKey, QString(themeNames[static_cast<std::size_t>(theme)]));
}

int savedScale() {
  bool isNumber = false;
  const int percent = QSettings().value(scaleKey).toInt(&isNumber);
  return isNumber ? std::clamp(percent, smallestScale, largestScale) : 100;
}

void keepScale(int percent) {
  QSettings().setValue(scaleKey, percent);
}

}  // namespace isolux::ui
