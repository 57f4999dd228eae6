#include "ui/panels/pieces_panel.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include "app/view_math/piece_choice.h"
#include "scene/shown_surfaces.h"
#include "ui/editors/setting_editor.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/viewport/pointed_piece.h"
#include "ui/widgets/parts.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::ui {

namespace {

constexpr int isovalueRestMilliseconds = 200;
constexpr std::size_t mostRows = 200;
constexpr int widestRows = 50;  // the largest pieces have the longest numbers
enum PieceColumn { idColumn, volumeColumn, boxColumn, pieceColumns };

QString boxText(const volume::WorldBox& box) {
  const glm::dvec3 size = box.highMm - box.lowMm;
  const auto text = [](double mm) {
    return numberText(mm < 10.0 ? std::round(10.0 * mm) / 10.0 : std::round(mm), 6);
  };
  return QString("%1 × %2 × %3").arg(text(size.x), text(size.y), text(size.z));
}

// "2600 ± 200": two digits of the error, of a number below its error two of its own.
QString withErrorText(const volume::Measured& measured) {
  const auto rounded = [&](double number) {
    if (!(measured.error > 0.0)) return numberText(number, 6);
    const double least = std::min(measured.error, std::max(number, 1e-6));
    const double step = std::pow(10.0, std::floor(std::log10(least)) - 1.0);
    return numberText(std::round(number / step) * step, 9);
  };
  return QString("%1 ± %2").arg(rounded(measured.value), rounded(measured.error));
}

}  // namespace

PiecesPanel::PiecesPanel(QWidget* parent)
    : Panel(parent),
      heading_(wrappedLabel({}, this)),
      more_(wrappedLabel({}, this)),
      list_(new QTreeWidget(this)),
      controls_(new QWidget(this)) {
  setInk(more_, Ink::quiet);
  makeList();
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layOut(controls_, columnOf({makeButtons(), form}), {});
  for (const auto& [path, label] : {std::pair{"pieces.keep", tr("Keep the largest")},
                                    {"pieces.smallest", tr("Hide smaller than")},
                                    {"pieces.within", tr("Inside the body above")}}) {
    SettingEditor* editor = editors_.emplace_back(new SettingEditor(scene::setting(path), controls_));
    form->addRow(label, editor);
    connect(editor, &SettingEditor::edited, this, &PiecesPanel::edited);
    connect(editor, &SettingEditor::failed, this, &PiecesPanel::failed);
  }
  layOut(this, columnOf({heading_, {list_, 1}, more_, controls_, Cell::room(0)}, 8), {12, 10, 12, 12});

  callOnce(restTimer_, isovalueRestMilliseconds, this, &PiecesPanel::find);

  showFound();
}

void PiecesPanel::makeList() {
  list_->setHeaderLabels({tr("Piece"), tr("Volume, mm³"), tr("Box, mm")});
  for (const PieceColumn column : {volumeColumn, boxColumn})
    list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Pieces of the isosurface, the largest first"));
  QHeaderView* header = list_->header();
  header->setStretchLastSection(false);
  header->setSectionsClickable(false);
  header->setResizeContentsPrecision(widestRows);
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(volumeColumn, QHeaderView::Stretch);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &PiecesPanel::enableButtons);
  connect(list_, &QTreeWidget::itemChanged, this, &PiecesPanel::toggle);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &PiecesPanel::centreSelected);
}

QPushButton* PiecesPanel::addButton(const QString& text, const QString& tip, void (PiecesPanel::*clicked)()) {
  auto* button = new QPushButton(text);
  button->setAutoDefault(false);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, clicked);
  return button;
}

QLayout* PiecesPanel::makeButtons() {
  hide_ = addButton(tr("Hide"), tr("Hide the pieces selected in the list"), &PiecesPanel::hideSelected);
  only_ = addButton(tr("Show only"), tr("Hide all but the selected pieces"), &PiecesPanel::isolateSelected);
  centre_ = addButton(tr("Centre"), tr("Centre the view on the selected piece (double click)"),
                      &PiecesPanel::centreSelected);
  all_ = addButton(tr("Show all"), tr("Show all pieces again"), &PiecesPanel::showAll);
  auto* grid = new QGridLayout;
  grid->addWidget(hide_, 0, 0);
  grid->addWidget(only_, 0, 1);
  grid->addWidget(centre_, 1, 0);
  grid->addWidget(all_, 1, 1);
  return grid;
}

// What is found

void PiecesPanel::setVolume(const VolumePointer& volume) {
  volume_ = volume;
  task_.reset();
  asked_ = {};
  found_ = {};
  foundOf_.reset();
  showFound();
}

