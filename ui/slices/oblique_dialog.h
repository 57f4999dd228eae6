// An oblique plane by its numbers: a point that it passes through, which becomes the crosshair, and its
// normal.
#pragma once

#include <array>

#include <QDialog>

#include <glm/vec3.hpp>

class QDialogButtonBox;

namespace isolux::ui {

class NumberSpinBox;
class SliceView;

class ObliqueDialog : public QDialog {
  Q_OBJECT
 public:
  ObliqueDialog(glm::dvec3 pointMm, glm::dvec3 normal, QWidget* parent);

  glm::dvec3 pointMm() const;
  glm::dvec3 normal() const;
  NumberSpinBox* pointBox(int axis) const { return point_[static_cast<std::size_t>(axis)]; }
  NumberSpinBox* normalBox(int axis) const { return normal_[static_cast<std::size_t>(axis)]; }

 private:
  void check();  // a normal without a direction is not taken

  std::array<NumberSpinBox*, 3> point_{}, normal_{};
  QDialogButtonBox* buttons_;
};

// Opens it over the view, which shows what was entered; a moved crosshair is one step of undo.
void askForPlane(SliceView& view);

}  // namespace isolux::ui
