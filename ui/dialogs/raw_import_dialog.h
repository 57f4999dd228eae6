// Asks how a file without a header is laid out, and shows at once what a slice looks like that way.
#pragma once

#include <array>
#include <optional>

#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QTimer>

#include "volume/read/raw_guess.h"

class QComboBox;
class QDialogButtonBox;
class QSlider;
class QSpinBox;

namespace isolux::ui {

class NumberSpinBox;
class SlicePreview;

// Slice z of `file`, at most `longestSide` pixels wide and high (larger slices are thinned out), brightness
// from the 1st to the 99th percentile of the slice; missing voxels are shown dark red. Empty when the slice
// lies outside the file. Reads no more than the rows it shows.
std::optional<QImage> rawSlice(const QString& file, const volume::RawDescription& description, int z,
                               int longestSide);

class RawImportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RawImportDialog(const QString& file, QWidget* parent = nullptr);

  volume::RawDescription description() const;
  void setDescription(const volume::RawDescription& description);
  bool fits() const;                                  // the file holds exactly or more than what is described
  QString sizeText() const { return size_->text(); }  // expected against actual bytes
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
