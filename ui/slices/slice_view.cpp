#include "ui/slices/slice_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/slices/slice_content.h"
#include "app/surfaces/surface_list.h"
#include "ui/editors/number_text.h"
#include "volume/field/reconstruct.h"

namespace isolux::ui {

namespace {

constexpr int pollMs = 8, smallest = 32;  // pixels of a side
constexpr double mostZoom = 64.0, notch = 120.0;

struct NamedWindow {
  const char* name;
  double level, width;  // HU
};
constexpr NamedWindow ctWindows[] = {{QT_TRANSLATE_NOOP("QObject", "Bone"), 500, 2000},
                                     {QT_TRANSLATE_NOOP("QObject", "Soft tissue"), 40, 400},
                                     {QT_TRANSLATE_NOOP("QObject", "Brain"), 40, 80},
                                     {QT_TRANSLATE_NOOP("QObject", "Lung"), -600, 1500},
                                     {QT_TRANSLATE_NOOP("QObject", "Angiography"), 300, 600}};

}  // namespace

SliceView::SliceView(volume::SliceDirection direction, QWidget* parent)
    : QWidget(parent), direction_(direction) {
  setMinimumSize(smallest, smallest);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::CrossCursor);
  constexpr const char* names[] = {QT_TRANSLATE_NOOP("QObject", "Axial slice"),
                                   QT_TRANSLATE_NOOP("QObject", "Coronal slice"),
                                   QT_TRANSLATE_NOOP("QObject", "Sagittal slice")};
  setAccessibleName(QObject::tr(names[static_cast<int>(direction)]));
  timer_.setInterval(pollMs);
  connect(&timer_, &QTimer::timeout, this, &SliceView::poll);
}

SliceView::~SliceView() = default;

void SliceView::setVolume(const VolumePointer& volume) {
  if (job_) job_->stop();
  volume_ = volume;
  zoom_ = 1.0;
  drawn_.reset();
  image_ = {};
  orderNew();
  update();
}

void SliceView::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  orderNew();
  update();
}

volume::SliceFrame SliceView::frame() const {
  return sliceFrame(direction_, volume_->volume.axes, resolved_.slice.convention);
}

glm::dvec3 SliceView::position() const {
  return volume_ ? app::slicePosition(resolved_, volume_->grid().geometry()) : glm::dvec3(0.0);
}

std::optional<volume::SlicePlane> SliceView::plane() const {
  if (!volume_) return std::nullopt;
  const volume::GridGeometry& geometry = volume_->grid().geometry();
  // Moving within the slice leaves it as it is.
  glm::dvec3 point = app::slicePosition({}, geometry);
  point[axisOf(direction_)] = position()[axisOf(direction_)];
  const QSize pixels = size() * devicePixelRatioF();
  volume::SlicePlane plane =
      fittedSlice(geometry, frame(), point, {std::max(1, pixels.width()), std::max(1, pixels.height())});
  if (zoom_ == 1.0) return plane;
  const glm::dvec2 half = 0.5 * glm::dvec2(plane.size - 1);
  const glm::dvec3 middle = plane.at(plane.pixelOf(middle_));
  plane.rightMm /= zoom_;
  plane.downMm /= zoom_;
  plane.originMm = middle - half.x * plane.rightMm - half.y * plane.downMm;
  return plane;
}

std::optional<app::SliceOrder> SliceView::order() const {
  const auto now = plane();
  if (!now) return std::nullopt;
  return app::sliceOrder(volume_, *now, resolved_);
}

QPointF SliceView::placeOf(glm::dvec3 world) const {
  const glm::dvec2 pixel = (plane()->pixelOf(world) + 0.5) / devicePixelRatioF();
  return {pixel.x, pixel.y};
}

glm::dvec3 SliceView::worldAt(QPointF place) const {
  return plane()->at(glm::dvec2(place.x(), place.y()) * devicePixelRatioF() - 0.5);
}

void SliceView::orderNew() {
  if (job_ || !isVisible()) return;
  auto wanted = order();
  if (!wanted || (drawn_ && *wanted == *drawn_)) return;
  job_ = std::make_unique<app::SliceJob>(std::move(*wanted));
  timer_.start();
}

void SliceView::poll() {
  if (!job_ || !job_->finished()) return;
  if (!job_->error() && job_->order().volume == volume_) {
    const render::ColorImage& picture = job_->picture();
    image_ = QImage(picture.rgba.data(), picture.size.x, picture.size.y, 4 * picture.size.x,
                    QImage::Format_RGBX8888)
                 .copy();
    drawn_ = job_->order();
  } else if (job_->error() && job_->error()->kind() != base::ErrorKind::interrupted) {
    drawn_ = job_->order();  // not again and again
    Q_EMIT failed(QString::fromStdString(job_->error()->what()));
  }
  job_.reset();
  timer_.stop();
  orderNew();
  update();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(24, 27, 32));
  if (!volume_ || image_.isNull()) return;
  // Until the next one is there, the last picture lies where its points are now.
  const volume::SlicePlane& was = drawn_->plane;
  const QPointF corner = placeOf(was.at(glm::dvec2(-0.5))), end = placeOf(was.at(glm::dvec2(was.size) - 0.5));
  painter.setRenderHint(QPainter::SmoothPixmapTransform, !complete());
  painter.drawImage(complete() ? QRectF(rect()) : QRectF(corner, end), image_);
  paintCrosshair(painter);
}

