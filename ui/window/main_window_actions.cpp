// What the menu entries of ui/window/main_window.h do to the view, full screen, the Tab key, and help. Files:
// ui/window/main_window_documents.cpp.
#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QMessageBox>
#include <QScreen>
#include <QShortcut>
#include <QStatusBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QWindowStateChangeEvent>

#include "app/files/documentation.h"
#include "app/version.h"
#include "scene/looks.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/document/baked_light.h"
#include "ui/document/preferences.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/panels/settings_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/parts.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "ui/window/window_layout.h"

namespace isolux::ui {

namespace {

// Pictures are as wide as the text at most.
class PageBrowser : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return resource;
    QImage image = resource.value<QImage>();
    if (image.isNull()) image = QImage(source().resolved(name).toLocalFile());
    const int most = viewport()->width() - 40;
    return image.width() > most ? image.scaledToWidth(most, Qt::SmoothTransformation) : image;
  }
};

// Shows the pages of the documentation that come with the program, offline; links lead from page to page.
class GuideWindow : public QDialog {
 public:
  // Opens index.md of `folder`, which must not be empty.
  GuideWindow(const QString& folder, QWidget* parent) : QDialog(parent), browser_(new PageBrowser(this)) {
    setWindowTitle(QObject::tr("Guide"));
    browser_->setOpenLinks(false);
    connect(browser_, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
    const auto button = [this](const char* sign, const QString& name) {
      auto* made = textButton(sign, {}, this);
      nameAndTip(made, name);
      return made;
    };
    QToolButton *back = button("←", QObject::tr("Back")), *forward = button("→", QObject::tr("Forward")),
                *contents = button("⌂", QObject::tr("Contents"));
    connect(back, &QToolButton::clicked, browser_, &QTextBrowser::backward);
    connect(forward, &QToolButton::clicked, browser_, &QTextBrowser::forward);
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
    const QUrl first = QUrl::fromLocalFile(QDir(folder).filePath("index.md"));
    connect(contents, &QToolButton::clicked, this, [this, first] { follow(first); });
    layOut(this, columnOf({lineOf({back, forward, contents, Cell::room()}), browser_}));
    resize(820, 760);
    follow(first);
    back->setEnabled(false);
    forward->setEnabled(false);
  }

 private:
  // Pages open here, addresses in the user's browser.
  void follow(const QUrl& link) {
    const QUrl target = browser_->source().resolved(link);
    const bool isFile = target.isLocalFile();
    if (isFile && target.path() == browser_->source().path()) {
      browser_->scrollToAnchor(target.fragment());
    } else if (isFile && target.path().endsWith(".md")) {
      browser_->setSource(target, QTextDocument::MarkdownResource);
    } else {
      QDesktopServices::openUrl(target);
    }
  }

  QTextBrowser* browser_;
};

}  // namespace

void MainWindow::chooseLook(int row) {
  Edit edit{document_->scene(), tr("Change look")};
  edit.scene.look.mode = scene::looks()[static_cast<std::size_t>(row)].mode;
  document_->edit(edit);
}

void MainWindow::stepLook(int step) {
  const int count = look_->count();
  chooseLook((look_->currentIndex() + step + count) % count);
}

// The picture with the menu and the isovalue, and everything as it was afterwards.
void MainWindow::toggleFullScreen(bool on) {
  leaveFullScreen_->setEnabled(on);
  if (on) {
    layout_->hideAllBut();
    setWindowState(windowState() | Qt::WindowFullScreen);
  } else {
    setWindowState(windowState() & ~Qt::WindowFullScreen);  // maximised again, where it was
    layout_->showAgain();
  }
  statusBar()->setVisible(!on);
}

// Panels behind others are no stops of the Tab key: Qt lays them out of sight and counts them as visible.
bool MainWindow::focusNextPrevChild(bool next) {
  constexpr int mostStops = 1000;
  for (int i = 0; i < mostStops; ++i) {
    if (!QMainWindow::focusNextPrevChild(next)) return false;
    const QWidget* const focused = QApplication::focusWidget();
    if (focused == nullptr || !layout_->isBehind(focused)) return true;
  }
  return true;
}

