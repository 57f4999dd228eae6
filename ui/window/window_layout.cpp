#include "ui/window/window_layout.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>

#include "ui/slices/slice_board.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr double mostForTabs = 0.4;  // of the window's width
constexpr int stateVersion = 1;      // of what QMainWindow stores: another set of docks and bars
constexpr auto geometryKey = "window/geometry", stateKey = "window/state", layoutKey = "window/layout";

struct NamedLayout {
  ViewLayout layout;
  const char *name, *stored, *tip;
};
constexpr std::array<NamedLayout, 3> namedLayouts{
    {{ViewLayout::picture, QT_TRANSLATE_NOOP("QObject", "&3-D view"), "picture",
      QT_TRANSLATE_NOOP("QObject", "Show the 3-D view without slices")},
     {ViewLayout::fourUp, QT_TRANSLATE_NOOP("QObject", "3-D view and &slices"), "four_up",
      QT_TRANSLATE_NOOP("QObject", "Show axial, coronal and sagittal slices next to the 3-D view")},
     {ViewLayout::slices, QT_TRANSLATE_NOOP("QObject", "Slices &alone"), "slices",
      QT_TRANSLATE_NOOP("QObject", "Show the three slices without the 3-D view")}}};

QList<QRect> availableScreens() {
  QList<QRect> areas;
  for (const QScreen* screen : QGuiApplication::screens()) areas.push_back(screen->availableGeometry());
  return areas;
}

void mend(QWidget* window) {
  const QRect fitted = fittedOnScreens(window->geometry(), availableScreens());
  if (fitted != window->geometry()) window->setGeometry(fitted);
}

// The first stop of the Tab key in it.
QWidget* firstStop(QWidget* part) {
  if (part->focusPolicy() & Qt::TabFocus) return part;
  for (QWidget* next = part->nextInFocusChain(); next != part; next = next->nextInFocusChain())
    if (part->isAncestorOf(next) && (next->focusPolicy() & Qt::TabFocus) && next->isEnabled() &&
        next->isVisible())
      return next;
  return nullptr;
}

}  // namespace

QRect fittedOnScreens(const QRect& window, const QList<QRect>& screens) {
  if (screens.isEmpty()) return window;
  const auto shared = [&](const QRect& screen) {
    const QRect common = screen.intersected(window);
    return static_cast<qint64>(common.width()) * common.height();
  };
  const QRect& screen = *std::max_element(
      screens.begin(), screens.end(), [&](const QRect& a, const QRect& b) { return shared(a) < shared(b); });
  QRect fitted(window.topLeft(), window.size().boundedTo(screen.size()));
  fitted.moveLeft(std::clamp(fitted.left(), screen.left(), screen.left() + screen.width() - fitted.width()));
  fitted.moveTop(std::clamp(fitted.top(), screen.top(), screen.top() + screen.height() - fitted.height()));
  return fitted;
}

WindowLayout::WindowLayout(QMainWindow* window, SliceBoard* board, Viewport* picture)
    : QObject(window), window_(window), board_(board), picture_(picture), layouts_(new QActionGroup(this)) {
  window->setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks |
                         QMainWindow::AllowTabbedDocks | QMainWindow::GroupedDragging);
  for (const NamedLayout& named : namedLayouts) {
    auto* action = new QAction(QObject::tr(named.name), layouts_);
    action->setCheckable(true);
    action->setToolTip(QObject::tr(named.tip));
    action->setChecked(board->arrangement() == named.layout);
    connect(action, &QAction::triggered, this, [this, layout = named.layout] { board_->arrange(layout); });
  }
  connect(board, &SliceBoard::arranged, this,
          [this](ViewLayout layout) { layouts_->actions().at(static_cast<int>(layout))->setChecked(true); });
}

void WindowLayout::addDock(QDockWidget* dock) {
  docks_.push_back(dock);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                    QDockWidget::DockWidgetFloatable);
  // Others' titles change with it, when all has settled.
  const auto later = [this] { QTimer::singleShot(0, this, &WindowLayout::styleTitles); };
  connect(dock, &QDockWidget::topLevelChanged, this, later);
  connect(dock, &QDockWidget::dockLocationChanged, this, later);
  connect(dock, &QDockWidget::visibilityChanged, this, later);
  connect(dock, &QDockWidget::visibilityChanged, this,
          [this] { QTimer::singleShot(0, this, &WindowLayout::giveTabsRoom); });
  later();
}

