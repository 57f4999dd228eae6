#include "ui/window/main_window.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QSignalBlocker>
#include <QStatusBar>

#include "app/documents/import_notes.h"
#include "app/documents/session.h"
#include "scene/looks.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/dicom_browser/folder_opener.h"
#include "ui/dicom_browser/recent_menu.h"
#include "ui/document/baked_light.h"
#include "ui/document/environment_edit.h"
#include "ui/document/mark_reports.h"
#include "ui/document/picture_request.h"
#include "ui/document/preferences.h"
#include "ui/document/privacy.h"
#include "ui/editors/elided_label.h"
#include "ui/language/number_text.h"
#include "ui/levels/full_resolution_view.h"
#include "ui/levels/level_marks.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/labels_panel.h"
#include "ui/panels/light_status.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/passes_panel.h"
#include "ui/panels/pieces_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/panels/volume_panel.h"
#include "ui/presets/looks_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/theme/style.h"
#include "ui/viewport/pointed_piece.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/picture_dot.h"
#include "ui/widgets/time_left.h"
#include "ui/window/load_card.h"
#include "ui/window/message_bar.h"
#include "ui/window/window_layout.h"
#include "volume/read/reader.h"

namespace isolux::ui {

namespace {
constexpr auto openHint =
    QT_TRANSLATE_NOOP("QObject", "Open a volume with Ctrl+O, or drop a file or folder here");
constexpr int panelWidth = 350;  // pixels, at first

// The window makes, docks and feeds all panels from a table, and knows none of them by name.
struct PanelInfo {
  const char* name;   // in saved layouts, for showPanel() and --panel; never translated
  const char* title;  // on its tab and in the View menu
  Panel* (*make)(QWidget* parent);
  bool atFirst = true;  // shown before the user has chosen; the rest waits in the View menu
};

template <class P>
Panel* makePanel(QWidget* parent) {
  return new P(parent);
}

// From left to right; the first is in front when the window opens.
constexpr PanelInfo panelTable[] = {
    {"Settings", QT_TRANSLATE_NOOP("QObject", "Settings"), makePanel<SettingsPanel>},
    {"Looks", QT_TRANSLATE_NOOP("QObject", "Looks"), makePanel<LooksPanel>},
    {"Marks", QT_TRANSLATE_NOOP("QObject", "Measure"), makePanel<MarksPanel>},
    {"Volume", QT_TRANSLATE_NOOP("QObject", "Volume"), makePanel<VolumePanel>},
    {"Labels", QT_TRANSLATE_NOOP("QObject", "Labels"), makePanel<LabelsPanel>, false},
    {"Pieces", QT_TRANSLATE_NOOP("QObject", "Pieces"), makePanel<PiecesPanel>},
    {"Passes", QT_TRANSLATE_NOOP("QObject", "Timing"), makePanel<PassesPanel>},
    {"Accuracy", QT_TRANSLATE_NOOP("QObject", "Accuracy"), makePanel<AccuracyPanel>, false}};

// What the user has written on pictures lately, where a new document says nothing of it.
void writeOnPictures(app::WindowRequest& request) {
  const auto written = [](scene::Scene scene) {
    if (scene.picture == asInWindow(scene.picture)) scene.picture = withKeptWords(scene.picture);
    return scene;
  };
  request.scene = written(request.scene);
  if (request.completed)
    request.completed = [written, completed = request.completed](const volume::PreparedVolume& volume) {
      return written(completed(volume));
    };
}
}  // namespace

QSize firstWindowSize(QSize available) {
  constexpr QSize wanted(1280, 800), frame(16, 44);  // title bar and borders of usual window managers
  return wanted.boundedTo(available - frame);
}

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      document_(new Document(this)),
      light_(new BakedLight(this)),
      marks_(new MarkReports(this)),
      viewport_(new Viewport(this)),
      slices_(new SliceBoard(viewport_, this)),
      isovalue_(new IsovaluePanel(this)),
      message_(new MessageBar(slices_)),
      loadCard_(new LoadCard(slices_)),
      lightStatus_(new LightStatus(this)),
      levelMarks_(new LevelMarks(this)),
      fullResolution_(new FullResolutionView(this)),
      pointedPiece_(new PointedPiece(this)),
      folders_(new FolderOpener(
          this, [this](const QString& folder, const QString& series) { openSeries(folder, series); })),
      recentPictures_(new RecentPictures(viewport_)),
      pointedLabel_(new ElidedLabel(this)),
      coarseLabel_(new ElidedLabel(this)),
      recordingLabel_(new QLabel(this)),
      pictureDot_(new PictureDot(this)) {
  setAcceptDrops(true);
  setWindowTitle("Isolux[*]");
  resize(firstWindowSize(screen()->availableSize()));
  layout_ = new WindowLayout(this, slices_, viewport_);
  makePanels();
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeMeasureMenu();
  makeCutMenu();
  makePresetsMenu();
  makeHelpMenu();
  makeToolBar();
  connectDocument();
  connectOpening();
  connectLight();
  connectMarks();
  connectSlices();
  connectLooks();
  setHostSettings(savedHostSettings());
  showScene(document_->scene(), document_->resolvedScene());
  viewport_->setHint(QObject::tr(openHint));
  showState();
  viewport_->setFocus();
  layout_->restore();
}

MainWindow::~MainWindow() = default;

void MainWindow::makePanels() {
  auto* centre = new QWidget(this);
  layOut(centre, columnOf({{slices_, 1}, isovalue_}, 0), {});
  setCentralWidget(centre);

  for (const PanelInfo& info : panelTable) {
    auto* dock = new QDockWidget(QObject::tr(info.title), this);
    Panel* const panel = info.make(dock);
    dock->setObjectName(info.name);
    dock->setWidget(panel);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    if (!panels_.empty()) tabifyDockWidget(panels_.back().dock, dock);
    panels_.push_back({dock, panel});
    layout_->addDock(dock);
    dock->setVisible(info.atFirst);
  }
  panels_.front().dock->raise();
  resizeDocks({panels_.front().dock}, {panelWidth}, Qt::Horizontal);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  setDocumentMode(true);

  static_cast<ElidedLabel*>(coarseLabel_)->keepFirstPart();
  setInk(coarseLabel_, Ink::warning);
  coarseLabel_->setContentsMargins(10, 0, 10, 0);
  setInk(recordingLabel_, Ink::error);
  recordingLabel_->setContentsMargins(10, 0, 10, 0);
  pointedLabel_->setContentsMargins(10, 0, 0, 0);
  statusBar()->addWidget(pointedLabel_, 1);
  // The text under the pointer gives way, so that the window can be as narrow as before.
  pointedLabel_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addPermanentWidget(coarseLabel_);
  statusBar()->addPermanentWidget(lightStatus_);
  statusBar()->addPermanentWidget(recordingLabel_);
  statusBar()->addPermanentWidget(pictureDot_);
  statusBar()->setSizeGripEnabled(false);
  // Whatever comes and goes in it, the picture above keeps its size.
  statusBar()->setFixedHeight(std::max(28, fontMetrics().height() + 12));
}

void MainWindow::connectDocument() {
  connect(document_, &Document::volumeChanged, this, [this](const VolumePointer& volume) {
    pointedPiece_->point(volume, {}, std::nullopt);
    isovalue_->setVolume(volume);
    light_->setVolume(volume);
    marks_->setVolume(volume);
    viewport_->setVolume(volume);
    play_->setEnabled(volume->volume.timeSteps > 1);
    slices_->setVolume(volume);
    for (const Docked& docked : panels_) docked.panel->setVolume(volume);
    nameViews();
    if (!document_->playing()) awaitsFirstPicture_ = true;
    levelMarks_->forget();
    const glm::ivec3 dims = volume->grid().dims();
    if (std::min({dims.x, dims.y, dims.z}) == 1 && !slices_->slicesShown())  // which has no surface
      slices_->arrange(ViewLayout::fourUp);
    if (!showLabels(volume) && !document_->playing()) tellImport(volume->volume.warnings);
  });
  connect(document_, &Document::sceneChanged, this, &MainWindow::showScene);
  connect(document_, &Document::flowMoved, viewport_, &Viewport::setFlowTime);
  auto* const volumePanel = panel<VolumePanel>();
  connect(document_, &Document::playingChanged, volumePanel, &VolumePanel::setPlaying);
  connect(document_, &Document::playingChanged, play_, &QAction::setChecked);
  connect(volumePanel, &VolumePanel::playClicked, this, &MainWindow::togglePlay);
  connect(volumePanel, &VolumePanel::speedChanged, this, [this](double speed) {
    if (document_->playing()) document_->play(speed);
  });
  connect(viewport_, &Viewport::derivativesChosen, document_, &Document::announce);
  connect(document_, &Document::stateChanged, this, &MainWindow::showState);
  connect(document_, &Document::loadStarted, this, [this](const QString& name) {
    message_->clear();
    viewport_->setHint({});
    loadCard_->begin(savedPrivacy().hideOnScreen ? tr("a volume") : name);
    const scene::Scene& coming = document_->loadingScene();
    const bool isNew = !document_->volume() || coming.source.path != document_->scene().source.path;
    if (isNew) loadCard_->lookAt(coming);
  });
  connect(document_, &Document::loadProgress, loadCard_, &LoadCard::report);
  connect(document_, &Document::loadEnded, this, [this] {
    loadCard_->end();
    viewport_->setHint(QObject::tr(openHint));
  });
  connect(document_, &Document::volumeMissing, this, &MainWindow::askForVolume);
  connect(document_, &Document::rawDescriptionNeeded, this, &MainWindow::chooseRaw);
  connect(loadCard_, &LoadCard::cancelled, document_, &Document::cancelLoading);

  connect(document_, &Document::failed, message_, &MessageBar::showError);
  connect(viewport_, &Viewport::failed, message_, &MessageBar::showError);

  connect(viewport_, &Viewport::resized, document_, [this] {
    const glm::ivec2 pixels = viewport_->pixelSize();
    document_->setPicture(pixels, Viewport::letterEdges(pixels, viewport_->devicePixelRatioF()));
  });
  viewport_->setFacts([this]() -> const scene::VolumeFacts& {
    document_->frameShown();
    return document_->facts();
  });
  connect(message_, &MessageBar::heightTaken, viewport_, &Viewport::setTopInset);
  connect(viewport_, &Viewport::noted, message_, &MessageBar::showNote);
  connect(viewport_, &Viewport::edited, this, &MainWindow::applyViewEdit);
  connect(viewport_, &Viewport::gestureEnded, this, &MainWindow::endGesture);
  connect(viewport_, &Viewport::pointed, this, &MainWindow::showPointed);
  connect(viewport_, &Viewport::menuAsked, this, &MainWindow::showSurfaceMenu);
  connect(pointedPiece_, &PointedPiece::changed, this, &MainWindow::showPointedText);
  connect(viewport_, &Viewport::drawn, this, [this](double milliseconds, bool complete) {
    pictureDot_->setDrawn(milliseconds, complete);
    if (awaitsFirstPicture_) {
      awaitsFirstPicture_ = false;
      for (const Docked& docked : panels_) docked.panel->setFirstPicture(document_->secondsSinceRead());
      showState();  // the title names what is on show
    }
  });
  connect(viewport_, &Viewport::drawing, pictureDot_, &PictureDot::setDrawing);
  connect(isovalue_, &IsovaluePanel::edited, document_, &Document::edit);
  const auto begin = [this] {
    viewport_->setInteracting(true);
    slices_->setInteracting(true);
  };
  const auto end = [this] {
    viewport_->setInteracting(false);
    endGesture();
    slices_->setInteracting(false);
  };
  connect(isovalue_, &IsovaluePanel::dragStarted, this, begin);
  connect(isovalue_, &IsovaluePanel::dragEnded, this, end);
  connect(viewport_, &Viewport::canvasChanged, this,
          [this] { panel<PassesPanel>()->setCanvas(viewport_->canvas()); });
  for (const Docked& docked : panels_) {
    connect(viewport_, &Viewport::reported, docked.panel, &Panel::setReport);
    connect(docked.panel, &Panel::failed, message_, &MessageBar::showError);
    connect(docked.panel, &Panel::edited, this, &MainWindow::applyEdit);
    connect(docked.panel, &Panel::dragStarted, this, begin);
    connect(docked.panel, &Panel::dragEnded, this, end);
  }
}

void MainWindow::togglePlay() {
  if (document_->playing())
    document_->pause();
  else
    document_->play(panel<VolumePanel>()->speed());
  play_->setChecked(document_->playing());  // nothing plays while another volume is loaded
}

// The gravest, and how many there are. What tells of missing data stays.
void MainWindow::tellImport(const std::vector<std::string>& warnings) {
  message_->withdraw(MessageBar::Kind::warning);
  if (warnings.empty()) return;
  const app::ImportNotes sorted = app::importNotes(warnings);
  const QString all = warnings.size() == 1 ? tr("also") : tr("all %1 warnings").arg(warnings.size());
  message_->show(sorted.grave > 0 ? MessageBar::Kind::warning : MessageBar::Kind::note,
                 tr("%1 (%2 in the Volume panel)").arg(QString::fromStdString(sorted.notes.front()), all));
}

void MainWindow::connectLight() {
  connect(viewport_, &Viewport::drawing, light_, &BakedLight::setDrawing);
  connect(viewport_, &Viewport::drawn, light_, &BakedLight::setDrawn);
  connect(viewport_, &Viewport::seen, light_, &BakedLight::setVisible);
  connect(light_, &BakedLight::lightChanged, viewport_, &Viewport::setLight);
  connect(light_, &BakedLight::stateChanged, lightStatus_, &LightStatus::setState);
  connect(light_, &BakedLight::stateChanged, pictureDot_,
          [this](const app::LightState& state, bool cancelled) {
            using Phase = app::LightState::Phase;
            const bool works = state.phase == Phase::preparing || state.phase == Phase::baking;
            pictureDot_->setLight(unfinishedLightSentence(state, cancelled), works && !cancelled);
          });
  connect(light_, &BakedLight::failed, message_, &MessageBar::showError);
  connect(light_, &BakedLight::noted, message_, &MessageBar::showNote);
  connect(light_, &BakedLight::takesLong, this, [this](double seconds) {
    message_->show(MessageBar::Kind::question,
                   tr("Light for this image takes about %1").arg(durationText(seconds)),
                   {{tr("Compute light"), [this] { light_->goOn(); }}});
  });
  connect(light_, &BakedLight::answered, this, [this] { message_->withdraw(MessageBar::Kind::question); });
  connect(lightStatus_, &LightStatus::paused, light_, [this] { light_->setPaused(true); });
  connect(lightStatus_, &LightStatus::goOn, light_, &BakedLight::goOn);
  connect(lightStatus_, &LightStatus::cancelled, light_, &BakedLight::cancel);
}

void MainWindow::applyEdit(const Edit& edit) {
  const bool moves = letsEnvironmentMove(document_->scene(), edit);
  document_->edit(edit);
  if (!moves) return;
  tellsOfMoving_ = true;
  if (edit.endsAfterPause) tellOfMoving();
}

// Not during a drag: the bar would move the picture away under the pointer.
void MainWindow::tellOfMoving() {
  if (!std::exchange(tellsOfMoving_, false)) return;
  message_->showNote(
      tr("Light is computed again for a rotatable environment; after that, turning it needs no "
         "new computation"));
}

void MainWindow::endGesture() {
  document_->endGesture();
  tellOfMoving();
}

bool MainWindow::attempt(const std::function<void()>& work, const QString& cancelled) {
  try {
    work();
    return true;
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::interrupted)
      message_->showError(QString::fromStdString(error.what()));
    else if (!cancelled.isEmpty())
      message_->showNote(cancelled);
    return false;
  }
}

