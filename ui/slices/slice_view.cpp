#include "ui/slices/slice_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include "app/slices/slice_content.h"
#include "app/slices/slice_labels.h"
#include "base/color.h"
#include "ui/document/picture_pixels.h"

namespace isolux::ui {

namespace {

constexpr int smallest = 32;  // pixels of a side
// A full picture that takes longer has drafts, which take about draftMs.
constexpr double slowMs = 40.0, draftMs = 15.0;
constexpr int coarsest = 6;
constexpr double openAbout = 8.0, dot = 3.5;  // units of the painter
constexpr int stripeHigh = 2;                 // of the view's own colour, at the top

QPointF unitOf(glm::dvec2 pixel, double ratio) {
  const glm::dvec2 place = (pixel + 0.5) / ratio;
  return {place.x, place.y};
}

void strokeOnRim(QPainter& painter, const QLineF& line, const QColor& color) {
  for (const auto& [ink, thick] : {std::pair{QColor(0, 0, 0, 140), 3.0}, std::pair{color, 1.0}}) {
    painter.setPen(QPen(ink, thick));
    painter.drawLine(line);
  }
}

// The lines in which the planes of the other views cross the slice. `picture`: in pixels of the screen, of
// which the painter's unit has `ratio`. Lines are open about the crosshair, and end at `border` from the
// sides, where letters stand.
void paintPlanes(QPainter& painter, const volume::SlicePlane& picture, const std::vector<PlaneOfView>& planes,
                 glm::dvec3 crosshairMm, QSizeF border, double ratio) {
  const QRectF all(QPointF(0.0, 0.0), QSizeF(picture.size.x, picture.size.y) / ratio);
  const QPointF cross = unitOf(picture.pixelOf(crosshairMm), ratio);
  painter.save();
  painter.setClipRect(all.adjusted(border.width(), border.height(), -border.width(), -border.height()));
  for (const PlaneOfView& other : planes) {
    const auto ends = app::crossingLine(picture, other.plane);
    if (!ends) continue;
    const QLineF line(unitOf((*ends)[0], ratio), unitOf((*ends)[1], ratio));
    const bool straight = line.dx() == 0.0 || line.dy() == 0.0;
    painter.setRenderHint(QPainter::Antialiasing, !straight);
    const QPointF way = (line.p2() - line.p1()) / line.length();
    const double along = QPointF::dotProduct(cross - line.p1(), way);
    const QPointF foot = line.p1() + along * way;
    if (QLineF(foot, cross).length() > openAbout) {  // of a plane that the crosshair does not lie in
      strokeOnRim(painter, line, other.color);
      continue;
    }
    if (along > openAbout) strokeOnRim(painter, {line.p1(), foot - openAbout * way}, other.color);
    if (along < line.length() - openAbout)
      strokeOnRim(painter, {foot + openAbout * way, line.p2()}, other.color);
  }
  painter.restore();
}

// Points of marks no farther from the plane than `reachMm`; pins with their names.
void paintPoints(QPainter& painter, const volume::SlicePlane& picture, const std::vector<scene::Mark>& marks,
                 double reachMm, double ratio) {
  const glm::dvec3 normal = picture.frame().normal();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const scene::Mark& mark : marks) {
    if (!mark.shown) continue;
    const QColor color(base::screenByte(mark.color.x), base::screenByte(mark.color.y),
                       base::screenByte(mark.color.z));
    for (const glm::dvec3& point : mark.points) {
      if (std::abs(glm::dot(point - picture.originMm, normal)) > reachMm) continue;
      const QPointF at = unitOf(picture.pixelOf(point), ratio);
      painter.setPen(QPen(QColor(0, 0, 0, 200), 1.5));
      painter.setBrush(color);
      painter.drawEllipse(at, dot, dot);
      if (mark.kind != scene::MarkKind::point) continue;
      QPainterPath name;
      name.addText(at + QPointF(2.0 * dot, -dot), painter.font(), QString::fromStdString(mark.name));
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(QColor(0, 0, 0, 200), 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(name);
      painter.fillPath(name, QColor(0xf4, 0xf6, 0xf8));
    }
  }
  painter.restore();
}

}  // namespace

SliceView::SliceView(volume::SliceDirection direction, QColor color, QWidget* parent)
    : QWidget(parent), direction_(direction), color_(std::move(color)) {
  choice_.direction = direction;
  setMinimumSize(smallest, smallest);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::CrossCursor);
  setFocusPolicy(Qt::StrongFocus);
  nameIt();
}

void SliceView::nameIt() {
  constexpr const char* names[] = {QT_TRANSLATE_NOOP("QObject", "Axial slice"),
                                   QT_TRANSLATE_NOOP("QObject", "Coronal slice"),
                                   QT_TRANSLATE_NOOP("QObject", "Sagittal slice")};
  const app::SliceChoice now = choice();
  using Kind = app::SliceChoice::Kind;
  setAccessibleName(now.kind == Kind::straight  ? QObject::tr(names[static_cast<int>(now.direction)])
                    : now.kind == Kind::oblique ? tr("Oblique slice")
                                                : tr("Slice in clip plane %1").arg(now.cut + 1));
}

void SliceView::setVolume(const VolumePointer& volume) {
  if (task_) task_->progress().requestStop();
  volume_ = volume;
  zoom_ = 1.0;
  middle_.reset();
  fullMilliseconds_ = 0.0;
  choice_ = {.direction = direction_};
  nameIt();
  drawn_.reset();
  image_ = {};
  showAnew();
}

void SliceView::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  showAnew();
}

