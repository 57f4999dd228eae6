// Views, mouse and keys of ui/viewport/viewport.h: gestures become edited scenes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <glm/geometric.hpp>

#include "app/view_math/turning.h"
#include "scene/rules/automatic.h"
#include "scene/rules/environment.h"
#include "ui/document/environment_edit.h"
#include "ui/language/translated.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int turnTickMilliseconds = 16;
constexpr double turnStep = 5.0 * std::numbers::pi / 180.0, panStep = 0.05, zoomFactor = 1.1;  // of a key

}  // namespace

// Views: when one is turned to, the scene has the new camera at once, and the pictures on the way belong to
// nobody.

scene::Camera Viewport::cameraNow() const {
  if (!turnsFrom_) return resolved_.camera;
  const double part = static_cast<double>(sinceTurn_.elapsed()) / turnMilliseconds_;
  return app::cameraBetween(*turnsFrom_, resolved_.camera, app::easedPart(part));
}

void Viewport::turnTo(const scene::Camera& camera, const QString& name) {
  const bool turns = turnMilliseconds_ > 0 && hasContext_ && volume_;
  const scene::Camera from = cameraNow();
  endTurn();
  sendCamera(camera, name, "", false);
  if (!turns || from == resolved_.camera) return;
  turnsFrom_ = from;
  sinceTurn_.start();
  turnTimer_.start(turnTickMilliseconds);
  showView();
}

void Viewport::turnOn() {
  if (sinceTurn_.elapsed() >= turnMilliseconds_) endTurn();
  showView();
  redraw();
}

void Viewport::endTurn() {
  turnsFrom_.reset();
  turnTimer_.stop();
}

// Letters, cube and marks go with the view.
void Viewport::showView() {
  scene::Scene shown = resolved_;
  shown.camera = cameraNow();
  overlay_->setScene(shown, volume_ != nullptr, axes());
}

void Viewport::setSlices(SlicesInPicture slices) {
  slices_ = std::move(slices);
  overlay_->setSlices(slices_);
}

void Viewport::sendCamera(const scene::Camera& camera, const QString& name, const char* mergeKey,
                          bool endsAfterPause) {
  if (!volume_) return;
  Edit edit{scene_, name, mergeKey, endsAfterPause};
  edit.scene.camera = camera;
  Q_EMIT edited(edit);
}

void Viewport::applyStandardView(scene::StandardView view) {
  if (!volume_) return;
  const scene::VolumeFacts& facts = facts_();
  const scene::Camera camera =
      scene::standardView(resolved_.camera, view, facts.axes, facts.boundsMinMm, facts.boundsMaxMm);
  turnTo(scene::framed(camera, facts),
         tr("%1 view").arg(translated(texts::views, scene::standardViewName(view, facts.axes))));
}

void Viewport::fitView() {
  if (!volume_) return;
  turnTo(scene::framed(resolved_.camera, facts_()), tr("Zoom to fit"));
}

void Viewport::resetView() {
  scene::Camera camera = scene_.camera;
  camera.eye.reset();
  camera.target.reset();
  camera.up.reset();
  turnTo(camera, tr("Reset view"));
}

void Viewport::toggleProjection() {
  scene::Camera camera = scene_.camera;
  const bool perspective = camera.projection == scene::Projection::perspective;
  camera.projection = perspective ? scene::Projection::orthographic : scene::Projection::perspective;
  sendCamera(camera, perspective ? tr("Orthographic view") : tr("Perspective view"), "", false);
}

// Keys: the camera by arrows, plus and minus, as 3D Slicer and ParaView have it

