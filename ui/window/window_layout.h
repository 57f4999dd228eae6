// How the window is laid out: picture and slices, docks that move and float, what of it is remembered between
// starts, and the keys that go from one part to another.
//
// Of the user, not of the document: kept in QSettings, no undo. A stored layout that cannot be read, or that
// lies where no screen is any more, is mended.
#pragma once

#include <vector>

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QRect>

class QActionGroup;
class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace isolux::ui {

class SliceBoard;
class Viewport;

// The rectangle moved and made smaller until it lies on the screen that it shares most with; on the first
// where it lies on none. `screens`: what each has room for; none: it stays. One that fits stays as it is.
QRect fittedOnScreens(const QRect& window, const QList<QRect>& screens);

class WindowLayout : public QObject {
  Q_OBJECT
 public:
  WindowLayout(QMainWindow* window, SliceBoard* board, Viewport* picture);

  // A panel's dock, in the order of their keys (Ctrl+1 ...). Moves, floats and closes.
  void addDock(QDockWidget* dock);
  void fillMenu(QMenu* menu);  // layouts, panels, the way between the parts

  void restore();  // what keep() kept; nothing where nothing was
  void keep() const;

  // In a panel that lies behind another: there is nothing to see of it.
  bool isBehind(const QWidget* widget) const;

  // All but the picture goes, and comes back as it was.
  void hideAllBut();
  void showAgain();

 private:
  void styleTitle(QDockWidget* dock);
  void styleTitles();
  void stepLayout();
  void goTo(QDockWidget* dock);
  void floatFront(bool floats);
  void goOn(int step);
  void mendFloating();
  int docksInPlace() const;  // open, and not floating
  void giveTabsRoom();

  QMainWindow* const window_;
  SliceBoard* const board_;
  Viewport* const picture_;
  std::vector<QDockWidget*> docks_;
  QActionGroup* layouts_;
  int inPlace_ = 0;    // docksInPlace() as it was last
  QByteArray before_;  // full screen: which panels were open
};

}  // namespace isolux::ui
