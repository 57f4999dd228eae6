// What ui/accuracy/accuracy_panel.h knows of the picture on screen: when it is measured, what is said of it,
// and what searches are of.
#include <algorithm>

#include "render/passes/pass_declarations.h"
#include "scene/rules/needs.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/accuracy_text.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

void AccuracyPanel::setReport(const render::FrameReport& report, const render::FrameRequest& request) {
  reported_ = {request, app::castsOnProcessor(report)};
}

void AccuracyPanel::setHostSettings(const scene::HostSettings& host) {
  host_ = host;
  showTarget();
}

void AccuracyPanel::setLight(const LightPointer& light, bool changing) {
  light_ = light;
  lightChanging_ = changing;
  if (!isSeen(this)) return;
  showPicture();
  showTarget();
}

void AccuracyPanel::setPreviewing(bool previews) {
  previewing_ = previews;
  showPicture();
}

void AccuracyPanel::setComplete(bool complete) {
  complete_ = complete;
  if (complete) drawn_ = reported_;
  if (!isSeen(this)) return;
  showPicture();
  showTarget();
  measureSoon();
}

void AccuracyPanel::setPixels(std::function<QImage()> picture, const std::optional<render::Tile>& legend) {
  pixels_ = std::move(picture);
  legend_ = legend;
  showOverlay();
}

// What the user has just asked to see goes before what nobody has.
void AccuracyPanel::wantOverlay() {
  picture_->keepImages(overlay_->wanted());
  if (overlay_->wanted() && picture_->wanted()) task_.reset();
  restTimer_.stop();
  measure();
  showOverlay();
}

void AccuracyPanel::showOverlay() {
  ErrorOverlayBox::Shown shown;
  if (volume_ && overlay_->wanted()) {
    shown.errors = picture_->images();
    if (shown.errors && pixels_) shown.picture = pixels_();
    const glm::dvec3 edges = volume_->grid().geometry().spacingMm();
    shown.shortestEdgeMm = std::min({edges.x, edges.y, edges.z});
    shown.corner = resolved_.look.legendCorner;
    shown.legend = legend_;
    shown.limit = target_->limit();
  }
  overlay_->setShown(shown);
}

void AccuracyPanel::showPicture() {
  const bool lit = scene::usesGi(resolved_);
  if (!isSeen(this) || !volume_ || !complete_ || previewing_ || (lit && lightChanging_))
    return picture_->show({});
  picture_->show(PictureAccuracy::Subject{{volume_, resolved_, lit ? light_ : nullptr, drawn_.request.size},
                                          drawn_.onProcessor});
}

void AccuracyPanel::tellPicture() {
  const std::optional<app::Accuracy>& known = picture_->known();
  if (!known)
    Q_EMIT pictureKnown({}, {});
  else
    Q_EMIT pictureKnown(accuracyText(*known, render::readsHessian(resolved_, drawn_.request)),
                        accuracyMeaning(*known));
  showOverlay();
  showState();
}

void AccuracyPanel::showTarget() {
  app::TargetSubject subject;
  if (isSeen(this)) {
    subject.volume = volume_;
    subject.given = scene_;
    subject.picture.size = drawn_.request.size;
    subject.picture.supersampling = std::clamp(resolved_.picture.supersampling, 1, 4);
    subject.picture.pixelRatio = drawn_.request.pixelRatio;
    subject.host = host_;
    subject.light = light_;
  }
  target_->setSubject(subject);
}

}  // namespace isolux::ui
