#include "ui/editors/value_widgets.h"

#include <array>
#include <cmath>

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>

#include "app/view_math/turning.h"
#include "base/numbers.h"
#include "scene/settings/assignment.h"
#include "ui/editors/color_points_view.h"
#include "ui/editors/curvature_map_view.h"
#include "ui/editors/planes_widget.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/icons.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

using nlohmann::json;
using scene::SettingInfo;
using scene::SettingType;

QString suffixOf(const SettingInfo& setting) {
  if (setting.unit == "degrees") return "°";
  if (setting.unit.empty() || setting.unit.size() > 4) return {};  // long ones stand in the tooltip
  const bool rate = setting.unit.starts_with("1/");                // "5 /s"
  return ' ' + translated(texts::units, rate ? setting.unit.substr(1) : setting.unit);
}

class NumberWidget : public ValueWidget {
 public:
  NumberWidget(const SettingInfo& setting, QWidget* parent)
      : ValueWidget(parent),
        minimum_(setting.minimum),
        maximum_(setting.maximum),
        box_(new NumberSpinBox(this)) {
    auto* layout = lineOf({}, 6);
    layOut(this, layout, {});
    box_->setRange(minimum_, maximum_);
    box_->setSuffix(suffixOf(setting));
    setFocusProxy(box_);
    connect(box_, &NumberSpinBox::refused, this, &ValueWidget::refused);
    const double range = maximum_ - minimum_;
    if (range <= 1e4) {  // a slider where its whole length makes sense
      // Over several decades (shininess 1 to 1000) equal lengths are equal ratios.
      logarithmic_ = minimum_ > 0.0 && maximum_ / minimum_ >= 100.0;
      slider_ = new CalmWheel<QSlider>(this);
      slider_->setOrientation(Qt::Horizontal);
      slider_->setRange(0, steps);
      slider_->setMinimumWidth(54);
      layout->addWidget(slider_, 1);
      box_->setFixedWidth(74);
      box_->setSingleStep(base::niceBelow(range / 50.0));
      connect(slider_, &QSlider::valueChanged, this, [this](int step) {
        box_->showValue(valueOf(step));
        Q_EMIT changed(!slider_->isSliderDown());
      });
      connect(slider_, &QSlider::sliderPressed, this, &ValueWidget::dragStarted);
      connect(slider_, &QSlider::sliderReleased, this, &ValueWidget::dragEnded);
    }
    layout->addWidget(box_, slider_ ? 0 : 1);
    connect(box_, &NumberSpinBox::valueChanged, this, [this] {
      showSlider();
      Q_EMIT changed(true);
    });
  }

  void showValue(const json& value) override {
    box_->showValue(value.get<double>());
    showSlider();
  }
  json value() const override { return box_->value(); }

 private:
  static constexpr int steps = 1000;

  double valueOf(int step) const {
    const double fraction = static_cast<double>(step) / steps;
    if (step == 0) return minimum_;
    if (step == steps) return maximum_;
    if (!logarithmic_) {
      return base::roundedToStep(minimum_ + fraction * (maximum_ - minimum_),
                                 base::niceBelow((maximum_ - minimum_) / steps));
    }
    const double value = minimum_ * std::pow(maximum_ / minimum_, fraction);
    return base::roundedToStep(value, base::niceBelow(value / 100.0));
  }
  void showSlider() {
    if (!slider_ || slider_->isSliderDown()) return;
    const QSignalBlocker block(slider_);
    const double fraction = logarithmic_ ? std::log(box_->value() / minimum_) / std::log(maximum_ / minimum_)
                                         : (box_->value() - minimum_) / (maximum_ - minimum_);
    slider_->setValue(static_cast<int>(std::lround(fraction * steps)));
  }

  double minimum_, maximum_;
  bool logarithmic_ = false;
  NumberSpinBox* box_;
  QSlider* slider_ = nullptr;
};

// Holds the value in one other widget.
template <class Inner>
class SingleWidget : public ValueWidget {
 public:
  explicit SingleWidget(QWidget* parent) : ValueWidget(parent), inner_(new Inner(this)) {
    layOut(this, lineOf({{inner_, 1}}), {});
    setFocusProxy(inner_);
  }

 protected:
  Inner* const inner_;
};

class IntegerWidget : public SingleWidget<IntegerSpinBox> {
 public:
  IntegerWidget(const SettingInfo& setting, QWidget* parent) : SingleWidget(parent) {
    inner_->setRange(static_cast<int>(setting.minimum), static_cast<int>(setting.maximum));
    inner_->setSuffix(suffixOf(setting));
    connect(inner_, &IntegerSpinBox::refused, this, &ValueWidget::refused);
    connect(inner_, &QSpinBox::valueChanged, this, [this] { Q_EMIT changed(true); });
  }
  void showValue(const json& value) override {
    const QSignalBlocker block(inner_);
    inner_->setValue(value.get<int>());
  }
  json value() const override { return inner_->value(); }
};

