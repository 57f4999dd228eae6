#include "ui/setting_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include "scene/error.h"
#include "ui/icons.h"
#include "ui/number_text.h"

namespace isolux::ui {

namespace {
QString nameOf(const scene::Setting& setting) {
  return QString::fromStdString(setting.path).section('.', 1).replace('_', ' ');
}

QString describe(const scene::Setting& setting) {
  QString text = QString::fromStdString(setting.meaning) + "\n\n" + QString::fromStdString(setting.path);
  if (setting.type == scene::SettingType::number || setting.type == scene::SettingType::integer) {
    text += QString(" = %1 … %2 ").arg(numberText(setting.minimum), numberText(setting.maximum)) +
            QString::fromStdString(setting.unit);
  }
  const nlohmann::json value = setting.defaultValue();
  return text.trimmed() +
         "\nDefault: " + QString::fromStdString(value.is_string() ? value.get<std::string>() : value.dump());
}
}  // namespace

SettingEditor::SettingEditor(const scene::Setting& setting, QWidget* parent)
    : QWidget(parent),
      setting_(setting),
      value_(makeValueWidget(setting, this)),
      reset_(new QToolButton(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(value_, 1);
  if (setting.mayBeAutomatic) {
    automatic_ = new QCheckBox("auto", this);
    automatic_->setToolTip("Chosen from the volume");
    layout->addWidget(automatic_);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool automatic) {
      send(automatic ? nlohmann::json("auto") : setting_.get(resolved_), false);
    });
  }
  reset_->setIcon(icon("restore"));
  reset_->setIconSize({14, 14});
  reset_->setAutoRaise(true);
  reset_->setToolTip("Back to the default");
  reset_->setAccessibleName("Reset " + nameOf(setting));
  QSizePolicy policy = reset_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);  // rows do not jump
  reset_->setSizePolicy(policy);
  layout->addWidget(reset_);
  setToolTip(describe(setting));
  value_->setAccessibleName(nameOf(setting));

  connect(value_, &ValueWidget::changed, this,
          [this](bool endsAfterPause) { send(value_->value(), endsAfterPause); });
  connect(value_, &ValueWidget::dragStarted, this, &SettingEditor::dragStarted);
  connect(value_, &ValueWidget::dragEnded, this, &SettingEditor::dragEnded);
  connect(reset_, &QToolButton::clicked, this, &SettingEditor::resetToDefault);
}

void SettingEditor::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  const nlohmann::json own = setting_.get(scene), seen = setting_.get(resolved);
  const bool automatic = setting_.mayBeAutomatic && own == "auto";
  reset_->setVisible(own != setting_.defaultValue());
  if (automatic_) {
    const QSignalBlocker block(automatic_);
    automatic_->setChecked(automatic);
  }
  if (seen == shown_ || seen == "auto") return;
  shown_ = seen;
  value_->showValue(seen);
}

void SettingEditor::resetToDefault() {
  send(setting_.defaultValue(), false);
}

void SettingEditor::send(const nlohmann::json& value, bool endsAfterPause) {
  // A gesture of one widget is one step; a single choice is a step of its own.
  const bool gesture = setting_.type == scene::SettingType::number || endsAfterPause;
  Edit edit{scene_, "Change " + nameOf(setting_), gesture ? QString::fromStdString(setting_.path) : QString(),
            endsAfterPause};
  shown_ = nullptr;  // whatever comes back is shown
  try {
    setting_.set(edit.scene, value);
  } catch (const scene::Error& error) {
    setScene(scene_, resolved_);
    Q_EMIT failed(QString::fromStdString(error.what()));
    return;
  }
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
