#include "ui/number_spin_box.h"

#include <cmath>

#include <QSignalBlocker>
#include <QWheelEvent>

#include "ui/number_text.h"

namespace isolux::ui {

namespace {
QString withoutSuffix(QString text, const QString& suffix) {
  if (!suffix.isEmpty() && text.endsWith(suffix)) text.chop(suffix.size());
  return text.trimmed().replace(',', '.');
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
  return numberText(value, 7);
}

double NumberSpinBox::valueFromText(const QString& text) const {
  return withoutSuffix(text, suffix()).toDouble();
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

}  // namespace isolux::ui
