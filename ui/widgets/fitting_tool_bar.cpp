#include "ui/widgets/fitting_tool_bar.h"

#include <algorithm>

#include <QEvent>

namespace isolux::ui {

void FittingToolBar::addGroup(int rank, Before before, const QList<QAction*>& actions) {
  Group group{rank, {}};
  if (before == Before::separator) {
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    group.actions += separator;
  }
  group.actions += actions;
  addActions(group.actions);
  groups_.push_back(std::move(group));
}

void FittingToolBar::hideRank(int rank) {
  const int before = sizeHint().width();
  for (const Group& group : groups_)
    if (group.rank == rank)
      for (QAction* action : group.actions) removeAction(action);
  hidden_[rank] = before - sizeHint().width();
}

void FittingToolBar::showRank(int rank) {
  hidden_.erase(rank);
  QAction* next = nullptr;  // from the right: what stands behind
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
    if (hidden_.contains(group->rank)) continue;
    if (group->rank == rank) insertActions(next, group->actions);
    next = group->actions.front();
  }
}

void FittingToolBar::fit() {
  if (groups_.empty()) return;
  for (;;) {
    int least = stays;  // of what is shown
    for (const Group& group : groups_)
      if (!hidden_.contains(group.rank)) least = std::min(least, group.rank);
    if (sizeHint().width() <= width() || least == stays) break;
    hideRank(least);
  }
  while (!hidden_.empty()) {
    const auto [rank, taken] = *hidden_.rbegin();
    if (sizeHint().width() + taken > width()) break;
    showRank(rank);
  }
}

bool FittingToolBar::event(QEvent* event) {
  const bool done = QToolBar::event(event);
  if (event->type() == QEvent::LayoutRequest && isVisible()) fit();
  return done;
}

void FittingToolBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  fit();
}

}  // namespace isolux::ui