// Keys that follow one another soon are one step of undo. Only the picture with the focus is asked.
bool Viewport::turnByKey(const QKeyEvent& event) {
  const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
  const scene::Camera& camera = resolved_.camera;
  if (event.key() == Qt::Key_Plus || event.key() == Qt::Key_Equal || event.key() == Qt::Key_Minus) {
    if (modifiers & ~Qt::ShiftModifier) return false;
    sendCamera(scene::zoomed(camera, event.key() == Qt::Key_Minus ? 1.0 / zoomFactor : zoomFactor),
               tr("Zoom"), "zoom keys", true);
    return true;
  }
  const glm::dvec2 arrow = arrowOf(event.key());
  if (arrow == glm::dvec2(0.0)) return false;
  if (modifiers == Qt::NoModifier) {  // the camera goes with the arrow
    sendCamera(scene::orbited(camera, turnStep * arrow.x, turnStep * arrow.y), tr("Rotate"), "turn keys",
               true);
  } else if (modifiers == Qt::ShiftModifier) {  // the picture goes with the arrow
    sendCamera(scene::panned(camera, panStep * arrow), tr("Pan"), "pan keys", true);
  } else if (modifiers == Qt::ControlModifier && arrow.x != 0.0) {
    sendCamera(scene::rolled(camera, turnStep * arrow.x), tr("Roll"), "roll keys", true);
  } else if (modifiers == Qt::ControlModifier) {
    sendCamera(scene::zoomed(camera, arrow.y > 0.0 ? zoomFactor : 1.0 / zoomFactor), tr("Zoom"), "zoom keys",
               true);
  } else {
    return false;
  }
  return true;
}

// Mouse

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (drag_ != Drag::none) return;  // the first button decides
  const Qt::KeyboardModifiers modifiers = event->modifiers();
  switch (event->button()) {
    case Qt::LeftButton:
      grip_ = lampUnder(event->position());
      cutGrip_ = grip_ ? std::nullopt : cutUnder(event->position());
      drag_ = grip_                             ? Drag::lamp
              : cutGrip_                        ? Drag::cut
              : modifiers & Qt::ControlModifier ? Drag::roll
              : modifiers & Qt::ShiftModifier   ? Drag::pan
                                                : Drag::orbit;
      break;
    case Qt::MiddleButton:
      drag_ = Drag::pan;
      break;
    case Qt::RightButton:
      if (!(modifiers & Qt::ShiftModifier)) {
        drag_ = Drag::zoom;
      } else if (const QString why = whyItCannotTurn(resolved_); !why.isEmpty()) {
        Q_EMIT noted(tr("Cannot turn the environment: %1").arg(why));
        return;
      } else {
        drag_ = Drag::environment;
        turnedFrom_ = scene::rotationOf(resolved_.light.environment, axes());
      }
      break;
    default:
      return;
  }
  dragButton_ = event->button();
  dragMoved_ = false;
  last_ = pressed_ = event->position();
  if (drag_ == Drag::lamp) takeHold(event->position());
  if (drag_ == Drag::cut) takeCut();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ != Drag::none && !(event->buttons() & dragButton_))
    endDrag(event->position());  // it was let go elsewhere
  if (drag_ == Drag::lamp) {
    dragLamp(event->position(), event->modifiers() & Qt::ControlModifier);
    return;
  }
  if (drag_ == Drag::cut) {
    dragCut(event->position(), event->modifiers() & Qt::ControlModifier);
    return;
  }
  if (drag_ != Drag::none) {
    const bool mayBeClick = tool_ && dragButton_ == Qt::LeftButton && !dragMoved_;
    const int moved = (event->position() - pressed_).toPoint().manhattanLength();
    if (!mayBeClick || moved >= QApplication::startDragDistance()) dragTo(event->position());
    return;
  }
  hoverAt(event->position());
  overlay_->pointAtCube(event->position());
  pointed_ = event->position();
  if (!pointTimer_.isActive()) pointTimer_.start();
}

