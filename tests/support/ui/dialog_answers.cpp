#include "tests/support/ui/dialog_answers.h"

#include <utility>

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "ui/dialogs/picture_dialog.h"

namespace isolux::test {

DialogAnswers::DialogAnswers(QMessageBox::StandardButton button, const QString& file)
    : button_(button), file_(file) {
  timer_.setInterval(10);
  connect(&timer_, &QTimer::timeout, this, &DialogAnswers::answer);
  timer_.start();
}

void DialogAnswers::answer() {
  // Afresh: a timer is silent while its own signal is handled, and an answer can lead to the next question.
  timer_.start();
  QWidget* dialog = QApplication::activeModalWidget();
  if (auto* question = qobject_cast<QMessageBox*>(dialog)) {
    lastText_ = question->text();
    const bool overwrites = qobject_cast<QFileDialog*>(question->parentWidget()) != nullptr;
    ++(overwrites ? overwriteQuestions_ : questions_);
    QAbstractButton* button = question->button(button_);
    if (overwrites) button = question->button(QMessageBox::No);
    if (button == nullptr) return question->reject();
    QTest::mouseClick(button, Qt::LeftButton);
  } else if (auto* picture = qobject_cast<ui::PictureDialog*>(dialog)) {
    QTest::mouseClick(picture->save, Qt::LeftButton);
  } else if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
    auto* name = files->findChild<QLineEdit*>("fileNameEdit");
    proposal_ = name->text();
    folder_ = files->directory().absolutePath();
    if (file_.isEmpty()) return files->reject();
    name->setText(std::exchange(file_, QString()));  // once: a refused name is not tried for ever
    QTest::keyClick(name, Qt::Key_Return);
  }
}

}  // namespace isolux::test
