// A rotation as heading, elevation and roll in degrees: the value widget of settings that are quaternions.
#pragma once

#include <array>

#include <glm/vec4.hpp>

#include "app/view_math/turning.h"
#include "ui/editors/setting_editor.h"

namespace isolux::ui {

class NumberSpinBox;

class RotationWidget : public ValueWidget {
  Q_OBJECT
 public:
  explicit RotationWidget(QWidget* parent = nullptr);
  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;  // unit length, or exactly what was shown while nobody edits it

 private:
  void edit();

  glm::dvec4 rotation_{1.0, 0.0, 0.0, 0.0};
  std::array<NumberSpinBox*, 3> boxes_;
};

}  // namespace isolux::ui
