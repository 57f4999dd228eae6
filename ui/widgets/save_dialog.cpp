#include "ui/widgets/save_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace isolux::ui {

namespace {
// "png" of "PNG, with session (*.png)".
QString suffixOf(const QString& filter) {
  return filter.section("(*.", -1).section(QChar(')'), 0, 0).section(QChar(' '), 0, 0);
}
}  // namespace

QString askForFileToSave(QWidget* parent, const QString& title, const QString& proposal,
                         const QStringList& filters) {
  const QFileInfo proposed(proposal);
  QFileDialog dialog(parent, title, proposed.absolutePath());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix(suffixOf(filters.first()));
  dialog.selectFile(proposed.fileName());
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&dialog](const QString& filter) { dialog.setDefaultSuffix(suffixOf(filter)); });
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  return QDir::cleanPath(dialog.selectedFiles().first());
}

QString folderBeside(const QString& source, const QString& otherwise) {
  const bool isFile = !source.isEmpty() && !source.startsWith("phantom:");
  const QString folder = isFile ? QFileInfo(QDir::cleanPath(source)).absolutePath() : QString();
  return isFile && QFileInfo(folder).isWritable() ? folder : otherwise;
}

}  // namespace isolux::ui