void Viewport::dragTo(QPointF position) {
  constexpr double clickPixels = 3.0;  // a click that moves no farther is none of a zoom
  const bool mayBeClick = drag_ == Drag::zoom && !dragMoved_;
  if (mayBeClick && (position - pressed_).manhattanLength() < clickPixels) return;
  const double unit = std::max(1, height());
  const QPointF step = (position - last_) / unit;
  if (step.isNull() || !volume_) return;
  const scene::Camera& camera = resolved_.camera;
  switch (drag_) {
    case Drag::orbit:  // a drag across the picture's height turns by 180 degrees
      sendCamera(scene::orbited(camera, -step.x() * std::numbers::pi, step.y() * std::numbers::pi),
                 tr("Rotate"), "rotate", false);
      break;
    case Drag::pan:
      sendCamera(scene::panned(camera, {step.x(), -step.y()}), tr("Pan"), "pan", false);
      break;
    case Drag::zoom:
      sendCamera(scene::zoomed(camera, std::exp(-3.0 * step.y())), tr("Zoom"), "zoom", false);
      break;
    case Drag::roll: {
      const QPointF centre(0.5 * width(), 0.5 * height());
      const QPointF from = last_ - centre, to = position - centre;
      const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), QPointF::dotProduct(from, to));
      sendCamera(scene::rolled(camera, angle), tr("Roll"), "roll", false);
      break;
    }
    case Drag::environment: {
      const double half = 0.5 * std::max(1, std::min(width(), height()));
      const auto onBall = [&](QPointF p) {
        return glm::dvec2(p.x() - 0.5 * width(), 0.5 * height() - p.y()) / half;
      };
      const glm::dvec4 turned =
          app::turnedByDrag(turnedFrom_, scene::frameOf(camera), onBall(pressed_), onBall(position));
      Q_EMIT edited(environmentTurned(scene_, turned, axes()));
      break;
    }
    case Drag::lamp:
    case Drag::cut:
    case Drag::none:
      return;
  }
  dragMoved_ = true;
  last_ = position;
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (drag_ == Drag::none || event->button() != dragButton_) return;
  const bool still = !dragMoved_ && drag_ != Drag::lamp && drag_ != Drag::cut,
             asksMenu = drag_ == Drag::zoom && !dragMoved_, clicks = !tool_ && drag_ == Drag::orbit && still,
             setsPoint = tool_ && dragButton_ == Qt::LeftButton && still;
  endDrag(event->position());
  if (clicks) clickOn(event->position());
  if (setsPoint) placePoint(event->position(), event->modifiers() & Qt::ShiftModifier);
  if (!asksMenu) return;
  if (const auto cut = cutUnder(event->position()))
    Q_EMIT cutMenuAsked(event->globalPosition().toPoint(), *cut);
  else
    Q_EMIT menuAsked(event->globalPosition().toPoint(), pickAt(event->position()));
}

// The mouse asks by the button's release: its press may begin a drag.
void Viewport::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() != QContextMenuEvent::Keyboard) return;
  const QPoint at =
      rect().contains(pointed_.toPoint()) && !pointed_.isNull() ? pointed_.toPoint() : rect().center();
  Q_EMIT menuAsked(mapToGlobal(at), pickAt(at));
}

// A press that did not move: on the cube it turns to that side, on the surface it is told.
void Viewport::clickOn(QPointF position) {
  if (const auto view = volume_ ? overlay_->cubeViewAt(position) : std::nullopt)
    applyStandardView(*view);
  else if (const auto pick = pickAt(position))
    Q_EMIT clicked(*pick);
}

void Viewport::endDrag(QPointF position) {
  const bool held = drag_ == Drag::lamp || drag_ == Drag::cut;
  if (drag_ == Drag::cut) setCursor(Qt::OpenHandCursor);
  drag_ = Drag::none;
  if (held) hoverAt(position);
  if (dragMoved_) Q_EMIT gestureEnded();
  rest();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool grips = lampUnder(event->position()) || cutUnder(event->position());
  if (tool_ || grips) mousePressEvent(event);  // the second of two quick clicks
  if (event->button() != Qt::LeftButton || !volume_ || tool_ || grips) return;
  const auto pick = pickAt(event->position());
  if (!pick) return;
  sendCamera(app::centredOn(resolved_.camera, pick->worldMm), tr("Centre on point"), "", false);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  if (!volume_ || event->angleDelta().y() == 0) return;
  const double notches = event->angleDelta().y() / 120.0;
  event->accept();
  if (const auto grip = lampUnder(event->position())) {
    sendLamp(*grip, app::lampMovedAway(*app::lampOf(resolved_, grip->id), lampStage(), 0.03 * notches), true);
    return;
  }
  if (const auto grip = cutUnder(event->position())) {
    stepCut(*grip, notches);
    return;
  }
  sendCamera(scene::zoomed(resolved_.camera, std::pow(1.1, notches)), tr("Zoom"), "wheel", true);
}

void Viewport::leaveEvent(QEvent*) {
  pointTimer_.stop();
  overlay_->pointAtCube(std::nullopt);
  if (drag_ == Drag::none) {
    hoverCut(std::nullopt);
    hover(std::nullopt);
  }
  if (placingAt_.has_value()) {
    placingAt_.reset();
    showMarks();
  }
  Q_EMIT pointed(std::nullopt);
}

