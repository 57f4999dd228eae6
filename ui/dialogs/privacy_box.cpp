#include "ui/dialogs/privacy_box.h"

#include <QCheckBox>

#include "ui/document/privacy.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

PrivacyBox::PrivacyBox(QWidget* parent)
    : QGroupBox(tr("Patient’s name, ID and birth date"), parent),
      onScreen_(new QCheckBox(tr("Hide on the &screen"), this)),
      inSaved_(new QCheckBox(tr("Hide in sa&ved files: images, measurements, recordings"), this)) {
  onScreen_->setToolTip(tr("Applies to titles, the Volume panel, the DICOM browser and recent files"));
  inSaved_->setToolTip(
      tr("Applies to sessions embedded in images, exported measurements, recordings and proposed file names. "
         "Session files always name the files that they open."));
  const Privacy privacy = savedPrivacy();
  onScreen_->setChecked(privacy.hideOnScreen);
  inSaved_->setChecked(privacy.hideInSaved);
  layOut(this, columnOf({onScreen_, inSaved_}));
  connect(onScreen_, &QCheckBox::toggled, this, &PrivacyBox::keep);
  connect(inSaved_, &QCheckBox::toggled, this, &PrivacyBox::keep);
}

void PrivacyBox::keep() {
  keepPrivacy({onScreen_->isChecked(), inSaved_->isChecked()});
  Q_EMIT changed();
}

}  // namespace isolux::ui
