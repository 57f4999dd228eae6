// What was opened last, most recent first, kept between runs; with a small picture of each, in the user's
// cache folder.
#pragma once

#include <QImage>
#include <QList>
#include <QStringList>

namespace isolux::ui {

struct RecentFile {
  QString path;         // a volume, folder, session, or "phantom:NAME"
  QString series = {};  // of a folder with several DICOM series; else empty
  QString name = {};    // as it is known without a path
  QString hidden = {};  // the same without what names the patient
};

inline constexpr int kMostRecentFiles = 20;

QList<RecentFile> recentEntries();
QStringList recentFiles();                   // their paths
void addRecentFile(const RecentFile& file);  // in the place of the one with its path and series
void removeRecentFile(const QString& path);  // with its pictures, as the next
void clearRecentFiles();

// Where files were opened and saved last; "": nowhere yet.
QString lastFolder();
void rememberFolder(const QString& file);
// The picture's file; there is none until one was kept.
QString recentPicture(const RecentFile& file);
// Writes it, reduced, on another thread, where the file is in the list.
void keepRecentPicture(const RecentFile& file, const QImage& shown);

}  // namespace isolux::ui
