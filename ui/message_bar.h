// One line above the picture for what went wrong, is worth knowing or is asked. Blocks nothing and can be
// closed.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QFrame>
#include <QTimer>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace isolux::ui {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { note, error, question };
  // A button beside the text. A click closes the message, then calls `chosen`.
  struct Answer {
    QString text;
    std::function<void()> chosen;
  };
  explicit MessageBar(QWidget* parent = nullptr);

  // Replaces the note or error that is shown. A note goes away by itself, an error stays until it is closed
  // or replaced. A question waits until it is answered or closed: notes and errors cover it while they last.
  void show(Kind kind, const QString& text, std::vector<Answer> answers = {});
  void clear();  // what is shown; a question that was covered is shown again
  QString text() const;
  Kind kind() const { return shown_.kind; }
  // Of what is shown, in the order of its answers.
  const std::vector<QPushButton*>& buttons() const { return buttons_; }

 private:
  struct Message {
    Kind kind = Kind::note;
    QString text;
    std::vector<Answer> answers;
  };
  void present(Message message);
  void makeButtons();
  void close();  // what is shown, for good

  QLabel *symbol_, *label_;
  QHBoxLayout* layout_;
  std::vector<QPushButton*> buttons_;
  Message shown_;
  std::optional<Message> question_;
  QTimer timer_;
};

}  // namespace isolux::ui
