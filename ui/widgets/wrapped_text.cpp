#include "ui/widgets/wrapped_text.h"

#include <cmath>

#include <QTextDocument>
#include <QWheelEvent>

namespace isolux::ui {

WrappedText::WrappedText(QWidget* parent) : QTextEdit(parent) {
  setReadOnly(true);
  setAcceptRichText(false);
  setAcceptDrops(false);  // files dropped here are the window's
  setFrameShape(QFrame::NoFrame);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setFocusPolicy(Qt::ClickFocus);
  setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  document()->setDocumentMargin(0.0);
  viewport()->setAutoFillBackground(false);
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void WrappedText::setText(const QString& text) {
  if (text == toPlainText()) return;
  setPlainText(text);
  updateGeometry();
}

int WrappedText::heightForWidth(int width) const {
  QTextDocument laidOut;
  laidOut.setDefaultFont(font());
  laidOut.setDocumentMargin(0.0);
  QTextOption option;
  option.setWrapMode(wordWrapMode());
  laidOut.setDefaultTextOption(option);
  laidOut.setPlainText(toPlainText());
  laidOut.setTextWidth(std::max(1, width));
  return static_cast<int>(std::ceil(laidOut.size().height()));
}

QSize WrappedText::sizeHint() const {
  const int one = fontMetrics().lineSpacing();
  return {24 * one / 2, width() > 0 ? heightForWidth(width()) : one};
}

void WrappedText::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace isolux::ui
