#include "ui/document/document.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <QDir>
#include <QFileInfo>

#include "app/documents/anonymous.h"
#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/files/output_guard.h"
#include "scene/rules/automatic.h"
#include "scene/settings/scene_diff.h"
#include "ui/document/privacy.h"
#include "volume/prepared/surface_outline.h"
#include "volume/read/reader.h"
#include "volume/read/step_files.h"

namespace isolux::ui {

namespace {
constexpr int playMilliseconds = 15;
constexpr int flowMilliseconds = 33;  // 30 pictures a second, as far as the machine can draw them

std::filesystem::path pathOf(const QString& file) {
  return {file.toStdString()};
}

// A picture that carries a session is opened like one, but saving never replaces it: by its content, whatever
// its name.
QString writableSession(const QString& file) {
  return app::looksLikePicture(app::readBeginning(pathOf(file), 8)) ? QString() : file;
}

QString textOf(const base::Error& error) {
  return QString::fromStdString(error.what());
}

// What was loaded instead of what was asked for; whether anything was.
bool takeInstead(scene::Source& source, const scene::Source& loaded) {
  const bool same = source.level == loaded.level && source.aroundDamage == loaded.aroundDamage;
  source.level = loaded.level;
  source.aroundDamage = loaded.aroundDamage;
  return !same;
}

// As short as a title bar wants it.
QString shortName(const std::string& path) {
  const QString text = QString::fromStdString(path);
  if (text.startsWith("phantom:")) return QObject::tr("%1 phantom").arg(text.mid(8).section(':', 0, 0));
  return QFileInfo(QDir::cleanPath(text)).fileName();
}

// What is the user's whatever the volume: the background, what is written on pictures, how slices lie. Look,
// lines and light were chosen for the volume before.
scene::Scene ofTheUser(const scene::Scene& before) {
  scene::Scene scene;
  scene.look.backgroundTop = before.look.backgroundTop;
  scene.look.backgroundBottom = before.look.backgroundBottom;
  scene.picture = before.picture;
  scene.picture.exposure.reset();
  scene.slice.convention = before.slice.convention;
  scene.camera.projection = before.camera.projection;
  return scene;
}

// Of another series of the same patient all stays but its values, its places and who knows it by which name.
void makeAutomatic(scene::Scene& scene) {
  for (scene::Surface& surface : scene.surfaces) {
    surface.value.reset();
    surface.name.clear();
  }
  scene.camera.eye.reset();
  scene.camera.target.reset();
  scene.camera.up.reset();
  scene.clip.planes.clear();
  scene.clip.box.clear();
  scene.clip.boxRotation = scene::Clip{}.boxRotation;
  scene.clip.removed.clear();
  scene.pieces.hidden.clear();
  scene.pieces.only.clear();
  scene.slice.position.reset();
  scene.slice.level.reset();
  scene.slice.width.reset();
  scene.marks.clear();
}

// What decides which surface is shown, all else at its defaults.
scene::Scene surfacesOf(const scene::Scene& scene) {
  scene::Scene surfaces;
  surfaces.isosurface.inside = scene.isosurface.inside;
  surfaces.isosurface.suggestion = scene.isosurface.suggestion;
  surfaces.pieces = scene.pieces;
  surfaces.surfaces.clear();
  for (const scene::Surface& surface : scene.surfaces)
    if (surface.shown || surfaces.surfaces.empty()) surfaces.surfaces.push_back({.value = surface.value});
  return surfaces;
}
}  // namespace

Document::Document(QObject* parent)
    : QObject(parent), savedScene_(history_.scene()), flow_(history_.scene()) {
  callOnce(pauseTimer_, 700, this, &Document::endGesture);

  flowTimer_.setTimerType(Qt::PreciseTimer);
  flowTimer_.setInterval(flowMilliseconds);
  connect(&flowTimer_, &QTimer::timeout, this, &Document::moveFlow);
  playTimer_.setInterval(playMilliseconds);
  connect(&playTimer_, &QTimer::timeout, this, &Document::movePlay);
}

scene::Scene Document::shownScene() const {
  scene::Scene shown = scene();
  shown.flow.time = flow_.seconds();
  return shown;
}

scene::Scene Document::resolved(const scene::Scene& scene) const {
  scene::Scene resolved = scene::resolve(scene, facts_);
  if (!volume_) return resolved;
  volume_->derivativeChoices->completeIfChosen(resolved);
  resolved.camera = scene::fittedTo(resolved.camera, facts_,
                                    [&] { return app::freeRooms(resolved, *volume_, pixels_, letters_); });
  return resolved;
}

void Document::setPicture(glm::ivec2 pixels, const app::Edges& letters) {
  const scene::Camera before = resolvedScene().camera;
  pixels_ = pixels;
  letters_ = letters;
  if (!(resolvedScene().camera == before)) announce();
}

scene::Camera Document::cameraOf(glm::ivec2 pixels, const app::Edges& letters) const {
  const scene::Scene resolved = scene::resolve(scene(), facts_);
  if (!volume_) return resolved.camera;
  return scene::fittedTo(resolved.camera, facts_,
                         [&] { return app::freeRooms(resolved, *volume_, pixels, letters); });
}

void Document::frameShown() {
  if (!volume_) return;
  base::Progress unwatched;
  try {
    std::vector<glm::dvec3> outline =
        volume::surfaceOutline(*volume_, resolved(scene()), false, unwatched).pointsMm;
    if (!outline.empty()) facts_.outlineMm = std::move(outline);
  } catch (const base::Error&) {
    // No memory to look for pieces: views stay as they are.
  }
}

QString Document::name() const {
  if (!sessionFile_.isEmpty()) return QFileInfo(sessionFile_).fileName();
  if (!volume_) return {};
  return shortName(loadedSource_.path);
}

double Document::secondsSinceRead() const {
  if (!volume_) return 0.0;
  const std::chrono::duration<double> total = std::chrono::steady_clock::now() - loadBegin_;
  return total.count() - volume_->readSeconds;
}

// Opening

void Document::open(const QString& path, const QString& series) {
  try {
    const bool builtIn = path.startsWith("phantom:");
    const QString absolute = builtIn ? path : QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    if (!builtIn && QFileInfo(absolute).isFile()) {
      if (app::isSession(pathOf(absolute))) {
        openScene(app::loadSession(pathOf(absolute)), absolute);
        return;
      }
      if (app::isRecording(pathOf(absolute))) {
        const QString name = QFileInfo(absolute).fileName();
        base::throwInput(
            name.toStdString(), "",
            tr("is a recording; render it with isolux replay %1 --out FOLDER").arg(name).toStdString());
      }
      if (volume::needsRawDescription(pathOf(absolute))) {
        Q_EMIT rawDescriptionNeeded(absolute);
        return;
      }
    }
    scene::Scene next = ofTheUser(scene());
    next.source.path = absolute.toStdString();
    next.source.series = series.toStdString();
    openScene(next, {});
  } catch (const base::Error& error) {
    Q_EMIT failed(textOf(error));
  }
}

void Document::openRaw(const QString& path, const QString& description) {
  scene::Scene next = ofTheUser(scene());
  next.source.path = QFileInfo(path).absoluteFilePath().toStdString();
  next.source.raw = description.toStdString();
  openScene(next, {});
}

void Document::resetSettings() {
  scene::Scene next = ofTheUser(scene());
  next.source = scene().source;
  next.camera = scene().camera;
  next.marks = scene().marks;
  edit({next, tr("Reset all settings")});
}

void Document::openScene(const scene::Scene& scene, const QString& sessionFile, CompleteScene completed) {
  const QString source = QString::fromStdString(scene.source.path);
  if (!sessionFile.isEmpty() && !source.startsWith("phantom:") && !QFileInfo::exists(source) &&
      volume::stepFiles(scene.source.path).empty()) {
    Q_EMIT volumeMissing(scene, sessionFile);
    return;
  }
  pendingOpened_ = sessionFile.isEmpty() ? QString::fromStdString(scene.source.path) : sessionFile;
  pendingSessionFile_ = writableSession(sessionFile);
  startLoading(scene, After::replaceDocument);
  pendingCompletion_ = std::move(completed);
}

app::OpenDocument Document::kept() const {
  return {name().toStdString(), history_, savedScene_, sessionFile_.toStdString(),
          recording() ? recordingFile_.toStdString() : std::string()};
}

void Document::restore(const app::OpenDocument& kept) {
  pendingOpened_.clear();
  startLoading(kept.history.scene(), After::restoreDocument);
  pendingKept_ = kept;
}

void Document::startLoading(const scene::Scene& scene, After after) {
  pause();
  cancelLoading();
  after_ = after;
  pendingKept_.reset();
  pendingCompletion_ = {};
  pendingScene_ = scene;
  loadBegin_ = std::chrono::steady_clock::now();
  std::unique_ptr<app::LoadTask> task = ahead_.take(scene.source);
  if (!task) {
    const bool opens = after == After::replaceDocument || after == After::restoreDocument;
    task = app::loadTask(scene.source, {.coarser = opens, .aroundDamage = after != After::keepScene},
                         volume_ ? std::optional(app::LoadedVolume{loadedSource_, volume_}) : std::nullopt);
  }
  loading_.watch(
      std::move(task), [this](auto& loaded) { finishLoading(loaded); },
      [this] {
        const base::Progress& progress = loading_->progress();
        Q_EMIT loadProgress(progress.fraction(), QString::fromUtf8(progress.stage()));
      });
  Q_EMIT loadStarted(shortName(scene.source.path));
}

void Document::cancelLoading() {
  if (!loading_) return;
  loading_.reset();
  keepLoadedSource();
  Q_EMIT loadEnded(false);
}

// Undo had already gone to another source, which is not to be had: stay with the volume that is on screen.
void Document::keepLoadedSource() {
  if (after_ != After::keepScene || scene().source == loadedSource_) return;
  const scene::Scene before = scene();
  scene::Scene next = before;
  next.source = loadedSource_;
  history_.edit(next, tr("Keep the volume").toStdString());
  commit(before, tr("Keep the volume"));
}

void Document::finishLoading(app::LoadTask& task) {
  const QString openedPath = std::exchange(pendingOpened_, {});
  if (task.error()) {
    keepLoadedSource();
    announce();  // the widgets show again what holds
    Q_EMIT loadEnded(false);
    if (task.error()->kind() != base::ErrorKind::interrupted) Q_EMIT failed(textOf(*task.error()));
    return;
  }
  const scene::Scene before = scene();
  const VolumePointer volume = task.value().volume;
  const scene::Source shownSource = std::exchange(loadedSource_, task.value().source);
  QString name = tr("Open %1").arg(shortName(loadedSource_.path));
  if (after_ == After::replaceDocument) {
    takeInstead(pendingScene_.source, loadedSource_);
    completePending(*volume);
    replaceDocument();
  } else if (after_ == After::restoreDocument) {
    restoreDocument();
  } else if (after_ == After::editSource) {
    changeSource(*volume);
    name = pendingName_;
  }
  if (scene::Scene next = scene(); takeInstead(next.source, loadedSource_)) {  // since this was saved
    const bool coarser = next.source.level != scene().source.level;
    history_.edit(next, (coarser ? tr("Coarser level") : tr("Skip unreadable chunks")).toStdString());
  }
  volume_ = volume;
  facts_ = volume_->facts;
  if (!(surfacesOf(scene()) == scene::Scene{})) frameShown();
  ahead_.moved(shownSource, loadedSource_, *volume);
  Q_EMIT volumeChanged(volume_);
  if (after_ == After::keepScene) {
    announce();  // undo() recorded the change already
  } else {
    commit(before, name);
  }
  Q_EMIT loadEnded(true);
  if (!openedPath.isEmpty() && after_ == After::replaceDocument) Q_EMIT opened(openedPath);
  if (after_ == After::restoreDocument) Q_EMIT restored();
}

// What cannot be said of this volume is told, and the scene shown as it is.
void Document::completePending(const volume::PreparedVolume& volume) {
  if (!pendingCompletion_) return;
  try {
    const scene::Source source = pendingScene_.source;
    pendingScene_ = pendingCompletion_(volume);
    pendingScene_.source = source;
  } catch (const base::Error& error) {
    Q_EMIT failed(textOf(error));
  }
  pendingCompletion_ = {};
}

void Document::replaceDocument() {
  sessionFile_ = pendingSessionFile_;
  history_.reset(pendingScene_);
  savedScene_ = pendingScene_;
}

void Document::restoreDocument() {
  sessionFile_ = writableSession(QString::fromStdString(pendingKept_->sessionFile));
  history_ = std::move(pendingKept_->history);
  savedScene_ = pendingKept_->saved;
  pendingKept_.reset();
}

// Steps are there to be compared: as it is on screen, but for the step.
scene::Scene Document::atLoadedStep() const {
  scene::Scene next = scene();
  const scene::Scene resolved = resolvedScene();
  next.surfaces.front().value = resolved.surfaces.front().value;
  next.camera = resolved.camera;
  next.source = loadedSource_;
  return next;
}

void Document::changeSource(const volume::PreparedVolume& volume) {
  scene::Scene next = scene();  // edits made while it loaded stay
  const bool otherSeries = next.source.series != loadedSource_.series;
  scene::Source otherStep = next.source;
  otherStep.timeStep = loadedSource_.timeStep;
  otherStep.aroundDamage = loadedSource_.aroundDamage;
  if (otherStep == loadedSource_) {
    history_.edit(atLoadedStep(), pendingName_.toStdString());
    return;
  }
  next.source = loadedSource_;
  if (otherSeries) makeAutomatic(next);
  if (next.surfaces.front().value && (*next.surfaces.front().value <= volume.grid().minimum() ||
                                      *next.surfaces.front().value >= volume.grid().maximum())) {
    next.surfaces.front().value.reset();
  }
  history_.edit(next, pendingName_.toStdString());
}

// Editing

void Document::announce() {
  flow_.setScene(scene());
  const bool runs = flow_.runs() && volume_;
  if (runs && !flowTimer_.isActive()) {
    sinceFlowMoved_.start();
    flowTimer_.start();
  } else if (!runs) {
    flowTimer_.stop();
  }
  Q_EMIT sceneChanged(scene(), resolvedScene());
  Q_EMIT stateChanged();
}

void Document::commit(const scene::Scene& before, const QString& name, bool dragged) {
  const bool automatic = !scene().camera.eye && !dragged;
  if (automatic && (before.camera.eye || !(surfacesOf(before) == surfacesOf(scene())))) frameShown();
  if (recorder_) {
    const volume::Patient hidden = hiddenInSaved(volume_);
    const scene::SceneDiff diff =
        scene::difference(app::withoutPatient(before, hidden), app::withoutPatient(scene(), hidden),
                          app::withoutPatient(name.toStdString(), hidden));
    try {
      if (!diff.changes.empty()) recorder_->add(diff);
    } catch (const base::Error& error) {
      stopRecording();
      Q_EMIT failed(
          tr("Recording stopped: %1. The file contains everything up to that point.").arg(textOf(error)));
    }
  }
  announce();
}

void Document::edit(const Edit& edit) {
  if (edit.scene == scene()) return;
  if (edit.scene.source != scene().source) {
    pendingName_ = edit.name;
    pendingOpened_.clear();
    scene::Scene next = edit.scene;
    if (loading_ && after_ == After::editSource)  // to be added to what is on its way already
      next.source =
          scene::applied(pendingScene_, scene::difference(scene(), edit.scene, edit.name.toStdString()))
              .source;
    startLoading(next, After::editSource);
    return;
  }
  const scene::Scene before = scene();
  scene::Scene next = edit.scene;
  // A flow that is stopped stands where it is seen.
  if (!next.flow.animate && next.flow.time == before.flow.time) next.flow.time = flow_.seconds();
  try {
    history_.edit(next, edit.name.toStdString(), edit.mergeKey.toStdString());
  } catch (const base::Error& error) {  // a value outside its range
    Q_EMIT failed(textOf(error));
    announce();  // the widget shows again what holds
    return;
  }
  if (edit.endsAfterPause)
    pauseTimer_.start();
  else
    pauseTimer_.stop();
  commit(before, edit.name, !edit.mergeKey.isEmpty());
}

void Document::endGesture() {
  pauseTimer_.stop();
  history_.seal();
}

void Document::undo() {
  if (history_.canUndo())
    step(tr("Undo %1").arg(QString::fromStdString(history_.undoName())), &app::History::undo);
}

void Document::redo() {
  if (history_.canRedo())
    step(tr("Redo %1").arg(QString::fromStdString(history_.redoName())), &app::History::redo);
}

void Document::step(const QString& name, scene::SceneDiff (app::History::*step)()) {
  const scene::Scene before = scene();
  history_.seal();
  (history_.*step)();
  commit(before, name);
  if (scene().source != loadedSource_) startLoading(scene(), After::keepScene);
}

void Document::toggleFlow() {
  Edit toggled{scene(), scene().flow.animate ? tr("Pause flow") : tr("Animate flow")};
  toggled.scene.flow.animate = !scene().flow.animate;
  edit(toggled);
}

void Document::moveFlow() {
  flow_.advance(static_cast<double>(sinceFlowMoved_.nsecsElapsed()) * 1e-9);
  sinceFlowMoved_.start();
  Q_EMIT flowMoved(flow_.seconds());
}

void Document::play(double stepsPerSecond) {
  pause();
  if (!volume_ || loading_ || volume_->volume.timeSteps < 2) return;
  player_ = std::make_unique<app::StepPlayer>(app::StepPlayer::Step{loadedSource_, volume_}, stepsPerSecond);
  sincePlay_.start();
  playTimer_.start();
  Q_EMIT playingChanged(true);
}

void Document::pause() {
  if (!player_) return;
  playTimer_.stop();
  player_.reset();
  history_.seal();
  Q_EMIT playingChanged(false);
}

void Document::movePlay() {
  const auto step = player_->at(static_cast<double>(sincePlay_.nsecsElapsed()) * 1e-9);
  if (step) showStep(*step);
  if (player_ && player_->error()) {
    const QString why = textOf(*player_->error());
    pause();
    Q_EMIT failed(why);
  }
}

void Document::showStep(const app::StepPlayer::Step& step) {
  const scene::Scene before = scene();
  loadedSource_ = step.source;
  const bool ofGesture = !history_.mergeKey().empty();
  const std::string name = ofGesture ? history_.undoName() : tr("Play time steps").toStdString();
  history_.edit(atLoadedStep(), name, ofGesture ? history_.mergeKey() : "play");
  volume_ = step.volume;
  facts_ = volume_->facts;
  Q_EMIT volumeChanged(volume_);
  commit(before, QString::fromStdString(name), true);
}

// Sessions and recordings

void Document::checkOutput(const QString& file) const {
  app::OutputGuard guard;
  guard.reads(scene());
  guard.writes(pathOf(file), "the new file");
}

bool Document::saveSession(const QString& file) {
  try {
    checkOutput(file);
    app::saveSession(scene(), pathOf(file));
  } catch (const base::Error& error) {
    Q_EMIT failed(textOf(error));
    return false;
  }
  sessionFile_ = file;
  savedScene_ = scene();
  Q_EMIT stateChanged();
  return true;
}

bool Document::startRecording(const QString& file) {
  try {
    checkOutput(file);
    recorder_ = std::make_unique<app::Recorder>(pathOf(file),
                                                app::withoutPatient(shownScene(), hiddenInSaved(volume_)));
    recordingFile_ = QFileInfo(file).absoluteFilePath();
  } catch (const base::Error& error) {
    recorder_.reset();
    Q_EMIT failed(textOf(error));
  }
  Q_EMIT stateChanged();
  return recording();
}

void Document::stopRecording() {
  recorder_.reset();
  Q_EMIT stateChanged();
}

}  // namespace isolux::ui
