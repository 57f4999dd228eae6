#include "ui/editors/points_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {
constexpr std::size_t mostPoints = 64;
constexpr double grabRadius = 10.0;  // pixels
}  // namespace

PointsView::PointsView(std::vector<Axis> axes, std::size_t fewest, QWidget* parent)
    : QWidget(parent), axes_(std::move(axes)), fewest_(fewest) {
  setFocusPolicy(Qt::StrongFocus);
}

void PointsView::showPoints(const std::vector<MapPoint>& points) {
  if (points == points_) return;
  points_ = points;
  map_ = pictureOf(points_);
  select(selected_);
}

void PointsView::select(int index) {
  selected_ = std::clamp(index, 0, static_cast<int>(points_.size()) - 1);
  update();
  Q_EMIT selectionChanged();
}

bool PointsView::canAdd() const {
  return points_.size() < mostPoints;
}

void PointsView::addPoint(glm::dvec2 at) {
  if (!canAdd()) return;
  at = reachable(at, points_.size());
  const std::size_t index = indexOfNew(at);
  std::vector<MapPoint> points = points_;
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(index), {at, colorAt(at)});
  selected_ = static_cast<int>(index);
  showPoints(points);
  Q_EMIT changed(false);
}

void PointsView::removeSelected() {
  if (!canRemove()) return;
  std::vector<MapPoint> points = points_;
  points.erase(points.begin() + selected_);
  showPoints(points);
  Q_EMIT changed(false);
}

void PointsView::replaceSelected(MapPoint point, bool endsAfterPause) {
  const auto index = static_cast<std::size_t>(selected_);
  if (point.at != selectedPoint().at) point.at = reachable(point.at, index);
  if (point == selectedPoint()) return;
  std::vector<MapPoint> points = points_;
  points[index] = point;
  showPoints(points);
  Q_EMIT changed(endsAfterPause);
}

int PointsView::pointAt(QPointF position) const {
  const QPointF pointer = positionOf(placeAt(position));  // over a bar its height does not count
  int nearest = -1;
  double least = grabRadius;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF offset = positionOf(points_[i].at) - pointer;
    const double distance = std::hypot(offset.x(), offset.y());
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void PointsView::beginDrag(QPointF grip) {
  grip_ = grip;
  pressed_ = true;
  Q_EMIT dragStarted();
}

void PointsView::mousePressEvent(QMouseEvent* event) {
  const int index = pointAt(event->position());
  if (event->button() != Qt::LeftButton || index < 0) return;
  select(index);
  beginDrag(positionOf(selectedPoint().at) - event->position());
}

void PointsView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (event->buttons() & Qt::LeftButton)
    replaceSelected({placeAt(event->position() + grip_), selectedPoint().color}, false);
  else if (std::exchange(pressed_, false))  // it was let go elsewhere
    Q_EMIT dragEnded();
}

void PointsView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && std::exchange(pressed_, false)) Q_EMIT dragEnded();
}

void PointsView::keyPressEvent(QKeyEvent* event) {
  const auto is = [event](Qt::Key key) { return event->key() == key; };
  if (is(Qt::Key_Delete) || is(Qt::Key_Backspace)) return removeSelected();
  glm::dvec2 way = arrowOf(event->key());
  if (axes_.size() == 1) way.y = 0.0;
  if (way == glm::dvec2(0.0)) return QWidget::keyPressEvent(event);
  replaceSelected({selectedPoint().at + axes_.front().step * way, selectedPoint().color}, true);
}

void PointsView::paintOver(QPainter& painter) const {
  painter.setPen(QPen(colours.border, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area());
}

void PointsView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (!isEnabled()) painter.setOpacity(0.4);
  painter.drawImage(area(), map_);
  paintOver(painter);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF centre = positionOf(points_[i].at);
    const bool chosen = static_cast<int>(i) == selected_;
    const double size = chosen ? radius + 1.0 : radius;
    painter.setBrush(screenColour(points_[i].color));
    painter.setPen(QPen(QColor(0, 0, 0, 170), chosen ? 4.5 : 3.5));
    painter.drawEllipse(centre, size, size);
    painter.setPen(QPen(chosen && hasFocus() ? colours.accent : QColor(Qt::white), chosen ? 2.5 : 1.5));
    painter.drawEllipse(centre, size, size);
  }
}

