// The menu Presets of ui/window/main_window.h.
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include "app/presets/preset_list.h"
#include "scene/rules/relevance.h"
#include "scene/settings/choice_names.h"
#include "ui/document/baked_light.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

namespace {

bool mayReplacePreset(const std::string& name, const QString& title, QWidget* parent) {
  if (!QFileInfo::exists(QString::fromStdString(app::ownPresetFile(name).string()))) return true;
  return QMessageBox::question(parent, "Isolux", QObject::tr("Replace the preset “%1”?").arg(title)) ==
         QMessageBox::Yes;
}

}  // namespace

void MainWindow::makePresetsMenu() {
  presetsMenu_ = menuBar()->addMenu(tr("&Presets"));
  presetsMenu_->setToolTipsVisible(true);
  presetsMenu_->menuAction()->setToolTip(
      tr("Apply a preset: isovalues, look and light for one kind of data"));
  connect(presetsMenu_, &QMenu::aboutToShow, this, &MainWindow::showPresets);
}

// Anew each time: what applies depends on the volume, and files may have come.
void MainWindow::showPresets() {
  presetsMenu_->clear();
  const VolumePointer volume = document_->volume();
  if (!volume) return;
  const auto add = [&](const app::Preset& preset) {
    if (!app::whyNot(preset, *volume).empty()) return;
    QString title = translated(texts::presets, preset.title);
    QAction* const action =
        presetsMenu_->addAction(title.replace('&', "&&"), this, [this, preset] { applyPreset(preset); });
    action->setToolTip(translated(texts::presets, preset.meaning));
  };
  QAction* const kind = presetsMenu_->addAction(
      tr("&Data: %1…").arg(wordsOf(QString::fromUtf8(scene::choiceName(volume->kind.kind)))), this,
      [this] { showPanel("Volume"); });
  kind->setToolTip(tr("Lists the presets for this kind of data; choose another kind in the Volume panel"));
  presetsMenu_->addSeparator();
  for (const app::Preset& preset : app::builtInPresets()) add(preset);
  presetsMenu_->addSeparator();
  std::vector<std::string> warnings;
  const std::vector<app::Preset> own = app::ownPresets(warnings);
  for (const app::Preset& preset : own) add(preset);
  if (!own.empty()) presetsMenu_->addSeparator();
  presetsMenu_->addAction(tr("&Save as preset…"), this, &MainWindow::savePreset);
  presetsMenu_->addAction(tr("&Reset all settings"), document_, &Document::resetSettings);
  if (!warnings.empty()) message_->showNote(QString::fromStdString(warnings.front()));
}

void MainWindow::applyPreset(const app::Preset& preset) {
  const VolumePointer volume = document_->volume();
  if (!volume) return;
  if (const std::string reason = app::whyNot(preset, *volume); !reason.empty())
    return message_->showError(tr("Does not apply: %1").arg(translated(texts::presets, reason)));
  document_->endGesture();
  document_->edit({app::withPreset(document_->scene(), preset, *volume),
                   tr("Preset %1").arg(translated(texts::presets, preset.title))});
  if (scene::usesGi(document_->scene())) light_->askFirst();
}

void MainWindow::savePreset() {
  bool accepted = false;
  const QString title = QInputDialog::getText(this, tr("Save as preset"), tr("Name of the preset:"),
                                              QLineEdit::Normal, {}, &accepted);
  if (accepted) keepPresetAs(title.trimmed());
}

void MainWindow::keepPresetAs(const QString& title) {
  attempt([&] {
    const std::string text = title.toStdString(), name = app::presetNameOf(text);
    if (!mayReplacePreset(name, title, this)) return;
    const std::filesystem::path file = app::savePreset(
        app::presetOf(document_->scene(), name, text, document_->volume().get()), /*overwrite=*/true);
    tellSaved(QString::fromStdString(file.string()), {});
  });
}

}  // namespace isolux::ui
