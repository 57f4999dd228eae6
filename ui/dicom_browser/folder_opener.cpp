#include "ui/dicom_browser/folder_opener.h"

#include <utility>

#include <QFileInfo>
#include <QWidget>

#include "ui/dicom_browser/dicom_browser.h"
#include "ui/dicom_browser/series_index.h"

namespace isolux::ui {

FolderOpener::FolderOpener(QWidget* window, Open open)
    : QObject(window), window_(window), openChosen_(std::move(open)), index_(new SeriesIndex(this)) {
  connect(index_, &SeriesIndex::changed, this, &FolderOpener::found);
  connect(index_, &SeriesIndex::ended, this, &FolderOpener::finish);
  connect(index_, &SeriesIndex::progressed, this, [this](double fraction) {
    if (looking_) Q_EMIT progressed(fraction);
  });
}

DicomBrowser* FolderOpener::browser() const {
  return browser_;
}

void FolderOpener::look(const QString& folder, Open open) {
  if (browser_) browser_->close();
  folder_ = folder;
  open_ = std::move(open);
  looking_ = true;
  Q_EMIT started(QFileInfo(folder).fileName());
  index_->start(folder);
}

void FolderOpener::endLooking() {
  if (std::exchange(looking_, false)) Q_EMIT ended();
}

void FolderOpener::cancel() {
  if (!looking_) return;
  index_->stop();
  endLooking();
}

// A second series: whoever opens the folder has to choose.
void FolderOpener::found() {
  if (!looking_ || index_->series().size() < 2) return;
  endLooking();
  Open open = std::exchange(open_, {});
  browse();
  disconnect(browser_, &DicomBrowser::chosen, this, nullptr);
  connect(browser_, &DicomBrowser::chosen, this, open);
}

void FolderOpener::finish() {
  if (!looking_) return;
  endLooking();
  const Open open = std::exchange(open_, {});
  if (open) open(folder_, {});
}

void FolderOpener::browse() {
  if (!browser_) {
    browser_ = new DicomBrowser(index_, window_);
    browser_->setAttribute(Qt::WA_DeleteOnClose);
    connect(browser_, &DicomBrowser::privacyChanged, this, &FolderOpener::privacyChanged);
    connect(browser_, &DicomBrowser::chosen, this,
            [this](const QString& folder, const QString& series) { openChosen_(folder, series); });
    connect(browser_, &QDialog::finished, this, [this] {
      index_->stop();
      browser_ = nullptr;  // it deletes itself
    });
  }
  browser_->show();
  browser_->raise();
  browser_->activateWindow();
}

}  // namespace isolux::ui
