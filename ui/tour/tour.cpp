#include "ui/tour/tour.h"

#include <utility>

#include <QEvent>
#include <QKeyEvent>
#include <QPushButton>

#include "ui/tour/tour_card.h"

namespace isolux::ui {

namespace {
constexpr int lookMilliseconds = 100;
}

Tour::Tour(QWidget* window, std::vector<TourStep> steps)
    : QObject(window), window_(window), steps_(std::move(steps)), card_(new TourCard(window)) {
  connect(card_->nextButton(), &QPushButton::clicked, this, &Tour::next);
  connect(card_->leaveButton(), &QPushButton::clicked, this, &Tour::end);
  timer_.setInterval(lookMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &Tour::look);
  window_->installEventFilter(this);
  present();
  timer_.start();
}

Tour::~Tour() {
  delete card_;
}

void Tour::present() {
  const TourStep& step = steps_[step_];
  doneSeen_ = false;
  if (step.begin) step.begin();
  const bool last = step_ + 1 == steps_.size();
  card_->setButtons(last        ? tr("Done")
                    : step.done ? tr("Skip")
                                : tr("Next"),
                    last ? QString() : tr("End the tour"));
  card_->present(step.title, step.text, tr("%1 of %2").arg(step_ + 1).arg(steps_.size()),
                 step.place ? step.place() : QRect());
}

// What was done is left to be seen for a moment: the next step comes with the next look.
void Tour::look() {
  const TourStep& step = steps_[step_];
  card_->setPlace(step.place ? step.place() : QRect());
  if (!step.done || !step.done()) return;
  if (!std::exchange(doneSeen_, true)) return;
  next();
}

void Tour::next() {
  if (step_ + 1 == steps_.size()) {
    end();
    return;
  }
  ++step_;
  present();
}

void Tour::end() {
  if (std::exchange(ended_, true)) return;
  timer_.stop();
  card_->leave();
  Q_EMIT ended(step_ + 1 == steps_.size());
  deleteLater();
}

bool Tour::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && !ended_) {
      end();
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::Resize) look();
  return QObject::eventFilter(object, event);
}

}  // namespace isolux::ui
