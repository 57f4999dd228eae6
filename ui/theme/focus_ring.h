// A ring about the control that has the focus of the keys, wherever that is and however the control is drawn.
//
// Only where keys have moved the focus: who clicks knows where he is.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace isolux::ui {

class FocusRing : public QObject {
  Q_OBJECT
 public:
  // Once, for all windows of the application, which owns it.
  static FocusRing* install();

  const QWidget* target() const { return target_; }  // null: none is shown
  const QWidget* ring() const { return ring_; }      // in the target's window

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  explicit FocusRing(QObject* parent) : QObject(parent) {}
  void follow(QWidget* widget);
  void place();

  QPointer<QWidget> target_, ring_;  // the ring goes with its window
};

}  // namespace isolux::ui
