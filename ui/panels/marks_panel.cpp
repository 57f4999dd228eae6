#include "ui/panels/marks_panel.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>

#include "app/marks/mark_kinds.h"
#include "ui/language/sentences.h"
#include "ui/theme/style.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

constexpr int swatchPixels = 12, detailLines = 9;

// What a mark says is not typed.
class ReadOnlyColumn : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QWidget* createEditor(QWidget*, const QStyleOptionViewItem&, const QModelIndex&) const override {
    return nullptr;
  }
};

QIcon swatch(glm::dvec3 linear) {
  QPixmap pixmap(swatchPixels, swatchPixels);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(screenColour(linear));
  painter.drawEllipse(QRectF(1, 1, swatchPixels - 2, swatchPixels - 2));
  return QIcon(pixmap);
}

}  // namespace

MarksPanel::MarksPanel(QWidget* parent)
    : Panel(parent),
      empty_(wrappedLabel(
          tr("No measurements yet.\n\nChoose a tool from the Measure menu, then click on the surface: pin "
             "(P), distance (M), geodesic distance (Shift+M), angle, circle, thickness or piece."),
          this)),
      measuring_(new QLabel(tr("Measuring…"), this)),
      list_(new QTreeWidget(this)),
      details_(new QPlainTextEdit(this)),
      colour_(new ColorButton(this)) {
  empty_->setAlignment(Qt::AlignTop);
  for (QLabel* label : {empty_, measuring_}) setInk(label, Ink::quiet);
  details_->setReadOnly(true);
  details_->setAccessibleName(tr("Measured values"));
  details_->setFixedHeight(fontMetrics().lineSpacing() * detailLines + 12);
  details_->setTabChangesFocus(true);
  nameAndTip(colour_, tr("Colour of the measurement"));
  keepPlaceWhenHidden(colour_);  // a mark that is chosen makes the panel no wider
  connect(colour_, &ColorButton::chosen, this, &MarksPanel::recolour);
  delete_ = addButton(tr("Delete"), tr("Delete selected measurements (Del)"), &MarksPanel::deleteChosen);
  copy_ = addButton(tr("Copy"), tr("Copy the values of all measurements as text"), &MarksPanel::copy);
  export_ =
      addButton(tr("Export…"), tr("Save the measurements as a table (CSV) or for 3D Slicer (.mrk.json)"),
                &MarksPanel::exportWanted);
  import_ = addButton(tr("Import…"), tr("Open 3D Slicer markups (.mrk.json)"), &MarksPanel::importWanted);
  stop_ = addButton(tr("Stop"), tr("Stop measuring"), &MarksPanel::stopWanted);
  anyway_ = addButton(tr("Measure anyway"),
                      tr("Measure with voxels of 1 mm, which may be wrong: the file states no voxel size"),
                      &MarksPanel::anywayWanted);
  makeList();

  auto* busy = lineOf({{measuring_, 1}, stop_, anyway_});
  auto* buttons = lineOf({colour_, delete_, copy_, export_, import_, Cell::room()});
  layOut(this, columnOf({empty_, {list_, 1}, busy, details_, buttons}, 8), {12, 10, 12, 12});
  showMarks();
  setReports({}, false);
}

QToolButton* MarksPanel::addButton(const QString& text, const QString& tip, void (MarksPanel::*clicked)()) {
  auto* button = textButton(text, tip, this);
  button->setFocusPolicy(Qt::StrongFocus);
  connect(button, &QToolButton::clicked, this, clicked);
  return button;
}

void MarksPanel::makeList() {
  list_->setHeaderLabels({tr("Measurement"), tr("Value")});
  list_->setRootIsDecorated(false);
  list_->setIndentation(0);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setItemDelegateForColumn(valueColumn, new ReadOnlyColumn(list_));
  list_->setIconSize({swatchPixels, swatchPixels});
  list_->setAccessibleName(tr("Measurements"));
  list_->header()->setStretchLastSection(true);
  list_->header()->setSectionResizeMode(nameColumn, QHeaderView::ResizeToContents);
  auto* remove = new QAction(tr("Delete"), list_);
  remove->setShortcut(QKeySequence::Delete);
  remove->setShortcutContext(Qt::WidgetShortcut);  // not while a name is edited
  list_->addAction(remove);
  connect(remove, &QAction::triggered, this, &MarksPanel::deleteChosen);
  connect(list_, &QTreeWidget::itemChanged, this, &MarksPanel::itemEdited);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &MarksPanel::showDetails);
  connect(list_, &QTreeWidget::currentItemChanged, this, &MarksPanel::tellChosen);
  connect(list_, &QTreeWidget::itemClicked, this, &MarksPanel::tellChosen);
}

void MarksPanel::setScene(const scene::Scene& scene, const scene::Scene&) {
  const bool same = scene.marks == scene_.marks;
  scene_ = scene;
  if (!same) showMarks();
}

void MarksPanel::setReports(const std::vector<app::MarkReport>& reports, bool measuring) {
  reports_ = reports;
  measuring_->setVisible(measuring);
  stop_->setVisible(measuring);
  anyway_->setVisible(std::any_of(reports.begin(), reports.end(), [](const app::MarkReport& report) {
    return report.problem.starts_with("lengths are doubtful");
  }));
  showMarks();
}

