// Keys of ui/viewport/viewport.h: the camera by arrows, plus and minus, as 3D Slicer and ParaView have it.
#include <numbers>

#include <QKeyEvent>

#include "ui/viewport/viewport.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr double turnStep = 5.0 * std::numbers::pi / 180.0, panStep = 0.05, zoomFactor = 1.1;

}  // namespace

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

}  // namespace isolux::ui
