// How the window looks, as rows of the preferences: theme and scale. Kept at once.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;

namespace isolux::ui {

class AppearanceRows : public QWidget {
  Q_OBJECT
 public:
  explicit AppearanceRows(QWidget* parent = nullptr);

  void restoreDefaults();

 private:
  const int scaleOfThisRun_;
  QComboBox* theme_;
  QSpinBox* scale_;
  QLabel* later_;  // the scale is that of the next start
};

}  // namespace isolux::ui
