#include "ui/dicom_browser/dicom_browser.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>

#include "app/browser/series_text.h"
#include "app/documents/anonymous.h"
#include "base/color.h"
#include "ui/dicom_browser/series_index.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/theme/style.h"
#include "ui/widgets/parts.h"

namespace isolux::ui {

namespace {

enum ScanColumn {
  titleColumn,
  modalityColumn,
  dateColumn,
  slicesColumn,
  sizeColumn,
  spacingColumn,
  kernelColumn,
  notesColumn
};
constexpr int sortRole = Qt::UserRole, seriesRole = Qt::UserRole + 1, pictureRole = Qt::UserRole + 2;
constexpr int pictureSide = 72;  // pixels of the screen's scale

QString textOf(const std::string& text) {
  return QString::fromStdString(text);
}

// Numbers by their size, other things as a dictionary has them.
class SortedItem : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
    const QVariant a = data(column, sortRole), b = other.data(column, sortRole);
    if (a.isValid() && b.isValid()) return a.toDouble() < b.toDouble();
    return QString::localeAwareCompare(text(column).toLower(), other.text(column).toLower()) < 0;
  }
};

QPixmap pictureOf(const volume::DecodedImage& image, double ratio) {
  QImage small(image.width, image.height, QImage::Format_RGB32);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3& p = image.pixels[volume::Extent2{{image.width, image.height}}.index(x, y)];
      small.setPixel(x, y, qRgb(base::screenByte(p.x), base::screenByte(p.y), base::screenByte(p.z)));
    }
  const int side = static_cast<int>(pictureSide * ratio);
  QPixmap square(side, side);
  square.fill(Qt::black);
  if (!small.isNull()) {
    const QImage scaled = small.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter painter(&square);
    painter.drawImage((side - scaled.width()) / 2, (side - scaled.height()) / 2, scaled);
  }
  square.setDevicePixelRatio(ratio);
  return square;
}

// Where no picture is yet, or can be made.
QPixmap emptyPicture(double ratio) {
  QPixmap square(QSize(pictureSide, pictureSide) * ratio);
  square.setDevicePixelRatio(ratio);
  square.fill(colours.base);
  QPainter painter(&square);
  painter.setPen(colours.border);
  painter.drawRect(QRectF(0.5, 0.5, pictureSide - 1.0, pictureSide - 1.0));
  return square;
}

QString patientKey(const volume::DicomSeries& series) {
  return textOf(series.patient.id) + '\n' + textOf(series.patient.name) + '\n' +
         textOf(series.patient.birthDate);
}

}  // namespace

DicomBrowser::DicomBrowser(SeriesIndex* index, QWidget* parent)
    : QDialog(parent),
      index_(index),
      folder_(new QLabel(this)),
      search_(new QLineEdit(this)),
      hide_(new QCheckBox(tr("&Hide patient data"), this)),
      tree_(new QTreeWidget(this)),
      details_(wrappedLabel({}, this)),
      summary_(new QLabel(this)),
      progress_(thinBar(this)),
      stop_(new QPushButton(tr("&Stop"), this)) {
  setWindowTitle(tr("DICOM browser"));
  search_->setPlaceholderText(tr("Search patients, descriptions, dates, modalities"));
  search_->setAccessibleName(tr("Search"));
  search_->setClearButtonEnabled(true);
  auto* choose = new QPushButton(tr("&Folder…"), this);
  choose->setToolTip(tr("Search another folder or disc"));
  choose->setAutoDefault(false);
  stop_->setAutoDefault(false);
  hide_->setChecked(savedPrivacy().hideOnScreen);
  hide_->setToolTip(tr("Show names, IDs and birth dates as “anonymous”, here and in the window"));
  makeTree();
  details_->setTextFormat(Qt::PlainText);
  details_->setMinimumHeight(3 * fontMetrics().height());
  details_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  progress_->setFixedWidth(160);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  open_ = buttons->button(QDialogButtonBox::Open);
  auto* top = lineOf({choose, {folder_, 1}, hide_, {search_, 1}});
  auto* bottom = lineOf({{summary_, 1}, progress_, stop_, buttons});
  layOut(this, columnOf({top, {tree_, 1}, details_, bottom}, 10), {14, 12, 14, 12});
  resize(1120, 680);

  connect(choose, &QPushButton::clicked, this, &DicomBrowser::chooseFolder);
  connect(search_, &QLineEdit::textChanged, this, &DicomBrowser::filter);
  connect(hide_, &QCheckBox::toggled, this, [this](bool hide) {
    keepHiddenOnScreen(hide);
    showSeries();
    Q_EMIT privacyChanged();
  });
  connect(stop_, &QPushButton::clicked, this, [this] {
    index_->stop();
    showSummary();
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &DicomBrowser::openCurrent);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(index_, &SeriesIndex::started, this, &DicomBrowser::restart);
  connect(index_, &SeriesIndex::changed, this, &DicomBrowser::showSeries);
  connect(index_, &SeriesIndex::ended, this, &DicomBrowser::showSummary);
  connect(index_, &SeriesIndex::progressed, progress_,
          [this](double fraction) { showFraction(progress_, fraction); });
  pictureTimer_.setInterval(30);
  connect(&pictureTimer_, &QTimer::timeout, this, &DicomBrowser::drawPictures);
  pictureTimer_.start();
  restart();
  showSeries();
}

void DicomBrowser::makeTree() {
  tree_->setAccessibleName(tr("Patients, studies and series"));
  tree_->setHeaderLabels({tr("Series"), tr("Modality"), tr("Date"), tr("Slices"), tr("Size"), tr("Spacing"),
                          tr("Kernel"), tr("Warnings")});
  tree_->setIconSize({pictureSide, pictureSide});
  tree_->setSortingEnabled(true);
  tree_->sortByColumn(titleColumn, Qt::AscendingOrder);
  tree_->setUniformRowHeights(false);
  tree_->setAllColumnsShowFocus(true);
  tree_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  tree_->header()->setStretchLastSection(true);
  const int letter = fontMetrics().horizontalAdvance('0');
  const int widths[] = {44, 10, 12, 8, 12, 22, 9};
  for (int column = titleColumn; column < notesColumn; ++column)
    tree_->setColumnWidth(column, widths[column] * letter);
  connect(tree_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    if (seriesOf(item)) openCurrent();
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &DicomBrowser::showDetails);
}

void DicomBrowser::chooseFolder() {
  const QString start = index_->folder().isEmpty() ? lastFolder() : index_->folder();
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Search a folder or disc"), start);
  if (!folder.isEmpty()) index_->start(folder);
}

void DicomBrowser::restart() {
  preview_.reset();
  tree_->clear();
  groups_.clear();
  items_.clear();
  progress_->setValue(0);
  showDetails();
  showSummary();
}

const volume::DicomSeries* DicomBrowser::seriesOf(const QTreeWidgetItem* item) const {
  if (!item) return nullptr;
  const std::string uid = item->data(0, seriesRole).toString().toStdString();
  const auto& all = index_->series();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.series == uid; });
  return uid.empty() || found == all.end() ? nullptr : &*found;
}

