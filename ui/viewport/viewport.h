// The picture: orders pictures of the scene and shows them, turns the mouse into edited cameras.
//
// Left drag rotates, middle or Shift+left pans, right drag or wheel zooms, Ctrl+left rolls, a double click
// puts the picked surface point into the centre, a right click asks for a menu, a click on the cube turns to
// the view from there. With the focus, arrows turn, pan, roll and zoom. Under global illumination
// Shift+right turns the environment, and lamps have handles; so have planes and the box that cut. With a tool
// for marks, clicks set points on the surface.
//
// Pictures are drawn by a thread (app/tasks/picture_thread.h) that has a GL context of its own and comes back
// with pixels; this widget needs no OpenGL and waits for nothing. While a view changes, each change orders a
// draft; at rest a sharp and then the full picture follow, which a new change drops.
//
// A picture that fails (no room on the GPU, a fault of the driver or of ours) costs that picture only: the
// reason stands in its place until something changes, and then it is tried again.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QImage>
#include <QPointF>
#include <QTimer>
#include <QWidget>

class QPushButton;

#include "app/cuts/cut_handles.h"
#include "app/ready/ready_fields.h"
#include "app/tasks/picture_thread.h"
#include "app/view_math/lamp_handles.h"
#include "app/view_math/mark_view.h"
#include "app/view_math/picture_quality.h"
#include "app/view_math/surface_pick.h"
#include "render/graph/frame.h"
#include "render/still_picture.h"
#include "scene/camera.h"
#include "scene/settings/host_settings.h"
#include "ui/document/background_task.h"
#include "ui/document/baked_light.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"
#include "ui/viewport/canvas.h"
#include "ui/viewport/canvas_choice.h"
#include "ui/viewport/overlay_painters.h"
#include "ui/widgets/waiting.h"

namespace isolux::ui {

class ViewportOverlay;

class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  // Asked whenever a view is fitted: the facts of the volume, with what is to be framed.
  using Facts = std::function<const scene::VolumeFacts&()>;
  void setFacts(Facts facts) { facts_ = std::move(facts); }
  void setHostSettings(const scene::HostSettings& host);
  void setHint(const QString& text);  // shown while there is no volume
  void setTopInset(int pixels);       // of the top that is covered: letters and cube stand below
  void setFlowTime(double seconds);   // an animated flow has moved on
  // Stored light to draw with from now on; null: none. `changing`: more is on its way, which pictures of one
  // ray per pixel follow. Unless `shown`, pictures are lit without it (scene::withoutGi) until it is; then
  // the lit one fades in.
  void setLight(LightPointer light, bool changing, bool shown = true);
  // While true, pictures stay quick (the isovalue is being dragged).
  void setInteracting(bool interacting);

  // What clicks on the surface mark from now on; nothing: they mark nothing.
  void setTool(std::optional<scene::MarkKind> tool);
  std::optional<scene::MarkKind> tool() const { return tool_; }
  // The marks of the scene, and what they say (as many).
  void setMarks(const std::vector<scene::Mark>& marks, const std::vector<app::MarkReport>& reports);
  const std::vector<app::MarkShape>& markShapes() const { return shapes_; }  // those that are shown
  const std::vector<glm::dvec3>& placing() const { return placing_; }  // points of the mark that is begun

  // Whether planes and box have handles; while a tool for marks is chosen they have none.
  void setCutHandles(bool shown);
  const std::vector<app::CutShape>& cutShapes() const { return cuts_; }  // that are shown
  void setSlices(SlicesInPicture slices);                                // that are shown beside the picture
  // Views that are asked for by name are turned to in this time, which no edit shows; 0: at once.
  void setTurnMilliseconds(int milliseconds) { turnMilliseconds_ = milliseconds; }

  void applyStandardView(scene::StandardView view);
  void fitView();
  void resetView();
  void toggleProjection();

