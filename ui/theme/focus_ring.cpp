#include "ui/theme/focus_ring.h"

#include <QApplication>
#include <QFocusEvent>
#include <QPainter>
#include <QTimer>

#include "ui/theme/style.h"

namespace isolux::ui {

namespace {

constexpr int thick = 2, rim = 1, outside = 1;  // pixels

// Beside any colour below, one of the two stands out.
class RingFrame : public QWidget {
 public:
  explicit RingFrame(QWidget* window) : QWidget(window) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
  }
  void setRing(const QRect& place) {
    constexpr int band = thick + rim;
    setGeometry(place);
    setMask(QRegion(rect()) - QRegion(rect().adjusted(band, band, -band, -band)));
    raise();
    show();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), colours.base);
    painter.setPen(QPen(colours.accent, thick, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(QRectF(rect()).adjusted(0.5 * thick, 0.5 * thick, -0.5 * thick, -0.5 * thick));
  }
};

bool comesByKeys(Qt::FocusReason reason) {
  return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
         reason == Qt::ShortcutFocusReason;
}

// What of the widget its window shows, in the window's coordinates.
QRect seenIn(const QWidget& widget, const QWidget& window) {
  QRect seen(widget.mapTo(&window, QPoint(0, 0)), widget.size());
  seen.adjust(-outside, -outside, outside, outside);
  for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
    seen &= QRect(parent->mapTo(&window, QPoint(0, 0)), parent->size());
    if (parent == &window) break;
  }
  return seen;
}

}  // namespace

FocusRing* FocusRing::install() {
  auto* ring = new FocusRing(qApp);
  qApp->installEventFilter(ring);
  return ring;
}

bool FocusRing::eventFilter(QObject* object, QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusIn:
      if (object->isWidgetType())
        follow(comesByKeys(static_cast<QFocusEvent*>(event)->reason()) ? static_cast<QWidget*>(object)
                                                                       : nullptr);
      break;
    case QEvent::FocusOut:
      if (object == target_) follow(nullptr);
      break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
      if (target_ && object != ring_ && object->isWidgetType() &&
          (object == target_ || static_cast<QWidget*>(object)->isAncestorOf(target_)))
        QTimer::singleShot(0, this, &FocusRing::place);  // when all has settled
      break;
    default:
      break;
  }
  return false;
}

void FocusRing::follow(QWidget* widget) {
  if (widget && widget->isWindow()) widget = nullptr;
  if (widget == target_ && !widget) return;
  target_ = widget;
  place();
}

void FocusRing::place() {
  const QWidget* const target = target_.data();
  if (target == nullptr || !target->isVisible()) {
    delete ring_.data();
    return;
  }
  QWidget* const window = target->window();
  const QRect seen = seenIn(*target, *window);
  QWidget* ring = ring_.data();
  if (ring != nullptr && (seen.isEmpty() || ring->parentWidget() != window)) {
    delete ring;
    ring = nullptr;
  }
  if (seen.isEmpty()) return;
  if (ring == nullptr) ring_ = ring = new RingFrame(window);
  static_cast<RingFrame*>(ring)->setRing(seen);
}

}  // namespace isolux::ui