// Open in its middle, and short of the letters at the sides.
void SliceView::paintCrosshair(QPainter& painter) const {
  constexpr double gap = 8.0, border = 24.0;
  const QPointF cross = placeOf(position());
  const auto line = [&](bool across, double from, double to) {
    if (from >= to) return;
    if (across)
      painter.drawLine(QPointF(from, cross.y()), QPointF(to, cross.y()));
    else
      painter.drawLine(QPointF(cross.x(), from), QPointF(cross.x(), to));
  };
  for (const auto& [color, thick] :
       {std::pair{QColor(0, 0, 0, 140), 3}, std::pair{QColor(255, 190, 60), 1}}) {
    painter.setPen(QPen(color, thick));
    for (const bool across : {true, false}) {
      const double at = across ? cross.x() : cross.y(), end = (across ? width() : height()) - border;
      line(across, border, std::min(at - gap, end));
      line(across, std::max(at + gap, border), end);
    }
  }
}

void SliceView::resizeEvent(QResizeEvent*) {
  orderNew();
}

void SliceView::showEvent(QShowEvent*) {
  orderNew();
}

void SliceView::moveTo(QPointF place) {
  Edit edit{scene_, tr("Move crosshair"), "slice position", false};
  const volume::GridGeometry& geometry = volume_->grid().geometry();
  glm::dvec3 low, high;
  geometry.worldBounds(low, high);
  glm::dvec3 world = worldAt(place);
  world[axisOf(direction_)] = position()[axisOf(direction_)];
  edit.scene.slice.position = glm::clamp(world, low, high);
  Q_EMIT edited(edit);
}

volume::GreyWindow SliceView::window() const {
  return volume::greyWindow(resolved_.slice, volume_->histogram);
}

void SliceView::sendWindow(double level, double width, const char* mergeKey) {
  Edit edit{scene_, tr("Change level and width"), mergeKey, false};
  edit.scene.slice.level = level;
  edit.scene.slice.width = width;
  Q_EMIT edited(edit);
}

// A drag across the view changes the width about twentyfold, the level by the width.
void SliceView::dragWindow(QPointF step) {
  const volume::GreyWindow now = window();
  sendWindow(now.level + now.width * step.y() / std::max(1, height()),
             now.width * std::exp(3.0 * step.x() / std::max(1, width())), "slice window");
}

// One more isosurface, of the value there.
void SliceView::offerSurface(QMenu* menu, QPointF place) {
  const glm::dvec3 voxel(volume_->grid().geometry().voxelFromWorld() * glm::dvec4(worldAt(place), 1.0));
  const double value = volume::sampleTrilinear(volume_->grid(), voxel).value;
  if (!std::isfinite(value)) return;
  const std::optional<scene::Scene> added = app::withSurface(scene_, *volume_, value);
  const QString text = valueText(value, QString::fromStdString(volume_->volume.unit));
  QAction* const add = menu->addAction(tr("Add an isosurface at the value here, %1").arg(text));
  add->setEnabled(added.has_value());
  if (added)
    connect(add, &QAction::triggered, this, [this, scene = *added] {
      Q_EMIT edited({scene, tr("Add isosurface"), {}, false});
    });
  menu->addSeparator();
}

void SliceView::offerWindows(QPointF at, QPoint place) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  offerSurface(menu, at);
  const auto add = [&](const QString& name, std::optional<double> level, std::optional<double> width) {
    connect(menu->addAction(name), &QAction::triggered, this, [this, level, width] {
      Edit edit{scene_, tr("Change level and width"), {}, false};
      edit.scene.slice.level = level;
      edit.scene.slice.width = width;
      Q_EMIT edited(edit);
    });
  };
  add(tr("Automatic"), std::nullopt, std::nullopt);
  if (volume_->volume.unit == "HU")
    for (const NamedWindow& named : ctWindows) add(QObject::tr(named.name), named.level, named.width);
  menu->popup(place);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (!volume_ || drag_ != Drag::none) return;
  moved_ = false;
  last_ = event->position();
  if (event->button() == Qt::RightButton) drag_ = Drag::window;
  if (event->button() != Qt::LeftButton) return;
  drag_ = Drag::position;
  moveTo(last_);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ == Drag::none || !volume_) return;
  const QPointF step = event->position() - last_;
  if (drag_ == Drag::window && !moved_ && step.manhattanLength() < 4) return;
  moved_ = true;
  last_ = event->position();
  if (drag_ == Drag::position)
    moveTo(last_);
  else
    dragWindow(step);
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  const Drag was = std::exchange(drag_, Drag::none);
  if (was == Drag::none) return;
  if (was == Drag::window && !moved_ && volume_)
    offerWindows(event->position(), event->globalPosition().toPoint());
  Q_EMIT gestureEnded();
}

void SliceView::mouseDoubleClickEvent(QMouseEvent*) {
  zoom_ = 1.0;
  orderNew();
  update();
}

void SliceView::zoom(QPointF place, double factor) {
  const glm::dvec3 under = worldAt(place);
  const glm::dvec3 middle = worldAt(QRectF(rect()).center());
  const double before = zoom_;
  zoom_ = std::clamp(zoom_ * factor, 1.0, mostZoom);
  middle_ = under + (middle - under) * (before / zoom_);
  orderNew();
  update();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!volume_) return;
  const double notches = event->angleDelta().y() / notch;
  if (event->modifiers() & Qt::ControlModifier) {
    zoom(event->position(), std::pow(1.25, notches));
    return;
  }
  steps_ += notches;
  const double whole = std::trunc(steps_);
  if (whole == 0.0) return;
  steps_ -= whole;
  const volume::GridGeometry& geometry = volume_->grid().geometry();
  const int axis = axisOf(direction_);
  glm::dvec3 normal(0.0), low, high;
  normal[axis] = 1.0;
  geometry.worldBounds(low, high);
  Edit edit{scene_, tr("Move crosshair"), "slice wheel", true};
  glm::dvec3 world = position();
  world[axis] = std::clamp(world[axis] + whole * voxelAlong(geometry, normal), low[axis], high[axis]);
  edit.scene.slice.position = world;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