void WindowLayout::styleTitles() {
  for (QDockWidget* dock : docks_) styleTitle(dock);
}

// Among tabs the tab says the name and is what one drags; alone or floating the dock has a title.
void WindowLayout::styleTitle(QDockWidget* dock) {
  const QList<QDockWidget*> beside = window_->tabifiedDockWidgets(dock);
  const bool inTabs = !dock->isFloating() && std::any_of(beside.begin(), beside.end(),
                                                         [](const QDockWidget* d) { return !d->isHidden(); });
  if (inTabs == (dock->titleBarWidget() != nullptr)) return;
  QWidget* const old = dock->titleBarWidget();
  dock->setTitleBarWidget(inTabs ? new QWidget(dock) : nullptr);
  delete old;
}

int WindowLayout::docksInPlace() const {
  return static_cast<int>(std::count_if(docks_.begin(), docks_.end(), [](const QDockWidget* dock) {
    return !dock->isHidden() && !dock->isFloating();
  }));
}

// One more panel: wide enough for all their names, once. Who makes them narrower later gets shorter names.
void WindowLayout::giveTabsRoom() {
  const int before = std::exchange(inPlace_, docksInPlace());
  if (inPlace_ <= before) return;
  for (const QTabBar* bar : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
    const int wanted = bar->sizeHint().width();
    if (!bar->isVisible() || bar->width() >= wanted || wanted > mostForTabs * window_->width()) continue;
    for (int tab = 0; tab < bar->count(); ++tab)
      for (QDockWidget* dock : docks_)
        if (dock->windowTitle() == bar->tabText(tab) && isSeen(dock))
          window_->resizeDocks({dock}, {wanted}, Qt::Horizontal);
  }
}

void WindowLayout::fillMenu(QMenu* menu) {
  QMenu* const layouts = menu->addMenu(tr("&Layout"));
  layouts->setToolTipsVisible(true);
  layouts->addActions(layouts_->actions());
  layouts->addSeparator();
  layouts->addAction(tr("&Next layout"), QKeySequence("F4"), this, &WindowLayout::stepLayout);

  QMenu* const shown = menu->addMenu(tr("&Panels"));
  for (QDockWidget* dock : docks_) shown->addAction(dock->toggleViewAction());
  shown->addSeparator();
  QAction* const floats = shown->addAction(tr("&Float the front panel"));
  floats->setCheckable(true);
  connect(shown, &QMenu::aboutToShow, this, [this, floats] {
    floats->setChecked(std::any_of(docks_.begin(), docks_.end(), [](const QDockWidget* dock) {
      return dock->isFloating() && !dock->isHidden();
    }));
  });
  connect(floats, &QAction::triggered, this, &WindowLayout::floatFront);

  QMenu* const go = menu->addMenu(tr("&Go to"));
  go->addAction(tr("3-D &view"), QKeySequence("Ctrl+0"), this, [this] {
    if (picture_->isVisible())
      picture_->setFocus(Qt::ShortcutFocusReason);
    else
      board_->view(volume::SliceDirection::axial)->setFocus(Qt::ShortcutFocusReason);
  });
  constexpr std::size_t mostKeys = 9;
  for (std::size_t i = 0; i < docks_.size(); ++i) {
    QAction* const action =
        go->addAction(docks_[i]->windowTitle(), this, [this, dock = docks_[i]] { goTo(dock); });
    if (i < mostKeys) action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(i + 1)));
  }
  go->addSeparator();
  for (const auto& [text, keys, step] : {std::tuple{tr("&Next part of the window"), "F6", 1},
                                         std::tuple{tr("P&revious part of the window"), "Shift+F6", -1}})
    go->addAction(text, QKeySequence(keys), this, [this, by = step] { goOn(by); });
}

