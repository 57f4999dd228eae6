// How the window is laid out: picture and slices, docks that move and float, what of it is remembered between
// starts, and the keys that go from one part to another.
//
// Of the user, not of the document: kept in QSettings, no undo. A stored layout that cannot be read, or that
// lies where no screen is any more, is mended.
#pragma once

#include <vector>

#include <QByteArray>
#include <QObject>

class QActionGroup;
class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace isolux::ui {

class SliceBoard;
class Viewport;

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