void MainWindow::open(const app::WindowRequest& request) {
  attempt([&] {
    scene::HostSettings host = host_;
    for (const std::string& assignment : request.host) scene::applyAssignment(host, assignment);
    setHostSettings(host);
    app::WindowRequest wanted = request;
    if (request.sessionFile.empty()) writeOnPictures(wanted);
    scene::Scene scene = wanted.scene;
    const QString path = QString::fromStdString(scene.source.path);
    const bool builtIn = path.startsWith("phantom:");
    if (!builtIn) scene.source.path = QFileInfo(path).absoluteFilePath().toStdString();
    const bool describesItself = !request.sessionFile.empty() || !scene.source.raw.empty() || builtIn ||
                                 !volume::needsRawDescription(scene.source.path);
    if (describesItself)
      openRequested(wanted, scene);
    else
      chooseRaw(QString::fromStdString(scene.source.path));
    // Not before: what opening begins with takes the message away that it cannot be recorded.
    if (!request.recordFile.empty()) document_->startRecording(QString::fromStdString(request.recordFile));
  });
}

void MainWindow::showScene(const scene::Scene& scene, const scene::Scene& resolved) {
  isovalue_->setScene(scene, resolved);
  light_->setScene(resolved);
  viewport_->setScene(scene, resolved);
  slices_->setScene(scene, resolved);
  tellLinked();
  for (const Docked& docked : panels_) docked.panel->setScene(scene, resolved);
  marks_->setScene(resolved);
  projection_->setChecked(scene.camera.projection == scene::Projection::orthographic);
  animate_->setEnabled(scene::showsFlow(scene));
  animate_->setChecked(scene.flow.animate);
  const QSignalBlocker block(look_);
  look_->setCurrentIndex(static_cast<int>(&scene::lookInfo(scene.look.mode) - scene::looks().data()));
}

