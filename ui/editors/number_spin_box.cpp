#include "ui/editors/number_spin_box.h"

#include <cmath>

#include <QFocusEvent>
#include <QHelpEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/editors/number_text.h"

namespace isolux::ui {

namespace {
QString withoutSuffix(QString text, const QString& suffix) {
  if (!suffix.isEmpty() && text.endsWith(suffix)) text.chop(suffix.size());
  return text.trimmed().replace(',', '.');
}

// Empty for what is no number, or one in range.
QString whyRefused(const QString& number, double minimum, double maximum) {
  bool good = false;
  const double value = number.toDouble(&good);
  if (!good || (minimum <= value && value <= maximum)) return {};
  return QObject::tr("%1 is out of range (%2 … %3)").arg(number, numberText(minimum), numberText(maximum));
}

QString tipOf(const QWidget* widget) {
  while (widget->toolTip().isEmpty() && !widget->isWindow()) widget = widget->parentWidget();
  return widget->toolTip();
}

}  // namespace

NumberSpinBox::NumberSpinBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setDecimals(323);  // no rounding of the value; textFromValue decides what is shown
  setRange(-1e300, 1e300);
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
}

QString NumberSpinBox::textFromValue(double value) const {
  return numberText(value, editing_ ? allDigits : shownDigits);
}

double NumberSpinBox::valueFromText(const QString& text) const {
  const QString number = withoutSuffix(text, suffix());
  return number == textFromValue(value()) ? value() : number.toDouble();  // not edited: not rounded
}

QValidator::State NumberSpinBox::validate(QString& text, int&) const {
  const QString number = withoutSuffix(text, suffix());
  bool good = false;
  const double value = number.toDouble(&good);
  if (!good || !std::isfinite(value)) {
    for (const QChar c : number) {
      if (!QString("+-.eE0123456789").contains(c)) return QValidator::Invalid;
    }
    return QValidator::Intermediate;
  }
  return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberSpinBox::fixup(QString& text) const {
  const QString why = whyRefused(withoutSuffix(text, suffix()), minimum(), maximum());
  if (!why.isEmpty()) Q_EMIT refused(why);
}

bool NumberSpinBox::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QDoubleSpinBox::event(event);
  const QString tip = tipOf(this), all = numberText(value(), allDigits) + suffix();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip.isEmpty() ? all : all + "\n\n" + tip,
                     this);
  return true;
}

void NumberSpinBox::focusInEvent(QFocusEvent* event) {
  editing_ = true;
  showText();
  QDoubleSpinBox::focusInEvent(event);
}

void NumberSpinBox::focusOutEvent(QFocusEvent* event) {
  QDoubleSpinBox::focusOutEvent(event);  // takes what was typed
  editing_ = false;
  showText();
}

void NumberSpinBox::showText() {
  const QSignalBlocker block(lineEdit());
  lineEdit()->setText(textFromValue(value()) + suffix());
}

void NumberSpinBox::showValue(double value) {
  const QSignalBlocker block(this);
  setValue(value);
}

void NumberSpinBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QDoubleSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

IntegerSpinBox::IntegerSpinBox(QWidget* parent) : QSpinBox(parent) {
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
}

// A number out of range may be typed, to be told why it is refused.
QValidator::State IntegerSpinBox::validate(QString& text, int& position) const {
  const QValidator::State state = QSpinBox::validate(text, position);
  bool good = false;
  static_cast<void>(withoutSuffix(text, suffix()).toLongLong(&good));
  return state == QValidator::Invalid && good ? QValidator::Intermediate : state;
}

void IntegerSpinBox::fixup(QString& text) const {
  const QString why = whyRefused(withoutSuffix(text, suffix()), minimum(), maximum());
  if (!why.isEmpty()) Q_EMIT refused(why);
}

void IntegerSpinBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

}  // namespace isolux::ui
