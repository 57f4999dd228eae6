// What the menu entries of ui/window/main_window.h do to the view, and help. Files:
// ui/window/main_window_documents.cpp.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/files/documentation.h"
#include "app/version.h"
#include "scene/looks.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/level_zero.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/privacy_box.h"
#include "ui/document/baked_light.h"
#include "ui/document/preferences.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/panels/settings_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/guide_window.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

void MainWindow::chooseLook(int row) {
  Edit edit{document_->scene(), tr("Change look"), {}, false};
  edit.scene.look.mode = scene::looks()[static_cast<std::size_t>(row)].mode;
  document_->edit(edit);
}

void MainWindow::stepLook(int step) {
  const int count = look_->count();
  chooseLook((look_->currentIndex() + step + count) % count);
}

void MainWindow::findSetting() {
  showPanel("Settings");
  panel<SettingsPanel>()->focusSearch();
}

void MainWindow::setMachine(const scene::Machine& machine) {
  machine_ = machine;
  viewport_->setMachine(machine);
  light_->setThreads(machine.threads);
  panel<AccuracyPanel>()->setMachine(machine);
  levelZero_->setMachine(machine);
}

void MainWindow::showPreferences() {
  auto* dialog = new PreferencesDialog(machine_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, [this](const scene::Machine& machine) {
    keepMachine(machine_, machine);
    setMachine(machine);
  });
  connect(dialog->privacy(), &PrivacyBox::changed, this, &MainWindow::applyPrivacy);
  dialog->show();
}

void MainWindow::showGuide() {
  if (!guide_) {
    const std::filesystem::path folder = app::documentationFolder();
    if (folder.empty())
      return message_->show(MessageBar::Kind::error, tr("The documentation is not installed"));
    guide_ = new GuideWindow(QString::fromStdString(folder.string()), this);
    guide_->setAttribute(Qt::WA_DeleteOnClose);
  }
  guide_->show();
  guide_->raise();
  guide_->activateWindow();
}

// Neither blocks the window: what they say is tried beside them.
void MainWindow::showHelp() {
  if (help_) {
    help_->raise();
    help_->activateWindow();
    return;
  }
  auto* box = new QDialog(this);
  help_ = box;
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("Mouse and keys"));
  auto* text = new QTextBrowser(box);
  text->setHtml(translatedCells(texts::help, helpText()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, box);
  connect(buttons, &QDialogButtonBox::rejected, box, &QDialog::close);
  auto* layout = new QVBoxLayout(box);
  layout->addWidget(text);
  layout->addWidget(buttons);
  constexpr QSize wanted(760, 940);  // scrolls where the screen has not as many pixels
  box->resize(wanted.boundedTo(screen()->availableSize() * 9 / 10));
  box->show();
}

