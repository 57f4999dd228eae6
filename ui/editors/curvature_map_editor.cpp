#include "ui/editors/curvature_map_editor.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "scene/curvature_map.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::ui {

namespace {

using scene::CurvaturePoint;

constexpr int texels = 96;        // of the picture of the map, per axis; drawn smoothly
constexpr double radius = 6.0;    // of a point, pixels
constexpr double keyStep = 0.02;  // of the range -1 .. 1
constexpr std::size_t mostPoints = 64;
// Room around the square for the names of the axes and of the shapes.
constexpr double left = 22.0, right = 52.0, top = 10.0, bottom = 42.0;
constexpr int largestSide = 200;

// What can occur: kappa1 >= kappa2, both in the range. A point above the diagonal goes to the nearest on it.
glm::dvec2 reachable(glm::dvec2 kappa) {
  kappa = glm::clamp(kappa, -1.0, 1.0);
  if (kappa.y > kappa.x) kappa = glm::dvec2(0.5 * (kappa.x + kappa.y));
  return glm::round(kappa * 1000.0) / 1000.0;
}

// The place that can occur and is farthest from all points.
glm::dvec2 largestGap(const std::vector<CurvaturePoint>& points) {
  constexpr int steps = 20;
  glm::dvec2 best{0.0};
  double most = -1.0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= i; ++j) {
      const glm::dvec2 place = glm::dvec2(i, j) / static_cast<double>(steps);
      double nearest = 1e9;
      for (const CurvaturePoint& point : points)
        nearest = std::min(nearest, glm::distance(place, glm::dvec2(point.kappa1, point.kappa2)));
      if (nearest > most) {
        most = nearest;
        best = place;
      }
    }
  }
  return best;
}

QImage pictureOf(const std::vector<CurvaturePoint>& points) {
  QImage image(texels, texels, QImage::Format_RGB32);
  scene::Look look;
  look.curvaturePoints = points;
  const std::vector<glm::vec3> samples = scene::curvatureTexels(look, texels);
  for (int row = 0; row < texels; ++row)
    for (int column = 0; column < texels; ++column)
      image.setPixel(
          column, texels - 1 - row,
          screenColour(samples[static_cast<std::size_t>(row) * texels + static_cast<std::size_t>(column)])
              .rgb());
  return image;
}

}  // namespace

// ---- The square
// ---------------------------------------------------------------------------------------------

CurvatureMapView::CurvatureMapView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setFixedHeight(largestSide + static_cast<int>(top + bottom));
  setMinimumWidth(static_cast<int>(left + right) + largestSide / 2);
  setAccessibleName(tr("Colour map of the principal curvatures"));
  showPoints(scene::automaticCurvaturePoints());
}

QRectF CurvatureMapView::square() const {
  const double side = std::max(std::min(width() - left - right, height() - top - bottom), 1.0);
  return {left, top, side, side};
}

QPointF CurvatureMapView::positionOf(glm::dvec2 kappa) const {
  const QRectF area = square();
  return {area.left() + 0.5 * (kappa.x + 1.0) * area.width(),
          area.bottom() - 0.5 * (kappa.y + 1.0) * area.height()};
}

glm::dvec2 CurvatureMapView::kappaAt(QPointF position) const {
  const QRectF area = square();
  return {2.0 * (position.x() - area.left()) / area.width() - 1.0,
          2.0 * (area.bottom() - position.y()) / area.height() - 1.0};
}

void CurvatureMapView::showPoints(const std::vector<CurvaturePoint>& points) {
  if (points == points_) return;
  points_ = points;
  map_ = pictureOf(points_);
  selected_ = std::clamp(selected_, 0, static_cast<int>(points_.size()) - 1);
  update();
  Q_EMIT selectionChanged();
}

void CurvatureMapView::select(int index) {
  selected_ = std::clamp(index, 0, static_cast<int>(points_.size()) - 1);
  update();
  Q_EMIT selectionChanged();
}

void CurvatureMapView::addPoint(glm::dvec2 kappa) {
  if (points_.size() >= mostPoints) return;
  kappa = reachable(kappa);
  std::vector<CurvaturePoint> points = points_;
  points.push_back({kappa.x, kappa.y, scene::curvatureColor(points_, kappa)});
  selected_ = static_cast<int>(points.size()) - 1;
  showPoints(points);
  Q_EMIT changed(false);
}

void CurvatureMapView::removeSelected() {
  if (points_.size() <= 1) return;
  std::vector<CurvaturePoint> points = points_;
  points.erase(points.begin() + selected_);
  showPoints(points);
  Q_EMIT changed(false);
}

