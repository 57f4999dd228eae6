#include "ui/panels/surface_list.h"

#include <algorithm>
#include <climits>
#include <cmath>

#include <QCheckBox>
#include <QFrame>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::ui {

namespace {
constexpr int rowHeight = 24, valueWidth = 84, opacityWidth = 52, nameWidth = 56;  // pixels
constexpr int opacitySteps = 100;
constexpr std::size_t longList = 12;  // rows; longer ones can be searched
}  // namespace

QString surfaceName(const app::ListedSurface& surface) {
  if (!surface.name.empty()) return QString::fromStdString(surface.name);
  if (!surface.isOfLabels) return QObject::tr("Isosurface %1").arg(surface.number + 1);
  if (surface.labels.empty()) return QObject::tr("Other labels");
  return QObject::tr("Labels %1").arg(QString::fromStdString(surface.labels));
}

SurfaceList::SurfaceList(QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)), search_(new QLineEdit(this)), place_(new QFrame(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(4);
  grid_->setVerticalSpacing(1);
  grid_->setColumnStretch(3, 1);
  search_->setPlaceholderText(tr("Find a surface"));
  search_->setAccessibleName(tr("Find a surface"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, &SurfaceList::search);
  place_->setFrameShape(QFrame::HLine);
  place_->hide();
  setAccessibleName(tr("Isosurfaces"));
}

void SurfaceList::setVolume(const VolumePointer& volume) {
  volume_ = volume;
  const QString unit = volume ? QString::fromStdString(volume->volume.unit) : QString();
  for (const Row& row : rows_) row.value->setSuffix(unit.isEmpty() ? QString() : ' ' + unit);
}

void SurfaceList::setStep(double step) {
  for (const Row& row : rows_) row.value->setSingleStep(step);
}

void SurfaceList::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  list_ = app::listedSurfaces(scene, resolved, volume_.get());
  const bool same =
      std::equal(rows_.begin(), rows_.end(), list_.begin(), list_.end(),
                 [](const Row& row, const app::ListedSurface& one) { return row.number == one.number; });
  if (!same) makeRows(list_);
  for (std::size_t i = 0; i < list_.size(); ++i) fill(rows_[i], list_[i]);
  search();
}

void SurfaceList::search() {
  const bool isLong = rows_.size() > longList;
  search_->setVisible(isLong);
  const QString wanted = isLong ? search_->text().trimmed() : QString();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool found = surfaceName(list_[i]).contains(wanted, Qt::CaseInsensitive);
    for (QWidget* widget : widgetsOf(rows_[i])) widget->setVisible(found);
    rows_[i].value->setVisible(found && !list_[i].isOfLabels);
    rows_[i].labels->setVisible(found && list_[i].isOfLabels);
  }
}

int SurfaceList::rowAt(int y) const {
  const auto distance = [&](const Row& row) { return std::abs(row.handle->geometry().center().y() - y); };
  const auto nearest = std::ranges::min_element(
      rows_, {}, [&](const Row& row) { return row.handle->isVisible() ? distance(row) : INT_MAX; });
  return static_cast<int>(nearest - rows_.begin());
}

void SurfaceList::move(int from, int to) {
  if (!volume_ || from == to || to < 0 || to >= static_cast<int>(rows_.size())) return;
  send(tr("Move surface"), {}, false,
       [&](scene::Scene& scene) { scene = app::withSurfaceMoved(scene, *volume_, from, to); });
}

bool SurfaceList::eventFilter(QObject* object, QEvent* event) {
  const auto row = std::ranges::find(rows_, object, &Row::handle);
  if (row == rows_.end()) return QWidget::eventFilter(object, event);
  const int from = static_cast<int>(row - rows_.begin());
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key != Qt::Key_Up && key != Qt::Key_Down) return false;
    const int to = from + (key == Qt::Key_Down ? 1 : -1);
    move(from, to);
    if (to >= 0 && to < static_cast<int>(rows_.size()))
      rows_[static_cast<std::size_t>(to)].handle->setFocus();
    return true;
  }
  if (event->type() != QEvent::MouseMove && event->type() != QEvent::MouseButtonRelease) return false;
  const int to = rowAt(row->handle->mapTo(this, static_cast<QMouseEvent*>(event)->position().toPoint()).y());
  const QRect target = rows_[static_cast<std::size_t>(to)].handle->geometry();
  const bool dropped = event->type() == QEvent::MouseButtonRelease;
  place_->setVisible(!dropped && to != from);
  place_->setGeometry(0, to > from ? target.bottom() : target.top() - 1, width(), 2);
  place_->raise();
  if (dropped) move(from, to);
  return true;
}

