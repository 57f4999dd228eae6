// The window: picture, isovalue, settings and facts about the volume, all fed by one Document.
#pragma once

#include <filesystem>
#include <vector>

#include <QAction>
#include <QMainWindow>
#include <QPointer>

#include "app/commands/command_line.h"
#include "app/presets/preset.h"
#include "app/view_math/surface_pick.h"
#include "render/graph/frame.h"
#include "render/still_picture.h"
#include "scene/settings/host_settings.h"
#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/tour/tour.h"

class QActionGroup;
class QComboBox;
class QLabel;
class QMenu;
class QSessionManager;
class QShortcut;

namespace isolux::ui {

class BakedLight;
class DocumentKeeper;
class FolderOpener;
class IsovaluePanel;
class LevelMarks;
class FullResolutionView;
class LightStatus;
class LoadCard;
class MarkReports;
class MessageBar;
class Panel;
class PointedPiece;
struct PictureChoices;
struct PictureRequest;
class PictureDot;
class RecentPictures;
class SliceBoard;
class Viewport;
class WindowLayout;

// Of a window that was never opened before: 1280x800, or what the screen has room for. Pixels of the screen's
// scale.
QSize firstWindowSize(QSize available);

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  void open(const app::WindowRequest& request);
  // File, folder, session, picture with a session, or "phantom:NAME"; asks first for a raw file.
  void openPath(const QString& path);
  void openFiles(const QStringList& paths);
  // From now on the document is autosaved in `folder`; offers to continue what a killed window has left
  // there.
  void keepDocument(const std::filesystem::path& folder);
  // The desktop's session ends: asks about unsaved work where that is allowed, and may hold up the end.
  void commitData(QSessionManager& manager);
  // The same without the manager: whether the session may end.
  bool endSession(bool mayAsk);

  // What is in the folder decides: a series of several, which the user chooses, or the folder itself.
  void openFolder(const QString& folder);
  void openSeries(const QString& folder, const QString& series);  // asks about unsaved work
  MainWindow* newWindow();                       // empty, shown; deletes itself when it is closed
  void useViewElsewhere();                       // all other windows show their volumes as this one does
  QAction* linkAction() const { return link_; }  // checked: views of windows where it is go together
  void applyPrivacy();                           // the user's request has changed (ui/document/privacy.h)

  const scene::HostSettings& host() const { return host_; }
  Document* document() const { return document_; }
  DocumentKeeper* keeper() const { return keeper_; }  // null until keepDocument()
  Viewport* viewport() const { return viewport_; }
  SliceBoard* slices() const { return slices_; }
  template <class P>
  P* panel() const {  // the only one of its kind: a Panel, or another part of the window
    return findChild<P*>();
  }
  QComboBox* lookChoice() const { return look_; }
  MessageBar* messageBar() const { return message_; }
  BakedLight* light() const { return light_; }
  QLabel* coarseLabel() const { return coarseLabel_; }  // empty where the file's own voxels are shown

  QAction* markLevelAction() const { return markLevel_; }  // checked: what an overview hides is hatched
  QAction* fullResolutionAction() const { return drawFullResolution_; }  // checked: at rest level 0 is drawn

  QMenu* presetsMenu() const { return presetsMenu_; }
  // A shell command that draws the picture as it is saved; empty without a volume.
  QString commandText() const;

