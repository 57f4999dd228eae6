// Answers the dialogs that the window opens while a test waits in them.
#pragma once

#include <functional>

#include <QMessageBox>
#include <QObject>
#include <QString>
#include <QTimer>

namespace isolux::test {

// From its making on: clicks `button` in each question, Save where a picture's size is asked for, and gives
// `file` to each dialog that asks for a name.
class DialogAnswers : public QObject {
 public:
  explicit DialogAnswers(QMessageBox::StandardButton button, const QString& file = {});

  int questions() const { return questions_; }  // that were asked
  int overwriteQuestions() const { return overwriteQuestions_; }
  const QString& lastText() const { return lastText_; }  // of the last question
  const QString& proposal() const { return proposal_; }  // the name that the last file dialog proposed
  const QString& folder() const { return folder_; }      // and where

 private:
  void answer();

  QMessageBox::StandardButton button_;
  QString file_, lastText_, proposal_, folder_;
  int questions_ = 0, overwriteQuestions_ = 0;
  QTimer timer_;
};

}  // namespace isolux::test