const char* MainWindow::helpText() {
  return R"(
    <style>td { padding: 2px 18px 2px 0; } h4 { margin: 10px 0 4px 0; }</style>
    <h4>Picture</h4>
    <table width="680">
    <tr><td><b>Left drag</b></td><td>rotate</td></tr>
    <tr><td><b>Middle drag</b>, <b>Shift+left drag</b></td><td>pan</td></tr>
    <tr><td><b>Right drag</b>, <b>wheel</b></td><td>zoom</td></tr>
    <tr><td><b>Right click</b>, <b>menu key</b></td><td>hide or keep the piece of the surface under the pointer</td></tr>
    <tr><td><b>Ctrl+left drag</b></td><td>roll</td></tr>
    <tr><td><b>Arrows</b>, <b>Shift+arrows</b></td><td>turn by 5 degrees, pan</td></tr>
    <tr><td><b>Ctrl+left, right</b>, <b>+ −</b></td><td>roll by 5 degrees, zoom</td></tr>
    <tr><td><b>Click on the cube</b></td><td>from that side</td></tr>
    <tr><td><b>Double click</b></td><td>centre on the point of the surface</td></tr>
    <tr><td><b>Shift+right drag</b></td><td>turn the light probe (global illumination)</td></tr>
    <tr><td><b>Lamp handles</b></td><td>drag; with Ctrl, or by the wheel, nearer and farther (global illumination)</td></tr>
    <tr><td><b>Handles of cuts</b></td><td>drag to move or turn planes and box; with Ctrl to axes; Esc puts it back; right click for more</td></tr>
    <tr><td><b>C</b>, <b>Shift+C</b>, <b>Shift+X</b></td><td>cut: plane facing the viewer, flip the last plane, remove all cuts</td></tr>
    <tr><td><b>1 2 3 4 5 6</b></td><td>from anterior, posterior, left, right, superior, inferior (front, back, +X, −X, up, down where the file states no orientation)</td></tr>
    <tr><td><b>R</b>, <b>F</b>, <b>O</b></td><td>reset the view, fit the volume, orthographic</td></tr>
    <tr><td><b>L</b>, <b>Shift+L</b></td><td>next and previous look</td></tr>
    <tr><td><b>Space</b></td><td>let the flow move, or stand still</td></tr>
    <tr><td><b>P</b>, <b>M</b>, <b>Shift+M</b></td><td>pin, distance, distance along the surface: clicks set points; Backspace takes the last back, Esc ends</td></tr>
    <tr><td><b>Ctrl+C</b>, <b>Ctrl+E</b></td><td>copy the picture, save it</td></tr>
    <tr><td><b>Ctrl+F</b></td><td>find a setting</td></tr>
    <tr><td><b>F4</b></td><td>picture and slices, slices alone, the picture alone</td></tr>
    <tr><td><b>Ctrl+0</b>, <b>Ctrl+1 …</b>, <b>F6</b></td><td>to the picture, to the panels, to the next part of the window</td></tr>
    <tr><td><b>F11</b>, <b>Esc</b></td><td>full screen, and back</td></tr>
    <tr><td colspan="2"><h4>Slices</h4></td></tr>
    <tr><td><b>Click</b>, <b>drag</b>, <b>arrows</b></td><td>move the crosshair; a click on the surface does, too</td></tr>
    <tr><td><b>Wheel</b>, <b>page keys</b></td><td>a voxel farther</td></tr>
    <tr><td><b>Right drag</b>, <b>right click</b></td><td>level and width; which plane, thick slice, windows of CT</td></tr>
    <tr><td><b>Middle drag</b>, <b>Ctrl+wheel</b>, <b>double click</b></td><td>pan, zoom, the whole</td></tr>
    <tr><td colspan="2"><h4>Histogram</h4></td></tr>
    <tr><td><b>Drag the line</b></td><td>choose the isovalue</td></tr>
    <tr><td><b>Wheel</b>, <b>arrow keys</b></td><td>fine steps; with Shift ten times larger</td></tr>
    <tr><td><b>Alt+click</b>, <b>right click</b></td><td>one more isosurface there</td></tr>
    <tr><td><b>Double click</b></td><td>suggested isovalue</td></tr>
    <tr><td><b>Ctrl+wheel</b>, <b>middle drag</b></td><td>zoom and move the axis of values</td></tr>
    </table>)";
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(this);
  box->setObjectName("about");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("About Isolux"));
  box->setIconPixmap(windowIcon().pixmap(64));
  box->setTextFormat(Qt::RichText);
  box->setTextInteractionFlags(Qt::TextBrowserInteraction);
  box->setText(
      tr("<h3>Isolux %1</h3><p>Explore scans and simulations as isosurfaces, drawn "
         "directly from the voxels.</p><p><b>Not a medical device: not for diagnosis.</b></p>"
         "<p>Free software under the <a href=\"https://opensource.org/license/bsd-3-clause\">BSD 3-Clause "
         "licence</a>, without any warranty.</p><p>Graphics: %2</p><p>Qt %3</p>")
          .arg(QString::fromStdString(std::string(app::version())), viewport_->description().toHtmlEscaped(),
               QString(qVersion())));
  box->setModal(false);
  box->show();
}

}  // namespace isolux::ui
