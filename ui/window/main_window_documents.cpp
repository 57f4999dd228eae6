// What the menu entries of ui/window/main_window.h do with files: opening, saving, recording, closing, and
// what a killed window has left.
#include <algorithm>

#include <QCloseEvent>
#include <QDesktopServices>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QSessionManager>
#include <QUrl>

#include "app/documents/session.h"
#include "app/files/file_names.h"
#include "app/presets/preset_list.h"
#include "ui/dialogs/raw_import_dialog.h"
#include "ui/dialogs/reference_dialog.h"
#include "ui/dicom_browser/folder_opener.h"
#include "ui/document/baked_light.h"
#include "ui/document/document_keeper.h"
#include "ui/document/environment_edit.h"
#include "ui/document/picture_request.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/panels/light_status.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/save_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "ui/window/window_layout.h"
#include "volume/read/reader.h"
#include "volume/read/step_files.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::ui {

namespace {
constexpr auto sessionFilter = QT_TRANSLATE_NOOP("QObject", "Isolux session (*.isolux)");
constexpr auto recordingFilter = QT_TRANSLATE_NOOP("QObject", "Isolux recording (*.jsonl)");

// The buttons of a message about a new file.
std::vector<MessageBar::Answer> showInFolder(const QString& file) {
  const QString folder = QFileInfo(file).absolutePath();
  return {
      {QObject::tr("Show in folder"), [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); }}};
}
}  // namespace

// Opening

void MainWindow::openPath(const QString& path) {
  if (QFileInfo(path).isDir() && !volume::isZarrFolder(path.toStdString())) {
    openFolder(path);
  } else if (mayDiscard()) {
    document_->open(path);
  }
}

// As time steps, or else the first.
void MainWindow::openFiles(const QStringList& paths) {
  std::vector<std::string> files;
  for (const QString& path : paths) files.push_back(path.toStdString());
  const QString steps = QString::fromStdString(volume::pathOfSteps(files));
  openPath(steps.isEmpty() ? paths.front() : steps);
}

void MainWindow::chooseFile() {
  QStringList filters, patterns;
  for (const std::string& filter : volume::fileFilters()) {
    const QString text = translatedFilter(filter);
    filters += text;
    const QString inside = text.section('(', -1).section(')', 0, 0);
    if (inside != "*") patterns += inside;
  }
  filters.prepend(tr("Volumes, sessions and images (%1)").arg(patterns.join(' ') + " *.isolux *.png"));
  filters += {QObject::tr(sessionFilter), tr("Raw voxels (*.raw *.bin *.img *.dat)"), tr("All files (*)")};
  filters.removeDuplicates();
  const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Open"), lastFolder(), filters.join(";;"));
  if (paths.isEmpty()) return;
  rememberFolder(paths.front());
  openFiles(paths);
}

void MainWindow::chooseFolder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open folder"), lastFolder());
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
  if (std::ranges::any_of(event->mimeData()->urls(), &QUrl::isLocalFile)) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths += url.toLocalFile();
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  // After the drop is answered: a dialog must not hold up the program that the file comes from.
  QMetaObject::invokeMethod(
      this,
      [this, paths] {
        const QString& path = paths.front();
        if (paths.size() > 1) {
          openFiles(paths);
        } else if (path.endsWith(".mrk.json", Qt::CaseInsensitive) && document_->volume()) {
          importMarks(path);
        } else if (path.endsWith(app::kPresetExtension, Qt::CaseInsensitive) && document_->volume()) {
          applyPreset(app::findPreset(path.toStdString()));
        } else if (isLightProbe(path)) {
          document_->edit(lightProbeChosen(document_->scene(), path));
        } else {
          openPath(path);
        }
      },
      Qt::QueuedConnection);
}

// Saving

// Beside the volume, by the name of the session or of the volume.
QString MainWindow::proposedFile(const QString& suffix) const {
  const QString session = document_->sessionFile();
  const QString source = QString::fromStdString(document_->scene().source.path);
  const QString name =
      savedText(QString::fromStdString(app::plainName((session.isEmpty() ? source : session).toStdString())),
                document_->volume());
  const QString folder = folderBeside(session.isEmpty() ? source : session, lastFolder());
  return (folder.isEmpty() ? QDir::homePath() : folder) + '/' + (name.isEmpty() ? tr("untitled") : name) +
         suffix;
}

void MainWindow::tellSaved(const QString& file, const QString& more) {
  const QString name = QFileInfo(file).fileName();
  const QString text = more.isEmpty() ? tr("Saved %1").arg(name) : tr("Saved %1, %2").arg(name, more);
  message_->show(MessageBar::Kind::note, text, showInFolder(file));
}

bool MainWindow::saveSession() {
  const QString file = document_->sessionFile();
  return file.isEmpty() ? saveSessionAs() : saveSessionTo(file);
}