void CurvatureMapView::replaceSelected(CurvaturePoint point, bool endsAfterPause) {
  std::vector<CurvaturePoint> points = points_;
  CurvaturePoint& old = points[static_cast<std::size_t>(selected_)];
  if (point.kappa1 != old.kappa1 || point.kappa2 != old.kappa2) {
    const glm::dvec2 kappa = reachable({point.kappa1, point.kappa2});
    point.kappa1 = kappa.x;
    point.kappa2 = kappa.y;
  }
  if (point == old) return;
  old = point;
  showPoints(points);
  Q_EMIT changed(endsAfterPause);
}

int CurvatureMapView::pointAt(QPointF position) const {
  int nearest = -1;
  double least = radius + 4.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF offset = positionOf({points_[i].kappa1, points_[i].kappa2}) - position;
    const double distance = std::hypot(offset.x(), offset.y());
    if (distance < least) {
      least = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

void CurvatureMapView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const int index = pointAt(event->position());
  if (index < 0) return;
  select(index);
  const CurvaturePoint& point = points_[static_cast<std::size_t>(index)];
  grip_ = positionOf({point.kappa1, point.kappa2}) - event->position();
  pressed_ = true;
  Q_EMIT dragStarted();
}

void CurvatureMapView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!(event->buttons() & Qt::LeftButton)) {  // it was let go elsewhere
    pressed_ = false;
    Q_EMIT dragEnded();
    return;
  }
  CurvaturePoint point = points_[static_cast<std::size_t>(selected_)];
  const glm::dvec2 kappa = kappaAt(event->position() + grip_);
  point.kappa1 = kappa.x;
  point.kappa2 = kappa.y;
  replaceSelected(point, false);
}

void CurvatureMapView::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_ || event->button() != Qt::LeftButton) return;
  pressed_ = false;
  Q_EMIT dragEnded();
}

void CurvatureMapView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && pointAt(event->position()) < 0)
    addPoint(kappaAt(event->position()));
}

void CurvatureMapView::keyPressEvent(QKeyEvent* event) {
  glm::dvec2 step{0.0};
  switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      removeSelected();
      return;
    case Qt::Key_Left:
      step.x = -keyStep;
      break;
    case Qt::Key_Right:
      step.x = keyStep;
      break;
    case Qt::Key_Up:
      step.y = keyStep;
      break;
    case Qt::Key_Down:
      step.y = -keyStep;
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  CurvaturePoint point = points_[static_cast<std::size_t>(selected_)];
  point.kappa1 += step.x;
  point.kappa2 += step.y;
  replaceSelected(point, true);
}

void CurvatureMapView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!isEnabled()) painter.setOpacity(0.4);
  const QRectF area = square();
  painter.drawImage(area, map_);
  QPainterPath never;
  never.addPolygon(QPolygonF({area.topLeft(), area.topRight(), area.bottomLeft(), area.topLeft()}));
  QColor veil = colours.base;
  veil.setAlpha(210);
  painter.fillPath(never, veil);
  painter.fillPath(never, QBrush(colours.border, Qt::BDiagPattern));
  painter.setPen(QPen(colours.border, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);
  paintAxes(painter);
  paintPoints(painter);
}

void CurvatureMapView::paintAxes(QPainter& painter) const {
  const QRectF area = square();
  painter.setPen(QPen(QColor(255, 255, 255, 70), 1.0));
  painter.drawLine(positionOf({0.0, 0.0}), positionOf({1.0, 0.0}));
  painter.drawLine(positionOf({0.0, 0.0}), positionOf({0.0, -1.0}));

  QFont small = font();
  small.setPointSizeF(0.86 * small.pointSizeF());
  painter.setFont(small);
  painter.setPen(colours.quietText);
  const double line = QFontMetricsF(small).height();
  const auto beside = [&](double kappa2, const QString& text) {
    const double y = std::clamp(positionOf({1.0, kappa2}).y() - 0.5 * line, area.top(), area.bottom() - line);
    painter.drawText(QRectF(area.right() + radius + 5.0, y, right, line), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
  };
  const auto below = [&](double kappa1, const QString& text, Qt::Alignment side) {
    const double x = positionOf({kappa1, -1.0}).x();
    const double from = side == Qt::AlignLeft ? x : side == Qt::AlignRight ? x - 60.0 : x - 30.0;
    painter.drawText(QRectF(from, area.bottom() + radius + 3.0, 60.0, line), side | Qt::AlignTop, text);
  };
  beside(1.0, tr("cap"));
  beside(0.0, tr("ridge"));
  beside(-1.0, tr("saddle"));
  below(-1.0, tr("cup"), Qt::AlignLeft);
  below(0.0, tr("valley"), Qt::AlignHCenter);
  painter.setPen(colours.text);
  painter.drawText(QRectF(area.left(), area.bottom() + radius + 5.0 + line, area.width(), line),
                   Qt::AlignCenter, "κ₁  →");
  painter.save();
  painter.translate(0.0, area.bottom());
  painter.rotate(-90.0);
  painter.drawText(QRectF(0.0, 0.0, area.height(), left - 3.0), Qt::AlignCenter, "κ₂  →");
  painter.restore();
}

void CurvatureMapView::paintPoints(QPainter& painter) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF centre = positionOf({points_[i].kappa1, points_[i].kappa2});
    const bool chosen = static_cast<int>(i) == selected_;
    const double size = chosen ? radius + 1.0 : radius;
    painter.setBrush(screenColour(points_[i].color));
    painter.setPen(QPen(QColor(0, 0, 0, 170), chosen ? 4.5 : 3.5));
    painter.drawEllipse(centre, size, size);
    painter.setPen(QPen(chosen && hasFocus() ? colours.accent : QColor(Qt::white), chosen ? 2.5 : 1.5));
    painter.drawEllipse(centre, size, size);
  }
}

