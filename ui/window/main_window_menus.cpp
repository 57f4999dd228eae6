// The menus and the tool bar of ui/window/main_window.h.

#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QToolButton>
#include <QWidgetAction>

#include "scene/looks.h"
#include "scene/rules/quality.h"
#include "scene/settings/settings.h"
#include "ui/dicom_browser/recent_menu.h"
#include "ui/document/privacy.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/levels/level_marks.h"
#include "ui/panels/marks_panel.h"
#include "ui/theme/icons.h"
#include "ui/viewport/cut_menu.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/fitting_tool_bar.h"
#include "ui/widgets/parts.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "ui/window/window_layout.h"
#include "volume/phantom/phantom.h"

namespace isolux::ui {

QAction* MainWindow::newAction(QMenu* menu, const QString& text, const QString& iconName,
                               const QKeySequence& keys, const QString& tip) {
  QAction* action = menu->addAction(text);
  if (!iconName.isEmpty()) action->setIcon(icon(iconName));
  action->setShortcut(keys);
  action->setIconVisibleInMenu(false);
  const QString shortcut = keys.toString(QKeySequence::NativeText);
  action->setToolTip(shortcut.isEmpty() ? tip : QString("%1 (%2)").arg(tip, shortcut));
  return action;
}

QAction* MainWindow::needsVolume(QAction* action) {
  ofVolume_.push_back(action);
  return action;
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  newAction(menu, tr("&New window"), "", QKeySequence::New, tr("Open another window, to compare volumes"),
            this, &MainWindow::newWindow);
  open_ = newAction(menu, tr("&Open…"), "open", QKeySequence::Open, tr("Open a volume, session or image"),
                    this, &MainWindow::chooseFile);
  openFolder_ =
      newAction(menu, tr("Open &folder (DICOM)…"), "folder", QKeySequence("Ctrl+Shift+O"),
                tr("Open a folder of DICOM files or numbered images"), this, &MainWindow::chooseFolder);
  newAction(menu, tr("&DICOM browser…"), "", QKeySequence("Ctrl+Shift+D"),
            tr("Choose from the patients, studies and series of a folder or disc"), this,
            &MainWindow::browseFolders);
  auto* recent = new RecentMenu(tr("Open re&cent"), menu);
  menu->addMenu(recent);
  connect(recent, &RecentMenu::chosen, this, &MainWindow::openRecent);
  connect(recent, &QMenu::aboutToShow, this, &MainWindow::keepShownPicture);
  QMenu* phantoms = menu->addMenu(tr("Open built-in &phantom"));
  phantoms->setToolTipsVisible(true);
  for (const volume::PhantomInfo& phantom : volume::phantoms()) {
    const QString name = QString::fromUtf8(phantom.name);
    QAction* action = phantoms->addAction(wordsOf(name), this, [this, name] { openPath("phantom:" + name); });
    action->setToolTip(translated(texts::phantoms, phantom.meaning));
  }
  menu->addSeparator();
  save_ = needsVolume(newAction(menu, tr("&Save session"), "save", QKeySequence::Save, tr("Save the session"),
                                this, &MainWindow::saveSession));
  needsVolume(newAction(menu, tr("Save session &as…"), "", QKeySequence("Ctrl+Shift+S"),
                        tr("Save the session elsewhere"), this, &MainWindow::saveSessionAs));
  picture_ = needsVolume(newAction(menu, tr("Save &image…"), "picture", QKeySequence("Ctrl+E"),
                                   tr("Save the image"), this, &MainWindow::choosePicture));
  needsVolume(newAction(menu, tr("Path-&trace image…"), "", {},
                        tr("Path-trace this view as a reference image without baked light"), this,
                        &MainWindow::tracePicture));
  needsVolume(newAction(menu, tr("Export &mesh…"), "", {},
                        tr("Export the isosurface as triangles, for 3-D printing and simulation"), this,
                        &MainWindow::chooseMesh));
  menu->addSeparator();
  record_ = newAction(menu, tr("Start &recording…"), "record", QKeySequence("Ctrl+R"),
                      tr("Record every change for `isolux replay`"), this, &MainWindow::toggleRecording);
  record_->setCheckable(true);
  menu->addSeparator();
  newAction(menu, tr("&Quit"), "", QKeySequence::Quit, tr("Quit Isolux"), qApp,
            &QApplication::closeAllWindows);
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  undo_ = newAction(menu, tr("&Undo"), "undo", QKeySequence::Undo, tr("Undo"), document_, &Document::undo);
  redo_ = newAction(menu, tr("&Redo"), "redo", QKeySequence::Redo, tr("Redo"), document_, &Document::redo);
  menu->addSeparator();
  QAction* copy = needsVolume(newAction(menu, tr("&Copy image"), "", QKeySequence::Copy,
                                        tr("Copy the image with the options of Save image"), this,
                                        &MainWindow::copyPicture));
  // Only while the picture has the focus: elsewhere it copies text.
  copy->setShortcutContext(Qt::WidgetShortcut);
  viewport_->addAction(copy);
  needsVolume(newAction(menu, tr("Copy as command &line"), "", QKeySequence("Ctrl+Shift+C"),
                        tr("Copy a shell command that renders this image"), this, &MainWindow::copyCommand));
  menu->addSeparator();
  newAction(menu, tr("&Find a setting"), "", QKeySequence::Find, tr("Find a setting by its name"), this,
            &MainWindow::findSetting);
  menu->addSeparator();
  newAction(menu, tr("&Preferences…"), "", QKeySequence("Ctrl+,"),
            tr("Set memory, threads and speed for this computer"), this, &MainWindow::showPreferences);
}

void MainWindow::makeViewMenu() {
  QMenu* menu = viewMenu_ = menuBar()->addMenu(tr("&View"));
  for (int i = 0; i < scene::standardViewCount; ++i)
    views_.push_back(
        needsVolume(newAction(menu, "", "", QKeySequence(QString::number(i + 1)), "", this, [this, i] {
          viewport_->applyStandardView(static_cast<scene::StandardView>(i));
        })));
  nameViews();
  menu->addSeparator();
  reset_ = needsVolume(newAction(menu, tr("&Reset view"), "reset_view", QKeySequence("R"),
                                 tr("Reset the view"), viewport_, &Viewport::resetView));
  fit_ = needsVolume(newAction(menu, tr("Zoom to &fit"), "fit", QKeySequence("F"),
                               tr("Fit the volume into the view"), viewport_, &Viewport::fitView));
  projection_ = needsVolume(newAction(menu, tr("&Orthographic"), "perspective", QKeySequence("O"),
                                      tr("Switch between perspective and orthographic projection"), viewport_,
                                      &Viewport::toggleProjection));
  projection_->setCheckable(true);
  menu->addSeparator();
  newAction(menu, tr("&Next look"), "", QKeySequence("L"), tr("Next look"), this, [this] { stepLook(1); });
  newAction(menu, tr("Pre&vious look"), "", QKeySequence("Shift+L"), tr("Previous look"), this,
            [this] { stepLook(-1); });
  makeQualityMenu(menu->addMenu(tr("Image &quality")));
  animate_ = newAction(menu, tr("&Animate flow"), "animate", QKeySequence("Space"),
                       tr("Start or stop the flow animation"), document_, &Document::toggleFlow);
  animate_->setCheckable(true);
  // Only while the picture has the focus: elsewhere the space bar presses buttons.
  animate_->setShortcutContext(Qt::WidgetShortcut);
  viewport_->addAction(animate_);
  play_ = newAction(menu, tr("&Play time steps"), "play", QKeySequence("T"),
                    tr("Play or pause the time steps"), this, &MainWindow::togglePlay);
  play_->setCheckable(true);
  play_->setEnabled(false);
  markLevel_ = newSwitch(menu, tr("&Mark structure lost in the overview"),
                         tr("Hatch where the coarser level shown may hide structure of the volume"),
                         levelMarks_->marking(), levelMarks_, &LevelMarks::setMarking);
  drawFullResolution_ =
      newSwitch(menu, tr("&Draw full resolution when idle"),
                tr("After the final image of a coarser level, draw full resolution from the "
                   "file; creates an index if there is none"),
                fullResolution_->wanted(), fullResolution_, &FullResolutionView::setWanted);
  menu->addSeparator();
  layout_->fillMenu(menu);
  link_ = newSwitch(menu, tr("Lin&k views of windows"),
                    tr("Link the views of all windows; untick it in a window to leave that window out"),
                    false, this, &MainWindow::setLinked);
  newAction(menu, tr("&Copy view to other windows"), "", {},
            tr("Show the volumes of all other windows from this view"), this, &MainWindow::useViewElsewhere);
  hidePatient_ = newSwitch(menu, tr("&Hide patient data"), tr("Show name, ID and birth date as “anonymous”"),
                           savedPrivacy().hideOnScreen, this, [this](bool hide) {
                             keepHiddenOnScreen(hide);
                             applyPrivacy();
                           });
  fullScreen_ = newSwitch(menu, tr("Full &screen"), tr("Switch to full screen; Esc leaves it"), false, this,
                          &MainWindow::toggleFullScreen, QKeySequence("F11"));
  leaveFullScreen_ = new QShortcut(QKeySequence(Qt::Key_Escape), this);
  leaveFullScreen_->setEnabled(false);
  connect(leaveFullScreen_, &QShortcut::activated, this, [this] { fullScreen_->setChecked(false); });
}

void MainWindow::makeQualityMenu(QMenu* menu) {
  for (const scene::Quality& quality : scene::qualities()) {
    QAction* action = menu->addAction(translated(texts::qualities, quality.title), this, [this, &quality] {
      document_->edit({scene::withQuality(document_->scene(), quality), tr("Change image quality")});
    });
    action->setStatusTip(translated(texts::qualities, quality.meaning));
    action->setCheckable(true);
    connect(menu, &QMenu::aboutToShow, action, [this, action, &quality] {
      action->setChecked(scene::withQuality(document_->scene(), quality) == document_->scene());
    });
  }
}

// By the volume's axes: "Anterior", or "−Y" where nobody says where the patient lies.
void MainWindow::nameViews() {
  const VolumePointer volume = document_->volume();
  const scene::WorldAxes axes = volume ? volume->volume.axes : scene::WorldAxes::anatomical;
  for (int i = 0; i < scene::standardViewCount; ++i) {
    QAction* action = views_[static_cast<std::size_t>(i)];
    const auto view = static_cast<scene::StandardView>(i);
    const QString name = translated(texts::views, scene::standardViewName(view, axes));
    action->setText(axes == scene::WorldAxes::anatomical ? name : tr("From %1").arg(name));
    action->setIconText(QString::fromStdString(scene::standardViewMark(view, axes)));
    action->setToolTip(tr("From %1 (%2)")
                           .arg(axes == scene::WorldAxes::anatomical ? name.toLower() : name,
                                action->shortcut().toString()));
  }
}

void MainWindow::makeCutMenu() {
  auto* const cuts = new CutMenu(menuBar()->addMenu(tr("&Cut")), this);
  connect(document_, &Document::volumeChanged, cuts, &CutMenu::setVolume);
  connect(document_, &Document::sceneChanged, cuts, &CutMenu::setScene);
  connect(cuts, &CutMenu::edited, this, &MainWindow::applyEdit);
  connect(cuts, &CutMenu::handlesShown, viewport_, &Viewport::setCutHandles);
  connect(cuts, &CutMenu::failed, message_, &MessageBar::showError);
  connect(viewport_, &Viewport::cutMenuAsked, cuts, &CutMenu::showMenuOf);
  cuts->setChosenMark([this] { return panel<MarksPanel>()->current(); });
  viewport_->setCutHandles(cuts->showsHandles());
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  newAction(menu, tr("Guided &tour"), "", {}, tr("Take a two-minute tour of the window"), this,
            &MainWindow::startTour);
  newAction(menu, tr("&Guide"), "", {}, tr("The documentation that comes with the program"), this,
            &MainWindow::showGuide);
  newAction(menu, tr("&Mouse and keys"), "", QKeySequence::HelpContents, tr("Mouse and keys"), this,
            &MainWindow::showHelp);
  newAction(menu, tr("&About Isolux"), "", {}, tr("Version and graphics"), this, &MainWindow::showAbout);
}

void MainWindow::makeToolBar() {
  auto* bar = new FittingToolBar(tr("Tools"), this);
  addToolBar(bar);
  bar->setObjectName("Tools");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  auto* measure = new QToolButton(bar);
  measure->setIcon(icon("measure"));
  nameAndTip(measure, tr("Measure"), tr("Pins and measurements: P, M, Shift+M"));
  measure->setPopupMode(QToolButton::InstantPopup);
  measure->setMenu(measureMenu_);
  look_ = new QComboBox(bar);
  nameAndTip(look_, tr("Look"), tr("Look: what the colours show (L, Shift+L: next, previous)"));
  look_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (const scene::LookInfo& look : scene::looks()) {
    look_->addItem(wordsOf(QString::fromUtf8(look.name)));
    look_->setItemData(look_->count() - 1, translated(texts::looks, look.meaning), Qt::ToolTipRole);
  }
  look_->setMaxVisibleItems(look_->count());
  connect(look_, &QComboBox::currentIndexChanged, this, &MainWindow::chooseLook);
  const auto actionOf = [bar](QWidget* widget) {
    auto* action = new QWidgetAction(bar);
    action->setDefaultWidget(widget);
    return action;
  };
  using enum FittingToolBar::Before;
  constexpr int stays = FittingToolBar::stays;
  bar->addGroup(stays, nothing, {open_});
  bar->addGroup(3, nothing, {openFolder_});
  bar->addGroup(stays, nothing, {save_, picture_});
  bar->addGroup(5, separator, {undo_, redo_});
  bar->addGroup(stays, separator, {reset_});
  bar->addGroup(1, nothing, {fit_, projection_});
  bar->addGroup(0, separator, {views_.begin(), views_.end()});  // the cube has them, too
  bar->addGroup(4, nothing, {actionOf(measure)});
  bar->addGroup(stays, separator, {actionOf(look_), presetsMenu_->menuAction()});
  if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(presetsMenu_->menuAction())))
    button->setPopupMode(QToolButton::InstantPopup);
  bar->addGroup(2, nothing, {animate_});
  bar->addGroup(stays, separator, {record_});
}

}  // namespace isolux::ui