// The window manager may end full screen as well.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::WindowStateChange || isFullScreen()) return;
  if (static_cast<QWindowStateChangeEvent*>(event)->oldState() & Qt::WindowFullScreen)
    fullScreen_->setChecked(false);
}

void MainWindow::findSetting() {
  showPanel("Settings");
  panel<SettingsPanel>()->focusSearch();
}

void MainWindow::setHostSettings(const scene::HostSettings& host) {
  host_ = host;
  viewport_->setHostSettings(host);
  light_->setThreads(host.threads);
  panel<AccuracyPanel>()->setHostSettings(host);
  fullResolution_->setHostSettings(host);
}

void MainWindow::showPreferences() {
  auto* dialog = new PreferencesDialog(host_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PreferencesDialog::changed, this, [this](const scene::HostSettings& host) {
    saveHostSettings(host_, host);
    setHostSettings(host);
  });
  connect(dialog, &PreferencesDialog::privacyChanged, this, &MainWindow::applyPrivacy);
  dialog->show();
}

void MainWindow::showGuide() {
  if (!guide_) {
    const std::filesystem::path folder = app::documentationFolder();
    if (folder.empty()) return message_->showError(tr("The documentation is not installed"));
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
  layOut(box, columnOf({text, buttons}));
  constexpr QSize wanted(760, 940);  // scrolls where the screen has not as many pixels
  box->resize(wanted.boundedTo(screen()->availableSize() * 9 / 10));
  box->show();
}

const char* MainWindow::helpText() {
  return R"(
    <style>td { padding: 2px 18px 2px 0; } h4 { margin: 10px 0 4px 0; }</style>
    <h4>3-D view</h4>
    <table width="680">
    <tr><td><b>Left drag</b></td><td>rotate</td></tr>
    <tr><td><b>Middle drag</b>, <b>Shift+left drag</b></td><td>pan</td></tr>
    <tr><td><b>Right drag</b>, <b>wheel</b></td><td>zoom</td></tr>
    <tr><td><b>Ctrl+left drag</b></td><td>roll</td></tr>
    <tr><td><b>Arrows</b>, <b>Shift+arrows</b></td><td>rotate by 5°, pan</td></tr>
    <tr><td><b>Ctrl+left, right</b>, <b>+ −</b></td><td>roll by 5°, zoom</td></tr>
    <tr><td><b>Double click</b></td><td>centre the surface point</td></tr>
    <tr><td><b>Click on the cube</b></td><td>view from that side</td></tr>
    <tr><td><b>1 2 3 4 5 6</b></td><td>view from anterior, posterior, left, right, superior, inferior (unknown orientation: front, back, +X, −X, above, below)</td></tr>
    <tr><td><b>R</b>, <b>F</b>, <b>O</b></td><td>reset view, zoom to fit, orthographic</td></tr>
    <tr><td><b>L</b>, <b>Shift+L</b></td><td>next, previous look</td></tr>
    <tr><td><b>Space</b></td><td>animate the flow, stop it</td></tr>
    <tr><td><b>T</b></td><td>play the time steps, pause</td></tr>
    <tr><td><b>Right click</b>, <b>Menu key</b></td><td>hide or keep the piece under the pointer</td></tr>
    <tr><td><b>P</b>, <b>M</b>, <b>Shift+M</b></td><td>pin, distance, geodesic distance</td></tr>
    <tr><td><b>Click</b>, <b>Shift+click</b></td><td>set a point, add more points (measuring)</td></tr>
    <tr><td><b>Backspace</b>, <b>Esc</b></td><td>remove the last point, end measuring</td></tr>
    <tr><td><b>C</b>, <b>Shift+C</b>, <b>Shift+X</b></td><td>clip plane facing the viewer, reverse the last plane, remove all</td></tr>
    <tr><td><b>Handles of cuts</b></td><td>drag: move, turn (Ctrl: snap; Esc: cancel); wheel: step by a voxel; right click: menu</td></tr>
    <tr><td><b>Handles of lights</b></td><td>drag: move (Ctrl, wheel: distance); outline: radius</td></tr>
    <tr><td><b>Shift+right drag</b></td><td>turn the environment</td></tr>
    <tr><td colspan="2"><h4>Slices</h4></td></tr>
    <tr><td><b>Click</b>, <b>drag</b>, <b>arrows</b></td><td>move the crosshair (or click the surface)</td></tr>
    <tr><td><b>Wheel</b>, <b>Page Up</b>, <b>Page Down</b></td><td>step by a voxel (moves the cut that the slice shows)</td></tr>
    <tr><td><b>Right drag</b></td><td>level (vertical) and width (horizontal)</td></tr>
    <tr><td><b>Right click</b>, <b>Menu key</b></td><td>plane, slab, CT windows, contours</td></tr>
    <tr><td><b>Middle drag</b>, <b>Shift+left drag</b>, <b>Shift+arrows</b></td><td>pan</td></tr>
    <tr><td><b>Ctrl+wheel</b>, <b>+ −</b></td><td>zoom</td></tr>
    <tr><td><b>Double click</b>, <b>Home</b></td><td>whole slice</td></tr>
    <tr><td colspan="2"><h4>Histogram</h4></td></tr>
    <tr><td><b>Drag</b>, <b>click</b></td><td>set the isovalue</td></tr>
    <tr><td><b>Wheel</b>, <b>arrows</b>, <b>Page Up</b>, <b>Page Down</b></td><td>fine steps (Shift: tenfold)</td></tr>
    <tr><td><b>Alt+click</b>, <b>right click</b></td><td>add an isosurface, menu</td></tr>
    <tr><td><b>Double click</b></td><td>suggested isovalue</td></tr>
    <tr><td><b>Ctrl+wheel</b>, <b>middle drag</b></td><td>zoom, pan the value axis</td></tr>
    <tr><td colspan="2"><h4>Window</h4></td></tr>
    <tr><td><b>Ctrl+N</b>, <b>Ctrl+O</b>, <b>Ctrl+Shift+O</b>, <b>Ctrl+Shift+D</b></td><td>new window, open a file, a folder, DICOM browser</td></tr>
    <tr><td><b>Ctrl+S</b>, <b>Ctrl+Shift+S</b></td><td>save session, save as</td></tr>
    <tr><td><b>Ctrl+E</b>, <b>Ctrl+C</b>, <b>Ctrl+Shift+C</b></td><td>save the image, copy it, copy its command line</td></tr>
    <tr><td><b>Ctrl+R</b></td><td>start, stop recording</td></tr>
    <tr><td><b>Ctrl+Z</b>, <b>Ctrl+Shift+Z</b></td><td>undo, redo</td></tr>
    <tr><td><b>Ctrl+F</b>, <b>Ctrl+,</b></td><td>find a setting, preferences</td></tr>
    <tr><td><b>Delete</b></td><td>delete selected measurements (panel <i>Measure</i>)</td></tr>
    <tr><td><b>F4</b></td><td>next layout: 3-D view, with slices, slices alone</td></tr>
    <tr><td><b>Ctrl+0</b>, <b>Ctrl+1 … 7</b></td><td>go to the 3-D view, to a panel</td></tr>
    <tr><td><b>F6</b>, <b>Shift+F6</b></td><td>next, previous part of the window</td></tr>
    <tr><td><b>F1</b>, <b>F11</b>, <b>Ctrl+Q</b></td><td>help, full screen (Esc: back), quit</td></tr>
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
          .arg(QString::fromUtf8(app::version()), viewport_->description().toHtmlEscaped(),
               QString(qVersion())));
  box->setModal(false);
  box->show();
}

}  // namespace isolux::ui