std::vector<QWidget*> SurfaceList::widgetsOf(const Row& row) {
  return {row.handle, row.shown,   row.colour,     row.name,  row.value,
          row.labels, row.opacity, row.seeThrough, row.remove};
}

void SurfaceList::makeRows(const std::vector<app::ListedSurface>& list) {
  for (const Row& row : rows_)
    for (QWidget* widget : widgetsOf(row)) {
      widget->hide();
      widget->deleteLater();  // one of them may be what asked for this
    }
  rows_.clear();
  grid_->addWidget(search_, 0, 0, 1, -1);
  for (const app::ListedSurface& surface : list) {
    const Row row = makeRow(surface.number);
    const int at = static_cast<int>(rows_.size()) + 1;
    int column = 0;
    for (QWidget* widget : widgetsOf(row)) {
      widget->setFixedHeight(rowHeight);
      grid_->addWidget(widget, at, column++);
      widget->show();
    }
    connectRow(row);
    rows_.push_back(row);
  }
  setVolume(volume_);
}

SurfaceList::Row SurfaceList::makeRow(int number) {
  Row row{number,
          new QLabel(QStringLiteral("⋮"), this),
          new QCheckBox(this),
          new ColorButton(this),
          new QLineEdit(this),
          new NumberSpinBox(this),
          new QLineEdit(this),
          new QSlider(Qt::Horizontal, this),
          new QToolButton(this),
          new QToolButton(this)};
  row.handle->setToolTip(tr("Drag, or press the up and down keys, to move this surface in the list"));
  row.handle->setCursor(Qt::SizeVerCursor);
  row.handle->setFocusPolicy(Qt::TabFocus);
  row.handle->installEventFilter(this);
  row.shown->setToolTip(tr("Show this isosurface"));
  row.colour->setFixedWidth(rowHeight);
  row.colour->setIconSize({16, 16});
  row.name->setMinimumWidth(nameWidth);
  row.name->setToolTip(tr("Name of this isosurface"));
  row.value->setFixedWidth(valueWidth);
  row.value->setButtonSymbols(QAbstractSpinBox::NoButtons);
  row.value->setToolTip(tr("Isovalue; arrow keys change it by one histogram step"));
  row.labels->setFixedWidth(valueWidth);
  row.labels->setToolTip(tr("Labels of this surface: numbers, ranges and names"));
  row.opacity->setRange(0, opacitySteps);
  row.opacity->setFixedWidth(opacityWidth);
  row.seeThrough->setCheckable(true);
  row.seeThrough->setText(QStringLiteral("◎"));
  row.seeThrough->setToolTip(tr(
      "View-dependent opacity: transparent where the surface faces the viewer, dense where it is edge-on"));
  row.remove->setText(QStringLiteral("×"));
  row.remove->setToolTip(tr("Remove this isosurface from the list"));
  for (QToolButton* button : {row.seeThrough, row.remove}) {
    button->setFixedWidth(rowHeight);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
  }
  return row;
}

template <class Change>
void SurfaceList::send(const QString& name, const QString& mergeKey, bool endsAfterPause,
                       const Change& change) {
  Edit edit{scene_, name, mergeKey, endsAfterPause};
  change(edit.scene);
  if (!(edit.scene == scene_)) Q_EMIT edited(edit);
}

