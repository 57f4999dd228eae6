#include "ui/widgets/parts.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>
#include <QToolButton>

namespace isolux::ui {

namespace {

constexpr int barSteps = 1000;

QBoxLayout* filled(QBoxLayout::Direction direction, std::initializer_list<Cell> cells, int spacing) {
  auto* const box = new QBoxLayout(direction);
  box->setSpacing(spacing);
  for (const Cell& cell : cells) {
    if (cell.widget)
      box->addWidget(cell.widget, cell.stretch);
    else if (cell.layout)
      box->addLayout(cell.layout, cell.stretch);
    else if (cell.pixels > 0)
      box->addSpacing(cell.pixels);
    else
      box->addStretch(cell.stretch);
  }
  return box;
}

}  // namespace

QBoxLayout* lineOf(std::initializer_list<Cell> cells, int spacing) {
  return filled(QBoxLayout::LeftToRight, cells, spacing);
}

QBoxLayout* columnOf(std::initializer_list<Cell> cells, int spacing) {
  return filled(QBoxLayout::TopToBottom, cells, spacing);
}

void layOut(QWidget* owner, QBoxLayout* cells) {
  owner->setLayout(cells);
}

void layOut(QWidget* owner, QBoxLayout* cells, QMargins margins) {
  cells->setContentsMargins(margins);
  owner->setLayout(cells);
}

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
  auto* const label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

QToolButton* textButton(const QString& text, const QString& tip, QWidget* parent) {
  auto* const button = new QToolButton(parent);
  button->setText(text);
  button->setToolTip(tip);
  return button;
}

QSpinBox* spinBox(int low, int high, int value, const QString& name, QWidget* parent) {
  auto* const box = new QSpinBox(parent);
  box->setRange(low, high);
  box->setValue(value);
  box->setAccessibleName(name);
  return box;
}

QLabel* addRow(QGridLayout* form, int row, const QString& name, QWidget* editor, const QString& tip) {
  auto* const label = new QLabel(name);
  label->setBuddy(editor);
  label->setToolTip(tip);
  nameAndTip(editor, name, tip);
  form->addWidget(label, row, 0);
  form->addWidget(editor, row, 1);
  return label;
}

void nameAndTip(QWidget* widget, const QString& name, const QString& tip) {
  widget->setAccessibleName(name);
  widget->setToolTip(tip.isEmpty() ? name : tip);
}

void makeBold(QWidget* widget) {
  QFont font = widget->font();
  font.setWeight(QFont::DemiBold);
  widget->setFont(font);
}

void keepPlaceWhenHidden(QWidget* widget) {
  QSizePolicy policy = widget->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  widget->setSizePolicy(policy);
}

glm::dvec2 arrowOf(int key) {
  return {int(key == Qt::Key_Right) - int(key == Qt::Key_Left),
          int(key == Qt::Key_Up) - int(key == Qt::Key_Down)};
}

bool isSeen(const QWidget* widget) {
  return widget->isVisible() && !widget->visibleRegion().isEmpty();
}

QProgressBar* thinBar(QWidget* parent) {
  auto* const bar = new QProgressBar(parent);
  bar->setRange(0, barSteps);
  bar->setTextVisible(false);
  bar->setFixedHeight(8);
  return bar;
}

void showFraction(QProgressBar* bar, double fraction) {
  bar->setValue(static_cast<int>(std::lround(barSteps * std::clamp(fraction, 0.0, 1.0))));
}

}  // namespace isolux::ui
