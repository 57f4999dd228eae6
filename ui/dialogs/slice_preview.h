// A grey picture of one slice, shown as large as fits with the slice's true proportions.
#pragma once

#include <QImage>
#include <QWidget>

namespace isolux::ui {

class SlicePreview : public QWidget {
  Q_OBJECT
 public:
  explicit SlicePreview(QWidget* parent = nullptr);
  // aspect: width / height of the slice in mm. A null image shows `text` instead.
  void showSlice(const QImage& image, double aspect, const QString& text);
  const QImage& image() const { return image_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  QSize sizeHint() const override { return {380, 380}; }

 private:
  QImage image_;
  double aspect_ = 1.0;
  QString text_;
};

}  // namespace isolux::ui
