// The volumes and sessions opened last, most recent first, kept between runs.
#pragma once

#include <QStringList>

namespace isolux::ui {

QStringList recentFiles();
void addRecentFile(const QString& path);
void removeRecentFile(const QString& path);
void clearRecentFiles();

}  // namespace isolux::ui