void MarksPanel::showMarks() {
  filling_ = true;
  const int count = static_cast<int>(scene_.marks.size()), before = list_->topLevelItemCount();
  while (list_->topLevelItemCount() > count) delete list_->takeTopLevelItem(count);
  while (list_->topLevelItemCount() < count) {
    auto* item = new QTreeWidgetItem(list_);
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  }
  for (int row = 0; row < count; ++row) showRow(list_->topLevelItem(row), static_cast<std::size_t>(row));
  if (before < count && before >= 0) list_->setCurrentItem(list_->topLevelItem(count - 1));
  filling_ = false;
  empty_->setVisible(count == 0);
  list_->setVisible(count > 0);
  details_->setVisible(count > 0);
  for (QWidget* widget : std::initializer_list<QWidget*>{colour_, delete_, copy_, export_})
    widget->setEnabled(count > 0);
  showDetails();
}

void MarksPanel::showRow(QTreeWidgetItem* item, std::size_t mark) {
  const scene::Mark& shown = scene_.marks[mark];
  item->setText(nameColumn, QString::fromStdString(shown.name));
  item->setIcon(nameColumn, swatch(shown.color));
  item->setCheckState(nameColumn, shown.shown ? Qt::Checked : Qt::Unchecked);
  item->setToolTip(nameColumn, tr("Double click: rename; box: show in the view"));
  const bool known = mark < reports_.size();
  const QString says = known ? translatedSentence(app::summaryText(reports_[mark])) : QString("…");
  const bool doubtful = known && (!reports_[mark].notes.empty() || !reports_[mark].problem.empty());
  item->setText(valueColumn, doubtful ? "⚠ " + says : says);
  item->setForeground(valueColumn, doubtful ? colours.warning : colours.text);
  item->setToolTip(valueColumn, known ? markText(shown, reports_[mark]).trimmed() : QString());
}

void MarksPanel::tellChosen() {
  const int mark = current();
  if (filling_ || mark < 0) return;
  const scene::Mark& chosen = scene_.marks[static_cast<std::size_t>(mark)];
  if (!chosen.points.empty()) Q_EMIT this->chosen(chosen.points.front());
}

int MarksPanel::current() const {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  return row < static_cast<int>(scene_.marks.size()) ? row : -1;
}

void MarksPanel::showDetails() {
  const int row = current();
  colour_->setVisible(row >= 0);
  if (row < 0) {
    details_->clear();
    return;
  }
  const auto mark = static_cast<std::size_t>(row);
  colour_->showColour(scene_.marks[mark].color);
  const app::MarkReport report = mark < reports_.size() ? reports_[mark] : app::MarkReport{};
  const QString text = markText(scene_.marks[mark], report).trimmed();
  if (text != details_->toPlainText()) details_->setPlainText(text);
}

void MarksPanel::copy() {
  QApplication::clipboard()->setText(text());
}

QString MarksPanel::text() const {
  QString text;
  for (std::size_t i = 0; i < scene_.marks.size() && i < reports_.size(); ++i)
    text += markText(scene_.marks[i], reports_[i]);
  return text;
}

void MarksPanel::itemEdited(QTreeWidgetItem* item, int column) {
  const int row = list_->indexOfTopLevelItem(item);
  if (filling_ || row < 0 || row >= static_cast<int>(scene_.marks.size())) return;
  std::vector<scene::Mark> marks = scene_.marks;
  scene::Mark& mark = marks[static_cast<std::size_t>(row)];
  const bool shown = item->checkState(nameColumn) == Qt::Checked;
  if (column == nameColumn && shown != mark.shown) {
    mark.shown = shown;
    const QString name = QString::fromStdString(mark.name);
    send(std::move(marks), shown ? tr("Show %1").arg(name) : tr("Hide %1").arg(name));
  } else if (const std::string name = item->text(nameColumn).trimmed().toStdString();
             column == nameColumn && name != mark.name && !name.empty()) {
    mark.name = name;
    send(std::move(marks), tr("Rename measurement"));
  } else {
    showMarks();  // an empty name, or a value: what holds is shown again
  }
}

void MarksPanel::recolour(glm::dvec3 linear) {
  std::vector<scene::Mark> marks = scene_.marks;
  for (QTreeWidgetItem* item : list_->selectedItems())
    marks[static_cast<std::size_t>(list_->indexOfTopLevelItem(item))].color = linear;
  send(std::move(marks), tr("Colour measurements"), "colour marks");
}

void MarksPanel::deleteChosen() {
  std::vector<scene::Mark> marks;
  int deleted = 0;
  for (int row = 0; row < static_cast<int>(scene_.marks.size()); ++row) {
    if (list_->topLevelItem(row)->isSelected())
      ++deleted;
    else
      marks.push_back(scene_.marks[static_cast<std::size_t>(row)]);
  }
  if (deleted > 0)
    send(std::move(marks), deleted == 1 ? tr("Delete measurement") : tr("Delete measurements"));
}

void MarksPanel::send(std::vector<scene::Mark> marks, const QString& name, const QString& mergeKey) {
  Edit edit{scene_, name, mergeKey, !mergeKey.isEmpty()};
  edit.scene.marks = std::move(marks);
  Q_EMIT edited(edit);
}

}  // namespace isolux::ui