// That what is shown is a coarser level of the volume, and what is known of what it hides.
void MainWindow::showLevel() {
  const int level = document_->volume() ? document_->shownLevel() : 0;
  markLevel_->setEnabled(level > 0);
  drawFullResolution_->setEnabled(level > 0);
  QStringList text, tip;
  const auto add = [](QStringList& to, const QString& what) {
    if (!what.isEmpty()) to += what;
  };
  const bool incomplete = document_->volume() && !document_->volume()->volume.damage.empty();
  if (incomplete) text += tr("Parts missing");
  if (level > 0)
    text += fullResolution_->shows() ? tr("Full resolution (level %1 in motion)").arg(level)
                                     : tr("Overview: level %1").arg(level);
  if (incomplete || level > 0) {  // of each the volume has a note, before all others
    const std::vector<std::string>& notes = document_->volume()->volume.warnings;
    const std::size_t count = (incomplete ? 1 : 0) + (level > 0 ? 1 : 0);
    for (std::size_t i = 0; i < std::min(count, notes.size()); ++i) tip += QString::fromStdString(notes[i]);
  }
  if (level > 0 && !fullResolution_->shows()) {
    add(text, levelMarks_->text());
    add(tip, levelMarks_->meaning());
  }
  if (level > 0) {
    add(text, fullResolution_->text());
    add(tip, fullResolution_->meaning());
  }
  coarseLabel_->setText(text.join(" · "));
  coarseLabel_->setToolTip(tip.join("\n\n"));
}

