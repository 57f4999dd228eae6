#include "ui/presets/looks_panel.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <QEvent>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>

#include "app/presets/applied_preset.h"
#include "app/presets/preset_list.h"
#include "ui/language/number_text.h"
#include "ui/language/translated.h"
#include "ui/presets/thumbnail_painter.h"
#include "ui/theme/style.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr QSize picturePixels(98, 84);
constexpr int gap = 4, titleLines = 2;
constexpr int pointMilliseconds = 120, thumbnailMilliseconds = 60;
constexpr int shiftSteps = 200;  // each way
constexpr int placeRole = Qt::UserRole;

QLabel* headingOf(const QString& text, QWidget* parent) {
  auto* heading = new QLabel(text, parent);
  makeBold(heading);
  return heading;
}

QIcon noPicture() {
  QPixmap blank(picturePixels);
  blank.fill(colours.base);
  QIcon icon(blank);
  icon.addPixmap(blank, QIcon::Disabled);
  return icon;
}

QString titleOf(const app::Thumbnail& one) {
  return one.kind == app::Thumbnail::Kind::look ? wordsOf(QString::fromStdString(one.title))
                                                : translated(texts::presets, one.title);
}

}  // namespace

LooksPanel::LooksPanel(QWidget* parent)
    : Panel(parent),
      painter_(new ThumbnailPainter(this)),
      presets_(makeList(tr("Presets"))),
      looks_(makeList(tr("Looks"))) {
  auto* page = new QWidget;
  auto* column = columnOf({headingOf(tr("Presets"), page), makeShift(), presets_, Cell::gap(6),
                           headingOf(tr("Looks"), page), looks_, Cell::room()},
                          6);
  layOut(page, column, {12, 10, 6, 12});
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  layOut(this, columnOf({scroll}), {});

  connect(painter_, &ThumbnailPainter::drawn, this, &LooksPanel::showPicture);
  callOnce(pointTimer_, pointMilliseconds, this, [this] {
    if (!pointed_ || *pointed_ >= thumbnails_.size()) return;
    previewing_ = true;
    Q_EMIT previewed(thumbnails_[*pointed_].scene);
  });
  callOnce(refreshTimer_, thumbnailMilliseconds, this, &LooksPanel::refresh);

  setEnabled(false);
}

QListWidget* LooksPanel::makeList(const QString& name) {
  auto* list = new QListWidget(this);
  list->setAccessibleName(name);
  list->setViewMode(QListView::IconMode);
  list->setMovement(QListView::Static);
  list->setResizeMode(QListView::Adjust);
  list->setIconSize(picturePixels);
  const int text = titleLines * list->fontMetrics().lineSpacing();
  list->setGridSize(picturePixels + QSize(gap, gap + text + 6));
  list->setWordWrap(true);
  list->setFrameShape(QFrame::NoFrame);
  list->setMouseTracking(true);
  list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setStyleSheet(QStringLiteral("QListWidget { background: transparent; }"));
  list->viewport()->installEventFilter(this);
  connect(list, &QListWidget::itemEntered, this,
          [this](QListWidgetItem* item) { pointAt(item->data(placeRole).toULongLong()); });
  connect(list, &QListWidget::itemClicked, this, &LooksPanel::choose);
  connect(list, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    // By the keyboard: a double click has chosen it already.
    if (!(item->listWidget()->viewport()->underMouse())) choose(item);
  });
  return list;
}

QWidget* LooksPanel::makeShift() {
  auto* box = new QWidget(this);
  shiftLabel_ = new QLabel(tr("Shift"), box);
  shift_ = new QSlider(Qt::Horizontal, box);
  shift_->setRange(-shiftSteps, shiftSteps);
  shift_->setAccessibleName(tr("Shift of the preset's isovalues"));
  shiftBox_ = new NumberSpinBox(box);
  shiftBox_->setFixedWidth(104);
  shiftBox_->setAccessibleName(tr("Shift of the preset's isovalues"));
  shiftLabel_->setBuddy(shiftBox_);
  layOut(box, lineOf({shiftLabel_, {shift_, 1}, shiftBox_}), {0, 0, 6, 0});
  connect(shift_, &QSlider::sliderPressed, this, &LooksPanel::dragStarted);
  connect(shift_, &QSlider::sliderReleased, this, &LooksPanel::dragEnded);
  connect(shift_, &QSlider::valueChanged, this, [this](int step) {
    if (volume_) sendShift(app::shiftReach(*volume_) * step / shiftSteps, !shift_->isSliderDown());
  });
  connect(shiftBox_, &NumberSpinBox::valueChanged, this, [this](double shift) { sendShift(shift, true); });
  return box;
}

