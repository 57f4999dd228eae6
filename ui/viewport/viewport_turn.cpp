// Views of ui/viewport/viewport.h that are turned to: the scene has the new camera at once, the pictures on
// the way belong to nobody.
#include "app/view_math/turning.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {
constexpr int turnTickMilliseconds = 16;
}

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

}  // namespace isolux::ui
