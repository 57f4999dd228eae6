// Shows the pages of the documentation that come with the program, offline; links lead from page to page.
#pragma once

#include <QDialog>
#include <QUrl>

class QTextBrowser;

namespace isolux::ui {

class GuideWindow : public QDialog {
  Q_OBJECT
 public:
  // Opens index.md of `folder`, which must not be empty.
  GuideWindow(const QString& folder, QWidget* parent);

 private:
  void follow(const QUrl& link);

  QTextBrowser* browser_;
};

}  // namespace isolux::ui
