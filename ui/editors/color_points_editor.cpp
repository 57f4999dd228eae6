#include "ui/editors/color_points_editor.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>

#include "scene/color_maps.h"
#include "scene/settings/setting_value.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::ui {

namespace {

using scene::ColorPoint;

constexpr int barSamples = 256;       // of the bar's colours; drawn smoothly
constexpr double handleRadius = 6.0;  // of a point, pixels
constexpr double barStep = 0.01;      // of the range 0 .. 1
constexpr std::size_t fewestColors = 2, mostColors = 64;
constexpr double barMargin = 9.0, barHeight = 24.0;

double toThousandths(double position) {
  return std::round(position * 1000.0) / 1000.0;
}

QImage barPicture(const std::vector<ColorPoint>& points) {
  QImage image(barSamples, 1, QImage::Format_RGB32);
  const std::vector<glm::vec3> samples = scene::pointSamples(points, barSamples);
  for (int i = 0; i < barSamples; ++i)
    image.setPixel(i, 0, screenColour(samples[static_cast<std::size_t>(i)]).rgb());
  return image;
}

}  // namespace

ColorPointsView::ColorPointsView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setFixedHeight(static_cast<int>(barHeight + 2.0 * barMargin));
  setMinimumWidth(120);
  setAccessibleName(tr("Colour bar with control points"));
  showPoints({{0.0, glm::dvec3(0.0)}, {1.0, glm::dvec3(1.0)}});
}

QRectF ColorPointsView::bar() const {
  return {barMargin, barMargin, std::max(width() - 2.0 * barMargin, 1.0), barHeight};
}

QPointF ColorPointsView::placeOf(double position) const {
  return {bar().left() + position * bar().width(), bar().center().y()};
}

double ColorPointsView::positionAt(QPointF place) const {
  return std::clamp((place.x() - bar().left()) / bar().width(), 0.0, 1.0);
}

void ColorPointsView::showPoints(const std::vector<ColorPoint>& points) {
  if (points == points_) return;
  points_ = points;
  colours_ = barPicture(points_);
  select(selected_);
}

void ColorPointsView::select(int index) {
  selected_ = std::clamp(index, 0, static_cast<int>(points_.size()) - 1);
  setAccessibleDescription(tr("Point %1 of %2 at %3")
                               .arg(selected_ + 1)
                               .arg(points_.size())
                               .arg(numberText(selectedPoint().position)));
  update();
  Q_EMIT selectionChanged();
}

void ColorPointsView::addPoint(double position) {
  if (points_.size() >= mostColors) return;
  const ColorPoint point{toThousandths(position), scene::colorOfPoints(points_, position)};
  std::vector<ColorPoint> points = points_;
  const auto at =
      std::upper_bound(points.begin(), points.end(), point,
                       [](const ColorPoint& a, const ColorPoint& b) { return a.position < b.position; });
  const auto added = points.insert(at, point);
  selected_ = static_cast<int>(added - points.begin());
  showPoints(points);
  Q_EMIT changed(false);
}

void ColorPointsView::addBehindSelected() {
  const auto from = static_cast<std::size_t>(std::min(selected_, static_cast<int>(points_.size()) - 2));
  addPoint(0.5 * (points_[from].position + points_[from + 1].position));
}

void ColorPointsView::removeSelected() {
  if (points_.size() <= fewestColors) return;
  std::vector<ColorPoint> points = points_;
  points.erase(points.begin() + selected_);
  showPoints(points);
  Q_EMIT changed(false);
}

void ColorPointsView::replaceSelected(ColorPoint point, bool endsAfterPause) {
  std::vector<ColorPoint> points = points_;
  const auto at = static_cast<std::size_t>(selected_);
  if (point.position != points[at].position) {
    const double least = at == 0 ? 0.0 : points[at - 1].position;
    const double most = at + 1 == points.size() ? 1.0 : points[at + 1].position;
    point.position = std::clamp(toThousandths(point.position), least, most);
  }
  if (point == points[at]) return;
  points[at] = point;
  showPoints(points);
  Q_EMIT changed(endsAfterPause);
}

int ColorPointsView::pointAt(QPointF place) const {
  int nearest = -1;
  double least = handleRadius + 3.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double distance = std::abs(placeOf(points_[i].position).x() - place.x());
    if (distance >= least) continue;
    least = distance;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

void ColorPointsView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const int index = pointAt(event->position());
  pressed_ = true;
  Q_EMIT dragStarted();
  if (index >= 0)
    select(index);
  else
    addPoint(positionAt(event->position()));
}

void ColorPointsView::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!(event->buttons() & Qt::LeftButton)) {  // it was let go elsewhere
    pressed_ = false;
    Q_EMIT dragEnded();
    return;
  }
  ColorPoint point = selectedPoint();
  point.position = positionAt(event->position());
  replaceSelected(point, false);
}