void SliceView::setInteracting(bool interacting) {
  interacting_ = interacting;
  orderNew();
}

void SliceView::setOthers(std::vector<PlaneOfView> others) {
  others_ = std::move(others);
  update();
}

void SliceView::choose(const app::SliceChoice& choice) {
  choice_ = choice;
  zoom_ = 1.0;
  middle_.reset();
  nameIt();
  showAnew();
  Q_EMIT chosen();
}

app::SliceChoice SliceView::choice() const {
  const bool gone =
      choice_.kind == app::SliceChoice::Kind::cut && choice_.cut >= resolved_.clip.planes.size();
  return gone ? app::SliceChoice{.direction = direction_} : choice_;
}

std::optional<app::ChosenPlane> SliceView::chosenPlane() const {
  if (!volume_) return std::nullopt;
  return app::chosenPlane(choice(), resolved_, volume_->grid().geometry(), volume_->volume.axes);
}

std::optional<PlaneOfView> SliceView::planeOfView() const {
  const auto chosen = chosenPlane();
  if (!chosen) return std::nullopt;
  return PlaneOfView{*chosen, color_};
}

glm::dvec3 SliceView::position() const {
  return volume_ ? app::slicePosition(resolved_, volume_->grid().geometry()) : glm::dvec3(0.0);
}

std::optional<volume::SlicePlane> SliceView::plane() const {
  const auto chosen = chosenPlane();
  if (!chosen) return std::nullopt;
  const QSize pixels = size() * devicePixelRatioF();
  volume::SlicePlane plane = fittedSlice(volume_->grid().geometry(), chosen->frame, chosen->pointMm,
                                         {std::max(1, pixels.width()), std::max(1, pixels.height())});
  if (zoom_ == 1.0 && !middle_) return plane;
  const glm::dvec2 half = 0.5 * glm::dvec2(plane.size - 1);
  const glm::dvec3 middle = plane.at(middle_ ? plane.pixelOf(*middle_) : half);
  plane.rightMm /= zoom_;
  plane.downMm /= zoom_;
  plane.originMm = middle - half.x * plane.rightMm - half.y * plane.downMm;
  return plane;
}

std::optional<app::SliceOrder> SliceView::order() const {
  const auto now = plane();
  if (!now) return std::nullopt;
  app::SliceOrder order = app::sliceOrder(volume_, *now, resolved_);
  order.pixelRatio = devicePixelRatioF();
  return order;
}

QPointF SliceView::placeOf(glm::dvec3 world) const {
  const glm::dvec2 pixel = (plane()->pixelOf(world) + 0.5) / devicePixelRatioF();
  return {pixel.x, pixel.y};
}

glm::dvec3 SliceView::worldAt(QPointF place) const {
  return plane()->at(glm::dvec2(place.x(), place.y()) * devicePixelRatioF() - 0.5);
}

int SliceView::coarseness() const {
  if (!interacting_ || fullMilliseconds_ <= slowMs) return 1;
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(fullMilliseconds_ / draftMs))), 2, coarsest);
}

void SliceView::orderNew() {
  if (!isVisible()) return;
  auto wanted = order();
  if (!wanted || (drawn_ && *wanted == *drawn_)) return;
  const int coarse = coarseness();
  if (task_) {  // a full one is not waited for while drafts are wanted
    if (coarse > 1 && ordered_.coarse == 1) task_->progress().requestStop();
    return;
  }
  wanted->coarse = coarse;
  if (drawn_ && *wanted == *drawn_) return;
  ordered_ = std::move(*wanted);
  task_.watch(app::sliceTask(ordered_), [this](auto& task) { take(task); });
}

void SliceView::showAnew() {
  orderNew();
  update();
}

void SliceView::take(app::SliceTask& task) {
  const app::SliceOrder order = std::exchange(ordered_, {});
  if (!task.error() && order.volume == volume_) {
    image_ = imageOf(task.value().picture);
    drawn_ = order;
    if (drawn_->coarse == 1) fullMilliseconds_ = task.value().milliseconds;
  } else if (task.error() && task.error()->kind() != base::ErrorKind::interrupted) {
    drawn_ = order;  // not again and again
    Q_EMIT failed(QString::fromStdString(task.error()->what()));
  }
  showAnew();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(24, 27, 32));
  const auto now = plane();
  if (!now || image_.isNull()) return;
  // Until the next one is there, the last picture lies where its points are now.
  const volume::SlicePlane& was = drawn_->plane;
  const bool inPlace = was == *now;
  const QPointF corner = placeOf(was.at(glm::dvec2(-0.5))), end = placeOf(was.at(glm::dvec2(was.size) - 0.5));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, !inPlace);
  painter.drawImage(inPlace ? QRectF(rect()) : QRectF(corner, end), image_);
  const double ratio = devicePixelRatioF();
  const scene::WorldAxes axes = volume_->volume.axes;
  const glm::dvec2 border = app::letterBorder(app::lettersOf(*now, axes), now->size, ratio) / ratio;
  paintPlanes(painter, *now, others_, position(), {border.x, border.y}, ratio);
  const glm::dvec3 normal = now->frame().normal();
  const double reach =
      std::max(0.5 * resolved_.slice.slab, 0.5 * volume::voxelAlong(volume_->grid().geometry(), normal));
  paintPoints(painter, *now, resolved_.marks, reach, ratio);
  painter.fillRect(0, 0, width(), stripeHigh, color_);
}

void SliceView::showWhole() {
  zoom_ = 1.0;
  middle_.reset();
  showAnew();
}

}  // namespace isolux::ui
