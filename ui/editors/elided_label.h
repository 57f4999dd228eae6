// A line of text that gives way: what has no room is left out from the end, in whole parts ("·" between them)
// and then in whole words, and an ellipsis says so. The tooltip has all of it.
#pragma once

#include <QLabel>

namespace isolux::ui {

// As much of `text` as is `width` pixels wide in this font: the whole, or fewer parts, or fewer words, and
// "…".
QString textThatFits(const QString& text, const QFontMetrics& metrics, int width);

class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  QString shownText() const;
  void keepFirstPart() { keepsFirstPart_ = true; }  // the layout may not take its room
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  bool keepsFirstPart_ = false;
};

}  // namespace isolux::ui
