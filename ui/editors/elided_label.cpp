#include "ui/editors/elided_label.h"

#include <algorithm>

#include <QHelpEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOption>
#include <QToolTip>

namespace isolux::ui {

namespace {
const QString ellipsis = QStringLiteral("…");

// Ends of the parts of a text, or of its words: where it may be left off.
QList<qsizetype> endsOf(const QString& text, const QRegularExpression& gap) {
  QList<qsizetype> ends;
  for (auto gaps = gap.globalMatch(text); gaps.hasNext();) ends.prepend(gaps.next().capturedStart());
  return ends;
}

const QRegularExpression& betweenParts() {
  static const QRegularExpression gap(QStringLiteral("\\s+·\\s+|\\s{3,}"));
  return gap;
}
}  // namespace

QString textThatFits(const QString& text, const QFontMetrics& metrics, int width) {
  if (metrics.horizontalAdvance(text) <= width) return text;
  static const QRegularExpression betweenWords(QStringLiteral("\\s+"));
  for (const QRegularExpression* gap : {&betweenParts(), &betweenWords})
    for (const qsizetype end : endsOf(text, *gap))
      if (const QString shorter = text.first(end) + " " + ellipsis;
          end > 0 && metrics.horizontalAdvance(shorter) <= width)
        return shorter;
  return metrics.horizontalAdvance(ellipsis) <= width ? ellipsis : QString();
}

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
}

QString ElidedLabel::shownText() const {
  return textThatFits(text(), fontMetrics(), contentsRect().width());
}

QSize ElidedLabel::minimumSizeHint() const {
  const QSize whole = QLabel::minimumSizeHint();
  if (!keepsFirstPart_) return {0, whole.height()};
  const QString first = text().section(betweenParts(), 0, 0);
  const QMargins margins = contentsMargins();
  const int wanted = fontMetrics().horizontalAdvance(first == text() ? first : first + " " + ellipsis) +
                     margins.left() + margins.right();
  constexpr int most = 220;  // pixels: a first part may be a sentence
  return {std::min(wanted, most), whole.height()};
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || shownText() == text()) return QLabel::event(event);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     toolTip().isEmpty() ? text() : text() + "\n\n" + toolTip(), this);
  return true;
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QStyleOption option;
  option.initFrom(this);
  const int flags = static_cast<int>(QStyle::visualAlignment(layoutDirection(), alignment()));
  style()->drawItemText(&painter, contentsRect(), flags, option.palette, isEnabled(), shownText(),
                        foregroundRole());
}

}  // namespace isolux::ui
