// The widgets that hold a setting's value, one for each type of setting.
#pragma once

#include <QWidget>

#include "scene/settings/setting.h"

namespace isolux::ui {

// The widget that holds one setting's value; a subclass for each SettingType.
class ValueWidget : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  virtual void showValue(const nlohmann::json& value) = 0;  // never "auto"
  virtual nlohmann::json value() const = 0;                 // what the user has just entered

 Q_SIGNALS:
  // The user changed it. Between dragStarted() and dragEnded() all changes are one gesture.
  void changed(bool endsAfterPause);
  void refused(const QString& why);  // what was entered cannot be taken; the old value stays
  void dragStarted();
  void dragEnded();
};

// A vector of linear RGB.
bool isColour(const scene::SettingInfo& setting);
ValueWidget* makeValueWidget(const scene::SettingInfo& setting, QWidget* parent);
// The accessible name of the widget and of all in it that takes the focus; three boxes are its x, y and z.
void nameValueWidget(ValueWidget* widget, const QString& name);

}  // namespace isolux::ui
