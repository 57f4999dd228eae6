#include "ui/panels/isovalue_panel.h"

#include <utility>

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "ui/editors/histogram_slider.h"
#include "ui/language/number_text.h"
#include "ui/panels/surface_list.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

IsovaluePanel::IsovaluePanel(QWidget* parent)
    : QWidget(parent),
      slider_(new HistogramSlider(this)),
      spinBox_(new NumberSpinBox(this)),
      surfaces_(new SurfaceList(this)),
      scroll_(new QScrollArea(this)),
      title_(new QLabel(tr("Isovalue"), this)),
      add_(textButton(tr("Add surface"), {}, this)),
      suggest_(textButton(
          tr("Suggested"),
          tr("Use the isovalue suggested by the histogram (also: double click on the histogram)"), this)),
      showAll_(textButton(tr("Whole range"), tr("Show the whole range of values"), this)) {
  makeBold(title_);
  title_->setBuddy(spinBox_);
  title_->setToolTip(
      tr("The surface consists of all points with this value.\n\nDrag the line on the histogram (counts are "
         "logarithmic).\nWheel or arrow keys: fine steps (Shift: tenfold)\nDouble click: suggested "
         "isovalue\nAlt+click or right click: add an isosurface there\nCtrl+wheel: zoom the value axis, "
         "middle drag: pan it"));
  nameAndTip(spinBox_, tr("Isovalue"), tr("Exact isovalue. Arrow keys change it by one histogram step."));
  for (QToolButton* button : {add_, suggest_, showAll_}) {
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
  }

  buttons_ = columnOf({suggest_, showAll_, add_}, 4);
  scroll_->setWidget(surfaces_);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its rows have it
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* side = columnOf({title_, spinBox_, {scroll_, 1}, buttons_, Cell::room(0)}, 4);
  layOut(this, lineOf({{slider_, 1}, side}, 4), {2, 8, 12, 4});
  spinBox_->setFixedWidth(124);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setFixedHeight(146);
  arrange(false);
  setEnabled(false);
  showAll_->setEnabled(false);

  connect(slider_, &HistogramSlider::isovalueChanged, this,
          [this](double value, bool endsAfterPause) { send(value, "isovalue", endsAfterPause); });
  connect(slider_, &HistogramSlider::dragStarted, this, &IsovaluePanel::dragStarted);
  connect(slider_, &HistogramSlider::dragEnded, this, &IsovaluePanel::dragEnded);
  connect(slider_, &HistogramSlider::suggestionWanted, this, [this] { send(std::nullopt, "", false); });
  connect(slider_, &HistogramSlider::zoomChanged, showAll_, &QWidget::setEnabled);
  connect(slider_, &HistogramSlider::zoomChanged, this, [this] {
    spinBox_->setSingleStep(slider_->plot().fineStep());
    surfaces_->setStep(slider_->plot().fineStep());
  });
  connect(slider_, &HistogramSlider::surfaceMoved, this, &IsovaluePanel::moveSurface);
  connect(slider_, &HistogramSlider::surfaceWanted, this, &IsovaluePanel::addSurface);
  connect(surfaces_, &SurfaceList::edited, this, &IsovaluePanel::edited);
  connect(surfaces_, &SurfaceList::dragStarted, this, &IsovaluePanel::dragStarted);
  connect(surfaces_, &SurfaceList::dragEnded, this, &IsovaluePanel::dragEnded);
  connect(add_, &QToolButton::clicked, this, [this] { addSurface(std::nullopt); });
  connect(suggest_, &QToolButton::clicked, this, [this] { send(std::nullopt, "", false); });
  connect(showAll_, &QToolButton::clicked, slider_, &HistogramSlider::showAll);
  connect(spinBox_, &NumberSpinBox::valueChanged, this,
          [this](double value) { send(value, "isovalue typed", true); });
}

void IsovaluePanel::setVolume(VolumePointer volume) {
  volume_ = std::move(volume);
  setEnabled(volume_ != nullptr);
  slider_->setVolume(volume_);
  surfaces_->setVolume(volume_);
  if (!volume_) return;
  const QString unit = QString::fromStdString(volume_->volume.unit);
  spinBox_->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
}

void IsovaluePanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  if (!resolved.surfaces.front().value) return;
  slider_->setIsovalue(*resolved.surfaces.front().value, resolved.isosurface.inside == scene::Inside::above);
  spinBox_->showValue(*resolved.surfaces.front().value);
  suggest_->setEnabled(scene.surfaces.front().value.has_value());
  showSurfaces(resolved);
}

void IsovaluePanel::showSurfaces(const scene::Scene& resolved) {
  surfaces_->setScene(scene_, resolved);
  std::vector<HistogramHandle> handles;
  const std::vector<app::ListedSurface> list = app::listedSurfaces(scene_, resolved, volume_.get());
  for (const app::ListedSurface& one : list)
    handles.push_back({one.number, one.value, screenColour(one.albedo), surfaceName(one), one.shown});
  slider_->setSurfaces(handles);
  arrange(list.size() > 1);
  const bool room = list.size() < scene::kSurfaces;
  add_->setEnabled(room);
  add_->setToolTip(room ? tr("Add an isosurface outside the present ones, where the histogram suggests one "
                             "(also: Alt+click on the histogram)")
                        : tr("At most %1 isosurfaces are possible").arg(scene::kSurfaces));
}

// One isosurface: its value above the buttons. Several: their list, and the buttons in a line below.
void IsovaluePanel::arrange(bool several) {
  title_->setVisible(!several);
  spinBox_->setVisible(!several);
  scroll_->setVisible(several);
  scroll_->setMinimumWidth(surfaces_->minimumSizeHint().width() +
                           scroll_->verticalScrollBar()->sizeHint().width());
  buttons_->setDirection(several ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void IsovaluePanel::moveSurface(int number, double value, bool endsAfterPause) {
  Edit edit{scene_, tr("Set isovalue"), QString("isovalue %1").arg(number), endsAfterPause};
  edit.scene.surfaces.at(static_cast<std::size_t>(number)).value = value;
  Q_EMIT edited(edit);
}

void IsovaluePanel::addSurface(std::optional<double> value) {
  if (!volume_) return;
  if (const auto added = app::withSurface(scene_, *volume_, value))
    Q_EMIT edited({*added, tr("Add isosurface")});
}

void IsovaluePanel::send(std::optional<double> value, const char* mergeKey, bool endsAfterPause) {
  Edit edit{scene_, value ? tr("Set isovalue") : tr("Suggested isovalue"), mergeKey, endsAfterPause};
  edit.scene.surfaces.front().value = value;
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
