// What was opened last, as a menu with a small picture of each, and as a row of pictures for a window without
// a volume.
#pragma once

#include <QFrame>
#include <QMenu>

#include "ui/document/recent_files.h"

class QHBoxLayout;

namespace isolux::ui {

// How an entry is called: without what names the patient where the user wants it so.
QString shownName(const RecentFile& file);

class RecentMenu : public QMenu {
  Q_OBJECT
 public:
  RecentMenu(const QString& title, QWidget* parent);
  void fill();  // anew, from the list

 Q_SIGNALS:
  void chosen(const isolux::ui::RecentFile& file);
};

// Shows itself at the lower edge of `parent`; hidden where there is nothing to show.
class RecentPictures : public QFrame {
  Q_OBJECT
 public:
  explicit RecentPictures(QWidget* parent);
  void fill();

 Q_SIGNALS:
  void chosen(const isolux::ui::RecentFile& file);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void place();
  QHBoxLayout* row_;
};

}  // namespace isolux::ui
