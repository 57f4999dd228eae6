#include "ui/editors/setting_editor.h"

#include <QCheckBox>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QToolTip>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/color_maps.h"
#include "scene/curvature_map.h"
#include "scene/rules/relevance.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/theme/icons.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {
bool isPoints(const scene::Setting& setting) {
  return setting.type == scene::SettingType::points || setting.type == scene::SettingType::color_points;
}

QString describe(const scene::Setting& setting) {
  QString text = translated(texts::settings, setting.meaning) + "\n\n" + QString::fromStdString(setting.path);
  if (setting.type == scene::SettingType::number || setting.type == scene::SettingType::integer) {
    text += QString(" = %1 … %2 ").arg(numberText(setting.minimum), numberText(setting.maximum)) +
            translated(texts::units, setting.unit);
  }
  const nlohmann::json value = setting.defaultValue();
  if (isPoints(setting)) return text;
  return text.trimmed() + '\n' +
         QObject::tr("Default: %1")
             .arg(QString::fromStdString(value.is_string() ? value.get<std::string>() : value.dump()));
}
}  // namespace

SettingEditor::SettingEditor(const scene::Setting& setting, QWidget* parent)
    : QWidget(parent),
      setting_(setting),
      shown_(std::make_unique<nlohmann::json>()),
      found_(std::make_unique<nlohmann::json>()),
      value_(makeValueWidget(setting, this)),
      reset_(new QToolButton(this)) {
  auto* layout = lineOf({{value_, 1}}, 4);
  layOut(this, layout, {});
  if (setting.mayBeAutomatic) {
    keepPlaceWhenHidden(value_);
    automatic_ = new QCheckBox(tr("auto"), this);
    automatic_->setToolTip(tr("Chosen automatically"));
    layout->addWidget(automatic_);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool automatic) {
      const nlohmann::json seen = seenValue();
      send(automatic ? nlohmann::json("auto") : seen == "auto" ? value_->value() : seen, false);
    });
  }
  reset_->setIcon(icon("restore"));
  reset_->setIconSize({14, 14});
  reset_->setAutoRaise(true);
  nameAndTip(reset_, tr("Reset %1").arg(nameOf(setting)), tr("Reset to default"));
  keepPlaceWhenHidden(reset_);
  layout->addWidget(reset_);
  description_ = describe(setting);
  setToolTip(description_);
  nameValueWidget(value_, nameOf(setting));

  connect(value_, &ValueWidget::changed, this,
          [this](bool endsAfterPause) { send(value_->value(), endsAfterPause); });
  connect(value_, &ValueWidget::refused, this, [this](const QString& why) {
    QString text = nameOf(setting_) + ": " + why;
    text[0] = text[0].toUpper();
    QToolTip::showText(value_->mapToGlobal(QPoint(0, value_->height() / 2)), text, value_);
    Q_EMIT failed(text);
  });
  connect(value_, &ValueWidget::dragStarted, this, [this] {
    dragging_ = true;
    Q_EMIT dragStarted();
  });
  connect(value_, &ValueWidget::dragEnded, this, [this] {
    dragging_ = false;
    Q_EMIT dragEnded();
  });
  connect(reset_, &QToolButton::clicked, this, &SettingEditor::resetToDefault);
}

SettingEditor::~SettingEditor() = default;

void SettingEditor::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  explain();
  const nlohmann::json own = setting_.get(scene), seen = seenValue();
  const bool automatic = setting_.mayBeAutomatic && own == "auto";
  reset_->setVisible(own != setting_.defaultValue());
  if (automatic_) {
    const QSignalBlocker block(automatic_);
    automatic_->setChecked(automatic);
  }
  // Some automatic values are found while the picture is drawn: there is no number to show.
  const bool unknown = automatic && seen == "auto";
  value_->setVisible(!unknown);
  if (seen == *shown_ || unknown) return;
  *shown_ = seen;
  value_->showValue(seen);
}

void SettingEditor::setFound(const nlohmann::json& value) {
  if (value == *found_) return;
  *found_ = value;
  setScene(scene_, resolved_);
}

nlohmann::json SettingEditor::seenValue() const {
  const nlohmann::json resolved = setting_.get(resolved_);
  if (resolved == "auto" && isPoints(setting_)) {  // points that it could be made of
    scene::Scene automatic;
    automatic.look.colormapPoints = scene::automaticColorPoints(resolved_.look);
    automatic.look.curvaturePoints = scene::automaticCurvaturePoints();
    automatic.look.accessibilityPoints = scene::automaticAccessibilityPoints();
    return setting_.get(automatic);
  }
  return resolved == "auto" && !found_->is_null() ? *found_ : resolved;
}

void SettingEditor::explain() {
  const std::string_view reason = scene::whyInactive(setting_.path, resolved_);
  const QString why = translated(texts::reasons, reason);
  if (why == whyInactive_) return;
  whyInactive_ = why;
  setEnabled(why.isEmpty());
  setToolTip(why.isEmpty() ? description_ : tr("Has no effect: %1.").arg(why) + "\n\n" + description_);
}

bool SettingEditor::isWide() const {
  const bool numbers = setting_.type == scene::SettingType::pair ||
                       (setting_.type == scene::SettingType::vector && !isColour(setting_));
  const bool slider = value_->findChild<QSlider*>() != nullptr;
  return isPoints(setting_) || setting_.type == scene::SettingType::planes ||
         setting_.type == scene::SettingType::quaternion || ((numbers || slider) && setting_.mayBeAutomatic);
}

void SettingEditor::resetToDefault() {
  send(setting_.defaultValue(), false);
}

void SettingEditor::send(const nlohmann::json& value, bool endsAfterPause) {
  // A gesture of one widget is one step; a single choice is a step of its own.
  const bool gesture = dragging_ || endsAfterPause;
  Edit edit{scene_, tr("Change %1").arg(nameOf(setting_)),
            gesture ? QString::fromStdString(setting_.path) : QString(), endsAfterPause};
  *shown_ = nullptr;  // whatever comes back is shown
  try {
    setting_.set(edit.scene, value);
  } catch (const base::Error& error) {
    setScene(scene_, resolved_);
    Q_EMIT failed(QString::fromStdString(error.what()));
    return;
  }
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
