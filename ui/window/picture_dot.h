// A dot that says whether the picture on screen is the final one: an open ring while it is worked on, full
// when it is. How long it took is in its tooltip.
#pragma once

#include <QWidget>

namespace isolux::ui {

class PictureDot : public QWidget {
  Q_OBJECT
 public:
  explicit PictureDot(QWidget* parent);

  void setDrawn(double milliseconds, bool complete);
  void setDrawing(bool draws);
  bool isFinal() const { return final_ && !draws_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void tell();

  double milliseconds_ = -1.0;  // below 0: there was no picture yet
  bool final_ = false, draws_ = false;
};

}  // namespace isolux::ui
