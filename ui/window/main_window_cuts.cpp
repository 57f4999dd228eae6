// Cuts by hand, of ui/window/main_window.h: the menu, and what the handles in the picture ask of it.
#include <QMenuBar>
#include <QTreeWidget>

#include "ui/cuts/cut_menu.h"
#include "ui/panels/marks_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

namespace isolux::ui {

void MainWindow::makeCutMenu() {
  auto* const cuts = new CutMenu(menuBar()->addMenu(tr("&Cut")), this);
  connect(document_, &Document::volumeChanged, cuts, &CutMenu::setVolume);
  connect(document_, &Document::sceneChanged, cuts, &CutMenu::setScene);
  connect(cuts, &CutMenu::edited, this, &MainWindow::applyEdit);
  connect(cuts, &CutMenu::handlesShown, viewport_, &Viewport::setCutHandles);
  connect(cuts, &CutMenu::failed, this,
          [this](const QString& text) { message_->show(MessageBar::Kind::error, text); });
  connect(viewport_, &Viewport::cutMenuAsked, cuts, &CutMenu::showMenuOf);
  cuts->setChosenMark([this] {
    const QTreeWidget* const list = panel<MarksPanel>()->list();
    return list->indexOfTopLevelItem(list->currentItem());
  });
  viewport_->setCutHandles(cuts->showsHandles());
}

}  // namespace isolux::ui
