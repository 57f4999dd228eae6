#include "ui/document/preferences.h"

#include <QSettings>

#include "base/error.h"

namespace isolux::ui {

namespace {

QString keyOf(const scene::MachineSetting& setting) {
  return "machine/" + QString::fromStdString(setting.path);
}

}  // namespace

scene::Machine keptMachine() {
  scene::Machine machine;
  const QSettings kept;
  for (const scene::MachineSetting& setting : scene::machineSettings()) {
    const QString text = kept.value(keyOf(setting)).toString();
    if (text.isEmpty()) continue;
    try {
      setting.set(machine, nlohmann::json::parse(text.toStdString()));
    } catch (const base::Error&) {  // of another version: the default
    } catch (const nlohmann::json::exception&) {
    }
  }
  return machine;
}

void keepMachine(const scene::Machine& before, const scene::Machine& after) {
  QSettings kept;
  for (const scene::MachineSetting& setting : scene::machineSettings()) {
    const nlohmann::json value = setting.get(after);
    if (value == setting.get(before)) continue;
    if (value == setting.defaultValue())
      kept.remove(keyOf(setting));
    else
      kept.setValue(keyOf(setting), QString::fromStdString(value.dump()));
  }
}

}  // namespace isolux::ui