void PiecesPanel::setScene(const scene::Scene& scene, const scene::Scene& resolved) {
  const bool otherChoice = !(scene.pieces == scene_.pieces);
  scene_ = scene;
  resolved_ = resolved;
  for (SettingEditor* editor : editors_) editor->setScene(scene, resolved);
  if (otherChoice) showRows();
  findSoon();
}

// What comes to the front is painted.
void PiecesPanel::paintEvent(QPaintEvent* event) {
  Panel::paintEvent(event);
  find();
}

void PiecesPanel::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  restTimer_.stop();
  task_.reset();
}

bool PiecesPanel::current() const {
  return found_.pieces && foundOf_ == volume_ &&
         resolved_.surfaces.front().value == found_.pieces->isovalue() &&
         resolved_.isosurface.inside == found_.pieces->inside();
}

bool PiecesPanel::measured() const {
  return current() && found_.measures.size() == found_.pieces->list().size();
}

bool PiecesPanel::isWanted() const {
  return isSeen(this) && volume_ && resolved_.surfaces.front().value && !measured() &&
         !(task_ && asked_ == app::PieceSubject{volume_, *resolved_.surfaces.front().value,
                                                resolved_.isosurface.inside});
}

// While the isovalue is dragged nothing is begun.
void PiecesPanel::findSoon() {
  if (isWanted()) restTimer_.start();
}

void PiecesPanel::find() {
  if (!isWanted()) return;
  asked_ = {volume_, *resolved_.surfaces.front().value, resolved_.isosurface.inside};
  task_.watch(
      app::pieceTask(asked_, resolved_, current()), [this](auto& task) { take(task); },
      [this] { showState(); });
  showState();
}

void PiecesPanel::take(app::PieceTask& task) {
  if (task.error()) {
    heading_->setText(QString::fromStdString(task.error()->what()));
    return;
  }
  found_ = task.value();
  foundOf_ = volume_;
  showFound();
  find();  // estimates are there: now the measures, or another isovalue
}

// What is shown

void PiecesPanel::showFound() {
  showRows();
  const bool any = volume_ && found_.pieces && !found_.pieces->list().empty();
  list_->setVisible(any);
  controls_->setVisible(volume_ != nullptr);
  showState();
}

void PiecesPanel::showRows() {
  const QSignalBlocker block(list_);
  more_->hide();
  if (!found_.pieces) return list_->clear();
  base::Progress unwatched;
  const std::vector<bool> shown = volume_->pieces->shown(*found_.pieces, scene_.pieces, unwatched);
  const std::size_t rows = std::min(shown.size(), mostRows);
  // A change of the choice comes from a row: its items stay.
  if (static_cast<std::size_t>(list_->topLevelItemCount()) != rows) {
    list_->clear();
    QList<QTreeWidgetItem*> items;
    for (std::size_t id = 0; id < rows; ++id) items += new QTreeWidgetItem;
    list_->addTopLevelItems(items);
  }
  fillRows(shown, rows);
  if (rows < shown.size()) more_->setText(tr("… and %1 smaller ones").arg(shown.size() - rows));
  more_->setVisible(rows < shown.size());
  showState();
  enableButtons();
}

// Told to the view once: telling it of every cell of 200 rows held the window up for a fifth of a second.
void PiecesPanel::fillRows(const std::vector<bool>& shown, std::size_t rows) {
  if (rows == 0) return;
  QAbstractItemModel* const model = list_->model();
  {
    const QSignalBlocker untold(model);
    for (std::size_t id = 0; id < rows; ++id)
      fillRow(list_->topLevelItem(static_cast<int>(id)), id, shown[id]);
  }
  Q_EMIT model->dataChanged(model->index(0, 0), model->index(static_cast<int>(rows) - 1, pieceColumns - 1));
}

void PiecesPanel::fillRow(QTreeWidgetItem* item, std::size_t id, bool shown) const {
  item->setText(idColumn, QString::number(id));
  item->setCheckState(idColumn, shown ? Qt::Checked : Qt::Unchecked);
  for (const PieceColumn column : {volumeColumn, boxColumn})
    item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  for (int column = 0; column < pieceColumns; ++column)
    item->setForeground(column, shown ? colours.text : colours.quietText);
  const volume::Piece& piece = found_.pieces->list()[id];
  if (id >= found_.measures.size()) {
    item->setText(boxColumn, {});
    item->setText(volumeColumn, tr("about %1").arg(numberText(piece.volumeMm3, 3)));
    return;
  }
  const volume::PieceMeasure& measure = found_.measures[id];
  const volume::Measured& volume = measure.surface.volumeMm3;
  item->setText(volumeColumn, withErrorText(volume));
  item->setText(boxColumn, boxText(measure.bounds));
  QStringList tip{tr("Volume %1 mm³").arg(withErrorText(volume)),
                  tr("Area %1 mm²").arg(withErrorText(measure.surface.areaMm2)),
                  tr("%1 voxels").arg(piece.voxels)};
  if (measure.surface.open()) tip += tr("Extends beyond the data: volume and area cover the part within");
  if (!shown) tip += tr("Hidden");
  for (int column = 0; column < pieceColumns; ++column) item->setToolTip(column, tip.join('\n'));
}

