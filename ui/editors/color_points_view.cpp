#include "ui/editors/color_points_view.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>

#include "scene/color_maps.h"
#include "ui/language/number_text.h"
#include "ui/widgets/color_button.h"

namespace isolux::ui {

namespace {

constexpr int barSamples = 256;  // of the bar's colours; drawn smoothly
constexpr double barMargin = 9.0, barHeight = 24.0;

std::vector<scene::ColorPoint> colorPointsOf(const std::vector<MapPoint>& points) {
  std::vector<scene::ColorPoint> same;
  for (const MapPoint& point : points) same.push_back({point.at.x, point.color});
  return same;
}

}  // namespace

ColorPointsView::ColorPointsView(QWidget* parent)
    : PointsView({{{},
                   tr("Position of the selected point"),
                   tr("Position of the selected point, as a fraction of the range"),
                   0.0,
                   0.01}},
                 2, parent) {
  setFixedHeight(static_cast<int>(barHeight + 2.0 * barMargin));
  setMinimumWidth(120);
  setAccessibleName(tr("Colour bar with control points"));
  connect(this, &PointsView::selectionChanged, this, [this] {
    setAccessibleDescription(tr("Point %1 of %2 at %3")
                                 .arg(selected() + 1)
                                 .arg(points().size())
                                 .arg(numberText(selectedPoint().at.x)));
  });
  showPoints({{{0.0, 0.0}, glm::dvec3(0.0)}, {{1.0, 0.0}, glm::dvec3(1.0)}});
}

QString ColorPointsView::addTip() const {
  return tr("Add a point (click on the bar, or Insert)");
}

QRectF ColorPointsView::area() const {
  return {barMargin, barMargin, std::max(width() - 2.0 * barMargin, 1.0), barHeight};
}

QPointF ColorPointsView::positionOf(glm::dvec2 at) const {
  return {area().left() + at.x * area().width(), area().center().y()};
}

glm::dvec2 ColorPointsView::placeAt(QPointF position) const {
  return {std::clamp((position.x() - area().left()) / area().width(), 0.0, 1.0), 0.0};
}

glm::dvec2 ColorPointsView::reachable(glm::dvec2 at, std::size_t index) const {
  const std::size_t count = points().size();
  const double least = index == 0 || index == count ? 0.0 : points()[index - 1].at.x;
  const double most = index + 1 >= count ? 1.0 : points()[index + 1].at.x;
  return {std::clamp(std::round(at.x * 1000.0) / 1000.0, least, most), 0.0};
}

std::size_t ColorPointsView::indexOfNew(glm::dvec2 at) const {
  const auto next = std::find_if(points().begin(), points().end(),
                                 [at](const MapPoint& point) { return point.at.x > at.x; });
  return static_cast<std::size_t>(next - points().begin());
}

glm::dvec3 ColorPointsView::colorAt(glm::dvec2 at) const {
  return scene::colorOfPoints(colorPointsOf(points()), at.x);
}

QImage ColorPointsView::pictureOf(const std::vector<MapPoint>& points) const {
  QImage image(barSamples, 1, QImage::Format_RGB32);
  const std::vector<glm::vec3> samples = scene::pointSamples(colorPointsOf(points), barSamples);
  for (int i = 0; i < barSamples; ++i)
    image.setPixel(i, 0, screenColour(samples[static_cast<std::size_t>(i)]).rgb());
  return image;
}

void ColorPointsView::addAnother() {
  const auto from = static_cast<std::size_t>(std::min(selected(), static_cast<int>(points().size()) - 2));
  addPoint(0.5 * (points()[from].at + points()[from + 1].at));
}

void ColorPointsView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || pointAt(event->position()) >= 0)
    return PointsView::mousePressEvent(event);
  beginDrag({});
  addPoint(placeAt(event->position()));
}

void ColorPointsView::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Insert || key == Qt::Key_Return || key == Qt::Key_Enter) return addAnother();
  PointsView::keyPressEvent(event);
}

void ColorPointsView::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) select(0);
  if (event->reason() == Qt::BacktabFocusReason) select(static_cast<int>(points().size()) - 1);
  QWidget::focusInEvent(event);
}

bool ColorPointsView::focusNextPrevChild(bool next) {
  const int wanted = selected() + (next ? 1 : -1);
  if (wanted < 0 || wanted >= static_cast<int>(points().size())) return QWidget::focusNextPrevChild(next);
  select(wanted);
  return true;
}

}  // namespace isolux::ui
