// A tour through the real controls of a window: each step waits until the user has done it, and can be
// skipped.
//
// A card and a frame lie over the window (ui/tour/tour_card.h); Esc, or closing the card, ends the tour at
// any time. The tour edits nothing.
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QRect>
#include <QString>
#include <QTimer>

#include "ui/tour/tour_card.h"

namespace isolux::ui {

struct TourStep {
  QString title, text;
  std::function<QRect()> place;  // of the window, what the step is about; null: of no part of it
  // Whether it was done, asked now and then; null: a step to be read, which ends by its button.
  std::function<bool()> done;
  std::function<void()> begin = {};  // when the step begins: remembers what done() compares with
};

class Tour : public QObject {
  Q_OBJECT
 public:
  Tour(QWidget* window, std::vector<TourStep> steps);  // begins at once; deletes itself at its end
  ~Tour() override;

  TourCard* card() const { return card_; }
  std::size_t step() const { return step_; }
  std::size_t count() const { return steps_.size(); }
  void next();
  void end();

 Q_SIGNALS:
  void ended(bool complete);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void present();
  void look();

  QWidget* window_;
  std::vector<TourStep> steps_;
  std::size_t step_ = 0;
  QPointer<TourCard> card_;
  QTimer timer_;
  bool ended_ = false, doneSeen_ = false;
};

}  // namespace isolux::ui