  // The full picture as the scene asks for it, with nothing written on it. A dialog says how far it is where
  // that takes long. Throws base::Error; Error{interrupted} where the user has cancelled.
  struct StillRequest {
    glm::ivec2 size{0};  // 0: the pixels of the screen, and its ratio
    double pixelRatio = 1.0;
    std::optional<scene::Camera> camera{};  // resolved; none: the window's
    bool linear = false;                    // also as linear float32
    QString what;                           // what the dialog says; empty: that a picture is drawn
  };
  render::StillPicture picture(const StillRequest& asked);
  // Returns the margins of the orientation labels of an image of this size; views are fitted between them.
  // `ratio`: pixels to one of a screen at 100 %.
  static app::Edges letterEdges(glm::ivec2 pixels, double ratio);
  glm::ivec2 pixelSize() const;  // of the screen
  const ViewportOverlay* overlay() const { return overlay_; }
  // Returns the pixels on screen, without letters and scale; the same QImage until another picture is shown.
  // Reads a texture back from the graphics card.
  const QImage& shown() const;
  const CanvasChoice& canvas() const { return canvasChoice_; }  // how pictures are shown, and why
  // Shows pictures in this way from now on. Where it turns out not to work, pixels are shown.
  void setCanvas(CanvasChoice choice);
  const std::optional<render::Tile>& legend() const { return legend_; }  // where it stands in them
  // What may be shown in place of the picture: the last that is there.
  enum class Over { structure, levelZero, errors };
  // Shown in place of the picture `of` while that is on screen; null: nothing is. `legend`: of its own,
  // beside the picture's.
  void setOver(Over what, const QImage& image, const QImage& of,
               const std::optional<render::Tile>& legend = {});
  bool showsOver(Over what) const {
    const Laid& laid = laid_[static_cast<std::size_t>(what)];
    return !laid.image.isNull() && laid.of == picture_.pixels.cacheKey();
  }
  bool complete() const;  // the picture on screen is the full one
  // GL strings, or why there is no picture.
  QString description() const { return problem_ ? *problem_ : glDescription_; }
  const std::optional<QString>& problem() const { return problem_; }  // why there is no picture now