void LooksPanel::readPresets() {
  std::vector<std::string> warnings;
  const auto builtIn = app::builtInPresets();
  list_.assign(builtIn.begin(), builtIn.end());
  for (app::Preset& own : app::ownPresets(warnings)) list_.push_back(std::move(own));
}

void LooksPanel::setVolume(const VolumePointer& volume) {
  volume_ = volume;
  setEnabled(volume_ != nullptr);
  painter_->setVolume(volume);
  for (QListWidget* list : {presets_, looks_})  // not for a moment another patient's
    for (int i = 0; i < list->count(); ++i) list->item(i)->setIcon(noPicture());
  readPresets();
  if (!volume_) return;
  const QString unit = QString::fromStdString(volume_->volume.unit);
  shiftBox_->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
  shiftBox_->setSingleStep(app::shiftReach(*volume_) / shiftSteps);
  refreshTimer_.start();
}

void LooksPanel::setScene(const scene::Scene& scene, const scene::Scene&) {
  const bool same = scene == scene_;
  scene_ = scene;
  if (isVisible()) refreshTimer_.start();
  // The window shows the document's scene now: said again only because more of it is known, or another one.
  if (previewing_ && same && pointed_ && *pointed_ < thumbnails_.size())
    Q_EMIT previewed(thumbnails_[*pointed_].scene);
  else if (std::exchange(previewing_, false))
    Q_EMIT previewed(std::nullopt);
}

void LooksPanel::setDrawing(bool draws) {
  painter_->setBusy(draws || !isVisible() || previewing_);
}

void LooksPanel::showEvent(QShowEvent* event) {
  Panel::showEvent(event);
  readPresets();  // files may have come
  painter_->setBusy(false);
  refreshTimer_.start();
}

void LooksPanel::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  painter_->setBusy(true);
  pointAt(std::nullopt);
}

void LooksPanel::refresh() {
  if (!volume_ || !isVisible()) return;
  thumbnails_ = app::thumbnailsOf(scene_, list_, *volume_);
  std::vector<std::optional<scene::Scene>> wanted;
  for (const app::Thumbnail& one : thumbnails_)
    wanted.push_back(one.why.empty() ? std::optional(app::drawnThumbnail(one, *volume_)) : std::nullopt);
  painter_->want(std::move(wanted), (QSizeF(picturePixels) * devicePixelRatioF()).toSize());
  fillLists();
  showShift();
}

void LooksPanel::fillLists() {
  const std::size_t presets = list_.size();
  const auto fill = [&](QListWidget* list, std::size_t begin, std::size_t end) {
    while (list->count() > static_cast<int>(end - begin)) delete list->takeItem(list->count() - 1);
    const QIcon nothing = noPicture();
    while (list->count() < static_cast<int>(end - begin)) new QListWidgetItem(nothing, {}, list);
    for (std::size_t i = begin; i < end; ++i) {
      const app::Thumbnail& one = thumbnails_[i];
      QListWidgetItem* const item = list->item(static_cast<int>(i - begin));
      item->setText(titleOf(one));
      item->setData(placeRole, static_cast<qulonglong>(i));
      item->setFlags(one.why.empty() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags);
      item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
      item->setToolTip(
          one.why.empty() ? translated(one.kind == app::Thumbnail::Kind::look ? texts::looks : texts::presets,
                                       one.meaning)
                          : tr("Does not apply: %1").arg(translated(texts::presets, one.why)));
      item->setSizeHint(list->gridSize());
      if (!one.why.empty()) item->setIcon(nothing);
      showPicture(static_cast<int>(i));
    }
  };
  fill(presets_, 0, presets);
  fill(looks_, presets, thumbnails_.size());
  fitLists();
}