class TextWidget : public SingleWidget<QLineEdit> {
 public:
  explicit TextWidget(QWidget* parent) : SingleWidget(parent) {
    connect(inner_, &QLineEdit::editingFinished, this, [this] {
      if (!inner_->isModified()) return;
      inner_->setModified(false);
      take();
    });
  }
  void showValue(const json& value) override { showText(value.get<std::string>()); }
  json value() const override { return inner_->text().toStdString(); }

 protected:
  virtual void take() { Q_EMIT changed(false); }  // what was typed
  void showText(const std::string& text) {
    inner_->setText(QString::fromStdString(text));
    inner_->setCursorPosition(0);
  }
};

// A file's path with a button that lets the user choose it.
class FileWidget : public TextWidget {
 public:
  explicit FileWidget(QWidget* parent) : TextWidget(parent) {
    auto* const button = new QToolButton(this);
    layout()->addWidget(button);
    layout()->setSpacing(4);
    inner_->setPlaceholderText(QObject::tr("none"));
    inner_->setMinimumWidth(60);
    button->setIcon(icon("open"));
    button->setIconSize({16, 16});
    nameAndTip(button, QObject::tr("Choose a file"));
    connect(button, &QToolButton::clicked, this, &FileWidget::choose);
  }
  void showValue(const json& value) override {
    const QString file = QString::fromStdString(value.get<std::string>());
    inner_->setText(file);
    inner_->setToolTip(file);
  }
  json value() const override { return inner_->text().trimmed().toStdString(); }

 private:
  void choose() {
    constexpr auto folderKey = "lightProbeFolder";
    const QString kept = QSettings().value(folderKey).toString();
    const QString file = QFileDialog::getOpenFileName(
        this, QObject::tr("Choose an environment map"), inner_->text().isEmpty() ? kept : inner_->text(),
        QObject::tr("Environment maps (*.hdr *.exr);;Images (*.hdr *.exr *.png *.jpg *.jpeg *.tif *.tiff);;"
                    "All files (*)"));
    if (file.isEmpty()) return;
    QSettings().setValue(folderKey, QFileInfo(file).absolutePath());
    inner_->setText(file);
    inner_->setModified(false);
    Q_EMIT changed(false);
  }
};

// World points as text. A text that is no such list is not taken.
class PositionsWidget : public TextWidget {
 public:
  explicit PositionsWidget(QWidget* parent) : TextWidget(parent) {
    inner_->setPlaceholderText("x,y,z; x,y,z");
    inner_->setClearButtonEnabled(true);
  }
  void showValue(const json& value) override {
    shown_ = value;
    showText(scene::textOfPositions(value));
  }
  json value() const override { return scene::positionsOf(inner_->text().toStdString()); }

 private:
  void take() override {
    if (value().is_array())
      TextWidget::take();
    else
      showValue(shown_);
  }

  json shown_ = json::array();
};

// Marks are edited in their panel: how many there are.
class MarksWidget : public SingleWidget<QLabel> {
 public:
  using SingleWidget::SingleWidget;

  void showValue(const json& value) override {
    shown_ = value;
    inner_->setText(value.size() == 1 ? QObject::tr("1 measurement")
                                      : QObject::tr("%1 measurements").arg(value.size()));
  }
  json value() const override { return shown_; }

 private:
  json shown_ = json::array();
};

class ToggleWidget : public SingleWidget<QCheckBox> {
 public:
  explicit ToggleWidget(QWidget* parent) : SingleWidget(parent) {
    connect(inner_, &QCheckBox::toggled, this, [this] { Q_EMIT changed(false); });
  }
  void showValue(const json& value) override {
    const QSignalBlocker block(inner_);
    inner_->setChecked(value.get<bool>());
  }
  json value() const override { return inner_->isChecked(); }
};

class ChoiceWidget : public SingleWidget<CalmWheel<QComboBox>> {
 public:
  ChoiceWidget(const SettingInfo& setting, QWidget* parent) : SingleWidget(parent) {
    for (const std::string& choice : setting.choices) {
      const QString word = QString::fromStdString(choice);
      inner_->addItem(word == "color" ? QObject::tr("Single colour") : wordsOf(word), word);
    }
    // not the longest choice
    inner_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    inner_->setMinimumContentsLength(8);
    connect(inner_, &QComboBox::currentIndexChanged, this, [this] { Q_EMIT changed(false); });
  }
  void showValue(const json& value) override {
    const QSignalBlocker block(inner_);
    inner_->setCurrentIndex(inner_->findData(QString::fromStdString(value.get<std::string>())));
  }
  json value() const override { return inner_->currentData().toString().toStdString(); }
};

class ColourWidget : public ValueWidget {
 public:
  explicit ColourWidget(QWidget* parent) : ValueWidget(parent), button_(new ColorButton(this)) {
    layOut(this, lineOf({button_, Cell::room()}), {});
    setFocusProxy(button_);
    connect(button_, &ColorButton::chosen, this, [this](glm::dvec3 colour) {
      button_->showColour(colour);
      Q_EMIT changed(true);
    });
  }
  void showValue(const json& value) override { button_->showColour({value[0], value[1], value[2]}); }
  json value() const override {
    const glm::dvec3 colour = button_->colour();
    return {colour.x, colour.y, colour.z};
  }

