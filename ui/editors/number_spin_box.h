// Spin boxes that keep what they hold, and say why when they take something not.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace isolux::ui {

// For any double, from 1e-20 to 1e6. Shows four digits, all of them while it is edited and in its tooltip;
// what is not edited keeps every digit.
class NumberSpinBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit NumberSpinBox(QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;  // accepts a comma as the decimal point
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;

  // Shows a value without sending valueChanged.
  void showValue(double value);

 Q_SIGNALS:
  void refused(const QString& why) const;  // a number out of range was entered; the old one stays

 protected:
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;  // only with the focus: scrolling a panel changes nothing

 private:
  void showText();

  bool editing_ = false;  // has the focus
};

class IntegerSpinBox : public QSpinBox {
  Q_OBJECT
 public:
  explicit IntegerSpinBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;

 Q_SIGNALS:
  void refused(const QString& why) const;

 protected:
  void wheelEvent(QWheelEvent* event) override;  // only with the focus
};

}  // namespace isolux::ui
