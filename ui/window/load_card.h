// What is being loaded, how far it is, and a way to stop it: a card over the picture that blocks nothing.
#pragma once

#include <QFrame>
#include <QTimer>

#include "ui/editors/time_left.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace isolux::ui {

class LoadCard : public QFrame {
  Q_OBJECT
 public:
  explicit LoadCard(QWidget* parent);  // stays at the lower edge of `parent`

  void begin(const QString& name);  // shows itself only when the work takes noticeable time
  void report(double fraction, const QString& stage);
  void end();
  QPushButton* cancelButton() const { return cancel_; }

 Q_SIGNALS:
  void cancelled();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void place();
  QString name_;
  QLabel *title_, *stage_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  TimeLeft left_;
  QTimer delay_;
};

}  // namespace isolux::ui
