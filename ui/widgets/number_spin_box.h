// Spin boxes that keep what they hold, and say why when they take something not.
//
// Undo (Ctrl+Z) shows at once. While something is typed and not entered yet, it puts the number back; else it
// is the window's, whose last step it takes back, or, in dialogs and where the number is no part of a
// document, the number that was entered before comes back.
#pragma once

#include <optional>

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QWheelEvent>

namespace isolux::ui {

// A wheel turned over a panel scrolls it and changes nothing, unless the widget has the focus.
template <class Base>
class CalmWheel : public Base {
 public:
  explicit CalmWheel(QWidget* parent) : Base(parent) { this->setFocusPolicy(Qt::StrongFocus); }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (this->hasFocus()) {
      Base::wheelEvent(event);
    } else {
      event->ignore();
    }
  }
};

// The numbers of a box since it has the focus.
template <typename Number>
struct EnteredNumbers {
  std::optional<Number> last, before;  // before: what undo brings back
  bool own = false;                    // also outside of dialogs
};

// For any double, from 1e-20 to 1e6. Shows four digits, all of them while it is edited and in its tooltip;
// what is not edited keeps every digit.
class NumberSpinBox : public CalmWheel<QDoubleSpinBox> {
  Q_OBJECT
 public:
  explicit NumberSpinBox(QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;  // accepts a comma as the decimal point
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;

  // Shows a value without sending valueChanged.
  void showValue(double value);
  void setOwnUndo() { entered_.own = true; }  // no part of the window's document

 Q_SIGNALS:
  void refused(const QString& why) const;  // a number out of range was entered; the old one stays

 protected:
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void showText();

  bool editing_ = false;  // has the focus
  EnteredNumbers<double> entered_;
};

class IntegerSpinBox : public CalmWheel<QSpinBox> {
  Q_OBJECT
 public:
  explicit IntegerSpinBox(QWidget* parent = nullptr);

  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;

 Q_SIGNALS:
  void refused(const QString& why) const;

 protected:
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  EnteredNumbers<int> entered_;
};

}  // namespace isolux::ui
