// Opening of ui/window/main_window.h: folders and their DICOM series, the recent files and their pictures,
// and whether the patient is named.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSignalBlocker>
#include <QTimer>

#include "app/documents/anonymous.h"
#include "ui/dicom_browser/folder_opener.h"
#include "ui/dicom_browser/recent_menu.h"
#include "ui/dicom_browser/series_index.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/load_card.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/step_files.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::ui {

void MainWindow::connectOpening() {
  connect(folders_, &FolderOpener::started, this, [this](const QString& name) {
    message_->clear();
    recentPictures_->hide();
    loadCard_->begin(savedPrivacy().hideOnScreen ? tr("a folder") : name);
  });
  connect(folders_, &FolderOpener::progressed, this,
          [this](double fraction) { loadCard_->report(fraction, "looking for series"); });
  connect(folders_, &FolderOpener::ended, this, [this] {
    loadCard_->end();
    showRecentPictures();
  });
  connect(folders_, &FolderOpener::privacyChanged, this, &MainWindow::applyPrivacy);
  connect(loadCard_, &LoadCard::cancelled, folders_, &FolderOpener::cancel);
  connect(document_, &Document::opened, this, &MainWindow::noteOpened);
  connect(document_, &Document::loadStarted, this, [this] {
    keepShownPicture();
    showRecentPictures();
  });
  connect(document_, &Document::loadEnded, this, &MainWindow::showRecentPictures);
  connect(recentPictures_, &RecentPictures::chosen, this, &MainWindow::openRecent);
  // What is asked for at the start has begun by then.
  QTimer::singleShot(0, this, &MainWindow::showRecentPictures);
  message_->setFilter([this](const QString& text) { return shownText(text, document_->volume()); });
}

void MainWindow::openFolder(const QString& folder) {
  folders_->look(QFileInfo(folder).absoluteFilePath(),
                 [this](const QString& path, const QString& series) { openSeries(path, series); });
}

void MainWindow::openSeries(const QString& folder, const QString& series) {
  if (mayDiscard()) document_->open(folder, series);
}

// At the start. A folder that says no series may hold several.
void MainWindow::openRequested(const app::WindowRequest& request, const scene::Scene& scene) {
  const QString path = QString::fromStdString(scene.source.path);
  if (!request.sessionFile.empty() || !scene.source.series.empty() || !QFileInfo(path).isDir() ||
      volume::isZarrFolder(scene.source.path)) {
    document_->openScene(scene, QString::fromStdString(request.sessionFile), request.completed);
    return;
  }
  folders_->look(path, [this, request, scene](const QString& folder, const QString& series) {
    scene::Scene chosen = scene;
    chosen.source.path = folder.toStdString();
    chosen.source.series = series.toStdString();
    document_->openScene(chosen, {}, request.completed);
  });
}

void MainWindow::browseFolders() {
  const QString path = QString::fromStdString(document_->scene().source.path);
  if (folders_->index()->folder().isEmpty() && QFileInfo(path).isDir()) folders_->index()->start(path);
  folders_->browse();
}

// Recent files

void MainWindow::openRecent(const RecentFile& file) {
  if (!file.path.startsWith("phantom:") && !QFileInfo::exists(file.path) &&
      !volume::hdf5PathOf(file.path.toStdString()) && volume::stepFiles(file.path.toStdString()).empty())
    removeRecentFile(file.path);
  if (file.series.isEmpty())
    openPath(file.path);
  else
    openSeries(file.path, file.series);
}

void MainWindow::noteOpened(const QString& path) {
  const scene::Source& source = document_->scene().source;
  shownFile_ = {path};
  if (!path.startsWith("phantom:")) {
    shownFile_.name = QFileInfo(path).fileName();
    if (path.toStdString() == source.path) shownFile_.series = QString::fromStdString(source.series);
    if (!shownFile_.series.isEmpty())
      shownFile_.name =
          tr("%1 – %2").arg(QString::fromStdString(document_->volume()->volume.name), shownFile_.name);
    shownFile_.hidden = QString::fromStdString(app::withoutPatient(
        shownFile_.name.toStdString(), volume::patientOf(document_->volume()->volume.grid)));
  }
  addRecentFile(shownFile_);
}

void MainWindow::keepShownPicture() {
  // Until a volume's first picture is there, the one before is on screen.
  if (document_->volume() && !awaitsFirstPicture_ && !shownFile_.path.isEmpty() && !viewport_->problem())
    keepRecentPicture(shownFile_, viewport_->shown());
}

void MainWindow::showRecentPictures() {
  if (document_->volume() || document_->loading() || folders_->index()->running())
    recentPictures_->hide();
  else
    recentPictures_->fill();
}

// The patient

void MainWindow::applyPrivacy() {
  const QSignalBlocker block(hidePatient_);
  hidePatient_->setChecked(savedPrivacy().hideOnScreen);
  if (document_->volume()) panel<VolumePanel>()->setVolume(document_->volume());
  showRecentPictures();
  showState();
}

// A session or picture whose volume is not where it says

// One of the same name that was opened lately may be another patient's: it is proposed, not taken.
void MainWindow::askForVolume(const scene::Scene& scene, const QString& sessionFile) {
  const QString name = QFileInfo(QString::fromStdString(scene.source.path)).fileName();
  const QString of = QFileInfo(sessionFile).fileName();
  const auto take = [this, scene, sessionFile](const QString& file) {
    scene::Scene found = scene;
    found.source.path = QFileInfo(file).absoluteFilePath().toStdString();
    document_->openScene(found, sessionFile);
  };
  std::vector<MessageBar::Answer> answers;
  for (const QString& recent : recentFiles()) {
    if (QFileInfo(recent).fileName() != name || !QFileInfo::exists(recent)) continue;
    answers.push_back(
        {tr("Use the one in %1").arg(QFileInfo(recent).dir().dirName()), [take, recent] { take(recent); }});
    break;
  }
  answers.push_back({tr("Find it…"), [this, take, name, sessionFile] {
                       const QString file = QFileDialog::getOpenFileName(
                           this, tr("Where is %1?").arg(name), QFileInfo(sessionFile).absolutePath());
                       if (file.isEmpty()) return;
                       rememberFolder(file);
                       take(file);
                     }});
  message_->show(
      MessageBar::Kind::question,
      tr("%1 shows %2, which is neither in its previous folder nor next to the session. Where is it now?")
          .arg(of, name),
      std::move(answers));
}

}  // namespace isolux::ui