 Q_SIGNALS:
  void resized();
  void edited(const isolux::ui::Edit& edit);
  void gestureEnded();
  void pointed(const std::optional<isolux::app::Pick>& pick);
  void clicked(const isolux::app::Pick& pick);  // on the surface, without a tool
  // A right click, or the menu key: of the surface there.
  void menuAsked(const QPoint& onScreen, const std::optional<isolux::app::Pick>& pick);
  // The same on the handle of a cut.
  void cutMenuAsked(const QPoint& onScreen, const isolux::app::CutGrip& grip);
  void toolChanged();
  void canvasChanged();
  void drawn(double milliseconds, bool complete);
  // A picture is on screen that shows a change of this long ago (the first, where it shows several). It was
  // finished `sinceFinished` ago.
  void answered(double milliseconds, double sinceFinished);
  void drawing(bool begins);  // pictures are on their way, or none is any more
  // The surface points of a picture that is lit by stored light, voxel coordinates; `finer`: of more rays
  // than those told of the same view.
  void seen(const isolux::gi::VisiblePointSet& hitVoxels, bool finer);
  void reported(const isolux::render::FrameReport& report, const isolux::render::FrameRequest& request);
  void failed(const QString& message);
  void
  derivativesChosen();  // what is automatic about them is known now (DerivativeChoices::completeIfChosen)
  void noted(const QString& message);  // worth knowing, nothing has failed

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintCanvas();
  void painted();  // the canvas was
  void failedPicture(const std::exception_ptr& reason);
  enum class Drag { none, orbit, pan, zoom, roll, environment, lamp, cut };
  void takeContext();
  void orderSoon();
  void order();
  app::PictureOrder orderOf(const render::FrameRequest& request, bool atRest);
  bool await(Waiting waiting);
  void awaitFields(const QString& what);
  render::FrameRequest::Hits wantedHits(const render::FrameRequest& request) const;
  double toldRays() const;    // of this view, in the finest picture that told all that is lit
  bool toldEveryRay() const;  // of this view, at full size
  void poll();
  void setDrawing(bool draws);
  void put(const app::DrawnPicture& picture);
  void offerRemedy(const std::optional<render::EmptyPicture>& empty);
  void takeRemedy();
  void placeButtons();
  std::vector<QRectF> legendBoxes() const;  // that are on screen
  void showCaveats();
  void showed(const app::DrawnPicture& picture, std::uint64_t view);
  void tellSeen(const app::DrawnPicture& picture, std::uint64_t view);
  void fail(const QString& reason, const QString& advice);
  void redraw(
      app::Motion motion = app::Motion::rays);  // something changed: a quick picture now, a full one soon
  void refine();
  void refineSoon();
  void rest();  // a gesture has ended
  struct Answered {
    std::uint64_t view = 0;
    bool standsIn = false;
  };
  Answered answer(std::uint64_t order);
  bool standsIn() const;  // the next picture is lit without the stored light that the scene asks for
  void viewChanged();
  bool current() const { return shownChanges_ == changes_; }
  void changed();
  bool restDiffers() const;  // a picture at rest shows other hits than one in motion
  bool drawsRest() const;    // the next picture is one at rest
  scene::Scene drawable();   // what of the scene can be drawn by now; has the rest made
  bool makesFields() const;  // of the scene, or could not
  void makeFields();
  void lookAtFields();
  QString fieldNote() const;
  app::LampStage lampStage() const;
  std::vector<app::LampHandle> lamps() const;
  std::optional<app::LampGrip> lampUnder(QPointF position) const;
  void showLamps();
  void hover(const std::optional<app::LampGrip>& grip);
  void takeHold(QPointF position);
  void dragLamp(QPointF position, bool inDepth);
  void sendLamp(const app::LampGrip& grip, const scene::Lamp& moved, bool endsAfterPause);
  app::CutStage cutStage() const;
  std::optional<app::CutGrip> cutUnder(QPointF position) const;
  void showCuts();
  void hoverAt(QPointF position);
  void showNoGrip();
  void hoverCut(const std::optional<app::CutGrip>& grip);
  static QString cutTip(const app::CutGrip& grip);
  void takeCut();
  void dragCut(QPointF position, bool constrained);
  void cancelCut();
  void stepCut(const app::CutGrip& grip, double notches);
  void sendCut(const scene::Clip& clip, const app::CutGrip& grip, bool endsAfterPause);
  void dragTo(QPointF position);
  void clickOn(QPointF position);
  void endDrag(QPointF position);
  void reportPointed();
  void placePoint(QPointF position, bool more);
  void showMarks();
  void lookBehindMarks();
  bool turnByKey(const QKeyEvent& event);
  void turnTo(const scene::Camera& camera, const QString& name);
  void turnOn();
  void endTurn();
  void showView();
  scene::Camera cameraNow() const;
  void sendCamera(const scene::Camera& camera, const QString& name, const char* mergeKey,
                  bool endsAfterPause);
  std::optional<app::Pick> pickAt(QPointF position) const;
  scene::WorldAxes axes() const;