PointsEditor::PointsEditor(PointsView* view, QWidget* parent)
    : ValueWidget(parent),
      view_(view),
      colour_(new ColorButton(this)),
      add_(textButton("+", {}, this)),
      remove_(textButton("−", {}, this)) {
  setFocusProxy(view_);
  colour_->setIconSize({34, 16});
  nameAndTip(colour_, tr("Colour of the selected point"));
  nameAndTip(add_, tr("Add a point"), view->addTip());
  nameAndTip(remove_, tr("Remove the selected point"), tr("Remove the selected point (Delete)"));
  auto* row = lineOf({colour_}, 4);
  for (const PointsView::Axis& axis : view->axes()) {
    auto* box = places_.emplace_back(new NumberSpinBox(this));
    box->setRange(axis.minimum, 1.0);
    box->setSingleStep(axis.step);
    nameAndTip(box, axis.title, axis.tip);
    if (!axis.name.isEmpty()) row->addWidget(new QLabel(axis.name, this));
    row->addWidget(box, 1);
    connect(box, &NumberSpinBox::valueChanged, this, &PointsEditor::moveSelected);
  }
  for (QToolButton* button : {add_, remove_}) {
    button->setFixedSize(26, 26);
    row->addWidget(button);
  }
  layOut(this, columnOf({view_, row}, 4), {});

  connect(view_, &PointsView::changed, this, &ValueWidget::changed);
  connect(view_, &PointsView::dragStarted, this, &ValueWidget::dragStarted);
  connect(view_, &PointsView::dragEnded, this, &ValueWidget::dragEnded);
  connect(view_, &PointsView::selectionChanged, this, &PointsEditor::showSelected);
  connect(colour_, &ColorButton::chosen, this, [this](glm::dvec3 colour) {
    view_->replaceSelected({view_->selectedPoint().at, colour}, true);
  });
  connect(add_, &QToolButton::clicked, view_, &PointsView::addAnother);
  connect(remove_, &QToolButton::clicked, view_, &PointsView::removeSelected);
  showSelected();
}

// Each point is its place, then its colour.
void PointsEditor::showValue(const nlohmann::json& value) {
  const std::size_t axes = places_.size();
  std::vector<MapPoint> points;
  for (const nlohmann::json& p : value)
    points.push_back({{p[0], axes > 1 ? p[1].get<double>() : 0.0}, {p[axes], p[axes + 1], p[axes + 2]}});
  view_->showPoints(points);
}

nlohmann::json PointsEditor::value() const {
  nlohmann::json value = nlohmann::json::array();
  for (const MapPoint& point : view_->points()) {
    nlohmann::json& entry = value.emplace_back(nlohmann::json::array({point.at.x}));
    if (places_.size() > 1) entry.push_back(point.at.y);
    for (int i = 0; i < 3; ++i) entry.push_back(point.color[i]);
  }
  return value;
}

void PointsEditor::showSelected() {
  const MapPoint& point = view_->selectedPoint();
  colour_->showColour(point.color);
  for (std::size_t i = 0; i < places_.size(); ++i) places_[i]->showValue(point.at[static_cast<int>(i)]);
  add_->setEnabled(view_->canAdd());
  remove_->setEnabled(view_->canRemove());
}

void PointsEditor::moveSelected() {
  MapPoint point = view_->selectedPoint();
  for (std::size_t i = 0; i < places_.size(); ++i) point.at[static_cast<int>(i)] = places_[i]->value();
  view_->replaceSelected(point, true);
  showSelected();  // what was typed may lie where no point can be
}

}  // namespace isolux::ui
