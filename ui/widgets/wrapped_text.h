// Plain text that may be selected and wraps anywhere where a word is too long: file names without a space do
// not widen what they stand in.
#pragma once

#include <QTextEdit>

namespace isolux::ui {

class WrappedText : public QTextEdit {
  Q_OBJECT
 public:
  explicit WrappedText(QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const { return toPlainText(); }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, fontMetrics().lineSpacing()}; }

 protected:
  void wheelEvent(QWheelEvent* event) override;  // scrolls what the text stands in
};

}  // namespace isolux::ui
