// How the window looks and which language it speaks, and the settings of the machine: memory, threads, how
// quick pictures in motion are. What is changed applies at once; the language at the next start.
#pragma once

#include <vector>

#include <QDialog>

#include "scene/settings/host_settings.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QGroupBox;
class QLabel;
class QSpinBox;

namespace isolux::ui {

class ValueWidget;

class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  PreferencesDialog(const scene::HostSettings& host, QWidget* parent);

  const scene::HostSettings& host() const { return host_; }
  QCheckBox* hideOnScreenBox() const { return hideOnScreen_; }
  QCheckBox* hideInSavedBox() const { return hideInSaved_; }
  QComboBox* themeBox() const { return theme_; }
  QSpinBox* scaleBox() const { return scale_; }
  QComboBox* languageBox() const { return language_; }
  void restoreDefaults();

 Q_SIGNALS:
  void changed(const isolux::scene::HostSettings& host);
  void privacyChanged();

 private:
  struct Row {
    const scene::HostSetting* setting;
    QLabel* label;
    ValueWidget* value;
    QCheckBox* automatic;  // null: it cannot be
  };
  void set(const Row& row, const nlohmann::json& value);
  void showRow(const Row& row);
  QGridLayout* makeAppearance();
  QGroupBox* makePrivacy();
  void addLanguage(QGridLayout* grid);

  scene::HostSettings host_;
  QCheckBox *hideOnScreen_, *hideInSaved_;
  QComboBox* theme_;
  QSpinBox* scale_;
  std::vector<Row> rows_;
  QComboBox* language_;
};

}  // namespace isolux::ui
