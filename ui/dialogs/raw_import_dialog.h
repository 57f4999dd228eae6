// Asks how a file without a header is laid out, and shows at once what a slice looks like that way.
#pragma once

#include <array>

#include <QDialog>
#include <QTimer>

#include "volume/read/raw_guess.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace isolux::ui {

class NumberSpinBox;
class SlicePreview;

class RawImportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RawImportDialog(const QString& file, QWidget* parent = nullptr);

  volume::RawDescription description() const;
  void setDescription(const volume::RawDescription& description);
  bool fits() const;         // the file holds exactly or more than what is described
  QString sizeText() const;  // expected against actual bytes
  const QImage& previewImage() const;

 private:
  void describedAnew();
  void showSlice();

  QString file_;
  std::uint64_t fileBytes_;
  QComboBox *suggestions_, *type_, *endianness_;
  std::array<QSpinBox*, 3> dims_{};
  std::array<NumberSpinBox*, 3> spacing_{};
  QSpinBox* header_;
  QLabel *size_, *sliceLabel_;
  SlicePreview* preview_;
  QSlider* slice_;
  QDialogButtonBox* buttons_;
  QTimer previewTimer_;
  std::vector<volume::RawDescription> guesses_;
};

}  // namespace isolux::ui
