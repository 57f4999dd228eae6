#include "ui/editors/planes_widget.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "scene/scene.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

using nlohmann::json;

PlanesWidget::PlanesWidget(const scene::SettingInfo& setting, QWidget* parent)
    : ValueWidget(parent), minimum_(setting.minimum), maximum_(setting.maximum) {
  list_ = columnOf({}, 8);
  add_ = textButton(
      tr("Add a plane"),
      tr("Add a copy of the last plane, or a plane across the z axis through the origin. The Cut menu adds "
         "planes through the view’s target."),
      this);
  auto* const layout = columnOf({list_}, 6);
  layout->addWidget(add_, 0, Qt::AlignLeft);
  layOut(this, layout, {});
  setFocusProxy(add_);
  connect(add_, &QToolButton::clicked, this, [this] {
    json planes = value();
    planes.push_back(planes.empty() ? json{0.0, 0.0, 0.0, 0.0, 0.0, 1.0} : json(planes.back()));
    enter(planes);
  });
}

void PlanesWidget::addRow() {
  const auto number = static_cast<int>(rows_.size()) + 1;
  Row row;
  row.box = new QWidget(this);
  auto* grid = new QGridLayout(row.box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  grid->addWidget(new QLabel(tr("%1 at").arg(number), row.box), 0, 0);
  grid->addWidget(new QLabel(tr("normal"), row.box), 1, 0);
  const char* axes = "xyz";
  for (std::size_t i = 0; i < row.numbers.size(); ++i) {
    auto* box = row.numbers[i] = new NumberSpinBox(row.box);
    const auto axis = i % 3;
    box->setRange(minimum_, maximum_);
    box->setSingleStep(i < 3 ? 1.0 : 0.05);
    box->setMinimumWidth(48);
    nameAndTip(box, (i < 3 ? tr("Plane %1, %2 of its point, mm") : tr("Plane %1, %2 of its normal"))
                        .arg(number)
                        .arg(QChar(axes[axis])));
    grid->addWidget(box, static_cast<int>(i / 3), 1 + static_cast<int>(axis));
    grid->setColumnStretch(1 + static_cast<int>(axis), 1);
    connect(box, &NumberSpinBox::refused, this, &ValueWidget::refused);
    connect(box, &NumberSpinBox::valueChanged, this, [this] { Q_EMIT changed(true); });
  }
  const auto button = [&](const QString& text, const QString& tip, int line) {
    auto* made = textButton(text, tip, row.box);
    nameAndTip(made, tip);
    made->setAutoRaise(true);
    made->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    grid->addWidget(made, line, 4);
    return made;
  };
  const std::size_t index = rows_.size();
  row.remove = button(tr("Remove"), tr("Remove plane %1").arg(number), 0);
  row.flip = button(tr("Reverse"), tr("Reverse plane %1: cut away the other side").arg(number), 1);
  connect(row.remove, &QToolButton::clicked, this, [this, index] {
    json planes = value();
    planes.erase(index);
    enter(planes);
  });
  connect(row.flip, &QToolButton::clicked, this, [this, index] {
    json planes = value();
    for (std::size_t i = 3; i < 6; ++i)
      if (const double part = planes[index][i]; part != 0.0) planes[index][i] = -part;
    enter(planes);
  });
  list_->addWidget(row.box);
  rows_.push_back(row);
}

// A button's change; numbers that are typed come by themselves.
void PlanesWidget::enter(const json& planes) {
  showValue(planes);
  Q_EMIT changed(false);
}

void PlanesWidget::showValue(const json& planes) {
  while (rows_.size() > planes.size()) {
    rows_.back().box->hide();
    rows_.back().box->deleteLater();  // its own button may have asked for it
    rows_.pop_back();
  }
  while (rows_.size() < planes.size()) addRow();
  for (std::size_t row = 0; row < rows_.size(); ++row)
    for (std::size_t i = 0; i < 6; ++i) rows_[row].numbers[i]->showValue(planes[row][i].get<double>());
  add_->setEnabled(planes.size() < scene::kClipPlanes);
}

json PlanesWidget::value() const {
  json planes = json::array();
  for (const Row& row : rows_) {
    json plane = json::array();
    for (const NumberSpinBox* number : row.numbers) plane.push_back(number->value());
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace isolux::ui
