#include "ui/slices/oblique_dialog.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <glm/geometric.hpp>

#include "ui/slices/slice_view.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

ObliqueDialog::ObliqueDialog(glm::dvec3 pointMm, glm::dvec3 normal, QWidget* parent)
    : QDialog(parent), buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setWindowTitle(tr("Oblique slice"));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  const auto addRow = [&](int row, const QString& name, std::array<NumberSpinBox*, 3>& boxes, glm::dvec3 v,
                          double reach) {
    grid->addWidget(new QLabel(name, this), row, 0);
    for (int i = 0; i < 3; ++i) {
      NumberSpinBox*& box = boxes[static_cast<std::size_t>(i)] = new NumberSpinBox(this);
      box->setRange(-reach, reach);
      box->setAccessibleName(name + ' ' + QChar("xyz"[i]));
      box->showValue(v[i]);
      grid->addWidget(box, row, 1 + i);
      connect(box, &NumberSpinBox::valueChanged, this, &ObliqueDialog::check);
    }
  };
  for (int i = 0; i < 3; ++i) grid->addWidget(new QLabel(QChar("xyz"[i]), this), 0, 1 + i, Qt::AlignHCenter);
  addRow(1, tr("Point (mm)"), point_, pointMm, 1e5);
  addRow(2, tr("Normal"), normal_, normal, 1e3);
  auto* note =
      wrappedLabel(tr("The crosshair moves to the point. The plane is perpendicular to the normal and "
                      "follows the crosshair."),
                   this);
  layOut(this, columnOf({grid, note, buttons_}, 14), {18, 18, 18, 14});
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  check();
}

glm::dvec3 ObliqueDialog::pointMm() const {
  return {point_[0]->value(), point_[1]->value(), point_[2]->value()};
}

glm::dvec3 ObliqueDialog::normal() const {
  return {normal_[0]->value(), normal_[1]->value(), normal_[2]->value()};
}

void ObliqueDialog::check() {
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(glm::length(normal()) > 0.0);
}

void askForPlane(SliceView& view) {
  const auto plane = view.planeOfView();
  if (!plane) return;
  const glm::dvec3 before = view.position();
  auto* dialog = new ObliqueDialog(before, plane->plane.normal(), view.window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QDialog::accepted, &view, [&view, dialog, before] {
    view.choose({.kind = app::SliceChoice::Kind::oblique, .normal = dialog->normal()});
    if (dialog->pointMm() == before) return;
    Edit edit{view.scene(), QObject::tr("Move crosshair")};
    edit.scene.slice.position = dialog->pointMm();
    Q_EMIT view.edited(edit);
  });
  dialog->open();
}

}  // namespace isolux::ui
