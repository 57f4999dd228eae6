// What the menu entries of ui/main_window.h do: dialogs, files, full screen, drag and drop.
#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include "app/image_io.h"
#include "app/session.h"
#include "app/version.h"
#include "ui/environment_edit.h"
#include "ui/file_widget.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/raw_import_dialog.h"
#include "ui/reference_dialog.h"
#include "ui/settings_panel.h"
#include "ui/viewport.h"

namespace isolux::ui {

namespace {
constexpr auto sessionFilter = "Isolux session (*.isolux)";

QString lastFolder() {
  return QSettings().value("lastFolder").toString();
}

void rememberFolder(const QString& path) {
  QSettings().setValue("lastFolder", QFileInfo(path).absolutePath());
}

QString withSuffix(const QString& file, const QString& suffix) {
  return QFileInfo(file).suffix().isEmpty() ? file + suffix : file;
}
}  // namespace

// ---- Opening
// ------------------------------------------------------------------------------------------------

void MainWindow::openPath(const QString& path) {
  if (mayDiscard()) document_->open(path);
}

void MainWindow::chooseFile() {
  QStringList filters, patterns;
  for (const std::string& filter : volume::fileFilters()) {
    const QString text = QString::fromStdString(filter);
    filters += text;
    const QString inside = text.section('(', -1).section(')', 0, 0);
    if (inside != "*") patterns += inside;
  }
  filters.prepend("Volumes, sessions and pictures (" + patterns.join(' ') + " *.isolux *.png)");
  filters += {sessionFilter, "Raw voxels (*.raw *.bin *.img *.dat)", "All files (*)"};
  filters.removeDuplicates();
  const QString path = QFileDialog::getOpenFileName(this, "Open", lastFolder(), filters.join(";;"));
  if (path.isEmpty()) return;
  rememberFolder(path);
  openPath(path);
}

void MainWindow::chooseFolder() {
  const QString path = QFileDialog::getExistingDirectory(this, "Open folder", lastFolder());
  if (path.isEmpty()) return;
  rememberFolder(path);
  openPath(path);
}

void MainWindow::chooseRaw(const QString& path) {
  auto* dialog = new RawImportDialog(path, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
    document_->openRaw(path, QString::fromStdString(volume::toText(dialog->description())));
  });
  dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) {
      event->acceptProposedAction();
      return;
    }
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    if (!url.isLocalFile()) continue;
    event->acceptProposedAction();
    const QString path = url.toLocalFile();
    // After the drop is answered: a dialog must not hold up the program that the file comes from.
    QMetaObject::invokeMethod(
        this,
        [this, path] {
          if (isLightProbe(path)) {
            document_->edit(lightProbeChosen(document_->scene(), path));
          } else {
            openPath(path);
          }
        },
        Qt::QueuedConnection);
    return;
  }
}

// ---- Saving
// -------------------------------------------------------------------------------------------------

bool MainWindow::saveSession() {
  const QString& file = document_->sessionFile();
  // A picture that carries a session is not overwritten with one.
  if (file.isEmpty() || file.endsWith(".png", Qt::CaseInsensitive)) return saveSessionAs();
  return document_->saveSession(file);
}

bool MainWindow::saveSessionAs() {
  const QString base = QFileInfo(document_->name()).completeBaseName();
  const QString start = lastFolder() + '/' + (base.isEmpty() ? "session" : base) + ".isolux";
  const QString file = QFileDialog::getSaveFileName(this, "Save session", start, sessionFilter);
  if (file.isEmpty()) return false;
  rememberFolder(file);
  return document_->saveSession(withSuffix(file, ".isolux"));
}

void MainWindow::choosePicture() {
  const QString start = lastFolder() + '/' + QFileInfo(document_->name()).completeBaseName() + ".png";
  const QString file = QFileDialog::getSaveFileName(
      this, "Save picture", start, "PNG, carries the session (*.png);;OpenEXR, linear colours (*.exr)");
  if (file.isEmpty()) return;
  rememberFolder(file);
  if (savePicture(withSuffix(file, ".png"))) {
    message_->show(MessageBar::Kind::note, "Picture saved as " + QFileInfo(file).fileName());
  }
}

