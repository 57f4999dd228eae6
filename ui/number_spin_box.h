// A spin box for any double: shows as many digits as matter and keeps the rest, from 1e-20 to 1e6.
#pragma once

#include <QDoubleSpinBox>

namespace isolux::ui {

class NumberSpinBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberSpinBox(QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;  // accepts a comma as the decimal point
  QValidator::State validate(QString& text, int& position) const override;

  // Shows a value without sending valueChanged.
  void showValue(double value);

 protected:
  void wheelEvent(QWheelEvent* event) override;  // only with the focus: scrolling a panel changes nothing
};

}  // namespace isolux::ui