void ColorPointsView::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_ || event->button() != Qt::LeftButton) return;
  pressed_ = false;
  Q_EMIT dragEnded();
}

void ColorPointsView::keyPressEvent(QKeyEvent* event) {
  ColorPoint point = selectedPoint();
  switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return removeSelected();
    case Qt::Key_Insert:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return addBehindSelected();
    case Qt::Key_Left:
      point.position -= barStep;
      break;
    case Qt::Key_Right:
      point.position += barStep;
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  replaceSelected(point, true);
}

void ColorPointsView::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) select(0);
  if (event->reason() == Qt::BacktabFocusReason) select(static_cast<int>(points_.size()) - 1);
  QWidget::focusInEvent(event);
}

bool ColorPointsView::focusNextPrevChild(bool next) {
  const int wanted = selected_ + (next ? 1 : -1);
  if (wanted < 0 || wanted >= static_cast<int>(points_.size())) return QWidget::focusNextPrevChild(next);
  select(wanted);
  return true;
}

void ColorPointsView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!isEnabled()) painter.setOpacity(0.4);
  painter.drawImage(bar(), colours_);
  painter.setPen(QPen(colours.border, 1.0));
  painter.drawRect(bar());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const bool chosen = static_cast<int>(i) == selected_;
    const double size = chosen ? handleRadius + 1.0 : handleRadius;
    painter.setBrush(screenColour(points_[i].color));
    painter.setPen(QPen(QColor(0, 0, 0, 170), chosen ? 4.5 : 3.5));
    painter.drawEllipse(placeOf(points_[i].position), size, size);
    painter.setPen(QPen(chosen && hasFocus() ? colours.accent : QColor(Qt::white), chosen ? 2.5 : 1.5));
    painter.drawEllipse(placeOf(points_[i].position), size, size);
  }
}

ColorPointsEditor::ColorPointsEditor(const scene::SettingInfo& setting, QWidget* parent)
    : ValueWidget(parent),
      view_(new ColorPointsView(this)),
      colour_(new ColorButton(this)),
      position_(new NumberSpinBox(this)),
      add_(new QToolButton(this)),
      remove_(new QToolButton(this)) {
  setFocusProxy(view_);
  colour_->setIconSize({34, 16});
  colour_->setToolTip(tr("Colour of the selected point"));
  colour_->setAccessibleName(tr("Colour of the selected point"));
  position_->setRange(setting.minimum, setting.maximum);
  position_->setSingleStep(barStep);
  position_->setToolTip(tr("Position of the selected point, as a fraction of the range"));
  position_->setAccessibleName(tr("Position of the selected point"));
  add_->setText("+");
  add_->setToolTip(tr("Add a point (click on the bar, or Insert)"));
  add_->setAccessibleName(tr("Add a point"));
  remove_->setText("−");
  remove_->setToolTip(tr("Remove the selected point (Delete)"));
  remove_->setAccessibleName(tr("Remove the selected point"));
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(colour_);
  row->addWidget(position_, 1);
  for (QToolButton* button : {add_, remove_}) {
    button->setFixedSize(26, 26);
    row->addWidget(button);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(view_);
  layout->addLayout(row);

  connect(view_, &ColorPointsView::changed, this, &ValueWidget::changed);
  connect(view_, &ColorPointsView::dragStarted, this, &ValueWidget::dragStarted);
  connect(view_, &ColorPointsView::dragEnded, this, &ValueWidget::dragEnded);
  connect(view_, &ColorPointsView::selectionChanged, this, &ColorPointsEditor::showSelected);
  connect(colour_, &ColorButton::chosen, this, [this](glm::dvec3 colour) {
    view_->replaceSelected({view_->selectedPoint().position, colour}, true);
  });
  connect(position_, &NumberSpinBox::valueChanged, this, [this] {
    view_->replaceSelected({position_->value(), view_->selectedPoint().color}, true);
    showSelected();  // what was typed may lie beyond a neighbour
  });
  connect(add_, &QToolButton::clicked, view_, &ColorPointsView::addBehindSelected);
  connect(remove_, &QToolButton::clicked, view_, &ColorPointsView::removeSelected);
  showSelected();
}

void ColorPointsEditor::showValue(const nlohmann::json& value) {
  std::vector<ColorPoint> points;
  for (const nlohmann::json& point : value) points.push_back({point[0], {point[1], point[2], point[3]}});
  view_->showPoints(points);
}

nlohmann::json ColorPointsEditor::value() const {
  return scene::jsonOf(view_->points());
}

void ColorPointsEditor::showSelected() {
  colour_->showColour(view_->selectedPoint().color);
  position_->showValue(view_->selectedPoint().position);
  add_->setEnabled(view_->points().size() < mostColors);
  remove_->setEnabled(view_->points().size() > fewestColors);
}

}  // namespace isolux::ui
