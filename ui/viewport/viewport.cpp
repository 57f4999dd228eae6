#include "ui/viewport/viewport.h"

#include <algorithm>
#include <cmath>

#include <QPushButton>

#include "app/overlay_text/annotation.h"
#include "app/ready/rest_scene.h"
#include "scene/rules/automatic.h"
#include "scene/rules/relevance.h"
#include "ui/document/picture_request.h"
#include "ui/language/sentences.h"
#include "ui/viewport/viewport_overlay.h"

namespace isolux::ui {

namespace {
constexpr int viewRestMilliseconds = 200;          // after the last change, before the fine picture
const QString caveatSign = QStringLiteral(" · ");  // between two of them
constexpr int pointedMilliseconds = 40;            // the pointer's value is looked up at most this often

// In the order of render::EmptyPicture::Remedy.
constexpr const char* remedyTexts[] = {"",
                                       QT_TRANSLATE_NOOP("isolux::ui::Viewport", "Suggested isovalue"),
                                       QT_TRANSLATE_NOOP("isolux::ui::Viewport", "Reset view"),
                                       QT_TRANSLATE_NOOP("isolux::ui::Viewport", "Make it opaque"),
                                       QT_TRANSLATE_NOOP("isolux::ui::Viewport", "Show all pieces"),
                                       QT_TRANSLATE_NOOP("isolux::ui::Viewport", "Remove the cuts")};

// Whether two scenes have the same pictures: marks lie over them.
bool samePictures(const scene::Scene& from, scene::Scene to) {
  to.marks = from.marks;
  return to == from;
}

// Whether two scenes differ in nothing but how a surface that is hit already is shown.
app::Motion motionBetween(const scene::Scene& from, scene::Scene to) {
  to.marks = from.marks;
  to.look = from.look;
  to.flow = from.flow;
  to.light = from.light;
  to.lamps = from.lamps;
  to.gi = from.gi;
  to.picture.exposure = from.picture.exposure;
  to.surfaces.front().albedo = from.surfaces.front().albedo;
  to.isosurface.albedoSource = from.isosurface.albedoSource;
  to.isosurface.albedoMap = from.isosurface.albedoMap;
  to.isosurface.albedoLow = from.isosurface.albedoLow;
  to.isosurface.albedoHigh = from.isosurface.albedoHigh;
  return to == from ? app::Motion::look : app::Motion::rays;
}
}  // namespace

Viewport::Viewport(QWidget* parent)
    : QWidget(parent),
      overlay_(new ViewportOverlay(this)),
      remedy_(new QPushButton(this)),
      caveats_(new QPushButton(this)) {
  resolved_ = scene::resolve(scene_, {});  // the background, until there is a volume
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setAttribute(Qt::WA_OpaquePaintEvent);  // the canvas covers it
  setAccessibleName(tr("3-D view"));
  remedy_->setObjectName("remedy");
  remedy_->hide();
  connect(remedy_, &QPushButton::clicked, this, &Viewport::takeRemedy);
  caveats_->setObjectName("caveats");
  caveats_->setFocusPolicy(Qt::TabFocus);
  caveats_->hide();
  connect(caveats_, &QPushButton::clicked, this, [this] {
    Edit edit{scene_, tr("Show all pieces"), {}, false};
    edit.scene.pieces = {};
    Q_EMIT edited(edit);
  });
  callOnce(refineTimer_, viewRestMilliseconds, this, &Viewport::refine);
  callOnce(pointTimer_, pointedMilliseconds, this, &Viewport::reportPointed);

  connect(&fadeTimer_, &QTimer::timeout, this, &Viewport::paintCanvas);
  connect(&turnTimer_, &QTimer::timeout, this, &Viewport::turnOn);
}

Viewport::~Viewport() = default;

// An empty picture says why (the overlay's note), and what would fill it is one click away.
void Viewport::offerRemedy(const std::optional<render::EmptyPicture>& empty) {
  using Remedy = render::EmptyPicture::Remedy;
  offered_ = empty ? empty->remedy : Remedy::none;
  remedy_->setVisible(offered_ != Remedy::none);
  if (offered_ == Remedy::none) return;
  remedy_->setText(tr(remedyTexts[static_cast<std::size_t>(offered_)]));
  placeButtons();
}

// As finished pictures have it written on them (app/overlay_text).
void Viewport::showCaveats() {
  const bool wasHidden = caveats_->isHidden();
  const app::Caveats caveats = volume_ ? app::caveatsOf(resolved_, *volume_) : app::Caveats{};
  QStringList words;
  for (const std::string& line : caveats.lines()) words += translatedSentence(line);
  caveats_->setVisible(!words.isEmpty());
  QString text = words.join(caveatSign);
  if (caveats.hidden > 0) text += " – " + tr("Show");
  if (text == QString(caveats_->text()).replace('\n', caveatSign)) {
    if (caveats_->isHidden() != wasHidden) placeButtons();
    return;
  }
  caveats_->setText(text);
  caveats_->setEnabled(caveats.hidden > 0);
  caveats_->setToolTip(caveats.hidden > 0 ? tr("Show all pieces") : QString());
  placeButtons();
}

void Viewport::takeRemedy() {
  using Remedy = render::EmptyPicture::Remedy;
  if (offered_ == Remedy::view) {
    resetView();
    return;
  }
  Edit edit{scene_, remedy_->text(), {}, false};
  if (offered_ == Remedy::isovalue) edit.scene.surfaces.front().value.reset();
  if (offered_ == Remedy::opacity) edit.scene.surfaces.front().opacity = 1.0;
  if (offered_ == Remedy::pieces) edit.scene.pieces = {};
  if (offered_ == Remedy::cuts) {
    edit.scene.clip.planes.clear();
    edit.scene.clip.box.clear();
    edit.scene.clip.removed.clear();
  }
  Q_EMIT edited(edit);
}

std::vector<QRectF> Viewport::legendBoxes() const {
  std::vector<QRectF> boxes;
  const auto add = [&](const std::optional<render::Tile>& tile) {  // from below, in the picture's pixels
    if (!tile || !picture_) return;
    const double across = static_cast<double>(width()) / picture_.size().width(),
                 down = static_cast<double>(height()) / picture_.size().height();
    boxes.emplace_back(across * tile->origin.x, height() - down * (tile->origin.y + tile->size.y),
                       across * tile->size.x, down * tile->size.y);
  };
  add(legend_);
  for (const Over what : {Over::errors, Over::levelZero, Over::structure})
    if (showsOver(what)) {
      add(laid_[static_cast<std::size_t>(what)].legend);
      break;
    }
  return boxes;
}

void Viewport::placeButtons() {
  constexpr int belowNote = 64, margin = 12;  // pixels: under a note of one line; from the picture's corner
  caveats_->setText(QString(caveats_->text()).replace('\n', caveatSign));
  caveats_->adjustSize();
  if (caveats_->width() > width() - 2 * margin) {  // a line each
    caveats_->setText(caveats_->text().replace(caveatSign, "\n"));
    caveats_->adjustSize();
  }
  QRectF place(width() - margin - caveats_->width(), height() - margin - caveats_->height(),
               caveats_->width(), caveats_->height());
  std::vector<QRectF> taken = legendBoxes();
  for (const QRectF& legend : taken)
    if (legend.intersects(place)) {
      const double left = legend.left() - margin - place.width();
      if (left >= margin)
        place.moveLeft(left);
      else
        place.moveBottom(legend.top() - margin);
    }
  caveats_->move(place.topLeft().toPoint());
  if (!caveats_->isHidden()) taken.push_back(place);
  overlay_->setTaken(std::move(taken));
  remedy_->adjustSize();
  const int below =
      std::max(topInset_ + belowNote,
               static_cast<int>(std::lround(overlay_->arrangement().note.bottom())) + margin / 2);
  remedy_->move((width() - remedy_->width()) / 2, below);
}

bool Viewport::complete() const {
  return current() && !turnsFrom_ && !bricksPending_ && !lightPending_ && !fieldsPending_ &&
         shownRequest_.size == pixelSize() && shownAtRest_ == restDiffers() &&
         shownRequest_.supersampling == std::clamp(resolved_.picture.supersampling, 1, 4);
}

// Something of the picture is another one.
void Viewport::changed() {
  ++changes_;
  if (!changed_) changed_ = std::chrono::steady_clock::now();
  if (hasContext_) failed_ = false;
  orderSoon();
}

void Viewport::redraw(app::Motion motion) {
  changed();
  if (motion == app::Motion::rays) viewChanged();
  quality_.changed(motion);
  refineTimer_.start(viewRestMilliseconds);
}

void Viewport::refine() {
  if (interacting_ || drag_ != Drag::none) return;  // starts again when the gesture ends
  if (complete()) {                                 // drawn in full at once: nothing finer follows
    while (quality_.refine()) {
    }
    return orderSoon();  // if all its rays are to be told
  }
  quality_.refine();
  orderSoon();  // refineSoon() starts the timer for the stage after this one
}

void Viewport::setInteracting(bool interacting) {
  interacting_ = interacting;
  if (interacting) return;
  if (fieldsPending_) changed();  // what was not begun while the isovalue moved
  rest();
}

void Viewport::rest() {
  refineTimer_.start(viewRestMilliseconds);
}

scene::WorldAxes Viewport::axes() const {
  return volume_ ? volume_->volume.axes : scene::WorldAxes::zUp;
}

void Viewport::setHint(const QString& text) {
  overlay_->setHint(text);
}

void Viewport::setTopInset(int pixels) {
  overlay_->setTopInset(pixels);
  topInset_ = pixels;
  placeButtons();
}

void Viewport::setVolume(VolumePointer volume) {
  fieldTask_.reset();
  fieldsOf_.reset();
  lastDerivatives_ = {};
  volume_ = std::move(volume);
  redraw();
}

void Viewport::setHostSettings(const scene::HostSettings& host) {
  if (canvas_ && host == host_) return;
  const bool otherCanvas = !canvas_ || host.canvas != host_.canvas;
  host_ = host;
  quality_.setHostSettings(host);
  if (otherCanvas) setCanvas(chooseCanvas(host.canvas));
  redraw();
}

void Viewport::setScene(const scene::Scene& scene, const scene::Scene& asked) {
  scene::Scene resolved = asked;
  resolved.picture = asInWindow(resolved.picture);
  const bool same = samePictures(resolved_, resolved) &&
                    (scene.marks != scene_.marks || !(scene.picture == scene_.picture));
  const app::Motion motion = motionBetween(resolved_, resolved);
  const bool switchedOn =
      scene::shadingOf(resolved) == scene::Shading::gi && scene::shadingOf(resolved_) != scene::Shading::gi;
  if (switchedOn) viewChanged();
  if (!(resolved.camera == resolved_.camera)) endTurn();
  scene_ = scene;
  resolved_ = resolved;
  showView();
  if (same) return;
  marksSeenFrom_ = 0;
  lookBehindMarks();
  showMarks();
  showLamps();
  showCuts();
  quality_.setSupersampling(resolved.picture.supersampling);
  redraw(motion);
}

void Viewport::setFlowTime(double seconds) {
  resolved_.flow.time = seconds;
  quality_.animated();
  changed();
}

void Viewport::setLight(LightPointer light, bool changing, bool shown) {
  if (light != light_) seenReflections_ = 0.0;
  light_ = std::move(light);
  showsLight_ = shown;
  // What few rays of the full picture still lack comes into that picture.
  quality_.setLightChanging(changing && !toldEveryRay());
  if (!changing && !refineTimer_.isActive()) rest();
  changed();
}

std::optional<app::Pick> Viewport::pickAt(QPointF position) const {
  if (!volume_ || !hasContext_ || failed_ || !rect().contains(position.toPoint())) return std::nullopt;
  const glm::dvec2 fraction(position.x() / width(), position.y() / height());
  const double aspect = static_cast<double>(pixelSize().x) / pixelSize().y;
  const scene::Scene shown = shownAtRest_ ? app::atRestIfReady(resolved_, *volume_) : resolved_;
  return app::pickSurface(*volume_, shown, {2.0 * fraction.x - 1.0, 1.0 - 2.0 * fraction.y}, aspect);
}

}  // namespace isolux::ui
