// Patients, studies and series of a DICOM folder or disc, with a small picture of each series, to choose
// from.
#pragma once

#include <QDialog>
#include <QHash>
#include <QTimer>

#include "app/browser/index_job.h"
#include "ui/document/background_task.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace isolux::ui {

class SeriesIndex;

class DicomBrowser : public QDialog {
  Q_OBJECT
 public:
  // Shows what `index` holds, and finds; it must outlive the dialog.
  DicomBrowser(SeriesIndex* index, QWidget* parent);
  QPushButton* openButton() const { return open_; }
  QPushButton* stopButton() const { return stop_; }
  QLabel* details() const { return details_; }
  QLabel* summary() const { return summary_; }
  // The item of a series; null: it is not there.
  QTreeWidgetItem* itemOf(const QString& series) const { return items_.value(series); }
  // No small picture of a visible series is missing.
  bool picturesComplete() const { return !preview_ && !withoutPicture(); }

 Q_SIGNALS:
  void chosen(const QString& folder, const QString& series);
  void privacyChanged();

 private:
  void makeTree();
  void chooseFolder();
  void restart();
  void showSeries();
  void showOne(const volume::DicomSeries& series);
  QTreeWidgetItem* parentOf(const volume::DicomSeries& series);
  void showPatient(QTreeWidgetItem* item, const volume::DicomSeries& series);
  void filter();
  void showDetails();
  void showSummary();
  void openCurrent();
  const volume::DicomSeries* seriesOf(const QTreeWidgetItem* item) const;
  QTreeWidgetItem* withoutPicture() const;
  void drawPictures();

  SeriesIndex* index_;
  QLabel* folder_;
  QLineEdit* search_;
  QCheckBox* hide_;
  QTreeWidget* tree_;
  QLabel *details_, *summary_;
  QProgressBar* progress_;
  QPushButton *stop_, *open_;
  QHash<QString, QTreeWidgetItem*> groups_, items_;  // by keys of patients and studies; by series UID
  BackgroundTask<volume::DecodedImage> preview_;
  QTimer pictureTimer_;
};

}  // namespace isolux::ui
