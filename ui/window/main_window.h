// The window: picture, isovalue, settings and facts about the volume, all fed by one Document.
#pragma once

#include <filesystem>
#include <vector>

#include <QAction>
#include <QMainWindow>

#include "app/commands/command_line.h"
#include "app/interaction/surface_pick.h"
#include "app/presets/preset.h"
#include "render/graph/frame.h"
#include "scene/machine.h"
#include "ui/document/document.h"

class QActionGroup;
class QComboBox;
class QLabel;
class QMenu;
class QSessionManager;
class QShortcut;

namespace isolux::ui {

class BakedLight;
class DocumentKeeper;
class IsovaluePanel;
class LightStatus;
class LoadCard;
class MarkReports;
class MessageBar;
class Panel;
class PointedPiece;
class SliceBoard;
class Viewport;

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
  // From now on the document is autosaved in `folder`; offers to continue what a killed window has left
  // there.
  void keepDocument(const std::filesystem::path& folder);
  // The desktop's session ends: asks about unsaved work where that is allowed, and may hold up the end.
  void commitData(QSessionManager& manager);
  // The same without the manager: whether the session may end.
  bool endSession(bool mayAsk);

  const scene::Machine& machine() const { return machine_; }
  Document* document() const { return document_; }
  DocumentKeeper* keeper() const { return keeper_; }  // null until keepDocument()
  Viewport* viewport() const { return viewport_; }
  SliceBoard* slices() const { return slices_; }
  IsovaluePanel* isovaluePanel() const { return isovalue_; }
  template <class P>
  P* panel() const {  // of ui/panels/panel.h
    return findChild<P*>();
  }
  QComboBox* lookChoice() const { return look_; }
  MessageBar* messageBar() const { return message_; }
  LoadCard* loadCard() const { return loadCard_; }
  BakedLight* light() const { return light_; }
  LightStatus* lightStatus() const { return lightStatus_; }

  QMenu* presetsMenu() const { return presetsMenu_; }
  // A shell command that draws the picture as it is saved; empty without a volume.
  QString commandText() const;

  // .png or .exr; tells what was saved, or why not.
  bool savePicture(const QString& file, bool withSession = true);
  // Marks as .csv or .mrk.json; tells what was saved, or why not.
  bool exportMarks(const QString& file);
  bool importMarks(const QString& file);  // adds those of a .mrk.json
  const MarkReports* marks() const { return marks_; }
  static const char* helpText();        // HTML, English: mouse and keys
  void showPanel(const QString& name);  // in front of the others

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QAction* newAction(QMenu* menu, const QString& text, const QString& iconName, const QKeySequence& keys,
                     const QString& tip);
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeMeasureMenu();
  void makePresetsMenu();
  void makeHelpMenu();
  void nameViews();
  void makeToolBar();
  void makePanels();
  void connectDocument();
  void connectLight();
  void connectMarks();
  void applyEdit(const Edit& edit);
  void endGesture();
  void tellOfMoving();
  void showScene(const scene::Scene& scene, const scene::Scene& resolved);
  void showState();  // title, undo names, recording: what stateChanged() announces
  void showPointed(const std::optional<app::Pick>& pick);
  void showPointedText();
  // What can be done with the piece under a place of the picture.
  void showSurfaceMenu(const QPoint& onScreen, const std::optional<app::Pick>& pick);
  void choosePieces(const QString& name, const scene::Pieces& choice);
  QString shapeText(glm::dvec3 worldMm) const;  // curvatures, where they are there already
  void showRecent();

  void chooseMarksToExport();
  void chooseMarksToImport();
  void chooseFile();
  void chooseFolder();
  void chooseRaw(const QString& path);
  bool saveSession();
  bool saveSessionAs();
  bool saveSessionTo(const QString& file);
  QString proposedFile(const QString& suffix) const;
  void tellSaved(const QString& file, const QString& more);
  void tellRecorded();
  void offerLost();
  void choosePicture();
  void tracePicture();
  void toggleRecording();
  void toggleFullScreen(bool on);
  void chooseLook(int row);  // of look_
  void stepLook(int step);
  void findSetting();
  void showPresets();
  void applyPreset(const app::Preset& preset);
  void savePreset();
  void keepPresetAs(const QString& title);
  void copyCommand();
  void showPreferences();
  void setMachine(const scene::Machine& machine);
  void showHelp();
  void showAbout();
  // True when there is no unsaved work, or the user has saved or discarded it.
  bool mayDiscard();

  scene::Machine machine_;  // as kept, and as --set says for this run
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
  struct Docked {
    QDockWidget* dock;
    Panel* panel;
  };
  std::vector<Docked> panels_;
  QMenu *recentMenu_ = nullptr, *presetsMenu_ = nullptr;
  QAction *open_, *openFolder_, *save_, *saveAs_, *picture_, *trace_, *record_;
  QAction *undo_, *redo_, *reset_, *fit_, *projection_, *fullScreen_, *animate_, *fourUp_, *copyCommand_;
  QAction *exportMarks_, *importMarks_;
  QActionGroup* markTools_;
  QMenu* measureMenu_ = nullptr;
  QComboBox* look_;
  QShortcut* leaveFullScreen_ = nullptr;  // Esc
  QByteArray layoutBefore_;               // full screen: which panels were open
  std::vector<QAction*> views_;
  PointedPiece* pointedPiece_;
  QString pointedText_;  // without the piece
  QLabel *pointedLabel_, *recordingLabel_, *frameLabel_;
  bool awaitsFirstPicture_ = false;
  bool tellsOfMoving_ = false;  // once the gesture has ended: the environment was turned for the first time
};

}  // namespace isolux::ui
