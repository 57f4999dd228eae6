#include "ui/widgets/number_spin_box.h"

#include <cmath>
#include <utility>

#include <QDialog>
#include <QFocusEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>
#include "ui/language/number_text.h"

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

bool isUndoOrRedo(const QEvent& event) {
  if (event.type() != QEvent::ShortcutOverride && event.type() != QEvent::KeyPress) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

// What undo and redo do in a box that shows `shown` when nothing is typed. The text's own undo would change
// it without entering it.
template <typename Box, typename Number>
void takeUndo(Box& box, QLineEdit& line, const QString& shown, const EnteredNumbers<Number>& entered,
              QEvent& event) {
  const bool undo = static_cast<const QKeyEvent&>(event).matches(QKeySequence::Undo);
  const bool typed = line.text() != shown, own = entered.own || qobject_cast<QDialog*>(box.window());
  if (event.type() == QEvent::ShortcutOverride) {
    event.setAccepted(own || (undo && typed));  // else the window's shortcut
  } else if (undo && typed) {
    line.setText(shown);
    box.selectAll();
  } else if (undo && own && entered.before) {
    box.setValue(*entered.before);
    box.selectAll();
  }
}

template <typename Number>
void noteEntered(EnteredNumbers<Number>& entered, Number value) {
  entered.before = std::exchange(entered.last, value);
}

}  // namespace

NumberSpinBox::NumberSpinBox(QWidget* parent) : CalmWheel(parent) {
  setDecimals(323);  // no rounding of the value; textFromValue decides what is shown
  setRange(-1e300, 1e300);
  setKeyboardTracking(false);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  connect(this, &NumberSpinBox::valueChanged, this, [this](double value) { noteEntered(entered_, value); });
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
  if (isUndoOrRedo(*event)) {
    takeUndo(*this, *lineEdit(), textFromValue(value()) + suffix(), entered_, *event);
    return true;
  }
  if (event->type() != QEvent::ToolTip) return QDoubleSpinBox::event(event);
  const QString tip = tipOf(this), all = numberText(value(), allDigits) + suffix();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip.isEmpty() ? all : all + "\n\n" + tip,
                     this);
  return true;
}

void NumberSpinBox::focusInEvent(QFocusEvent* event) {
  editing_ = true;
  entered_.last = value();
  entered_.before.reset();
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

IntegerSpinBox::IntegerSpinBox(QWidget* parent) : CalmWheel(parent) {
  setKeyboardTracking(false);
  connect(this, &IntegerSpinBox::valueChanged, this, [this](int value) { noteEntered(entered_, value); });
}

bool IntegerSpinBox::event(QEvent* event) {
  if (!isUndoOrRedo(*event)) return QSpinBox::event(event);
  takeUndo(*this, *lineEdit(), prefix() + textFromValue(value()) + suffix(), entered_, *event);
  return true;
}

void IntegerSpinBox::focusInEvent(QFocusEvent* event) {
  entered_.last = value();
  entered_.before.reset();
  QSpinBox::focusInEvent(event);
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

}  // namespace isolux::ui
