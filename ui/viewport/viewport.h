// The picture: draws the scene with the renderer, turns the mouse into edited cameras.
//
// Left drag rotates, middle or Shift+left pans, right drag or wheel zooms, Ctrl+left rolls, a double click
// puts the picked surface point into the centre. Under global illumination Shift+right turns the environment,
// and lamps have handles.
//
// The renderer is made with the GL context and dies with it. A picture that fails (no room on the GPU, a
// fault of the driver or of ours) costs that picture only: the reason stands in its place until something
// changes, and then it is tried again.
#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QPointF>
#include <QTimer>

class QPushButton;

#include "app/interaction/lamp_handles.h"
#include "app/interaction/picture_quality.h"
#include "app/jobs/field_job.h"
#include "render/graph/frame.h"
#include "render/renderer.h"
#include "render/still_picture.h"
#include "scene/camera.h"
#include "scene/machine.h"
#include "ui/document/baked_light.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"

namespace isolux::render {
struct Gl;
}

namespace isolux::ui {

class ViewportOverlay;

class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setMachine(const scene::Machine& machine);
  void setHint(const QString& text);  // shown while there is no volume
  void setTopInset(int pixels);       // of the top that is covered: letters and cube stand below
  void setFlowTime(double seconds);   // an animated flow has moved on
  // Stored light to draw with from now on; null: none. `changing`: more is on its way, which pictures of one
  // ray per pixel follow.
  void setLight(LightPointer light, bool changing);
  // While true, pictures stay quick (the isovalue is being dragged).
  void setInteracting(bool interacting);

  void applyStandardView(scene::StandardView view);
  void fitView();
  void resetView();
  void toggleProjection();

  // The full picture as the scene asks for it, without letters and scale; `linear`: also as linear float32.
  // Throws base::Error.
  render::StillPicture picture(bool linear = false);
  bool complete() const;        // the picture on screen is the full one
  QString description() const;  // GL strings, or why there is no picture
  const std::optional<QString>& problem() const { return problem_; }  // why there is no picture now

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void gestureEnded();
  void pointed(const std::optional<isolux::render::Pick>& pick);
  void drawn(double milliseconds, bool complete);
  void drawing(bool begins);  // a frame, now
  // The surface points of a picture that is lit by stored light, voxel coordinates; `finer`: of more pixels
  // than those told of the same view.
  void seen(const std::vector<glm::vec3>& hitVoxels, bool finer);
  void reported(const isolux::render::FrameReport& report, const isolux::render::FrameRequest& request);
  void failed(const QString& message);
  void noted(const QString& message);  // worth knowing, nothing has failed

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeGL(int width, int height) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Drag { none, orbit, pan, zoom, roll, environment, lamp };
  void releaseRenderer();
  const render::FrameReport& drawPicture();
  void clearPicture();
  void offerRemedy(const std::optional<render::EmptyPicture>& empty);
  void takeRemedy();
  void placeRemedy();
  void showed(const render::FrameReport& report, double milliseconds);
  void fail(const QString& reason, const QString& advice);
  void redraw(
      app::Motion motion = app::Motion::rays);  // something changed: a quick picture now, a full one soon
  void refine();
  void rest();  // a gesture has ended
  void reportSeen();
  scene::Scene drawable();  // what of the scene can be drawn by now; has the rest made
  void pollFields();
  app::LampStage lampStage() const;
  std::vector<app::LampHandle> lamps() const;
  std::optional<app::LampGrip> lampUnder(QPointF position) const;
  void showLamps();
  void hover(const std::optional<app::LampGrip>& grip);
  void takeHold(QPointF position);
  void dragLamp(QPointF position, bool inDepth);
  void sendLamp(const app::LampGrip& grip, const scene::Lamp& moved, bool endsAfterPause);
  void dragTo(QPointF position);
  void endDrag(QPointF position);
  void reportPointed();
  void sendCamera(const scene::Camera& camera, const char* name, const char* mergeKey, bool endsAfterPause);
  std::optional<render::Pick> pickAt(QPointF position);
  glm::ivec2 pixelSize() const;
  scene::WorldAxes axes() const;

  std::shared_ptr<const render::Gl> gl_;  // null: no usable context
  std::unique_ptr<render::Renderer> renderer_;
  std::optional<QString> problem_;
  QString glDescription_;
  VolumePointer volume_;
  scene::Scene scene_, resolved_;
  LightPointer light_;
  scene::Machine machine_;
  app::PictureQuality quality_;
  render::FrameRequest lastRequest_;
  double pictureMilliseconds_ = 0.0;
  bool current_ = false;        // nothing has changed since lastRequest_ was drawn
  bool failed_ = false;         // the last try to draw it: nothing is tried until something changes
  bool bricksPending_ = false;  // the next frame gets further
  bool lightPending_ = false;   // so it does, with stored light
  bool fieldsPending_ = false;  // the picture is drawn with other fields than the scene asks for
  std::unique_ptr<app::FieldJob> fieldJob_;
  bool interacting_ = false;
  double seenPixels_ = 0.0;  // of the finest picture of this view that was told by seen(); 0 none
  QElapsedTimer sinceSeen_;
  QTimer refineTimer_, pointTimer_, contextTimer_, fieldTimer_;

  Drag drag_ = Drag::none;
  Qt::MouseButton dragButton_ = Qt::NoButton;
  bool dragMoved_ = false;
  QPointF pressed_, last_, pointed_;
  glm::dvec4 turnedFrom_{1.0, 0.0, 0.0, 0.0};  // the environment when its drag began
  std::optional<app::LampGrip> grip_;          // under the pointer, or being dragged
  QPointF gripOffset_;
  ViewportOverlay* overlay_;
  QPushButton* remedy_;  // over an empty picture: what would show something
  render::EmptyPicture::Remedy offered_ = render::EmptyPicture::Remedy::none;
};

}  // namespace isolux::ui
