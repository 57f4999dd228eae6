// The document: the Scene with its history, the volume on screen, and the loading of the next one.
//
// Everything the window shows comes from here by signals that carry values; every change of the Scene goes
// through edit(), undo() or redo(), so that history and recordings are complete. Lives on the GUI thread; a
// volume is loaded by a background task; nothing of it runs on a foreign thread.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "app/documents/autosave.h"
#include "app/documents/recording.h"
#include "app/documents/unsaved_work.h"
#include "app/overlay_text/free_rooms.h"
#include "app/tasks/load_task.h"
#include "app/tasks/step_ahead.h"
#include "app/tasks/step_player.h"
#include "scene/rules/automatic.h"
#include "scene/rules/flow_clock.h"
#include "ui/document/background_task.h"
#include "ui/document/edit.h"

namespace isolux::ui {

using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);
  const scene::Scene& scene() const { return history_.scene(); }
  // As it is on screen: an animated flow has moved on since scene().
  scene::Scene shownScene() const;
  // shownScene() with automatic settings filled in from the volume, as far as they are known.
  scene::Scene resolvedScene() const { return resolved(shownScene()); }
  scene::Scene resolved(const scene::Scene& scene) const;
  // Says how large the window's picture is, and what its letters take: a view that the user has not turned,
  // moved or zoomed is fitted to what is free (app::freeRooms()).
  void setPicture(glm::ivec2 pixels, const app::Edges& letters);
  // The view that a picture of this size has.
  scene::Camera cameraOf(glm::ivec2 pixels, const app::Edges& letters) const;
  // The resolved scene's, before it is fitted.
  scene::Camera camera() const { return scene::resolve(scene(), facts_).camera; }
  // Tells what automatic settings depend on. Automatic views frame the surface that was shown when it was
  // last exchanged in one go (loaded, by a preset, shown or hidden): they stay while its isovalue is dragged.
  const scene::VolumeFacts& facts() const { return facts_; }
  void frameShown();  // from now on the surface that is shown now
  void announce();    // says both again: more of what is automatic is known
  const VolumePointer& volume() const { return volume_; }
  const app::History& history() const { return history_; }

  bool loading() const { return bool(loading_); }
  const scene::Scene& loadingScene() const { return pendingScene_; }  // while loading(): of what comes
  bool recording() const { return recorder_ != nullptr; }
  const QString& recordingFile() const { return recordingFile_; }  // of the recording that runs, or ran last
  bool modified() const { return scene() != savedScene_; }
  app::UnsavedWork unsavedWork() const { return app::unsavedWork(savedScene_, scene()); }
  const QString& sessionFile() const { return sessionFile_; }  // empty: not saved yet; never a picture
  QString name() const;                                        // for the title bar
  // Since the volume's bytes were read; for the time to the first picture.
  int shownLevel() const { return volume_ ? loadedSource_.level : 0; }  // source.level of volume()
  double secondsSinceRead() const;

  // A volume, DICOM folder, "phantom:NAME[:SIZE]", session, or picture that carries a session. Keeps the
  // look; makes isovalues and camera automatic and leaves out cuts, hidden pieces, marks and what else is of
  // the volume before. `series`: of a DICOM folder with several. Emits rawDescriptionNeeded for a file
  // without a known header.
  void open(const QString& path, const QString& series = {});
  // Loads scene.source and then shows exactly this scene, with an empty history.
  // completed, where given, says the scene once the volume is there, as app::WindowRequest has it.
  // Emits volumeMissing where a session names a volume that is not there.
  using CompleteScene = std::function<scene::Scene(const volume::PreparedVolume&)>;
  void openScene(const scene::Scene& scene, const QString& sessionFile, CompleteScene completed = {});
  // Every setting but the view, the marks and what is the user's goes back to its default, as one step.
  void resetSettings();
  void openRaw(const QString& path, const QString& description);
  // All but the volume, as an autosave holds it.
  app::OpenDocument kept() const;
  // Loads the kept document's volume and goes on with its scene and undo list; then emits restored().
  void restore(const app::OpenDocument& kept);
  void cancelLoading();

  void edit(const Edit& edit);  // a changed source is loaded first and takes effect when it is there
  void endGesture();
  void undo();
  void redo();
  void toggleFlow();  // lets the flow move, or stand where it is seen
  // Shows one time step after the other, at this many steps per second. What is played is one undo step, and
  // part of the gesture that goes on meanwhile. Nothing for a volume of one step; another source ends it.
  void play(double stepsPerSecond);
  void pause();
  bool playing() const { return player_ != nullptr; }

  // Throws base::Error when `file` holds what the picture is made of: nothing is written over that.
  void checkOutput(const QString& file) const;
  bool saveSession(const QString& file);
  bool startRecording(const QString& file);
  void stopRecording();

 Q_SIGNALS:
  void volumeChanged(isolux::ui::VolumePointer volume);
  void sceneChanged(const isolux::scene::Scene& scene, const isolux::scene::Scene& resolved);
  void playingChanged(bool playing);
  void flowMoved(double seconds);  // to this flow.time; not an edit
  void stateChanged();             // history, modified mark, name, recording
  void loadStarted(const QString& name);
  void loadProgress(double fraction, const QString& stage);
  void loadEnded(bool success);
  void restored();
  void opened(const QString& path);  // for the recent files: a volume or session the user asked for
  void failed(const QString& message);
  void rawDescriptionNeeded(const QString& path);
  // What a session or picture shows is not where it says: nothing was opened.
  void volumeMissing(const isolux::scene::Scene& scene, const QString& sessionFile);

 private:
  // What to do when the volume is loaded.
  enum class After {
    replaceDocument,  // a new document shows pendingScene_
    restoreDocument,  // an autosaved one, pendingKept_, is continued
    editSource,       // one undoable step: another series, component or time step
    keepScene         // undo or redo came to another source; the scene says so already
  };
  void startLoading(const scene::Scene& scene, After after);
  void finishLoading(app::LoadTask& task);
  void keepLoadedSource();
  void completePending(const volume::PreparedVolume& volume);
  void replaceDocument();
  void restoreDocument();
  scene::Scene atLoadedStep() const;
  void changeSource(const volume::PreparedVolume& volume);
  // dragged: one edit of many.
  void commit(const scene::Scene& before, const QString& name, bool dragged = false);
  void step(const QString& name, scene::SceneDiff (app::History::*step)());
  void moveFlow();
  void movePlay();
  void showStep(const app::StepPlayer::Step& step);

  app::History history_;
  VolumePointer volume_;
  scene::VolumeFacts facts_;
  scene::Source loadedSource_;
  scene::Scene savedScene_;
  QString sessionFile_;

  BackgroundTask<app::LoadedVolume> loading_;
  app::StepAhead ahead_;
  After after_ = After::replaceDocument;
  scene::Scene pendingScene_;
  CompleteScene pendingCompletion_;
  std::optional<app::OpenDocument> pendingKept_;
  QString pendingName_, pendingSessionFile_, pendingOpened_;
  QTimer pauseTimer_, flowTimer_;
  std::chrono::steady_clock::time_point loadBegin_;

  std::unique_ptr<app::Recorder> recorder_;
  QString recordingFile_;

  glm::ivec2 pixels_{1};  // of the window's picture
  app::Edges letters_;
  scene::FlowClock flow_;
  QElapsedTimer sinceFlowMoved_;
  std::unique_ptr<app::StepPlayer> player_;
  QTimer playTimer_;
  QElapsedTimer sincePlay_;
};

}  // namespace isolux::ui
