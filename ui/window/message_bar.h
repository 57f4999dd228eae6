// What went wrong, is worth knowing or is asked, over the top of the picture. Blocks nothing, can be closed,
// and changes no one's size: it lies over its parent, as wide as that is.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QFrame>
#include <QTimer>

#include "ui/widgets/wrapped_text.h"

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace isolux::ui {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { note, warning, error, question };
  // A button beside the text. A click closes the message, then calls `chosen`.
  struct Answer {
    QString text;
    std::function<void()> chosen;
  };
  explicit MessageBar(QWidget* parent);

  // Replaces what is shown. A note goes away by itself, an error stays until it is closed or replaced. A
  // warning (data that are missing or invented) and a question wait until they are answered or closed: what
  // comes meanwhile covers them while it lasts.
  void show(Kind kind, const QString& text, std::vector<Answer> answers = {});
  void showNote(const QString& text) { show(Kind::note, text); }
  void showError(const QString& text) { show(Kind::error, text); }
  // What each text becomes before it is shown.
  void setFilter(std::function<QString(const QString&)> filter) { filter_ = std::move(filter); }
  void clear();              // what is shown; what waits is shown again, a question before a warning
  void withdraw(Kind kind);  // what is shown or waits of that kind
  QString text() const { return label_->text(); }
  Kind kind() const { return shown_.kind; }
  // Of what is shown, in the order of its answers.
  const std::vector<QPushButton*>& buttons() const { return buttons_; }

 Q_SIGNALS:
  void heightTaken(int pixels);  // of the parent's top; 0: hidden

 protected:
  bool eventFilter(QObject* parent, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Message {
    Kind kind = Kind::note;
    QString text;
    std::vector<Answer> answers;
  };
  void present(Message message);
  void dress();
  void makeButtons();
  void close() { withdraw(shown_.kind); }  // what is shown, for good
  void place();

  QLabel* symbol_;
  WrappedText* label_;
  QHBoxLayout* layout_;
  std::vector<QPushButton*> buttons_;
  Message shown_;
  std::optional<Message> question_, warning_;  // that wait
  QTimer timer_;
  std::function<QString(const QString&)> filter_;
};

}  // namespace isolux::ui
