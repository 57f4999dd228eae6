// A dot that says whether the picture on screen is the final one: an open ring while it or its light is
// worked on, full when it is. Its tooltip says what is being done, how far that is, and how long the picture
// took.
#pragma once

#include <QWidget>

namespace isolux::ui {

class PictureDot : public QWidget {
  Q_OBJECT
 public:
  explicit PictureDot(QWidget* parent);

  void setDrawn(double milliseconds, bool complete);
  void setDrawing(bool draws);
  // Light that is on its way (unfinishedLightSentence(); empty: none), and whether it is computed now.
  void setLight(const QString& unfinished, bool works);
  bool isFinal() const { return final_ && !draws_ && !lightWorks_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void tell();

  double milliseconds_ = -1.0;  // below 0: there was no picture yet
  bool final_ = false, draws_ = false, lightWorks_ = false;
  QString light_;
};

}  // namespace isolux::ui
