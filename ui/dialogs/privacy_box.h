// Whether the patient is named on the screen and in what is saved (ui/document/privacy.h). Keeps what is
// clicked at once.
#pragma once

#include <QGroupBox>

class QCheckBox;

namespace isolux::ui {

class PrivacyBox : public QGroupBox {
  Q_OBJECT
 public:
  explicit PrivacyBox(QWidget* parent);

  QCheckBox* onScreen() const { return onScreen_; }
  QCheckBox* inSaved() const { return inSaved_; }

 Q_SIGNALS:
  void changed();

 private:
  void keep();
  QCheckBox *onScreen_, *inSaved_;
};

}  // namespace isolux::ui
