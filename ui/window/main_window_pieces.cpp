// Pieces of the surface by hand, of ui/window/main_window.h: the menu that a right click opens.
#include <QMenu>

#include "app/interaction/piece_choice.h"
#include "ui/viewport/pointed_piece.h"
#include "ui/window/main_window.h"

namespace isolux::ui {

void MainWindow::choosePieces(const QString& name, const scene::Pieces& choice) {
  Edit edit{document_->scene(), name, {}, false};
  edit.scene.pieces = choice;
  applyEdit(edit);
}

void MainWindow::showSurfaceMenu(const QPoint& onScreen, const std::optional<app::Pick>& pick) {
  const VolumePointer& volume = document_->volume();
  if (!volume) return;
  showPointed(pick);
  const scene::Pieces before = document_->scene().pieces;
  const scene::Inside inside = document_->scene().isosurface.inside;
  const auto seed = pick ? app::seedOfPick(*volume, *pick, inside) : std::nullopt;
  auto* menu = new QMenu(this);
  menu->setObjectName("surface");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const QString& name, const scene::Pieces& choice) {
    QAction* action = menu->addAction(text);
    action->setEnabled(!(choice == before));
    connect(action, &QAction::triggered, this, [=, this] { choosePieces(name, choice); });
  };
  if (seed) {
    const QString what = pointedPiece_->text();
    if (!what.isEmpty()) menu->addSection(what[0].toUpper() + what.mid(1));
    add(tr("&Hide this piece"), tr("Hide piece"), app::withHidden(before, {*seed}));
    add(tr("Show &only this piece"), tr("Show only one piece"), app::onlyThese({*seed}));
    menu->addSeparator();
  }
  add(tr("&Keep the largest piece"), tr("Keep the largest piece"), app::onlyLargest(1));
  add(tr("Show &all pieces"), tr("Show all pieces"), {});
  menu->addSeparator();
  connect(menu->addAction(tr("&List the pieces")), &QAction::triggered, this,
          [this] { showPanel("Pieces"); });
  menu->popup(onScreen);
}

}  // namespace isolux::ui