void Viewport::reportPointed() {
  if (drag_ != Drag::none || interacting_) return;
  const auto pick = pickAt(pointed_);
  if (tool_ && !placing_.empty()) {
    placingAt_ = pick ? std::optional(pick->worldMm) : std::nullopt;
    showMarks();
  }
  Q_EMIT pointed(pick);
}

// Lamps

app::LampStage Viewport::lampStage() const {
  return app::lampStageOf(resolved_, volume_ ? volume_->facts : scene::VolumeFacts{}, {width(), height()});
}

std::vector<app::LampHandle> Viewport::lamps() const {
  return volume_ ? app::lampHandles(resolved_, lampStage()) : std::vector<app::LampHandle>{};
}

std::optional<app::LampGrip> Viewport::lampUnder(QPointF position) const {
  return app::lampAt(lamps(), {position.x(), position.y()});
}

void Viewport::showLamps() {
  overlay_->setLamps(lamps(), grip_);
}

void Viewport::hoverAt(QPointF position) {
  const auto lamp = lampUnder(position);
  const auto cut = lamp ? std::nullopt : cutUnder(position);
  if (!cut) hoverCut(cut);
  if (!cut || grip_) hover(lamp);
  if (cut) hoverCut(cut);
}

// The pointer is over no handle.
void Viewport::showNoGrip() {
  if (tool_)
    setCursor(Qt::CrossCursor);
  else
    unsetCursor();
  setToolTip({});
}

void Viewport::hover(const std::optional<app::LampGrip>& grip) {
  if (grip == grip_ && drag_ == Drag::none && grip.has_value() == !toolTip().isEmpty()) return;
  grip_ = grip;
  if (!grip) {
    showNoGrip();
  } else if (grip->part == app::LampPart::ring) {
    setCursor(Qt::SizeAllCursor);
    setToolTip(tr("Light %1: drag its outline to resize it").arg(grip->number));
  } else {
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("Light %1: drag to move it; Ctrl+drag or wheel changes its distance").arg(grip->number));
  }
  showLamps();
}

void Viewport::takeHold(QPointF position) {
  setCursor(grip_->part == app::LampPart::ring ? Qt::SizeAllCursor : Qt::ClosedHandCursor);
  for (const app::LampHandle& handle : lamps())
    if (handle.id == grip_->id)  // the handle stays where it is under the pointer
      gripOffset_ = QPointF(handle.pixel.x, handle.pixel.y) - position;
  showLamps();
}

void Viewport::dragLamp(QPointF position, bool inDepth) {
  if (!volume_ || position == last_) return;
  const scene::Lamp* const held = app::lampOf(resolved_, grip_->id);
  if (held == nullptr || !held->shown) return;  // removed or switched off meanwhile
  const scene::Lamp& lamp = *held;
  const glm::dvec2 pixel(position.x(), position.y());
  if (grip_->part == app::LampPart::ring) {
    sendLamp(*grip_, app::lampResizedTo(lamp, lampStage(), pixel), false);
  } else if (inDepth) {
    const double fraction = (last_.y() - position.y()) / std::max(1, height());
    sendLamp(*grip_, app::lampMovedAway(lamp, lampStage(), fraction), false);
    takeHold(position);
  } else {
    const glm::dvec2 offset(gripOffset_.x(), gripOffset_.y());
    sendLamp(*grip_, app::lampMovedTo(lamp, lampStage(), pixel + offset), false);
  }
  dragMoved_ = true;
  last_ = position;
}

void Viewport::sendLamp(const app::LampGrip& grip, const scene::Lamp& moved, bool endsAfterPause) {
  const bool ring = grip.part == app::LampPart::ring;
  const QString name = QString(ring ? tr("Resize light %1") : tr("Move light %1")).arg(grip.number);
  Edit edit{scene_, name, name, endsAfterPause};
  scene::Lamp* const lamp = app::lampOf(edit.scene, grip.id);
  if (lamp == nullptr) return;
  if (ring) {
    lamp->radius = moved.radius;
  } else if (moved.kind == scene::LampKind::directional) {
    lamp->direction = moved.direction;
  } else {
    lamp->position = moved.position;
  }
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
