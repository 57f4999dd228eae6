#include "ui/editors/histogram_slider.h"

#include <algorithm>
#include <utility>

#include <QFontMetricsF>
#include <QPainter>

#include "ui/language/number_text.h"
#include "ui/theme/style.h"

namespace isolux::ui {

namespace {
constexpr double sideMargin = 14.0, topMargin = 24.0, axisHeight = 20.0;
constexpr int detailBins = 16384;
constexpr double labelTop = 1.0, labelHeight = 18.0, markWidth = 10.0;

QRectF labelBox(const PlacedHandle& placed, const QRectF& area, double width, const QFontMetricsF& metrics) {
  const double boxWidth = metrics.horizontalAdvance(placed.label) + 14.0;
  QRectF box(std::clamp(placed.x, area.left(), area.right()) - 0.5 * boxWidth, labelTop, boxWidth,
             labelHeight);
  box.moveLeft(std::clamp(box.left(), 1.0, std::max(1.0, width - 1.0 - boxWidth)));
  return box;
}

// `area`: the plot; labels stand above it, within [1, width - 1]. A label that would cover that of a handle
// painted later is only a mark.
void paintHandles(QPainter& painter, const QRectF& area, double width, const QFont& font,
                  std::vector<PlacedHandle> handles) {
  std::stable_partition(handles.begin(), handles.end(), [](const auto& placed) { return !placed.active; });
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const PlacedHandle& placed = handles[i];
    QRectF box = labelBox(placed, area, width, metrics);
    const bool covered = std::any_of(
        handles.begin() + static_cast<std::ptrdiff_t>(i) + 1, handles.end(),
        [&](const PlacedHandle& later) { return labelBox(later, area, width, metrics).intersects(box); });
    const double x = std::clamp(placed.x, area.left(), area.right());
    if (covered) box = QRectF(x - 0.5 * markWidth, labelTop + labelHeight - markWidth, markWidth, markWidth);
    QColor colour = placed.handle->colour;
    colour.setAlphaF(placed.handle->shown ? 1.0F : 0.45F);
    if (placed.x >= area.left() - 0.5 && placed.x <= area.right() + 0.5) {
      painter.setPen(QPen(colour, 2.0, placed.handle->shown ? Qt::SolidLine : Qt::DashLine));
      painter.drawLine(QPointF(x, box.bottom()), QPointF(x, area.bottom()));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(box, 4.0, 4.0);
    if (covered) continue;
    const bool bright = 0.3 * colour.redF() + 0.59 * colour.greenF() + 0.11 * colour.blueF() > 0.5;
    painter.setPen(bright ? QColor(0x22, 0x1a, 0x08) : QColor(0xf4, 0xf6, 0xf8));
    painter.drawText(box, Qt::AlignCenter, placed.label);
  }
}

}  // namespace

HistogramSlider::HistogramSlider(QWidget* parent) : QWidget(parent), handles_(1) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Isovalue on the histogram"));
  callOnce(sendTimer_, 0, this, &HistogramSlider::sendPending);
}

void HistogramSlider::setVolume(VolumePointer volume) {
  volume_ = std::move(volume);
  detailTask_.reset();
  detail_ = {};
  pending_.reset();
  hovered_.reset();
  dragging_ = panning_ = false;
  if (volume_) plot_ = app::HistogramPlot(volume_->histogram.minimum, volume_->histogram.maximum);
  zoomed();
}

void HistogramSlider::setIsovalue(double value, bool insideAbove) {
  if (!dragging_) {
    isovalue_ = value;
    if (volume_) plot_.reveal(std::clamp(value, plot_.minimum(), plot_.maximum()));
  }
  insideAbove_ = insideAbove;
  update();
}

void HistogramSlider::setSurfaces(const std::vector<HistogramHandle>& surfaces) {
  const double held = valueOf(active_);
  handles_ = surfaces;
  if (handles_.empty()) handles_.emplace_back();
  const auto isActive = [this](const HistogramHandle& handle) { return handle.number == active_; };
  if (std::none_of(handles_.begin(), handles_.end(), isActive)) active_ = 0;
  if (handles_.size() == 1) handles_.front().colour = colours.isovalue;
  if (dragging_) setActiveValue(held);
  update();
}

void HistogramSlider::showAll() {
  plot_.showAll();
  zoomed();
}

void HistogramSlider::zoomAtLine(double factor) {
  plot_.zoom(factor, isovalue_);
  wantDetail();
  zoomed();
}

void HistogramSlider::zoomed() {
  Q_EMIT zoomChanged(plot_.zoomed());
  update();
}

void HistogramSlider::wantDetail() {
  if (!volume_ || !detail_.counts.empty() || detailTask_) return;
  const double bins = static_cast<double>(volume_->histogram.counts.size());
  const double shown = bins * plot_.shownRange() / (plot_.maximum() - plot_.minimum());
  if (shown > plotArea().width()) return;  // still more bins than pixels
  using Counting = base::Task<volume::Histogram>;
  const auto count = [volume = volume_](base::Progress& progress) {
    return volume::makeHistogram(volume->grid(), detailBins, progress);
  };
  detailTask_.watch(Counting::start({"", "count voxels"}, count), [this](Counting& task) {
    if (!task.error()) detail_ = std::move(task.value());
    update();
  });
}

// Painting

QRectF HistogramSlider::plotArea() const {
  return QRectF(rect()).adjusted(sideMargin, topMargin, -sideMargin, -axisHeight);
}

