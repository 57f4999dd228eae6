// A file's path with a button that lets the user choose it: the value widget of settings that name a file.
#pragma once

#include "ui/editors/setting_editor.h"

class QLineEdit;
class QToolButton;

namespace isolux::ui {

// Image files that can be light probes: for dialogs and for what is dropped on the window.
bool isLightProbe(const QString& file);

class FileWidget : public ValueWidget {
  Q_OBJECT
 public:
  explicit FileWidget(QWidget* parent = nullptr);
  void showValue(const nlohmann::json& value) override;
  nlohmann::json value() const override;

 private:
  void choose();
  QLineEdit* line_;
  QToolButton* choose_;
};

}  // namespace isolux::ui