void DicomBrowser::showSeries() {
  tree_->setSortingEnabled(false);
  for (const volume::DicomSeries& series : index_->series()) showOne(series);
  tree_->setSortingEnabled(true);
  filter();
  for (QTreeWidgetItemIterator item(tree_); *item && !tree_->currentItem(); ++item)
    if (seriesOf(*item)) tree_->setCurrentItem(*item);
  showDetails();
  showSummary();
}

// "anonymous 2": the number tells patients apart.
void DicomBrowser::showPatient(QTreeWidgetItem* item, const volume::DicomSeries& series) {
  const volume::Patient& patient = series.patient;
  QStringList parts;
  if (hide_->isChecked()) {
    parts += tr("anonymous %1").arg(item->data(0, pictureRole).toInt());
  } else {
    parts += patient.name.empty() ? tr("No name") : textOf(app::personText(patient.name));
    if (!patient.id.empty()) parts += tr("ID %1").arg(textOf(patient.id));
    if (!patient.birthDate.empty()) parts += tr("born %1").arg(textOf(app::dateText(patient.birthDate)));
  }
  item->setText(titleColumn, parts.join("   "));
}

QTreeWidgetItem* DicomBrowser::parentOf(const volume::DicomSeries& series) {
  QTreeWidgetItem*& patient = groups_[patientKey(series)];
  if (!patient) {
    patient = new SortedItem(tree_);
    patient->setData(0, pictureRole, tree_->topLevelItemCount());
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    patient->setFont(titleColumn, bold);
    patient->setFirstColumnSpanned(true);
    patient->setExpanded(true);
  }
  showPatient(patient, series);
  QTreeWidgetItem* const above = patient;
  QTreeWidgetItem*& study = groups_[patientKey(series) + '\n' + textOf(series.study)];
  if (!study) {
    study = new SortedItem(above);
    study->setFirstColumnSpanned(true);
    study->setExpanded(true);
  }
  std::string title = series.studyDescription.empty() ? tr("Study").toStdString() : series.studyDescription;
  if (hide_->isChecked()) title = app::withoutPatient(title, series.patient);
  study->setText(titleColumn, textOf(title) + "   " + textOf(app::dateText(series.studyDate)));
  return study;
}

void DicomBrowser::showOne(const volume::DicomSeries& series) {
  QTreeWidgetItem* const parent = parentOf(series);
  QTreeWidgetItem*& item = items_[textOf(series.series)];
  if (!item) {
    item = new SortedItem(parent);
    item->setData(0, seriesRole, textOf(series.series));
    item->setIcon(titleColumn, emptyPicture(devicePixelRatioF()));
  }
  std::string title = app::titleOf(series);
  if (hide_->isChecked()) title = app::withoutPatient(title, series.patient);
  item->setText(titleColumn, textOf(title));
  item->setText(modalityColumn, textOf(series.modality));
  item->setText(dateColumn, textOf(app::dateText(series.date)));
  item->setText(slicesColumn, textOf(app::slicesText(series)));
  item->setData(slicesColumn, sortRole, static_cast<double>(series.slices * series.timeSteps));
  item->setText(sizeColumn, textOf(app::sizeText(series)));
  item->setData(sizeColumn, sortRole, static_cast<double>(series.columns * series.rows));
  item->setText(spacingColumn, textOf(app::spacingText(series)));
  item->setData(spacingColumn, sortRole, series.spacingMm.x * series.spacingMm.y * series.spacingMm.z);
  item->setText(kernelColumn, textOf(series.kernel));
  QStringList notes;
  for (const std::string& note : app::shortWarnings(series)) notes += textOf(note);
  item->setText(notesColumn, notes.join(", "));
  item->setToolTip(notesColumn, notes.join('\n'));
  item->setForeground(notesColumn, series.problem.empty() ? colours.warning : colours.error);
}