// ---- The square with what belongs to its selected point
// ------------------------------------------------------------------------------------------------------------

CurvatureMapEditor::CurvatureMapEditor(QWidget* parent)
    : ValueWidget(parent),
      view_(new CurvatureMapView(this)),
      colour_(new ColorButton(this)),
      kappa1_(new NumberSpinBox(this)),
      kappa2_(new NumberSpinBox(this)),
      add_(new QToolButton(this)),
      remove_(new QToolButton(this)) {
  setFocusProxy(view_);
  colour_->setIconSize({34, 16});
  colour_->setToolTip(tr("Colour of the selected point"));
  add_->setText("+");
  add_->setToolTip(tr("Add a point (double click on the map)"));
  add_->setAccessibleName(tr("Add a point"));
  remove_->setText("−");
  remove_->setToolTip(tr("Remove the selected point (Delete)"));
  remove_->setAccessibleName(tr("Remove the selected point"));
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(colour_);
  for (auto [box, name] : {std::pair{kappa1_, "κ₁"}, std::pair{kappa2_, "κ₂"}}) {
    box->setRange(-1.0, 1.0);
    box->setSingleStep(keyStep);
    box->setAccessibleName(name);
    box->setToolTip(tr("%1 of the selected point, as a fraction of the range").arg(name));
    row->addWidget(new QLabel(name, this));
    row->addWidget(box, 1);
    connect(box, &NumberSpinBox::valueChanged, this, &CurvatureMapEditor::moveSelected);
  }
  for (QToolButton* button : {add_, remove_}) {
    button->setFixedSize(26, 26);
    row->addWidget(button);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(view_);
  layout->addLayout(row);

  connect(view_, &CurvatureMapView::changed, this, &ValueWidget::changed);
  connect(view_, &CurvatureMapView::dragStarted, this, &ValueWidget::dragStarted);
  connect(view_, &CurvatureMapView::dragEnded, this, &ValueWidget::dragEnded);
  connect(view_, &CurvatureMapView::selectionChanged, this, &CurvatureMapEditor::showSelected);
  connect(colour_, &ColorButton::chosen, this, [this](glm::dvec3 colour) {
    CurvaturePoint point = view_->points()[static_cast<std::size_t>(view_->selected())];
    point.color = colour;
    view_->replaceSelected(point, true);
  });
  connect(add_, &QToolButton::clicked, this, [this] { view_->addPoint(largestGap(view_->points())); });
  connect(remove_, &QToolButton::clicked, view_, &CurvatureMapView::removeSelected);
  showSelected();
}

void CurvatureMapEditor::showValue(const nlohmann::json& value) {
  scene::Scene scene;
  scene::setting("look.curvature_points").set(scene, value);
  view_->showPoints(scene.look.curvaturePoints.value_or(scene::automaticCurvaturePoints()));
}

nlohmann::json CurvatureMapEditor::value() const {
  scene::Scene scene;
  scene.look.curvaturePoints = view_->points();
  return scene::setting("look.curvature_points").get(scene);
}

void CurvatureMapEditor::showSelected() {
  const CurvaturePoint& point = view_->points()[static_cast<std::size_t>(view_->selected())];
  colour_->showColour(point.color);
  kappa1_->showValue(point.kappa1);
  kappa2_->showValue(point.kappa2);
  add_->setEnabled(view_->points().size() < mostPoints);
  remove_->setEnabled(view_->points().size() > 1);
}

void CurvatureMapEditor::moveSelected() {
  CurvaturePoint point = view_->points()[static_cast<std::size_t>(view_->selected())];
  point.kappa1 = kappa1_->value();
  point.kappa2 = kappa2_->value();
  view_->replaceSelected(point, true);
  showSelected();  // what was typed may lie above the diagonal
}

}  // namespace isolux::ui
