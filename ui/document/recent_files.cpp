#include "ui/document/recent_files.h"

#include <algorithm>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>

#include "app/files/state_folder.h"
#include "base/destroy_in_background.h"
#include "base/error.h"

namespace isolux::ui {

namespace {

constexpr auto key = "recentFiles";
constexpr QSize pictureSize(256, 160);  // pixels, at most
// Between the parts of an entry: no name of a file has it.
constexpr QChar between(0x1f);

QString textOf(const RecentFile& file) {
  if (file.series.isEmpty() && file.name.isEmpty() && file.hidden.isEmpty()) return file.path;
  return QStringList{file.path, file.series, file.name, file.hidden}.join(between);
}

RecentFile fileOf(const QString& text) {
  QStringList parts = text.split(between);
  while (parts.size() < 4) parts += QString();
  return {parts[0], parts[1], parts[2], parts[3]};
}

bool same(const RecentFile& a, const RecentFile& b) {
  return a.path == b.path && a.series == b.series;
}

void store(const QList<RecentFile>& files) {
  QStringList texts;
  for (const RecentFile& file : files) texts += textOf(file);
  QSettings().setValue(key, texts);
}

QString pictureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/recent";
}

void writePicture(const QImage& shown, const QString& file) {
  try {  // for the user's eyes only
    app::makePrivateFolder(QFileInfo(file).absolutePath().toStdString());
  } catch (const base::Error&) {
    return;  // no picture, then
  }
  QSaveFile stream(file);
  if (stream.open(QIODevice::WriteOnly) &&
      shown.scaled(pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)
          .convertToFormat(QImage::Format_RGB32)
          .save(&stream, "PNG"))
    stream.commit();
}

}  // namespace

QList<RecentFile> recentEntries() {
  QList<RecentFile> files;
  for (const QString& text : QSettings().value(key).toStringList()) files += fileOf(text);
  return files;
}

QStringList recentFiles() {
  QStringList paths;
  for (const RecentFile& file : recentEntries()) paths += file.path;
  return paths;
}

void addRecentFile(const RecentFile& file) {
  QList<RecentFile> files = recentEntries();
  files.removeIf([&](const RecentFile& known) { return same(known, file); });
  files.prepend(file);
  while (files.size() > kMostRecentFiles) QFile::remove(recentPicture(files.takeLast()));
  store(files);
}

void removeRecentFile(const QString& path) {
  QList<RecentFile> files = recentEntries();
  for (const RecentFile& file : files)
    if (file.path == path) QFile::remove(recentPicture(file));
  files.removeIf([&](const RecentFile& file) { return file.path == path; });
  store(files);
}

void clearRecentFiles() {
  QSettings().remove(key);
  QDir(pictureFolder()).removeRecursively();
}

QString recentPicture(const RecentFile& file) {
  const QByteArray name = (file.path + between + file.series).toUtf8();
  return pictureFolder() + '/' +
         QString::fromLatin1(QCryptographicHash::hash(name, QCryptographicHash::Sha1).toHex()) + ".png";
}

void keepRecentPicture(const RecentFile& file, const QImage& shown) {
  const QList<RecentFile> files = recentEntries();
  const bool listed =
      std::any_of(files.begin(), files.end(), [&](const auto& one) { return same(one, file); });
  if (!listed || shown.isNull()) return;
  // A copy of its own: the picture's pixels are drawn into again.
  base::runInBackground(
      [image = shown.copy(), target = recentPicture(file)] { writePicture(image, target); });
}

QString lastFolder() {
  return QSettings().value("lastFolder").toString();
}

void rememberFolder(const QString& file) {
  QSettings().setValue("lastFolder", QFileInfo(file).absolutePath());
}

}  // namespace isolux::ui
