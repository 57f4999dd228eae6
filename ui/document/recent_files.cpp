#include "ui/document/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace isolux::ui {

namespace {
constexpr auto key = "recentFiles";
constexpr int most = 10;
}  // namespace

QStringList recentFiles() {
  return QSettings().value(key).toStringList();
}

void addRecentFile(const QString& path) {
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(key, files.mid(0, most));
}

void removeRecentFile(const QString& path) {
  QStringList files = recentFiles();
  files.removeAll(path);
  QSettings().setValue(key, files);
}

void clearRecentFiles() {
  QSettings().remove(key);
}

QString lastFolder() {
  return QSettings().value("lastFolder").toString();
}

void rememberFolder(const QString& file) {
  QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
}

}  // namespace isolux::ui
