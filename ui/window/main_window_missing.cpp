// A session or picture whose volume is not where it says, of ui/window/main_window.h: where is it?
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "ui/document/recent_files.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

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