 private:
  ColorButton* button_;
};

class VectorWidget : public ValueWidget {
 public:
  VectorWidget(const SettingInfo& setting, QWidget* parent) : ValueWidget(parent) {
    auto* layout = lineOf({}, 4);
    layOut(this, layout, {});
    boxes_.resize(scene::componentsOf(setting.type));
    const char* names[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      boxes_[i] = new NumberSpinBox(this);
      boxes_[i]->setRange(setting.minimum, setting.maximum);
      boxes_[i]->setSingleStep(0.05);
      boxes_[i]->setAccessibleName(names[i]);
      boxes_[i]->setMinimumWidth(48);
      layout->addWidget(boxes_[i], 1);
      connect(boxes_[i], &NumberSpinBox::refused, this, &ValueWidget::refused);
      connect(boxes_[i], &NumberSpinBox::valueChanged, this, [this] { Q_EMIT changed(true); });
    }
    setFocusProxy(boxes_[0]);
  }
  void showValue(const json& value) override {
    for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i]->showValue(value[i].get<double>());
  }
  json value() const override {
    json list = json::array();
    for (const NumberSpinBox* box : boxes_) list.push_back(box->value());
    return list;
  }

 private:
  std::vector<NumberSpinBox*> boxes_;
};

// A quaternion as heading, elevation and roll in degrees.
class RotationWidget : public ValueWidget {
 public:
  explicit RotationWidget(QWidget* parent) : ValueWidget(parent) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(4);
    layout->setVerticalSpacing(1);
    struct Angle {
      QString name, tip;
      double range;
    };
    const std::array<Angle, 3> angles{
        {{QObject::tr("Heading"),
          QObject::tr("Rotation about the vertical axis, counterclockwise from above"), 180.0},
         {QObject::tr("Elevation"), QObject::tr("Height of the environment map’s centre above the horizon"),
          90.0},
         {QObject::tr("Roll"), QObject::tr("Rotation about the direction of the environment map’s centre"),
          180.0}}};
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
      connect(box, &NumberSpinBox::valueChanged, this, [this] {
        rotation_ = app::rotationOf({boxes_[0]->value(), boxes_[1]->value(), boxes_[2]->value()});
        Q_EMIT changed(true);
      });
    }
    setFocusProxy(boxes_[0]);
  }
  void showValue(const json& value) override {
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
  // Unit length, or exactly what was shown while nobody edits it.
  json value() const override { return {rotation_.x, rotation_.y, rotation_.z, rotation_.w}; }

 private:
  glm::dvec4 rotation_{1.0, 0.0, 0.0, 0.0};
  std::array<NumberSpinBox*, 3> boxes_;
};

}  // namespace

bool isColour(const SettingInfo& setting) {
  return setting.type == SettingType::vector && setting.unit.starts_with("linear RGB");
}

ValueWidget* makeValueWidget(const SettingInfo& setting, QWidget* parent) {
  switch (setting.type) {
    case SettingType::number:
      return new NumberWidget(setting, parent);
    case SettingType::integer:
      return new IntegerWidget(setting, parent);
    case SettingType::text:
      if (setting.path.ends_with(".file")) return new FileWidget(parent);
      return new TextWidget(parent);
    case SettingType::choice:
      return new ChoiceWidget(setting, parent);
    case SettingType::toggle:
      return new ToggleWidget(parent);
    case SettingType::positions:
      return new PositionsWidget(parent);
    case SettingType::planes:
      return new PlanesWidget(setting, parent);
    case SettingType::marks:
      return new MarksWidget(parent);
    case SettingType::color_points:
      return new PointsEditor(new ColorPointsView(parent), parent);
    case SettingType::points:
      return new PointsEditor(new CurvatureMapView(parent), parent);
    case SettingType::quaternion:
      return new RotationWidget(parent);
    case SettingType::item:
    case SettingType::ids:
      assert(false && "whole items have no row");
      break;
    case SettingType::pair:
    case SettingType::vector:
      break;
  }
  if (isColour(setting)) return new ColourWidget(parent);
  return new VectorWidget(setting, parent);
}

void nameValueWidget(ValueWidget* widget, const QString& name) {
  widget->setAccessibleName(name);
  const QList<QAbstractSpinBox*> boxes = widget->findChildren<QAbstractSpinBox*>();
  for (QWidget* part : widget->findChildren<QWidget*>()) {
    if (part->focusPolicy() == Qt::NoFocus || !part->accessibleName().isEmpty()) continue;
    auto* box = qobject_cast<QAbstractSpinBox*>(part);
    if (box == nullptr) box = qobject_cast<QAbstractSpinBox*>(part->parentWidget());  // its line
    const qsizetype axis = boxes.size() == 3 && box != nullptr ? boxes.indexOf(box) : -1;
    part->setAccessibleName(axis < 0 ? name : name + ' ' + QChar("xyz"[axis]));
  }
}

}  // namespace isolux::ui