void PiecesPanel::showState() {
  if (!volume_) {
    heading_->setText(tr("Open a volume to list the pieces (connected components) of its isosurface."));
    return;
  }
  if (task_ && !current()) {
    heading_->setText(tr("Finding pieces… %1 %").arg(qRound(100.0 * task_->progress().fraction())));
    return;
  }
  if (!found_.pieces) {
    heading_->setText("");
    return;
  }
  const auto unit = QString::fromStdString(volume_->volume.unit);
  const QString where = valueText(found_.pieces->isovalue(), unit);
  const std::size_t count = found_.pieces->list().size();
  if (count == 0) {
    heading_->setText(tr("No voxel is inside at %1: change the isovalue.").arg(where));
    return;
  }
  base::Progress unwatched;
  const std::vector<bool> shown = volume_->pieces->shown(*found_.pieces, scene_.pieces, unwatched);
  const auto hidden = std::count(shown.begin(), shown.end(), false);
  QString text = count == 1 ? tr("One piece at %1").arg(where) : tr("%1 pieces at %2").arg(count).arg(where);
  if (hidden > 0) text += tr(", %1 hidden").arg(hidden);
  if (scene::shownSurfaces(resolved_).size() > 1) text += tr(" (of the first isosurface)");
  if (task_) text += tr(" – measuring…");
  heading_->setText(text);
}

// What is done with them

std::vector<std::size_t> PiecesPanel::selected() const {
  std::vector<std::size_t> ids;
  for (QTreeWidgetItem* item : list_->selectedItems())
    ids.push_back(static_cast<std::size_t>(list_->indexOfTopLevelItem(item)));
  std::sort(ids.begin(), ids.end());
  return ids;
}

void PiecesPanel::enableButtons() {
  const std::size_t count = measured() ? selected().size() : 0;
  hide_->setEnabled(count > 0);
  only_->setEnabled(count > 0);
  centre_->setEnabled(count == 1);
  all_->setEnabled(volume::hidesPieces(scene_.pieces));
}

std::vector<glm::dvec3> PiecesPanel::selectedSeeds() const {
  std::vector<glm::dvec3> seeds;
  for (const std::size_t id : selected()) seeds.push_back(found_.seedsMm[id]);
  return seeds;
}

QString PiecesPanel::nameOfSelected(const QString& one, const QString& several) const {
  const std::vector<std::size_t> ids = selected();
  return ids.size() == 1 ? one.arg(ids.front()) : several.arg(ids.size());
}

void PiecesPanel::choose(const QString& name, const scene::Pieces& choice) {
  Edit edit{scene_, name};
  edit.scene.pieces = choice;
  Q_EMIT edited(edit);
}

void PiecesPanel::toggle(QTreeWidgetItem* item, int column) {
  if (column != idColumn) return;
  const auto id = static_cast<std::size_t>(list_->indexOfTopLevelItem(item));
  if (!measured()) return showRows();  // as it was
  if (item->checkState(idColumn) == Qt::Unchecked)
    choose(tr("Hide piece %1").arg(id), app::withHidden(scene_.pieces, {found_.seedsMm[id]}));
  else
    choose(tr("Show piece %1").arg(id),
           app::withShown(scene_.pieces, *found_.pieces, static_cast<std::uint32_t>(id), found_.seedsMm[id]));
}

void PiecesPanel::hideSelected() {
  choose(nameOfSelected(tr("Hide piece %1"), tr("Hide %1 pieces")),
         app::withHidden(scene_.pieces, selectedSeeds()));
}

void PiecesPanel::isolateSelected() {
  choose(nameOfSelected(tr("Show only piece %1"), tr("Show only %1 pieces")),
         app::onlyThese(selectedSeeds()));
}

void PiecesPanel::centreSelected() {
  if (!measured() || selected().size() != 1) return;
  const volume::WorldBox& box = found_.measures[selected().front()].bounds;
  Edit edit{scene_, tr("Centre on piece")};
  edit.scene.camera = app::centredOn(resolved_.camera, 0.5 * (box.lowMm + box.highMm));
  Q_EMIT edited(edit);
}

void PiecesPanel::showAll() {
  choose(tr("Show all pieces"), {});
}

}  // namespace isolux::ui