void SurfaceList::connectRow(const Row& row) {
  const int number = row.number;
  const QString key = QStringLiteral("isosurface %1 ").arg(number);
  connect(row.shown, &QCheckBox::toggled, this, [this, number](bool on) {
    if (!volume_) return;
    send(on ? tr("Show isosurface") : tr("Hide isosurface"), {}, false,
         [&](scene::Scene& scene) { scene = app::withSurfaceShown(scene, *volume_, number, on); });
  });
  connect(row.colour, &ColorButton::chosen, this, [this, number, key](glm::dvec3 linear) {
    send(tr("Colour of isosurface"), key + "colour", true, [&](scene::Scene& scene) {
      scene.surfaces.at(number).albedo = linear;
      scene.surfaces.at(number).labelColors = false;
    });
  });
  connect(row.name, &QLineEdit::editingFinished, this, [this, number, name = row.name] {
    send(tr("Rename isosurface"), {}, false,
         [&](scene::Scene& scene) { scene.surfaces.at(number).name = name->text().trimmed().toStdString(); });
  });
  connect(row.value, &NumberSpinBox::valueChanged, this, [this, number, key](double value) {
    send(tr("Set isovalue"), key + "value", true,
         [&](scene::Scene& scene) { scene.surfaces.at(number).value = value; });
  });
  connect(row.labels, &QLineEdit::editingFinished, this, [this, number, labels = row.labels] {
    send(tr("Choose labels of surface"), {}, false, [&](scene::Scene& scene) {
      scene.surfaces.at(number).labels = labels->text().trimmed().toStdString();
    });
  });
  connect(row.opacity, &QSlider::sliderPressed, this, &SurfaceList::dragStarted);
  connect(row.opacity, &QSlider::sliderReleased, this, &SurfaceList::dragEnded);
  connect(row.opacity, &QSlider::valueChanged, this, [this, number, key, slider = row.opacity](int steps) {
    send(tr("Opacity of isosurface"), key + "opacity", !slider->isSliderDown(), [&](scene::Scene& scene) {
      scene.surfaces.at(number).opacity = static_cast<double>(steps) / opacitySteps;
    });
  });
  connect(row.seeThrough, &QToolButton::clicked, this, [this, number](bool on) {
    send(on ? tr("Turn on view-dependent opacity") : tr("Turn off view-dependent opacity"), {}, false,
         [&](scene::Scene& scene) { scene.surfaces.at(number).facingOpacity = on ? app::kSeeThrough : 1.0; });
  });
  connect(row.remove, &QToolButton::clicked, this, [this, number] {
    if (!volume_) return;
    send(tr("Remove isosurface"), {}, false,
         [&](scene::Scene& scene) { scene = app::withoutSurface(scene, *volume_, number); });
  });
}

void SurfaceList::fill(const Row& row, const app::ListedSurface& surface) {
  const QString name = surfaceName(surface);
  const QSignalBlocker noShown(row.shown), noOpacity(row.opacity);
  row.shown->setChecked(surface.shown);
  row.shown->setAccessibleName(tr("Show %1").arg(name));
  row.colour->showColour(surface.albedo);
  row.colour->setAccessibleName(tr("Colour of %1").arg(name));
  row.name->setPlaceholderText(name);
  row.name->setAccessibleName(tr("Name of %1").arg(name));
  if (!row.name->hasFocus() || row.name->text().isEmpty()) {
    row.name->setText(QString::fromStdString(surface.name));
    row.name->setCursorPosition(0);
  }
  row.handle->setAccessibleName(tr("Place of %1").arg(name));
  if (!row.labels->hasFocus()) row.labels->setText(QString::fromStdString(surface.labels));
  row.labels->setPlaceholderText(tr("others"));
  row.labels->setAccessibleName(tr("Labels of %1").arg(name));
  row.value->showValue(surface.value);
  row.value->setAccessibleName(tr("Isovalue of %1").arg(name));
  if (!row.opacity->isSliderDown())
    row.opacity->setValue(static_cast<int>(std::lround(surface.opacity * opacitySteps)));
  row.opacity->setAccessibleName(tr("Opacity of %1").arg(name));
  row.opacity->setToolTip(tr("Opacity: %1 %").arg(std::lround(100.0 * surface.opacity)));
  row.seeThrough->setChecked(surface.facingOpacity < 1.0);
  row.seeThrough->setAccessibleName(tr("View-dependent opacity of %1").arg(name));
  row.remove->setAccessibleName(tr("Remove %1").arg(name));
}

}  // namespace isolux::ui
