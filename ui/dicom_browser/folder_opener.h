// From a folder to what is opened of it: the only DICOM series there, the one that the user chooses among
// several, or, where there is none, the folder itself.
#pragma once

#include <functional>

#include <QObject>
#include <QPointer>
#include <QString>

namespace isolux::ui {

class DicomBrowser;
class SeriesIndex;

class FolderOpener : public QObject {
  Q_OBJECT
 public:
  // Series empty: what opening the folder takes by itself.
  using Open = std::function<void(const QString& folder, const QString& series)>;
  FolderOpener(QWidget* window, Open open);  // `open`: what the browser's menu entry does with a choice

  // Looks through the folder beside the window's work, then calls `open`; nothing where the user cancels.
  void look(const QString& folder, Open open);
  void cancel();
  void browse();  // shows the browser with what was looked through last

  SeriesIndex* index() const { return index_; }
  DicomBrowser* browser() const;  // null: not shown

 Q_SIGNALS:
  void started(const QString& name);
  void progressed(double fraction);
  void ended();  // no more progress: the browser is there, or the folder is opened
  void privacyChanged();

 private:
  void found();
  void finish();
  void endLooking();

  QWidget* window_;
  Open openChosen_, open_;
  SeriesIndex* index_;
  QPointer<DicomBrowser> browser_;
  QString folder_;
  bool looking_ = false;  // for somebody who waits, not for an open browser
};

}  // namespace isolux::ui
