#include "ui/tour/tour_card.h"

#include <algorithm>
#include <array>

#include <QPushButton>

#include "ui/theme/style.h"
#include "ui/widgets/parts.h"
namespace isolux::ui {

namespace {
constexpr int cardWidth = 330, cardGap = 14, lineWidthOfFrame = 3;  // pixels
}

TourCard::TourCard(QWidget* window)
    : QFrame(window),
      title_(wrappedLabel({}, this)),
      text_(wrappedLabel({}, this)),
      progress_(new QLabel(this)),
      next_(new QPushButton(this)),
      leave_(new QPushButton(this)),
      frame_(new QWidget(window)) {
  setObjectName("tourCard");
  setCursor(Qt::ArrowCursor);
  setAttribute(Qt::WA_NoMousePropagation);
  frame_->setObjectName("tourFrame");
  frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
  frame_->setAttribute(Qt::WA_StyledBackground);
  frame_->hide();
  QFont bold = font();
  bold.setBold(true);
  bold.setPointSizeF(bold.pointSizeF() + 1.5);
  title_->setFont(bold);
  setInk(progress_, Ink::quiet);
  for (QPushButton* button : {next_, leave_}) button->setFocusPolicy(Qt::TabFocus);

  auto* buttons = lineOf({{progress_, 1}, leave_, next_});
  layOut(this, columnOf({title_, text_, Cell::gap(4), buttons}, 8), {16, 14, 16, 12});

  hide();
}

TourCard::~TourCard() {
  delete frame_;
}

void TourCard::setButtons(const QString& next, const QString& leave) {
  next_->setText(next);
  leave_->setText(leave);
  leave_->setVisible(!leave.isEmpty());
}

void TourCard::present(const QString& title, const QString& text, const QString& progress, const QRect& at) {
  title_->setText(title);
  text_->setText(text);
  progress_->setText(progress);
  setAccessibleName(title);
  setAccessibleDescription(text);
  place_ = at;
  show();
  place();
}

void TourCard::presentIn(const QRect& at, const QString& title, const QString& text) {
  framed_ = false;
  present(title, text, {}, at);
}

void TourCard::leave() {
  hide();
  if (QWidget* const frame = frame_; frame != nullptr) frame->hide();
}

void TourCard::setPlace(const QRect& at) {
  if (at == place_) return;
  place_ = at;
  place();
}

// Beside the place where the window has room, else in the place's lower left corner.
void TourCard::place() {
  QWidget* const frame = frame_;
  if (frame == nullptr) return;  // the window goes
  const QRect window = parentWidget()->rect().adjusted(cardGap, cardGap, -cardGap, -cardGap);
  const int width = std::min(cardWidth, window.width());
  setFixedWidth(width);
  const int height = std::max(layout()->totalHeightForWidth(width), layout()->totalMinimumSize().height());
  resize(width, height);
  frame->setVisible(framed_ && !place_.isEmpty());
  QPoint at = window.center() - QPoint(width / 2, height / 2);
  if (!framed_) {
    at = QPoint(place_.left() + cardGap, place_.bottom() - cardGap - height);
  } else if (!place_.isEmpty()) {
    frame->setGeometry(
        place_.adjusted(-lineWidthOfFrame, -lineWidthOfFrame, lineWidthOfFrame, lineWidthOfFrame) &
        parentWidget()->rect());
    frame->raise();
    const std::array candidates{QPoint(place_.left(), place_.bottom() + cardGap),
                                QPoint(place_.left(), place_.top() - cardGap - height),
                                QPoint(place_.left() - cardGap - width, place_.top()),
                                QPoint(place_.right() + cardGap, place_.top())};
    at = QPoint(place_.left() + cardGap, place_.bottom() - cardGap - height);
    for (QPoint candidate : candidates) {
      candidate.setX(
          std::clamp(candidate.x(), window.left(), std::max(window.left(), window.right() - width)));
      const QRect card(candidate, QSize(width, height));
      if (!window.contains(card) || card.intersects(place_)) continue;
      at = candidate;
      break;
    }
  }
  move(at);
  raise();
}

}  // namespace isolux::ui
