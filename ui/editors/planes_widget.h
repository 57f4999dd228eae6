// Planes that cut, one below the other: a point and a normal each as numbers, to flip, remove and add.
#pragma once

#include <array>
#include <vector>

#include "ui/editors/value_widgets.h"

class QToolButton;
class QBoxLayout;

namespace isolux::ui {

class NumberSpinBox;

class PlanesWidget : public ValueWidget {
  Q_OBJECT
 public:
  PlanesWidget(const scene::SettingInfo& setting, QWidget* parent);

  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;

  // The rows that are there, for tests: point x, y, z and normal x, y, z.
  struct Row {
    QWidget* box = nullptr;
    std::array<NumberSpinBox*, 6> numbers{};
    QToolButton *flip = nullptr, *remove = nullptr;
  };
  const std::vector<Row>& rows() const { return rows_; }
  QToolButton* addButton() const { return add_; }

 private:
  void addRow();
  void enter(const nlohmann::json& planes);

  double minimum_, maximum_;
  std::vector<Row> rows_;
  QBoxLayout* list_;
  QToolButton* add_;
};

}  // namespace isolux::ui