void WindowLayout::stepLayout() {
  const int next = (static_cast<int>(board_->arrangement()) + 1) % static_cast<int>(namedLayouts.size());
  board_->arrange(static_cast<ViewLayout>(next));
}

// In front, with the focus on its first control; again: back to the picture.
void WindowLayout::goTo(QDockWidget* dock) {
  const QWidget* const focused = QApplication::focusWidget();
  if (focused && dock->isAncestorOf(focused) && picture_->isVisible()) {
    picture_->setFocus(Qt::ShortcutFocusReason);
    return;
  }
  dock->show();
  dock->raise();
  if (dock->isFloating()) dock->activateWindow();
  if (QWidget* const stop = firstStop(dock->widget())) stop->setFocus(Qt::ShortcutFocusReason);
}

void WindowLayout::floatFront(bool floats) {
  for (QDockWidget* dock : docks_) {
    if (dock->isHidden() || dock->isFloating() == floats || (floats && !isSeen(dock))) continue;
    dock->setFloating(floats);
    if (floats) return;
  }
}

// Picture, slices, and the panels in front, in a circle.
void WindowLayout::goOn(int step) {
  std::vector<QWidget*> parts;
  if (picture_->isVisible()) parts.push_back(picture_);
  for (const auto direction :
       {volume::SliceDirection::axial, volume::SliceDirection::coronal, volume::SliceDirection::sagittal})
    if (board_->view(direction)->isVisible()) parts.push_back(board_->view(direction));
  for (QWidget* sibling : window_->centralWidget()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
    if (sibling != board_ && sibling->isVisible() && firstStop(sibling)) parts.push_back(sibling);
  for (QDockWidget* dock : docks_)
    if (isSeen(dock)) parts.push_back(dock->widget());
  const QWidget* const focused = QApplication::focusWidget();
  const auto holds = [&](const QWidget* part) { return part == focused || part->isAncestorOf(focused); };
  const auto at = std::find_if(parts.begin(), parts.end(), holds);
  const int count = static_cast<int>(parts.size());
  const int from = at == parts.end() ? (step > 0 ? -1 : 0) : static_cast<int>(at - parts.begin());
  QWidget* const part = parts[static_cast<std::size_t>((from + step + count) % count)];
  if (QWidget* const stop = firstStop(part)) stop->setFocus(Qt::ShortcutFocusReason);
}

bool WindowLayout::isBehind(const QWidget* widget) const {
  return std::any_of(docks_.begin(), docks_.end(), [widget](const QDockWidget* dock) {
    return dock->isAncestorOf(widget) && dock->visibleRegion().isEmpty();
  });
}

void WindowLayout::hideAllBut() {
  before_ = window_->saveState(stateVersion);
  for (QToolBar* bar : window_->findChildren<QToolBar*>()) bar->hide();
  for (QDockWidget* dock : docks_) dock->hide();
}

void WindowLayout::showAgain() {
  window_->restoreState(before_, stateVersion);  // which docks were open, and which lay in front
  before_.clear();
}

void WindowLayout::keep() const {
  QSettings kept;
  kept.setValue(stateKey, before_.isEmpty() ? window_->saveState(stateVersion) : before_);
  if (!window_->isFullScreen()) kept.setValue(geometryKey, window_->saveGeometry());
  kept.setValue(layoutKey, QString(namedLayouts[static_cast<std::size_t>(board_->arrangement())].stored));
}

void WindowLayout::restore() {
  const QSettings kept;
  const QByteArray geometry = kept.value(geometryKey).toByteArray(),
                   state = kept.value(stateKey).toByteArray();
  if (!geometry.isEmpty() && window_->restoreGeometry(geometry) && !window_->isMaximized()) mend(window_);
  if (!state.isEmpty()) window_->restoreState(state, stateVersion);
  for (const NamedLayout& named : namedLayouts)
    if (kept.value(layoutKey).toString() == named.stored) board_->arrange(named.layout);
  mendFloating();
  styleTitles();
  inPlace_ = docksInPlace();
}

void WindowLayout::mendFloating() {
  for (QDockWidget* dock : docks_)
    if (dock->isFloating()) mend(dock);
}

}  // namespace isolux::ui
