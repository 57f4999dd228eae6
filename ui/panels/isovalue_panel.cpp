#include "ui/panels/isovalue_panel.h"

#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/editors/histogram_slider.h"
#include "ui/editors/number_spin_box.h"
#include "ui/editors/number_text.h"

namespace isolux::ui {

IsovaluePanel::IsovaluePanel(QWidget* parent)
    : QWidget(parent),
      slider_(new HistogramSlider(this)),
      spinBox_(new NumberSpinBox(this)),
      suggest_(new QToolButton(this)),
      showAll_(new QToolButton(this)) {
  auto* title = new QLabel(tr("Isovalue"), this);
  QFont bold = title->font();
  bold.setWeight(QFont::DemiBold);
  title->setFont(bold);
  title->setBuddy(spinBox_);
  title->setToolTip(
      tr("The surface is where the volume has this value.\n\n"
         "Drag the line on the histogram (counts are logarithmic).\n"
         "Wheel or arrow keys: fine steps (Shift: ten times larger)\n"
         "Double click: suggested isovalue\n"
         "Ctrl+wheel: zoom the axis, middle drag: move it"));
  spinBox_->setAccessibleName(tr("Isovalue"));
  spinBox_->setToolTip(tr("The exact isovalue. Arrow keys change it by the step of the histogram."));
  suggest_->setText(tr("Suggested"));
  suggest_->setToolTip(
      tr("Back to the isovalue found from the histogram (also: double click on the histogram)"));
  showAll_->setText(tr("Whole range"));
  showAll_->setToolTip(tr("Show the whole range of values again"));
  for (QToolButton* button : {suggest_, showAll_}) {
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
  }

  auto* side = new QVBoxLayout;
  side->setSpacing(6);
  side->addWidget(title);
  side->addWidget(spinBox_);
  side->addWidget(suggest_);
  side->addWidget(showAll_);
  side->addStretch();
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2, 8, 12, 4);
  layout->setSpacing(4);
  layout->addWidget(slider_, 1);
  layout->addLayout(side);
  spinBox_->setFixedWidth(124);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setFixedHeight(146);
  setEnabled(false);
  showAll_->setEnabled(false);

  connect(slider_, &HistogramSlider::isovalueChanged, this,
          [this](double value, bool endsAfterPause) { send(value, "isovalue", endsAfterPause); });
  connect(slider_, &HistogramSlider::dragStarted, this, &IsovaluePanel::dragStarted);
  connect(slider_, &HistogramSlider::dragEnded, this, &IsovaluePanel::dragEnded);
  connect(slider_, &HistogramSlider::suggestionWanted, this, [this] { send(std::nullopt, "", false); });
  connect(slider_, &HistogramSlider::zoomChanged, showAll_, &QWidget::setEnabled);
  connect(slider_, &HistogramSlider::zoomChanged, this,
          [this] { spinBox_->setSingleStep(slider_->plot().fineStep()); });
  connect(suggest_, &QToolButton::clicked, this, [this] { send(std::nullopt, "", false); });
  connect(showAll_, &QToolButton::clicked, slider_, &HistogramSlider::showAll);
  connect(spinBox_, &NumberSpinBox::valueChanged, this,
          [this](double value) { send(value, "isovalue typed", true); });
}

void IsovaluePanel::setVolume(VolumePointer volume) {
  volume_ = std::move(volume);
  setEnabled(volume_ != nullptr);
  slider_->setVolume(volume_);
  if (!volume_) return;
  const QString unit = QString::fromStdString(volume_->volume.unit);
  spinBox_->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
}

void IsovaluePanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  if (!resolved.isosurface.value) return;
  slider_->setIsovalue(*resolved.isosurface.value, resolved.isosurface.inside == scene::Inside::above);
  spinBox_->showValue(*resolved.isosurface.value);
  suggest_->setEnabled(scene.isosurface.value.has_value());
}

void IsovaluePanel::send(std::optional<double> value, const char* mergeKey, bool endsAfterPause) {
  Edit edit{scene_, value ? tr("Set isovalue") : tr("Suggested isovalue"), mergeKey, endsAfterPause};
  edit.scene.isosurface.value = value;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
