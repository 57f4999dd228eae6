#include "ui/panels/labels_panel.h"

#include <algorithm>

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>

#include "ui/editors/setting_editor.h"
#include "ui/language/number_text.h"
#include "ui/panels/surface_list.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

enum LabelColumn { nameColumn, labelColumn, labelVolumeColumn, labelColumns };
constexpr int labelRole = Qt::UserRole;
constexpr int widestLabelRows = 50, mostSurfacesHeight = 176;

QIcon swatchOf(const glm::vec3& linear) {
  QPixmap pixmap(14, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 90), 1.0));
  painter.setBrush(screenColour(glm::dvec3(linear)));
  painter.drawRoundedRect(QRectF(0.5, 0.5, 13.0, 13.0), 3.0, 3.0);
  return QIcon(pixmap);
}

}  // namespace

LabelsPanel::LabelsPanel(QWidget* parent)
    : Panel(parent),
      heading_(wrappedLabel({}, this)),
      search_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      controls_(new QWidget(this)),
      hide_(addButton(tr("Hide"), tr("Hide the labels selected in the list"))),
      only_(addButton(tr("Show only"), tr("Hide all but the selected labels"))),
      all_(addButton(tr("Show all"), tr("Show all labels but 0"))),
      apart_(addButton(tr("Own surface"), tr("Give the selected labels a surface of their own, with its own "
                                             "opacity and colour"))),
      surfaces_(new SurfaceList(this)),
      surfaceScroll_(new QScrollArea(this)),
      smoothing_(new SettingEditor(scene::setting("source.smoothing"), this)) {
  search_->setPlaceholderText(tr("Find a label"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Find a label"));
  list_->setHeaderLabels({tr("Label"), tr("Value"), tr("Volume, mm³")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Labels of the volume"));
  for (const LabelColumn column : {labelColumn, labelVolumeColumn})
    list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  QHeaderView* const header = list_->header();
  header->setStretchLastSection(false);
  header->setSectionsClickable(false);
  header->setResizeContentsPrecision(widestLabelRows);
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(nameColumn, QHeaderView::Stretch);

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Smoothing"), smoothing_);
  surfaceScroll_->setWidget(surfaces_);
  surfaceScroll_->setWidgetResizable(true);
  surfaceScroll_->setFrameShape(QFrame::NoFrame);
  surfaceScroll_->setFocusPolicy(Qt::NoFocus);  // its rows have it
  surfaceScroll_->setMaximumHeight(mostSurfacesHeight);
  layOut(controls_,
         columnOf({lineOf({{hide_, 1}, {only_, 1}, {all_, 1}, {apart_, 1}}), surfaceScroll_, form}), {});
  layOut(this, columnOf({heading_, search_, {list_, 1}, controls_, Cell::room(0)}, 8), {12, 10, 12, 12});

  connect(search_, &QLineEdit::textChanged, this, &LabelsPanel::search);
  connect(list_, &QTreeWidget::itemChanged, this, &LabelsPanel::toggle);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] {
    const bool any = !list_->selectedItems().isEmpty();
    hide_->setEnabled(any);
    only_->setEnabled(any);
    apart_->setEnabled(any);
  });
  connect(hide_, &QPushButton::clicked, this, [this] {
    show(where([](const QTreeWidgetItem& item) {
           return item.checkState(nameColumn) == Qt::Checked && !item.isSelected();
         }),
         tr("Hide labels"));
  });
  connect(only_, &QPushButton::clicked, this, [this] {
    show(where([](const QTreeWidgetItem& item) { return item.isSelected(); }), tr("Show only labels"));
  });
  connect(all_, &QPushButton::clicked, this, [this] {
    show(where([](const QTreeWidgetItem& item) { return item.data(nameColumn, labelRole).toInt() != 0; }),
         tr("Show all labels"));
  });
  connect(apart_, &QPushButton::clicked, this, &LabelsPanel::makeOwnSurface);
  connect(surfaces_, &SurfaceList::edited, this, &LabelsPanel::edited);
  connect(surfaces_, &SurfaceList::dragStarted, this, &LabelsPanel::dragStarted);
  connect(surfaces_, &SurfaceList::dragEnded, this, &LabelsPanel::dragEnded);
  connect(smoothing_, &SettingEditor::edited, this, &LabelsPanel::edited);
  connect(smoothing_, &SettingEditor::failed, this, &LabelsPanel::failed);
  fill();
}

QPushButton* LabelsPanel::addButton(const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, this);
  button->setAutoDefault(false);
  button->setToolTip(tip);
  return button;
}

void LabelsPanel::setVolume(const VolumePointer& volume) {
  const bool other =
      !volume_ || !volume->labels || !volume_->labels || volume->labels->blocks != volume_->labels->blocks;
  volume_ = volume;
  surfaces_->setVolume(volume);
  if (other) fill();
  showChecks();
}

void LabelsPanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  scene_ = scene;
  resolved_ = resolved;
  smoothing_->setScene(scene, resolved);
  surfaces_->setScene(scene, resolved);
  surfaceScroll_->setVisible(scene.surfaces.size() > 1);
  surfaceScroll_->setMinimumHeight(std::min(mostSurfacesHeight, surfaces_->minimumSizeHint().height()));
}

