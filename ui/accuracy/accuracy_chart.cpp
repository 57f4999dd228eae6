#include "ui/accuracy/accuracy_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsSimpleTextItem>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QValueAxis>

#include "render/legend/legend.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"

namespace isolux::ui {

namespace {

constexpr double pointPixels = 9.0, presentPixels = 13.0, ringPixels = 17.0, reachPixels = 14.0;
constexpr int chartHeight = 260;

QScatterSeries* scatter(QScatterSeries::MarkerShape shape, double pixels, const QColor& fill,
                        const QColor& edge) {
  auto* series = new QScatterSeries;
  series->setMarkerShape(shape);
  series->setMarkerSize(pixels);
  series->setColor(fill);
  series->setBorderColor(edge);
  return series;
}

void ink(QAbstractAxis* axis, const QString& title) {
  axis->setTitleText(title);
  axis->setTitleBrush(colours.text);
  axis->setLabelsBrush(colours.text);
  axis->setLinePen(QPen(colours.edge));
  axis->setGridLinePen(QPen(colours.border));
  QFont font = axis->titleFont();
  font.setBold(false);
  axis->setTitleFont(font);
}

QString shownValue(const std::string& value) {
  const auto text = QString::fromStdString(value);
  bool isNumber = false;
  text.toDouble(&isNumber);
  return isNumber ? text : wordsOf(text);
}

// 1, 2 or 5 times a power of ten.
double roundStep(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 4.0)));
  for (const double step : {1.0, 2.0, 5.0})
    if (range / 4.0 <= step * power) return step * power;
  return 10.0 * power;
}

// Of decimal logarithms, labelled with the numbers themselves as the legend of a picture is: all of them as
// powers of ten, or none. (QLogValueAxis labels full decades only, and mixes 0.0001 with 1e-05.)
QCategoryAxis* logarithmicAxis(double low, double high) {
  auto* axis = new QCategoryAxis;
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  axis->setStartValue(std::log10(low) - 1.0);
  const std::vector<double> ticks = render::logarithmicTicks(low, high);
  const QChar gap(0x00A0);  // or the last digit touches the tick
  for (const double tick : ticks)
    axis->append(
        QString::fromStdString(render::logarithmicTickText(tick, render::areShownAsPowers(ticks))) + gap,
        std::log10(tick));
  axis->setRange(std::log10(low), std::log10(high));
  return axis;
}

}  // namespace

AccuracyChart::AccuracyChart(QWidget* parent) : QChartView(parent) {
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumHeight(chartHeight);
  setMouseTracking(true);
  setAccessibleName(tr("Error against time"));
  chart()->legend()->hide();
  chart()->setMargins({0, fontMetrics().height() / 2 + 2, 0, 0});  // of the uppermost tick's label
  chart()->layout()->setContentsMargins(0, 0, 0, 0);
  rebuild();
  connect(chart(), &QChart::plotAreaChanged, this, &AccuracyChart::placeLabels);
}

void AccuracyChart::show(std::vector<app::QualityPoint> points, const QString& costLabel,
                         const QString& errorLabel) {
  points_ = std::move(points);
  costLabel_ = costLabel;
  errorLabel_ = errorLabel;
  rebuild();
}

QPointF AccuracyChart::inAxes(const app::QualityPoint& point) const {
  return {point.cost, std::log10(std::max(point.error, least_))};
}