void LooksPanel::showPicture(int place) {
  const QImage* const image = painter_->picture(static_cast<std::size_t>(place));
  const int presets = static_cast<int>(list_.size());
  QListWidget* const list = place < presets ? presets_ : looks_;
  QListWidgetItem* const item = list->item(place < presets ? place : place - presets);
  if (!image || !item) return;
  QPixmap pixmap = QPixmap::fromImage(*image);
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  item->setIcon(QIcon(pixmap));
}

// As high as all their rows: what is around them scrolls.
void LooksPanel::fitLists() {
  for (QListWidget* list : {presets_, looks_}) {
    const int columns = std::max(1, (width() - 40) / list->gridSize().width());
    const int rows = (list->count() + columns - 1) / columns;
    list->setFixedHeight(rows * list->gridSize().height() + gap);
  }
}

void LooksPanel::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  fitLists();
}

bool LooksPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Leave) pointAt(std::nullopt);
  return Panel::eventFilter(watched, event);
}

void LooksPanel::pointAt(std::optional<std::size_t> place) {
  if (place && (*place >= thumbnails_.size() || !thumbnails_[*place].why.empty())) place.reset();
  if (place == pointed_) return;
  pointed_ = place;
  pointTimer_.stop();
  if (place) {
    pointTimer_.start();
  } else if (std::exchange(previewing_, false)) {
    Q_EMIT previewed(std::nullopt);
  }
}

void LooksPanel::choose(const QListWidgetItem* item) {
  const std::size_t place = item->data(placeRole).toULongLong();
  if (refreshTimer_.isActive()) {  // of a scene that is no more
    refreshTimer_.stop();
    refresh();
  }
  if (place >= thumbnails_.size() || !thumbnails_[place].why.empty()) return;
  const app::Thumbnail one = thumbnails_[place];  // the edit makes them anew
  pointTimer_.stop();
  const bool preset = one.kind == app::Thumbnail::Kind::preset;
  if (std::exchange(previewing_, false)) Q_EMIT previewed(std::nullopt);
  if (one.scene == scene_) return;
  Q_EMIT edited({one.scene, (preset ? tr("Preset %1") : tr("Look %1")).arg(titleOf(one)), {}, false});
}

void LooksPanel::showShift() {
  std::optional<app::AppliedPreset> applied;
  if (shifted_ && shift_->isSliderDown()) {  // the values pass by those of others
    applied = app::appliedPreset(scene_, std::span(list_).subspan(*shifted_, 1), *volume_);
    if (applied) applied->index = *shifted_;
  } else {
    applied = app::appliedPreset(scene_, list_, *volume_, shifted_);
  }
  shifted_ = applied ? std::optional(applied->index) : std::nullopt;
  for (QWidget* widget : std::initializer_list<QWidget*>{shiftLabel_, shift_, shiftBox_}) {
    widget->setEnabled(applied.has_value());
    widget->setToolTip(
        applied
            ? tr("Shifts the isovalues of %1").arg(translated(texts::presets, list_[applied->index].title))
            : tr("Choose a preset to shift its isovalues"));
  }
  const double shift = applied ? applied->shift : 0.0;
  const QSignalBlocker noShift(shift_);
  if (!shift_->isSliderDown())
    shift_->setValue(
        static_cast<int>(std::lround(shiftSteps * shift / std::max(app::shiftReach(*volume_), 1e-300))));
  shiftBox_->showValue(shift);
}

void LooksPanel::sendShift(double shift, bool endsAfterPause) {
  if (!volume_ || !shifted_ || *shifted_ >= list_.size()) return;
  const app::Preset& preset = list_[*shifted_];
  Q_EMIT edited({app::withPreset(scene_, preset, *volume_, shift),
                 tr("Shift preset %1").arg(translated(texts::presets, preset.title)), "preset shift",
                 endsAfterPause});
}

}  // namespace isolux::ui
