#include "ui/dialogs/appearance_rows.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include "ui/document/preferences.h"
#include "ui/theme/style.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

AppearanceRows::AppearanceRows(QWidget* parent)
    : QWidget(parent),
      scaleOfThisRun_(savedScale()),
      theme_(new QComboBox(this)),
      scale_(new IntegerSpinBox(this)),
      later_(new QLabel(tr("Takes effect after a restart."), this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(9);
  theme_->addItems({tr("Dark"), tr("Light"), tr("System default")});  // as Theme
  addRow(grid, 0, tr("Theme"), theme_, tr("The background of the image is a setting of the scene."));
  scale_->setRange(smallestScale, largestScale);
  scale_->setSingleStep(25);
  scale_->setSuffix(" %");
  addRow(grid, 1, tr("Text and control size"), scale_, tr("Multiplies the scaling of the screen."));
  grid->addWidget(later_, 2, 1);
  grid->setColumnStretch(1, 1);
  setInk(later_, Ink::quiet);
  later_->hide();
  theme_->setCurrentIndex(static_cast<int>(theme()));
  scale_->setValue(scaleOfThisRun_);
  connect(theme_, &QComboBox::currentIndexChanged, this, [](int row) {
    keepTheme(static_cast<Theme>(row));
    applyTheme(static_cast<Theme>(row));
  });
  connect(scale_, &QSpinBox::valueChanged, this, [this](int percent) {
    keepScale(percent);
    later_->setVisible(percent != scaleOfThisRun_);
  });
}

void AppearanceRows::restoreDefaults() {
  theme_->setCurrentIndex(static_cast<int>(Theme::dark));
  scale_->setValue(100);
}

}  // namespace isolux::ui
