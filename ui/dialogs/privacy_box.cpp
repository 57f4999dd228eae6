#include "ui/dialogs/privacy_box.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include "ui/document/privacy.h"

namespace isolux::ui {

PrivacyBox::PrivacyBox(QWidget* parent)
    : QGroupBox(tr("The patient’s name, id and birth date"), parent),
      onScreen_(new QCheckBox(tr("Hide on the &screen"), this)),
      inSaved_(new QCheckBox(tr("Hide in what is sa&ved: pictures, marks, recordings"), this)) {
  onScreen_->setToolTip(tr("In titles, the Volume panel, the DICOM browser and the recent files"));
  inSaved_->setToolTip(tr(
      "In the sessions that pictures carry, exported marks, recordings and proposed names of files. Sessions "
      "saved as such name the files that they open."));
  const Privacy privacy = keptPrivacy();
  onScreen_->setChecked(privacy.hideOnScreen);
  inSaved_->setChecked(privacy.hideInSaved);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(onScreen_);
  layout->addWidget(inSaved_);
  connect(onScreen_, &QCheckBox::toggled, this, &PrivacyBox::keep);
  connect(inSaved_, &QCheckBox::toggled, this, &PrivacyBox::keep);
}

void PrivacyBox::keep() {
  keepPrivacy({onScreen_->isChecked(), inSaved_->isChecked()});
  Q_EMIT changed();
}

}  // namespace isolux::ui
