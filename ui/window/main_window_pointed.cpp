// What is under the pointer, of ui/window/main_window.h: its text in the status bar, the menu of its piece,
// and the slices beside the picture, in which a point that is clicked on is shown.
#include <cmath>

#include <QLabel>
#include <QMenu>

#include "app/cuts/cut_edits.h"
#include "app/slices/slice_choice.h"
#include "app/slices/slice_content.h"
#include "app/view_math/piece_choice.h"
#include "ui/language/number_text.h"
#include "ui/panels/marks_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/viewport/pointed_piece.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "volume/measure/point_probe.h"

namespace isolux::ui {

namespace {

// "liver (5)", "label 5", or "" where none is shown.
QString labelText(const volume::ShownLabels& labels, const glm::dvec3& voxel) {
  const std::optional<int> label = volume::labelAt(labels, voxel);
  if (!label) return {};
  const QString name = QString::fromStdString(volume::labelName(labels.table.get(), *label));
  return name.isEmpty() ? QObject::tr("label %1").arg(*label) : QString("%1 (%2)").arg(name).arg(*label);
}

}  // namespace

void MainWindow::showPointed(const std::optional<app::Pick>& pick) {
  const VolumePointer& loaded = document_->volume();
  pointedPiece_->point(loaded, document_->resolvedScene(), loaded ? pick : std::nullopt);
  if (!pick || !loaded) {
    pointedText_.clear();
    pointedLabel_->clear();
    return;
  }
  const volume::Volume& volume = loaded->volume;
  // The way a radiologist says them: "L 12.3"; "X −12.3" where no side is known.
  const auto place = [&](int axis) {
    const double mm = pick->worldMm[axis];
    const bool sides = volume.axes == scene::WorldAxes::anatomical;
    const QString letter =
        sides ? QString::fromStdString(axisEnd(volume.axes, axis, mm >= 0.0)) : QString(QChar("XYZ"[axis]));
    return QString("%1 %2%3").arg(letter, !sides && mm < 0.0 ? "−" : "").arg(std::abs(mm), 0, 'f', 1);
  };
  const QString unit = QString::fromStdString(volume.unit);
  const QString label = loaded->labels ? labelText(*loaded->labels, pick->voxel) : QString();
  pointedText_ = tr("%1   %2   %3 mm      voxel %4, %5, %6      %7")
                     .arg(place(0), place(1), place(2))
                     .arg(pick->voxel.x, 0, 'f', 1)
                     .arg(pick->voxel.y, 0, 'f', 1)
                     .arg(pick->voxel.z, 0, 'f', 1)
                     .arg(label.isEmpty() ? tr("value %1").arg(valueText(pick->value, unit)) : label) +
                 shapeText(pick->worldMm);
  showPointedText();
}

void MainWindow::showPointedText() {
  if (pointedText_.isEmpty()) return;
  const QString piece = pointedPiece_->text();
  pointedLabel_->setText(piece.isEmpty() ? pointedText_ : pointedText_ + "      " + piece);
}

// Only where noise, scale and field are known: nothing is made for a pointer that passes by.
QString MainWindow::shapeText(glm::dvec3 worldMm) const {
  const VolumePointer& volume = document_->volume();
  scene::Scene scene = document_->resolvedScene();
  const scene::Derivatives& derivatives = scene.derivatives;
  if (!scene.surfaces.front().value ||
      !volume->derivativeChoices->find(
          {*scene.surfaces.front().value, derivatives.field, document_->scene().derivatives.noise}) ||
      !volume->derivativeChoices->completeIfChosen(scene))
    return {};
  const auto interpolating = scene::Field::cubic_interpolating;
  const bool reads = scene.hit.field == interpolating || derivatives.field == interpolating;
  const double scale = derivatives.scale.value_or(0.0);
  if ((reads && !volume->cubicFields->find(interpolating)) ||
      (scale > 0.0 && !volume->cubicFields->find(derivatives.field, scale)))
    return {};
  base::Progress progress;
  const auto point = volume::PointProbe(volume, scene, progress).at(worldMm);
  if (!point || point->curvature.normal == glm::dvec3(0.0)) return {};
  return tr("      κ₁ %1, κ₂ %2 /mm (confidence %3)")
      .arg(numberText(point->curvature.kappa1, 3), numberText(point->curvature.kappa2, 3),
           numberText(point->confidence, 2));
}

void MainWindow::choosePieces(const QString& name, const scene::Pieces& choice) {
  Edit edit{document_->scene(), name};
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
    menu->addAction(text, this, [=, this] { choosePieces(name, choice); })->setEnabled(!(choice == before));
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
  menu->addAction(tr("&List the pieces"), this, [this] { showPanel("Pieces"); });
  menu->popup(onScreen);
}

// Slices

void MainWindow::connectSlices() {
  connect(slices_, &SliceBoard::edited, this, &MainWindow::applyEdit);
  connect(slices_, &SliceBoard::gestureEnded, this, &MainWindow::endGesture);
  connect(slices_, &SliceBoard::failed, message_, &MessageBar::showError);
  connect(slices_, &SliceBoard::planesChanged, this, &MainWindow::showSlicesInPicture);
  connect(viewport_, &Viewport::clicked, this,
          [this](const app::Pick& pick) { moveCrosshair(pick.worldMm); });
  connect(panel<MarksPanel>(), &MarksPanel::chosen, this, &MainWindow::moveCrosshair);
}

// Only where slices are shown: else a click would change the scene and show nothing of it.
void MainWindow::moveCrosshair(glm::dvec3 worldMm) {
  const VolumePointer& volume = document_->volume();
  if (!volume || !slices_->slicesShown()) return;
  if (app::slicePosition(document_->scene(), volume->grid().geometry()) == worldMm) return;
  Edit edit{document_->scene(), tr("Move crosshair")};
  edit.scene.slice.position = worldMm;
  applyEdit(edit);
}

void MainWindow::showSlicesInPicture() {
  SlicesInPicture shown;
  const VolumePointer& volume = document_->volume();
  if (volume) {
    const volume::GridGeometry& geometry = volume->grid().geometry();
    shown.crosshairMm = app::slicePosition(document_->resolvedScene(), geometry);
    for (const PlaneOfView& view : slices_->planes())
      shown.outlines.push_back(
          {app::outlineOf({view.plane.pointMm, view.plane.normal()}, geometry.corners()), view.color});
  }
  viewport_->setSlices(std::move(shown));
}

}  // namespace isolux::ui
