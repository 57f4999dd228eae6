// One line above the picture for what went wrong or is worth knowing. Blocks nothing and can be closed.
#pragma once

#include <QFrame>
#include <QTimer>

class QLabel;

namespace isolux::ui {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { note, error };
  explicit MessageBar(QWidget* parent = nullptr);

  // Replaces what is shown. A note goes away by itself, an error stays until it is closed or replaced.
  void show(Kind kind, const QString& text);
  void clear();
  QString text() const;
  Kind kind() const { return kind_; }

 private:
  QLabel *symbol_, *label_;
  Kind kind_ = Kind::note;
  QTimer timer_;
};

}  // namespace isolux::ui