  // .png or .exr, of the size that was chosen last; tells what was saved, or why not.
  bool savePicture(const QString& file, bool withSession = true);
  bool copyPicture();  // into the clipboard; tells so
  // Marks as .csv or .mrk.json; tells what was saved, or why not.
  bool exportMarks(const QString& file);
  bool importMarks(const QString& file);  // adds those of a .mrk.json
  const MarkReports* marks() const { return marks_; }
  static const char* helpText();        // HTML, English: mouse and keys
  void showPanel(const QString& name);  // in front of the others
  void keepPresetAs(const QString& title);
  void greet();                         // three hints, to a user who has not seen them
  void startTour();                     // Help > Explore
  Tour* tour() const { return tour_; }  // null: none is running
  TourCard* greeting() const { return greeting_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  QAction* newAction(QMenu* menu, const QString& text, const QString& iconName, const QKeySequence& keys,
                     const QString& tip);
  // `slot` of `receiver` is called by its clicks.
  template <class Receiver, class Slot>
  QAction* newAction(QMenu* menu, const QString& text, const QString& iconName, const QKeySequence& keys,
                     const QString& tip, Receiver* receiver, Slot slot) {
    QAction* const action = newAction(menu, text, iconName, keys, tip);
    connect(action, &QAction::triggered, receiver, slot);
    return action;
  }
  // Checked or not, which `slot` is told by whatever changes it.
  template <class Receiver, class Slot>
  QAction* newSwitch(QMenu* menu, const QString& text, const QString& tip, bool on, Receiver* receiver,
                     Slot slot, const QKeySequence& keys = {}) {
    QAction* const action = newAction(menu, text, "", keys, tip);
    action->setCheckable(true);
    action->setChecked(on);
    connect(action, &QAction::toggled, receiver, slot);
    return action;
  }
  QAction* needsVolume(QAction* action);  // enabled while there is one
  bool showLabels(const VolumePointer& volume);
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeQualityMenu(QMenu* menu);
  void makeMeasureMenu();
  void makeCutMenu();
  void makePresetsMenu();
  void makeHelpMenu();
  void nameViews();
  void makeToolBar();
  void makePanels();
  void connectDocument();
  void connectLight();
  void togglePlay();
  void tellImport(const std::vector<std::string>& warnings);
  void connectMarks();
  void connectSlices();
  void moveCrosshair(glm::dvec3 worldMm);
  void showSlicesInPicture();
  void connectLooks();
  void tellAccuracy();                                     // its panel, and LevelMarks: what is on screen
  void preview(const std::optional<scene::Scene>& scene);  // none: the document's
  // Tells the error of what could not be done; of what the user has cancelled, this note.
  bool attempt(const std::function<void()>& work, const QString& cancelled = {});
  void applyEdit(const Edit& edit);
  void applyViewEdit(const Edit& edit);  // of the viewport
  void endGesture();
  void tellOfMoving();
  void showScene(const scene::Scene& scene, const scene::Scene& resolved);
  void showLevel();
  void showState();  // title, undo names, recording: what stateChanged() announces
  void showPointed(const std::optional<app::Pick>& pick);
  void showPointedText();
  // What can be done with the piece under a place of the picture.
  void showSurfaceMenu(const QPoint& onScreen, const std::optional<app::Pick>& pick);
  void choosePieces(const QString& name, const scene::Pieces& choice);
  QString shapeText(glm::dvec3 worldMm) const;  // curvatures, where they are there already
  void connectOpening();
  void openRecent(const RecentFile& file);
  void noteOpened(const QString& path);
  void keepShownPicture();    // of what is open, for the recent files
  void showRecentPictures();  // where no volume is open
  void browseFolders();
  void takeCamera(const MainWindow& other);
  void tellLinked();
  void setLinked(bool linked);
  void openRequested(const app::WindowRequest& request, const scene::Scene& scene);

  void chooseMarksToExport();
  void chooseMarksToImport();
  void chooseFile();
  void chooseFolder();
  void chooseRaw(const QString& path);
  void askForVolume(const scene::Scene& scene, const QString& sessionFile);
  bool saveSession();
  bool saveSessionAs();
  bool saveSessionTo(const QString& file);
  QString proposedFile(const QString& suffix) const;
  void tellSaved(const QString& file, const QString& more);
  void tellRecorded();
  void offerLost();
  void choosePicture();
  void chooseMesh();
  QImage previewOf(const PictureChoices& chosen) const;
  void takeChoices(const PictureChoices& chosen);
  scene::Scene pictureScene(const PictureRequest& asked) const;
  scene::Camera pictureCamera(QSize pixels, double ratio) const;  // of a picture of this size
  render::StillPicture finishedPicture(bool linear, const QString& what);
  void tracePicture();
  void toggleRecording();
  void toggleFullScreen(bool on);
  void chooseLook(int row);  // of look_
  void stepLook(int step);
  void findSetting();
  void showPresets();
  void applyPreset(const app::Preset& preset);
  void savePreset();
  void copyCommand();
  void showPreferences();
  void setHostSettings(const scene::HostSettings& host);
  QRect placeOfMenu(const QAction* menu) const;
  QRect placeOfTool(const QAction* action) const;
  void showHelp();
  void showGuide();
  void showAbout();
  // True when there is no unsaved work, or the user has saved or discarded it.
  bool mayDiscard();

  scene::HostSettings host_;  // as kept, and as --set says for this run
  Document* document_;
  DocumentKeeper* keeper_ = nullptr;
  BakedLight* light_;
  MarkReports* marks_;
  Viewport* viewport_;
  SliceBoard* slices_;
  IsovaluePanel* isovalue_;
  MessageBar* message_;
  LoadCard* loadCard_;
  LightStatus* lightStatus_;
  LevelMarks* levelMarks_;
  FullResolutionView* fullResolution_;
  struct Docked {
    QDockWidget* dock;
    Panel* panel;
  };
  std::shared_ptr<const volume::LabelBlocks> labelBlocks_;  // of the volume; null: it is no label map
  std::vector<Docked> panels_;
  QMenu *presetsMenu_ = nullptr, *viewMenu_ = nullptr;
  QAction *open_, *openFolder_, *save_, *picture_, *record_, *undo_, *redo_, *reset_, *fit_, *projection_,
      *fullScreen_, *animate_, *play_, *hidePatient_, *markLevel_, *drawFullResolution_, *exportMarks_,
      *link_ = nullptr;
  std::vector<QAction*> ofVolume_;  // needsVolume()
  QActionGroup* markTools_;
  QMenu* measureMenu_ = nullptr;
  QComboBox* look_;
  QShortcut* leaveFullScreen_ = nullptr;  // Esc
  WindowLayout* layout_;
  std::vector<QAction*> views_;
  PointedPiece* pointedPiece_;
  FolderOpener* folders_;
  RecentPictures* recentPictures_;
  scene::Camera toldCamera_;  // to windows that are linked
  bool follows_ = false;      // takes over a camera now
  RecentFile shownFile_;      // what is open, as the recent files have it
  QString pointedText_;       // without the piece
  QLabel *pointedLabel_, *coarseLabel_, *recordingLabel_;
  PictureDot* pictureDot_;
  QPointer<Tour> tour_;
  QPointer<TourCard> greeting_;
  QPointer<QWidget> help_, guide_;
  bool awaitsFirstPicture_ = false;
  bool previewing_ = false;     // the viewport shows a scene that is not the document's
  bool tellsOfMoving_ = false;  // once the gesture has ended: the environment was turned for the first time
};

}  // namespace isolux::ui
