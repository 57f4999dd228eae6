// What panels and dialogs are put together from: lines and columns of widgets, and widgets with their texts.
#pragma once

#include <initializer_list>

#include <QBoxLayout>
#include <QString>
#include <glm/vec2.hpp>

class QGridLayout;
class QLabel;
class QProgressBar;
class QSpinBox;
class QToolButton;
class QWidget;

namespace isolux::ui {

// A place in a line or column. `stretch` as QBoxLayout has it.
struct Cell {
  Cell(QWidget* shown, int itsStretch = 0) : widget(shown), stretch(itsStretch) {}
  Cell(QLayout* inside, int itsStretch = 0) : layout(inside), stretch(itsStretch) {}
  static Cell gap(int pixels) { return {nullptr, nullptr, 0, pixels}; }
  static Cell room(int stretch = 1) { return {nullptr, nullptr, stretch, 0}; }

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int stretch = 0, pixels = 0;

 private:
  Cell(QWidget* w, QLayout* l, int s, int p) : widget(w), layout(l), stretch(s), pixels(p) {}
};

// `spacing` in pixels; below 0: that of the style.
QBoxLayout* lineOf(std::initializer_list<Cell> cells, int spacing = -1);
QBoxLayout* columnOf(std::initializer_list<Cell> cells, int spacing = -1);
// All that `owner` shows. The margins are the style's where none are given.
void layOut(QWidget* owner, QBoxLayout* cells);
void layOut(QWidget* owner, QBoxLayout* cells, QMargins margins);

QLabel* wrappedLabel(const QString& text, QWidget* parent);
QToolButton* textButton(const QString& text, const QString& tip, QWidget* parent);

QSpinBox* spinBox(int low, int high, int value, const QString& name, QWidget* parent = nullptr);
// A row of a form. The name and the tip are those of the editor, too.
QLabel* addRow(QGridLayout* form, int row, const QString& name, QWidget* editor, const QString& tip);
// The accessible name and the tool tip; without a tip the name is both.
void nameAndTip(QWidget* widget, const QString& name, const QString& tip = {});
void makeBold(QWidget* widget);
// What is around it does not move when it is hidden.
void keepPlaceWhenHidden(QWidget* widget);

// Of an arrow key: x right, y up; 0 0 for other keys.
glm::dvec2 arrowOf(int key);

// A tab behind others is visible to Qt, but not to anybody.
bool isSeen(const QWidget* widget);

// A thin bar without text.
QProgressBar* thinBar(QWidget* parent);
void showFraction(QProgressBar* bar, double fraction);

}  // namespace isolux::ui
