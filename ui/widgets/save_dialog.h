// Asking for the name of a file to write.
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace isolux::ui {

struct SaveQuestion {
  QString title;
  QString proposal;     // absolute path: folder and name
  QStringList filters;  // "PNG (*.png)"; the chosen one's suffix is given to a name that has none
};
struct SaveAnswer {
  QString file;    // absolute; empty: cancelled
  QString filter;  // the chosen one
};
// Shows a dialog and waits. The suffix is added before the dialog looks whether such a file exists already,
// so that nothing is overwritten unasked.
SaveAnswer askForFileToSave(QWidget* parent, const SaveQuestion& question);

// Where to propose a file that belongs to `source` (a volume's or session's path): the folder it lies in, if
// one may write there; else `otherwise`.
QString folderBeside(const QString& source, const QString& otherwise);

}  // namespace isolux::ui