bool MainWindow::saveSessionAs() {
  const QString file =
      askForFileToSave(this, tr("Save session"), proposedFile(".isolux"), {QObject::tr(sessionFilter)});
  if (file.isEmpty()) return false;
  rememberFolder(file);
  return saveSessionTo(file);
}

bool MainWindow::saveSessionTo(const QString& file) {
  if (!document_->saveSession(file)) return false;
  tellSaved(file, {});
  return true;
}

void MainWindow::tracePicture() {
  const double ratio = viewport_->devicePixelRatioF();
  scene::Scene resolved = document_->resolvedScene();
  // As bright as the picture of the window: a reference by itself is exposed by the lights.
  if (const LightPointer& light = light_->light(); light && light->seen && !resolved.picture.exposure)
    resolved.picture.exposure = static_cast<double>(light->automaticExposure);
  scene::Scene given = document_->shownScene();
  given.picture.exposure = resolved.picture.exposure;
  auto* dialog = new ReferenceDialog(document_->volume(), given, resolved,
                                     (QSizeF(viewport_->size()) * ratio).toSize(), host_.threads, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void MainWindow::toggleRecording() {
  if (document_->recording()) {
    document_->stopRecording();
    tellRecorded();
    return;
  }
  const QString start = QFileInfo(proposedFile("")).absolutePath() + "/recording.jsonl";
  const QString file = askForFileToSave(this, tr("Save recording as"), start, {QObject::tr(recordingFilter)});
  if (!file.isEmpty()) {
    rememberFolder(file);
    document_->startRecording(file);
  }
  showState();  // the entry is checkable: a cancelled dialog must not leave it checked
}

void MainWindow::tellRecorded() {
  const QString file = document_->recordingFile();
  const QString name = QFileInfo(file).fileName();
  tellSaved(file, tr("render it with isolux replay %1 --out FOLDER").arg(name));
}

// Closing

bool MainWindow::mayDiscard() {
  const QString file = document_->sessionFile();
  if (!document_->volume() || !app::asksBeforeDiscarding(document_->unsavedWork(), !file.isEmpty()))
    return true;
  QMessageBox box(QMessageBox::Question, "Isolux", {},
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setText(
      !file.isEmpty()
          ? tr("Save the changes to %1?").arg(QFileInfo(file).fileName())
          : tr("Save your work on %1 as a session?").arg(shownText(document_->name(), document_->volume())));
  box.setInformativeText(tr("A session stores isovalue, look, light and view, but not the baked light."));
  box.setDefaultButton(QMessageBox::Save);
  box.setEscapeButton(QMessageBox::Cancel);
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveSession());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  document_->cancelLoading();
  folders_->cancel();
  keepShownPicture();
  if (keeper_) keeper_->forget();
  layout_->keep();
  event->accept();
}

void MainWindow::commitData(QSessionManager& manager) {
  const bool mayAsk = manager.allowsInteraction();
  const bool ends = endSession(mayAsk);
  if (mayAsk) manager.release();
  if (!ends) manager.cancel();
}

bool MainWindow::endSession(bool mayAsk) {
  if (mayAsk && !mayDiscard()) return false;
  if (!keeper_) return true;
  if (mayAsk) {
    keeper_->forget();
  } else {  // the next start offers what is open
    keeper_->save();
    keeper_->finish();
  }
  return true;
}

// What a killed window has left

void MainWindow::keepDocument(const std::filesystem::path& folder) {
  keeper_ = new DocumentKeeper(document_, folder, this);
  connect(keeper_, &DocumentKeeper::failed, message_, &MessageBar::showError);
  connect(keeper_, &DocumentKeeper::noted, message_, &MessageBar::showNote);
  offerLost();
  if (keeper_->damaged().empty()) return;
  const QString file = QString::fromStdString(keeper_->damaged().front().string());
  message_->show(MessageBar::Kind::note, tr("An autosave could not be read. Its file is %1").arg(file),
                 showInFolder(file));
}

void MainWindow::offerLost() {
  const app::Autosave* lost = keeper_->lost();
  if (!lost) return;
  const auto restore = [this] {
    if (mayDiscard()) {
      keeper_->restoreLost();
    } else {
      offerLost();
    }
  };
  const auto discard = [this] {
    keeper_->discardLost();
    offerLost();
  };
  const auto age = std::chrono::system_clock::now() - lost->time;
  message_->show(
      MessageBar::Kind::question,
      tr("Continue: %1, %2")
          .arg(savedPrivacy().hideOnScreen ? tr("anonymous")
                                           : QString::fromStdString(app::plainName(lost->document.name)),
               translatedSentence(app::agoText(age))),
      {{tr("Restore"), restore}, {tr("Discard"), discard}});
}

}  // namespace isolux::ui
