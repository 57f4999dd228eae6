// The volumes and sessions opened last, most recent first, kept between runs.
#pragma once

#include <QStringList>

namespace isolux::ui {

QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);
void clearRecentFiles();

// Where files were opened and saved last; "": nowhere yet.
QString lastFolder();
void rememberFolder(const QString& file);

}  // namespace isolux::ui
