#include "ui/editors/rotation_widget.h"

#include <QGridLayout>
#include <QLabel>
#include <nlohmann/json.hpp>

#include "ui/theme/style.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

RotationWidget::RotationWidget(QWidget* parent) : ValueWidget(parent) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(4);
  layout->setVerticalSpacing(1);
  struct Angle {
    QString name, tip;
    double range;
  };
  const std::array<Angle, 3> angles{
      {{tr("Heading"), tr("Rotation about the vertical axis, counterclockwise from above"), 180.0},
       {tr("Elevation"), tr("Height of the environment map’s centre above the horizon"), 90.0},
       {tr("Roll"), tr("Rotation about the direction of the environment map’s centre"), 180.0}}};
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    auto* box = boxes_[i] = new NumberSpinBox(this);
    const int column = static_cast<int>(i);
    box->setRange(-angles[i].range, angles[i].range);
    box->setWrapping(angles[i].range == 180.0);
    box->setSingleStep(5.0);
    box->setSuffix("°");
    box->setMinimumWidth(48);
    nameAndTip(box, angles[i].name, angles[i].tip);
    auto* name = new QLabel(angles[i].name, this);
    setInk(name, Ink::quiet);
    layout->addWidget(name, 0, column);
    layout->addWidget(box, 1, column);
    layout->setColumnStretch(column, 1);
    connect(box, &NumberSpinBox::valueChanged, this, &RotationWidget::edit);
  }
  setFocusProxy(boxes_[0]);
}

void RotationWidget::showValue(const nlohmann::json& value) {
  const glm::dvec4 rotation(value[0].get<double>(), value[1].get<double>(), value[2].get<double>(),
                            value[3].get<double>());
  // What was entered stays as entered: straight up, other angles mean the same rotation.
  if (rotation == rotation_) return;
  rotation_ = rotation;
  const app::TurnAngles angles = app::anglesOf(rotation);
  boxes_[0]->showValue(angles.heading);
  boxes_[1]->showValue(angles.elevation);
  boxes_[2]->showValue(angles.roll);
}

void RotationWidget::edit() {
  rotation_ = app::rotationOf({boxes_[0]->value(), boxes_[1]->value(), boxes_[2]->value()});
  Q_EMIT changed(true);
}

nlohmann::json RotationWidget::value() const {
  return {rotation_.x, rotation_.y, rotation_.z, rotation_.w};
}

}  // namespace isolux::ui