void MainWindow::tracePicture() {
  const double ratio = viewport_->devicePixelRatioF();
  auto* dialog = new ReferenceDialog(document_->volume(), document_->resolvedScene(),
                                     (QSizeF(viewport_->size()) * ratio).toSize(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

bool MainWindow::savePicture(const QString& file) {
  try {
    const std::filesystem::path path = file.toStdString();
    const std::string session = app::sessionText(document_->shownScene(), path.parent_path());
    const render::ColorImage image = viewport_->picture();
    if (file.endsWith(".exr", Qt::CaseInsensitive)) {
      app::writeExr(&image, {}, path, session);
    } else {
      app::writePng(image, path, session);
    }
    return true;
  } catch (const scene::Error& error) {
    message_->show(MessageBar::Kind::error, QString::fromStdString(error.what()));
    return false;
  }
}

void MainWindow::toggleRecording() {
  if (document_->recording()) {
    document_->stopRecording();
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, "Record into", lastFolder() + "/recording.jsonl",
                                                    "Isolux recording (*.jsonl)");
  if (!file.isEmpty()) {
    rememberFolder(file);
    document_->startRecording(withSuffix(file, ".jsonl"));
  }
  showState();  // the entry is checkable: a cancelled dialog must not leave it checked
}

bool MainWindow::mayDiscard() {
  if (document_->sessionFile().isEmpty() || !document_->modified()) return true;
  QMessageBox box(QMessageBox::Question, "Isolux",
                  QString("Save the changes to %1?").arg(QFileInfo(document_->sessionFile()).fileName()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveSession());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  document_->cancelLoading();
  if (!isFullScreen()) QSettings().setValue("window/geometry", saveGeometry());
  event->accept();
}

// ---- View and help
// ------------------------------------------------------------------------------------------

void MainWindow::toggleFullScreen(bool on) {
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->setVisible(!on);
  statusBar()->setVisible(!on);
  settingsDock_->setVisible(!on);
  infoDock_->setVisible(!on);
  passesDock_->setVisible(!on);
  if (on) {
    showFullScreen();
  } else {
    showNormal();
    settingsDock_->raise();
  }
}

void MainWindow::chooseLook(int mode) {
  Edit edit{document_->scene(), "Change look", {}, false};
  edit.scene.look.mode = static_cast<scene::LookMode>(mode);
  document_->edit(edit);
}

void MainWindow::stepLook(int step) {
  const int count = look_->count();
  chooseLook((static_cast<int>(document_->scene().look.mode) + step + count) % count);
}

void MainWindow::findSetting() {
  showPanel("settings");
  settings_->focusSearch();
}

void MainWindow::showHelp() {
  QMessageBox box(this);
  box.setWindowTitle("Mouse and keys");
  box.setTextFormat(Qt::RichText);
  box.setText(R"(
    <style>td { padding: 2px 18px 2px 0; } h4 { margin: 10px 0 4px 0; }</style>
    <h4>Picture</h4>
    <table>
    <tr><td><b>Left drag</b></td><td>rotate</td></tr>
    <tr><td><b>Middle drag</b>, <b>Shift+left drag</b></td><td>pan</td></tr>
    <tr><td><b>Right drag</b>, <b>wheel</b></td><td>zoom</td></tr>
    <tr><td><b>Ctrl+left drag</b></td><td>roll</td></tr>
    <tr><td><b>Double click</b></td><td>centre on the point of the surface</td></tr>
    <tr><td><b>Shift+right drag</b></td><td>turn the light probe (global illumination)</td></tr>
    <tr><td><b>Lamp handles</b></td><td>drag; with Ctrl, or by the wheel, nearer and farther (global illumination)</td></tr>
    <tr><td><b>1 2 3 4 5 6</b></td><td>from anterior, posterior, left, right, superior, inferior</td></tr>
    <tr><td><b>R</b>, <b>F</b>, <b>O</b></td><td>reset the view, fit the volume, orthographic</td></tr>
    <tr><td><b>L</b>, <b>Shift+L</b></td><td>next and previous look</td></tr>
    <tr><td><b>Space</b></td><td>let the flow move, or stand still</td></tr>
    <tr><td><b>Ctrl+F</b></td><td>find a setting</td></tr>
    <tr><td><b>F11</b></td><td>full screen</td></tr>
    </table>
    <h4>Histogram</h4>
    <table>
    <tr><td><b>Drag the line</b></td><td>choose the isovalue</td></tr>
    <tr><td><b>Wheel</b>, <b>arrow keys</b></td><td>fine steps; with Shift ten times larger</td></tr>
    <tr><td><b>Double click</b></td><td>suggested isovalue</td></tr>
    <tr><td><b>Ctrl+wheel</b>, <b>middle drag</b></td><td>zoom and move the axis of values</td></tr>
    </table>)");
  box.exec();
}

void MainWindow::showAbout() {
  QMessageBox::about(this, "About Isolux",
                     QString("<h3>Isolux %1</h3><p>Explore scans and simulations as isosurfaces, drawn "
                             "directly from the voxels.</p><p>Graphics: %2</p><p>Qt %3</p>")
                         .arg(QString::fromStdString(std::string(app::version())),
                              viewport_->description().toHtmlEscaped(), QString(qVersion())));
}

}  // namespace isolux::ui