void AccuracyChart::rebuild() {
  chart()->removeAllSeries();
  for (QAbstractAxis* axis : chart()->axes()) {
    chart()->removeAxis(axis);
    delete axis;
  }
  qDeleteAll(labels_);
  labels_.clear();
  chart()->setBackgroundVisible(false);
  if (points_.empty()) return;

  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0, dearest = 0.0;
  for (const app::QualityPoint& point : points_) {
    if (point.error > 0.0) smallest = std::min(smallest, point.error);
    largest = std::max(largest, point.error);
    dearest = std::max(dearest, point.cost);
  }
  if (largest == 0.0) smallest = largest = 1e-6;
  least_ = std::pow(10.0, std::floor(std::log10(0.8 * smallest)));

  auto* front = new QLineSeries;
  auto* ordinary = scatter(QScatterSeries::MarkerShapeCircle, pointPixels, colours.accent, colours.window);
  auto* present =
      scatter(QScatterSeries::MarkerShapeRectangle, presentPixels, colours.isovalue, colours.window);
  auto* ring = scatter(QScatterSeries::MarkerShapeCircle, ringPixels, Qt::transparent, colours.text);
  std::vector<QPointF> best;
  for (const app::QualityPoint& point : points_) {
    const QPointF place = inAxes(point);
    if (point.onFront) best.push_back(place);
    if (point.isDefault) ring->append(place);
    (point.isPresent ? present : ordinary)->append(place);
  }
  std::sort(best.begin(), best.end(), [](QPointF a, QPointF b) { return a.x() < b.x(); });
  for (const QPointF place : best) front->append(place);
  front->setPen(QPen(colours.quietText, 1.0, Qt::DashLine));

  auto* cost = new QValueAxis;
  const double step = roundStep(std::max(dearest, 1e-9));
  cost->setRange(0.0, step * std::ceil(1.12 * dearest / step));
  cost->setTickType(QValueAxis::TicksDynamic);
  cost->setTickAnchor(0.0);
  cost->setTickInterval(step);
  cost->setLabelFormat("%g");
  auto* error = logarithmicAxis(least_, std::pow(10.0, std::ceil(std::log10(1.25 * largest))));
  ink(cost, costLabel_);
  ink(error, errorLabel_);
  chart()->addAxis(cost, Qt::AlignBottom);
  chart()->addAxis(error, Qt::AlignLeft);
  for (QXYSeries* series : {static_cast<QXYSeries*>(front), static_cast<QXYSeries*>(ring),
                            static_cast<QXYSeries*>(ordinary), static_cast<QXYSeries*>(present)}) {
    chart()->addSeries(series);
    series->attachAxis(cost);
    series->attachAxis(error);
  }
  for (const app::QualityPoint& point : points_) {
    auto* label = new QGraphicsSimpleTextItem(shownValue(point.value), chart());
    label->setBrush(colours.text);
    labels_ += label;
  }
  placeLabels();
}

// Beside their points, on the side with room; one that would cover another stands below its point.
void AccuracyChart::placeLabels() {
  if (labels_.size() != static_cast<qsizetype>(points_.size()) || chart()->series().isEmpty()) return;
  QList<QRectF> taken;
  const QRectF plot = chart()->plotArea();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QPointF at = chart()->mapToPosition(inAxes(points_[i]), chart()->series().front());
    QGraphicsSimpleTextItem* const label = labels_[static_cast<qsizetype>(i)];
    const QSizeF size = label->boundingRect().size();
    const double gap = 0.6 * ringPixels;
    const QPointF tries[] = {{at.x() + gap, at.y() - 0.5 * size.height()},
                             {at.x() - gap - size.width(), at.y() - 0.5 * size.height()},
                             {at.x() - 0.5 * size.width(), at.y() - gap - size.height()},
                             {at.x() - 0.5 * size.width(), at.y() + gap}};
    QPointF place = tries[0];
    for (const QPointF wanted : tries) {
      const QRectF box(wanted, size);
      const bool covers =
          std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); });
      if (covers || !plot.contains(box)) continue;
      place = wanted;
      break;
    }
    label->setPos(place);
    taken += QRectF(place, size);
  }
}

QPointF AccuracyChart::placeOf(std::size_t point) const {
  const QPointF inChart = chart()->mapToPosition(inAxes(points_.at(point)), chart()->series().front());
  return mapFromScene(chart()->mapToScene(inChart));
}

std::optional<std::size_t> AccuracyChart::pointAt(QPointF place) const {
  std::optional<std::size_t> nearest;
  double least = reachPixels;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (const double far = QLineF(place, placeOf(i)).length(); far < least) {
      least = far;
      nearest = i;
    }
  return nearest;
}

void AccuracyChart::mouseReleaseEvent(QMouseEvent* event) {
  const auto point = pointAt(event->position());
  if (point && event->button() == Qt::LeftButton)
    Q_EMIT chosen(QString::fromStdString(points_[*point].value));
}

void AccuracyChart::mouseMoveEvent(QMouseEvent* event) {
  const auto point = pointAt(event->position());
  setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (!point) return setToolTip({});
  const app::QualityPoint& of = points_[*point];
  QStringList lines{shownValue(of.value), tr("%1: %2").arg(costLabel_, numberText(of.cost, 3)),
                    tr("%1: %2").arg(errorLabel_, numberText(of.error, 3))};
  if (of.isPresent) lines += tr("Current setting");
  if (of.isDefault) lines += tr("Default");
  setToolTip(lines.join('\n'));
}

void AccuracyChart::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

void AccuracyChart::resizeEvent(QResizeEvent* event) {
  QChartView::resizeEvent(event);
  placeLabels();
}

}  // namespace isolux::ui
