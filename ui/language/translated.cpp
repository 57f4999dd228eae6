#include "ui/language/translated.h"

#include <algorithm>
#include <string>

#include <QCoreApplication>

#include "scene/settings/scene_list.h"
#include "ui/language/number_text.h"

namespace isolux::ui {

QString translated(const char* context, std::string_view english) {
  if (english.empty()) return {};
  return QCoreApplication::translate(context, std::string(english).c_str());
}

QString translatedFilter(std::string_view filter) {
  const std::size_t patterns = std::min(filter.rfind(" ("), filter.size());
  const std::string_view rest = filter.substr(patterns);
  return translated(texts::files, filter.substr(0, patterns)) +
         QString::fromUtf8(rest.data(), static_cast<qsizetype>(rest.size()));
}

QString plainNameOf(const scene::SettingInfo& setting) {
  const QString path = QString::fromStdString(setting.path);
  const scene::SceneList* const list = scene::listOfPath(setting.path);
  QString name = plainWordsOf(path.section('.', list ? 2 : 1)).replace('.', ' ').replace("color", "colour");
  if (name == "Colormap") name = "Colour map";
  name[0] = name[0].toLower();
  return list && list->path == "lamps" ? "light " + name : name;
}

QString nameOf(const scene::SettingInfo& setting) {
  return translated(texts::words, plainNameOf(setting).toStdString());
}

}  // namespace isolux::ui
