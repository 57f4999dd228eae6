// A card over a window beside one of its widgets, and a frame around that widget. Neither takes the focus;
// all but the card goes on answering the mouse.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPointer>

class QPushButton;

namespace isolux::ui {

class TourCard : public QFrame {
  Q_OBJECT
 public:
  explicit TourCard(QWidget* window);  // hidden at first; lies over it
  ~TourCard() override;

  // `place` of the window, what the text is about; empty: the middle of the window, without a frame.
  void present(const QString& title, const QString& text, const QString& progress, const QRect& place);
  // In the lower left corner of `place`, without a frame.
  void presentIn(const QRect& place, const QString& title, const QString& text);
  void setPlace(const QRect& place);
  void setButtons(const QString& next, const QString& leave);
  QString title() const { return title_->text(); }
  QString text() const { return text_->text(); }
  QPushButton* nextButton() const { return next_; }
  QPushButton* leaveButton() const { return leave_; }
  void leave();  // hides card and frame

 private:
  void place();

  QLabel *title_, *text_, *progress_;
  QPushButton *next_, *leave_;
  QPointer<QWidget> frame_;  // a child of the window, too
  QRect place_;
  bool framed_ = true;
};

}  // namespace isolux::ui
