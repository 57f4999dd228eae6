// A tool bar with no more than there is room for: the groups that matter least go, whole, and come back. What
// they hold is in the menus, too.
#pragma once

#include <map>
#include <vector>

#include <QToolBar>

namespace isolux::ui {

class FittingToolBar : public QToolBar {
  Q_OBJECT
 public:
  FittingToolBar(const QString& title, QWidget* parent) : QToolBar(title, parent) {}

  // From left to right. Groups of the lowest rank go first, those of `stays` never.
  static constexpr int stays = 100;
  enum class Before { nothing, separator };
  void addGroup(int rank, Before before, const QList<QAction*>& actions);

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void hideRank(int rank);
  void showRank(int rank);

  struct Group {
    int rank;
    QList<QAction*> actions;  // with the separator
  };
  std::vector<Group> groups_;
  std::map<int, int> hidden_;  // ranks, and how many pixels they took
};

}  // namespace isolux::ui
