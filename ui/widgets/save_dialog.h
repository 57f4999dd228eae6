// Asking for the name of a file to write.
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace isolux::ui {

// Shows a dialog and waits. Returns an absolute path, or nothing where the user cancels. `proposal`: the
// same, folder and name. `filters`: "PNG (*.png)"; the chosen one's suffix is given to a name that has none,
// before the dialog looks whether such a file exists already, so that nothing is overwritten unasked.
QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposal,
                         const QStringList& filters);

// Where to propose a file that belongs to `source` (a volume's or session's path): the folder it lies in, if
// one may write there; else `otherwise`.
QString folderBeside(const QString& source, const QString& otherwise);

}  // namespace isolux::ui