void DicomBrowser::filter() {
  const std::string wanted = search_->text().toStdString();
  for (QTreeWidgetItem* group : std::as_const(groups_)) group->setHidden(true);
  for (const volume::DicomSeries& series : index_->series()) {
    QTreeWidgetItem* const item = items_.value(textOf(series.series));
    if (!item) continue;
    const bool found = app::matches(series, wanted, hide_->isChecked());
    item->setHidden(!found);
    if (!found) continue;
    item->parent()->setHidden(false);
    item->parent()->parent()->setHidden(false);
  }
}

void DicomBrowser::showDetails() {
  const volume::DicomSeries* const series = seriesOf(tree_->currentItem());
  open_->setEnabled(series && series->problem.empty());
  QStringList lines;
  if (series) {
    if (!series->problem.empty()) lines += tr("Cannot be opened: %1").arg(textOf(series->problem));
    for (const std::string& warning : series->warnings) lines += textOf(warning);
    if (lines.isEmpty()) lines += tr("Evenly spaced slices; no warnings.");
  }
  QString text = lines.join('\n');
  if (series && hide_->isChecked()) text = textOf(app::withoutPatient(text.toStdString(), series->patient));
  details_->setText(text);
}

void DicomBrowser::showSummary() {
  const bool running = index_->running();
  progress_->setVisible(running);
  stop_->setVisible(running);
  QString folder = index_->folder();
  if (hide_->isChecked() && !folder.isEmpty()) folder = tr("(folder hidden)");
  folder_->setText(folder_->fontMetrics().elidedText(folder, Qt::ElideMiddle, 360));
  folder_->setToolTip(hide_->isChecked() ? QString() : index_->folder());
  QStringList parts;
  const int patients = tree_->topLevelItemCount();
  if (!items_.isEmpty())
    parts += tr("%1 series of %2 patients").arg(items_.size()).arg(patients);
  else if (index_->folder().isEmpty())
    parts += tr("Choose a folder or disc with DICOM files.");
  else if (!running && index_->problem().isEmpty())
    parts += tr("No DICOM images in this folder.");
  if (running) parts += tr("search in progress");
  if (!index_->problem().isEmpty())
    parts += hide_->isChecked() ? tr("some could not be read") : index_->problem();
  const volume::DicomIndexEnd& end = index_->end();
  if (end.unreadable > 0) parts += tr("%1 of %2 files could not be read").arg(end.unreadable).arg(end.files);
  summary_->setText(parts.join(tr("; ")));
  summary_->setToolTip(hide_->isChecked() ? QString() : textOf(end.firstReason));
}

void DicomBrowser::openCurrent() {
  const volume::DicomSeries* const series = seriesOf(tree_->currentItem());
  if (!series || !series->problem.empty()) return;
  const QString folder = textOf(series->folder), uid = textOf(series->series);
  accept();
  Q_EMIT chosen(folder, uid);
}

// Small pictures, of what is visible only

QTreeWidgetItem* DicomBrowser::withoutPicture() const {
  const QRect area = tree_->viewport()->rect();
  for (QTreeWidgetItem* item = tree_->itemAt(2, 2); item; item = tree_->itemBelow(item)) {
    if (tree_->visualItemRect(item).top() > area.bottom()) break;
    const volume::DicomSeries* const series = seriesOf(item);
    if (!series || series->middleFile.empty()) continue;
    const QString made = item->data(0, pictureRole).toString();
    // While files are still being found the middle moves: the picture follows at the end.
    if (made.isEmpty() || (!index_->running() && made != textOf(series->middleFile))) return item;
  }
  return nullptr;
}

void DicomBrowser::drawPictures() {
  if (!isVisible() || preview_) return;
  QTreeWidgetItem* const item = withoutPicture();
  const volume::DicomSeries* const series = seriesOf(item);
  if (!series) return;
  const QString key = textOf(series->series), file = textOf(series->middleFile);
  preview_.watch(app::previewTask(series->middleFile, series->middleFrame), [this, key, file](auto& task) {
    QTreeWidgetItem* const of = items_.value(key);
    if (of == nullptr) return;
    of->setData(0, pictureRole, file);
    // No picture if it failed: opening the series says why.
    if (!task.error() && task.value().width > 0)
      of->setIcon(titleColumn, pictureOf(task.value(), devicePixelRatioF()));
  });
}

}  // namespace isolux::ui