// A row for each label that the volume has.
void LabelsPanel::fill() {
  filling_ = true;
  list_->clear();
  const bool labels = volume_ && volume_->labels;
  heading_->setText(labels ? tr("Labels: %1").arg(volume_->labels->blocks->list().size())
                           : tr("The volume is no label map."));
  for (QWidget* widget : {static_cast<QWidget*>(search_), static_cast<QWidget*>(list_), controls_})
    widget->setVisible(labels);
  if (labels) {
    const volume::LabelTable* const table = volume_->labels->table.get();
    const double voxelMm3 = volume_->labels->grid().geometry().voxelMm3();
    for (const volume::LabelExtent& label : volume_->labels->blocks->list()) {
      auto* item = new QTreeWidgetItem(list_);
      const QString name = QString::fromStdString(volume::labelName(table, label.label));
      const QString unnamed = label.label == 0 ? tr("Background") : tr("Label %1").arg(label.label);
      item->setText(nameColumn, name.isEmpty() ? unnamed : name);
      item->setIcon(nameColumn, swatchOf(volume::labelColor(table, label.label)));
      item->setData(nameColumn, labelRole, label.label);
      item->setText(labelColumn, QString::number(label.label));
      item->setText(labelVolumeColumn, numberText(voxelMm3 * static_cast<double>(label.voxels), 6));
      for (const LabelColumn column : {labelColumn, labelVolumeColumn})
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    }
  }
  for (QPushButton* button : {hide_, only_, apart_}) button->setEnabled(false);
  filling_ = false;
  showChecks();
  search(search_->text());
}

void LabelsPanel::showChecks() {
  if (!volume_ || !volume_->labels) return;
  filling_ = true;
  const std::vector<int>& shown = volume_->labels->mask.labels;
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* const item = list_->topLevelItem(row);
    const bool isShown = std::ranges::binary_search(shown, item->data(nameColumn, labelRole).toInt());
    item->setCheckState(nameColumn, isShown ? Qt::Checked : Qt::Unchecked);
  }
  filling_ = false;
}

void LabelsPanel::search(const QString& text) {
  const QString wanted = text.trimmed().toLower();
  for (int row = 0; row < list_->topLevelItemCount(); ++row) {
    QTreeWidgetItem* const item = list_->topLevelItem(row);
    const bool found = item->text(nameColumn).toLower().contains(wanted) || item->text(labelColumn) == wanted;
    item->setHidden(!found);
    if (!found) item->setSelected(false);  // what is not seen is not changed
  }
}

std::vector<int> LabelsPanel::where(bool (*wanted)(const QTreeWidgetItem& item)) const {
  std::vector<int> labels;
  for (int row = 0; row < list_->topLevelItemCount(); ++row)
    if (const QTreeWidgetItem* item = list_->topLevelItem(row); wanted(*item))
      labels.push_back(item->data(nameColumn, labelRole).toInt());
  return labels;
}

void LabelsPanel::toggle(QTreeWidgetItem* item) {
  if (filling_) return;
  const bool shows = item->checkState(nameColumn) == Qt::Checked;
  show(where([](const QTreeWidgetItem& one) { return one.checkState(nameColumn) == Qt::Checked; }),
       (shows ? tr("Show %1") : tr("Hide %1")).arg(item->text(nameColumn)));
}

void LabelsPanel::makeOwnSurface() {
  const std::vector<int> labels = where([](const QTreeWidgetItem& item) { return item.isSelected(); });
  if (const auto made = app::withLabelSurface(scene_, *volume_, labels))
    Q_EMIT edited({*made, tr("Give labels a surface")});
  else
    Q_EMIT failed(tr("At most %1 surfaces are possible").arg(scene::kSurfaces));
}

void LabelsPanel::show(const std::vector<int>& labels, const QString& name) {
  if (labels.empty()) {
    Q_EMIT failed(tr("At least one label stays shown."));
    showChecks();
    return;
  }
  Edit edit{scene_, name};
  edit.scene.source.labels = volume::textOfLabels(labels, *volume_->labels->blocks);
  edit.scene.camera = resolved_.camera;  // the view stays, whatever is shown
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