QPointF HistogramSlider::positionOf(double value) const {
  const QRectF area = plotArea();
  return {area.left() + plot_.pixelOf(value, area.width()), area.center().y()};
}

std::vector<PlacedHandle> HistogramSlider::placedHandles() const {
  std::vector<PlacedHandle> placed;
  for (const HistogramHandle& handle : handles_) {
    const double value = handle.number == 0 ? isovalue_ : handle.value;
    placed.push_back({&handle, positionOf(value).x(), text(value), handle.number == active_});
  }
  return placed;
}

double HistogramSlider::valueOf(int number) const {
  for (const HistogramHandle& handle : handles_)
    if (number != 0 && handle.number == number) return handle.value;
  return isovalue_;
}

void HistogramSlider::setActiveValue(double value) {
  if (active_ == 0) isovalue_ = value;
  for (HistogramHandle& handle : handles_)
    if (handle.number == active_) handle.value = value;
}

void HistogramSlider::emitActive(double value, bool endsAfterPause) {
  if (active_ == 0)
    Q_EMIT isovalueChanged(value, endsAfterPause);
  else
    Q_EMIT surfaceMoved(active_, value, endsAfterPause);
}

QString HistogramSlider::text(double value) const {
  return valueText(value, volume_ ? QString::fromStdString(volume_->volume.unit) : QString());
}

void HistogramSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = plotArea();
  painter.fillRect(area, colours.base);
  if (volume_) {
    paintColumns(painter, area);
    paintAxis(painter, area);
    QFont labels = font();
    labels.setWeight(QFont::DemiBold);
    paintHandles(painter, area, width(), labels, placedHandles());
  } else {
    painter.setPen(colours.quietText);
    painter.drawText(area, Qt::AlignCenter, tr("The histogram of the volume appears here"));
  }
  painter.setPen(QPen(hasFocus() ? colours.accent : colours.edge, 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area.adjusted(-0.5, -0.5, 0.5, 0.5));
}

void HistogramSlider::paintColumns(QPainter& painter, const QRectF& area) const {
  const int width = static_cast<int>(area.width());
  const auto heights = plot_.columns(detail_.counts.empty() ? volume_->histogram : detail_, width);
  const double line = plot_.pixelOf(isovalue_, area.width());
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int x = 0; x < width; ++x) {
    const double height = heights[static_cast<std::size_t>(x)] * (area.height() - 4.0);
    if (height <= 0.0) continue;
    const bool in = insideAbove_ ? x >= line : x < line;
    painter.fillRect(
        QRectF(area.left() + x, area.bottom() - std::max(1.0, height), 1.0, std::max(1.0, height)),
        in ? colours.plotInside : colours.plotOutside);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  // Peaks: small marks on the floor of the plot.
  painter.setPen(Qt::NoPen);
  QColor ink = colours.plotInk;
  ink.setAlpha(150);
  painter.setBrush(ink);
  for (const double peak : volume_->histogram.peaks) {
    const double x = area.left() + plot_.pixelOf(peak, area.width());
    if (x < area.left() || x > area.right()) continue;
    painter.drawPolygon(
        QPolygonF({{x - 3.5, area.bottom()}, {x + 3.5, area.bottom()}, {x, area.bottom() - 6.0}}));
  }
  if (hovered_) {
    ink.setAlpha(110);
    painter.setPen(QPen(ink, 1.0, Qt::DotLine));
    const double x = area.left() + plot_.pixelOf(*hovered_, area.width());
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  }
}

void HistogramSlider::paintAxis(QPainter& painter, const QRectF& area) const {
  QFont font = this->font();
  font.setPointSizeF(font.pointSizeF() - 1.0);
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  for (const double tick : plot_.ticks(area.width(), 85.0)) {
    const double x = area.left() + plot_.pixelOf(tick, area.width());
    painter.setPen(QPen(colours.border, 1.0));
    painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.bottom() + 4.0));
    painter.setPen(colours.quietText);
    const QString label = numberText(tick);
    const double labelWidth = metrics.horizontalAdvance(label);
    const double left = std::clamp(x - 0.5 * labelWidth, 2.0, this->width() - labelWidth - 2.0);
    painter.drawText(QPointF(left, area.bottom() + 5.0 + metrics.ascent()), label);
  }
  if (plot_.zoomed()) {  // which part of the whole range is shown
    const double whole = plot_.maximum() - plot_.minimum();
    const double from = (plot_.shownMinimum() - plot_.minimum()) / whole * area.width();
    const double length = std::max(4.0, plot_.shownRange() / whole * area.width());
    painter.fillRect(QRectF(area.left(), area.top() - 5.0, area.width(), 3.0), colours.border);
    painter.fillRect(QRectF(area.left() + from, area.top() - 5.0, length, 3.0), colours.accent);
  }
  if (hovered_ && !dragging_) {
    painter.setPen(colours.quietText);
    const QString label = text(*hovered_);
    const double x = area.left() + plot_.pixelOf(*hovered_, area.width());
    const double labelWidth = metrics.horizontalAdvance(label);
    const bool fitsRight = x + 6.0 + labelWidth < area.right();
    painter.drawText(QPointF(fitsRight ? x + 6.0 : x - 6.0 - labelWidth, area.top() + metrics.ascent() + 4.0),
                     label);
  }
}

}  // namespace isolux::ui