  CanvasChoice canvasChoice_;
  std::unique_ptr<Canvas> canvas_;
  std::unique_ptr<app::PictureThread> thread_;
  bool hasContext_ = false;
  std::optional<QString> problem_;
  QString glDescription_;
  VolumePointer volume_;
  Facts facts_;
  scene::Scene scene_, resolved_;
  LightPointer light_;
  bool showsLight_ = true;
  scene::HostSettings host_;
  app::PictureQuality quality_;
  // Changes are counted. What is on screen: its pixels, what they were asked for, and after how many changes.
  // What was ordered last: the same.
  std::uint64_t changes_ = 1, shownChanges_ = 0, orderedChanges_ = 0;
  mutable CanvasPicture picture_;  // its pixels as far as somebody asked for them
  struct Laid {
    QImage image;
    qint64 of = 0;  // QImage::cacheKey
    std::optional<render::Tile> legend{};
  };
  std::array<Laid, 3> laid_;  // by Over
  std::optional<render::Tile> legend_;
  // The picture before stored light was there, and since when it fades into picture_; none: none does.
  CanvasPicture before_;
  QElapsedTimer sinceFade_;
  Answered shownAs_;
  render::FrameRequest shownRequest_, orderedRequest_;
  std::uint64_t orderNumber_ = 0;
  // When the first change came that was not ordered yet, and that is shown by the next painting.
  using Moment = std::chrono::steady_clock::time_point;
  std::optional<Moment> changed_, unpainted_;
  Moment finished_{};  // when the picture on screen was
  struct Awaited {
    std::uint64_t order, view;
    bool standsIn;                  // lit without the stored light that its scene asks for
    std::optional<Moment> changed;  // the first change since the order before
  };
  std::vector<Awaited> awaited_;  // orders that have not come back, and may have been dropped
  bool orderComes_ = false;       // order() has been asked for
  bool stillComes_ = false;       // picture() waits
  bool drawing_ = false;          // what drawing() said last
  bool failed_ = false;           // the last try to draw it: nothing is tried until something changes
  bool bricksPending_ = false;    // the next frame gets further
  bool lightPending_ = false;     // so it does, with stored light
  bool orderedAtRest_ = false, shownAtRest_ = false;
  bool fieldsPending_ = false;  // the picture is drawn with other fields than the scene asks for
  BackgroundTask<void> fieldTask_;
  std::optional<scene::Scene> fieldsOf_;   // what the task is for, or was
  std::optional<base::Error> fieldError_;  // of the last
  scene::Derivatives lastDerivatives_;     // of the last picture of the volume that had what it asked for
  bool interacting_ = false;
  // What rays hit: the number of the view, and the rays of its finest picture that was told by seen(); 0
  // none.
  std::uint64_t view_ = 0;
  double seenRays_ = 0.0;
  double seenReflections_ = 0.0;  // the same, with what glossy surfaces reflect in it
  QElapsedTimer sinceSeen_;
  QTimer refineTimer_, pointTimer_, turnTimer_, fadeTimer_;
  int turnMilliseconds_ = 0;
  std::optional<scene::Camera> turnsFrom_;  // while the view turns to the scene's camera
  QElapsedTimer sinceTurn_;

  Drag drag_ = Drag::none;
  Qt::MouseButton dragButton_ = Qt::NoButton;
  bool dragMoved_ = false;
  QPointF pressed_, last_, pointed_;
  glm::dvec4 turnedFrom_{1.0, 0.0, 0.0, 0.0};  // the environment when its drag began
  std::optional<app::LampGrip> grip_;          // under the pointer, or being dragged
  QPointF gripOffset_;
  bool cutHandles_ = true;
  std::vector<app::CutShape> cuts_;
  std::optional<app::CutGrip> cutGrip_;  // under the pointer, or being dragged
  scene::Clip cutFrom_;                  // the cut when its drag began, and how it lay on the picture
  app::CutStage cutStage_;
  std::optional<scene::MarkKind> tool_;
  std::vector<glm::dvec3> placing_;      // points of the mark that is begun, world mm
  std::optional<glm::dvec3> placingAt_;  // and where the next would be
  std::vector<app::MarkShape> shapes_;
  std::size_t marksSeenFrom_ =
      0;  // corners of shapes_ of which it is known whether they are behind the surface
  SlicesInPicture slices_;
  ViewportOverlay* overlay_;
  int topInset_ = 0;
  QPushButton* remedy_;   // over an empty picture: what would show something
  QPushButton* caveats_;  // what the picture leaves out or nobody measured; a click shows hidden pieces
  render::EmptyPicture::Remedy offered_ = render::EmptyPicture::Remedy::none;
};

}  // namespace isolux::ui