void MainWindow::showState() {
  const bool pictureComes =
      awaitsFirstPicture_ && viewport_->isVisible() && !isMinimized() && !viewport_->problem();
  const QString name = shownText(document_->name(), document_->volume());
  if (!pictureComes) setWindowTitle(name.isEmpty() ? "Isolux[*]" : name + "[*] – Isolux");
  // What closing would ask about: a turned view alone is no work.
  setWindowModified(document_->modified() &&
                    app::asksBeforeDiscarding(document_->unsavedWork(), !document_->sessionFile().isEmpty()));
  const app::History& history = document_->history();
  undo_->setEnabled(history.canUndo());
  redo_->setEnabled(history.canRedo());
  undo_->setText(history.canUndo() ? tr("&Undo %1").arg(QString::fromStdString(history.undoName()))
                                   : tr("&Undo"));
  redo_->setText(history.canRedo() ? tr("&Redo %1").arg(QString::fromStdString(history.redoName()))
                                   : tr("&Redo"));
  const bool loaded = document_->volume() != nullptr;
  for (QAction* action : ofVolume_) action->setEnabled(loaded);
  exportMarks_->setEnabled(!document_->scene().marks.empty());
  presetsMenu_->setEnabled(loaded);
  showLevel();
  const bool recording = document_->recording();
  record_->setText(recording ? tr("Stop &recording") : tr("Start &recording…"));
  record_->setChecked(recording);
  recordingLabel_->setText(recording ? tr("● Recording") : "");
}

// Of a label map the list of labels takes the place of the histogram. Returns whether only other labels are
// shown.
bool MainWindow::showLabels(const VolumePointer& volume) {
  const auto blocks = volume->labels ? volume->labels->blocks : nullptr;
  if (blocks && blocks == labelBlocks_) return true;
  isovalue_->setVisible(!blocks);
  if (blocks) showPanel("Labels");
  if (!blocks && labelBlocks_) panel<LabelsPanel>()->parentWidget()->hide();
  labelBlocks_ = blocks;
  return false;
}

void MainWindow::showPanel(const QString& name) {
  for (const Docked& docked : panels_) {
    if (docked.dock->objectName().compare(name, Qt::CaseInsensitive) != 0) continue;
    docked.dock->show();
    docked.dock->raise();
  }
}

}  // namespace isolux::ui
