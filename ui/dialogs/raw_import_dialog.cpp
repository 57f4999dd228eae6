#include "ui/dialogs/raw_import_dialog.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include "base/quantiles.h"
#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/parts.h"
#include "volume/read/input/convert.h"

namespace isolux::ui {

namespace {
using volume::Endianness;
using volume::RawDescription;
using volume::VoxelType;

constexpr std::array<VoxelType, 10> types{
    VoxelType::uint8, VoxelType::int8,   VoxelType::uint16, VoxelType::int16,   VoxelType::uint32,
    VoxelType::int32, VoxelType::uint64, VoxelType::int64,  VoxelType::float32, VoxelType::float64};

QString typeName(VoxelType type) {
  return QString::fromUtf8(volume::nameOf(type));
}

QString guessText(const RawDescription& guess) {
  QString text = QString("%1 × %2 × %3  %4")
                     .arg(guess.dims.x)
                     .arg(guess.dims.y)
                     .arg(guess.dims.z)
                     .arg(typeName(guess.type));
  if (volume::bytesOf(guess.type) > 1 && guess.endianness == Endianness::big)
    text += QObject::tr(" big endian");
  if (guess.headerBytes > 0) text += QObject::tr(", header %1 bytes").arg(guess.headerBytes);
  return text;
}

template <class Box>
QLayout* inARow(const std::array<Box*, 3>& boxes) {
  return lineOf({{boxes[0], 1}, new QLabel("×"), {boxes[1], 1}, new QLabel("×"), {boxes[2], 1}}, 5);
}
}  // namespace

template <class T>
double decode(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swap) std::reverse(copy.begin(), copy.end());
  return static_cast<double>(std::bit_cast<T>(copy));
}

double decodeVoxel(const char* bytes, VoxelType type, bool swap) {
  return volume::withType(type, [&](auto zero) { return decode<decltype(zero)>(bytes, swap); });
}

// Values at the given fractions of the sorted finite values.
std::pair<double, double> percentiles(std::vector<double> values, double low, double high) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return {0.0, 1.0};
  double a = base::lowerQuantile(values, low), b = base::lowerQuantile(values, high);
  if (!(b > a)) {  // few bright voxels in a constant slice: the whole range
    a = *std::min_element(values.begin(), values.end());
    b = *std::max_element(values.begin(), values.end());
  }
  return {a, b > a ? b : a + 1.0};
}

// A grey picture of one slice, shown as large as fits with the slice's true proportions.
class SlicePreview : public QWidget {
 public:
  explicit SlicePreview(QWidget* parent) : QWidget(parent) { setMinimumSize(260, 260); }

  // aspect: width / height of the slice in mm. A null image shows `text` instead.
  void showSlice(const QImage& image, double aspect, const QString& text) {
    image_ = image;
    aspect_ = std::clamp(aspect, 0.02, 50.0);
    text_ = text;
    update();
  }
  const QImage& image() const { return image_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (image_.isNull()) {
      painter.setPen(colours.quietText);
      painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, text_);
    } else {
      QSizeF size(width(), width() / aspect_);
      if (size.height() > height()) size = {height() * aspect_, static_cast<double>(height())};
      QRectF target(QPointF(), size);
      target.moveCenter(QRectF(rect()).center());
      const bool enlarged = size.width() > image_.width();  // enlarged voxels stay voxels
      painter.setRenderHint(QPainter::SmoothPixmapTransform, !enlarged);
      painter.drawImage(target, image_);
    }
    painter.setPen(colours.border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  QSize sizeHint() const override { return {380, 380}; }

 private:
  QImage image_;
  double aspect_ = 1.0;
  QString text_;
};

std::optional<QImage> rawSlice(const QString& path, const RawDescription& description, int z,
                               int longestSide) {
  const glm::ivec3 dims = description.dims;
  if (dims.x < 1 || dims.y < 1 || z < 0 || z >= dims.z || longestSide < 1) return std::nullopt;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;

  const auto voxelBytes = static_cast<qint64>(volume::bytesOf(description.type));
  const qint64 rowBytes = voxelBytes * dims.x;
  constexpr qint64 readBudget = 64 << 20;
  const qint64 rows = std::clamp<qint64>(readBudget / rowBytes, 1, std::min(dims.y, longestSide));
  const qint64 columns = std::min(dims.x, longestSide);
  const bool swap =
      (description.endianness == volume::Endianness::big) == (std::endian::native == std::endian::little);

  std::vector<double> values(static_cast<std::size_t>(rows * columns),
                             std::numeric_limits<double>::quiet_NaN());
  QByteArray row(rowBytes, '\0');
  const auto start = static_cast<long double>(description.headerBytes) +
                     static_cast<long double>(z) * static_cast<long double>(rowBytes) * dims.y;
  if (start + static_cast<long double>(rowBytes) * dims.y > static_cast<long double>(file.size()))
    return std::nullopt;
  for (qint64 r = 0; r < rows; ++r) {
    const qint64 y = r * dims.y / rows;
    if (!file.seek(static_cast<qint64>(start) + y * rowBytes)) return std::nullopt;
    if (file.read(row.data(), rowBytes) != rowBytes) return std::nullopt;
    for (qint64 c = 0; c < columns; ++c) {
      const qint64 x = c * dims.x / columns;
      values[static_cast<std::size_t>(r * columns + c)] =
          decodeVoxel(row.constData() + x * voxelBytes, description.type, swap);
    }
  }

  const auto [black, white] = percentiles(values, 0.01, 0.99);
  QImage image(static_cast<int>(columns), static_cast<int>(rows), QImage::Format_RGB32);
  for (qint64 r = 0; r < rows; ++r) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(static_cast<int>(r)));
    for (qint64 c = 0; c < columns; ++c) {
      const double value = values[static_cast<std::size_t>(r * columns + c)];
      if (!std::isfinite(value)) {
        line[c] = qRgb(110, 20, 20);
        continue;
      }
      const int grey =
          static_cast<int>(std::lround(std::clamp((value - black) / (white - black), 0.0, 1.0) * 255.0));
      line[c] = qRgb(grey, grey, grey);
    }
  }
  return image;
}

RawImportDialog::RawImportDialog(const QString& file, QWidget* parent)
    : QDialog(parent),
      file_(file),
      fileBytes_(static_cast<std::uint64_t>(QFileInfo(file).size())),
      suggestions_(new QComboBox(this)),
      type_(new QComboBox(this)),
      endianness_(new QComboBox(this)),
      header_(new QSpinBox(this)),
      size_(wrappedLabel({}, this)),
      sliceLabel_(new QLabel(this)),
      preview_(new SlicePreview(this)),
      slice_(new QSlider(Qt::Horizontal, this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)),
      guesses_(volume::guessRaw(QFileInfo(file).fileName().toStdString(), fileBytes_)) {
  setWindowTitle(tr("Open raw file – %1").arg(QFileInfo(file).fileName()));
  auto* intro = wrappedLabel(tr("<b>%1</b> has no header that Isolux can read. How are its voxels stored?")
                                 .arg(QFileInfo(file).fileName().toHtmlEscaped()),
                             this);

  suggestions_->addItem(guesses_.empty() ? tr("no match by name or size") : tr("choose…"));
  for (const RawDescription& guess : guesses_) suggestions_->addItem(guessText(guess));
  suggestions_->setEnabled(!guesses_.empty());
  for (const VoxelType type : types) type_->addItem(typeName(type), static_cast<int>(type));
  endianness_->addItem(tr("little endian"), static_cast<int>(Endianness::little));
  endianness_->addItem(tr("big endian"), static_cast<int>(Endianness::big));
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    dims_[i] = new QSpinBox(this);
    dims_[i]->setRange(1, 65536);
    dims_[i]->setButtonSymbols(QAbstractSpinBox::NoButtons);
    dims_[i]->setAccessibleName(tr("Voxels along %1").arg(axes[i]));
    dims_[i]->setMinimumWidth(64);
    spacing_[i] = new NumberSpinBox(this);
    spacing_[i]->setRange(1e-6, 1e6);
    spacing_[i]->setValue(1.0);
    spacing_[i]->setAccessibleName(tr("Spacing along %1").arg(axes[i]));
    spacing_[i]->setMinimumWidth(64);
  }
  header_->setRange(0, 1 << 30);
  header_->setSuffix(' ' + tr("bytes"));
  header_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  size_->setMinimumHeight(2 * fontMetrics().height() + 4);
  size_->setAlignment(Qt::AlignLeft | Qt::AlignTop);

  auto* form = new QFormLayout;
  form->setVerticalSpacing(9);
  form->setHorizontalSpacing(14);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Suggestions"), suggestions_);
  form->addRow(tr("Voxels"), inARow(dims_));
  form->addRow(tr("Type"), type_);
  form->addRow(tr("Byte order"), endianness_);
  form->addRow(tr("Header"), header_);
  form->addRow(tr("Spacing, mm"), inARow(spacing_));
  form->addRow(tr("Size"), size_);
  sliceLabel_->setMinimumWidth(fontMetrics().horizontalAdvance(tr("slice 9999 of 9999")));
  auto* left = columnOf({intro, Cell::gap(8), form, Cell::room()});
  auto* right = columnOf({{preview_, 1}, lineOf({{slice_, 1}, sliceLabel_})});
  layOut(this, columnOf({{lineOf({left, {right, 1}}, 20), 1}, buttons_}, 14), {18, 16, 18, 14});
  resize(820, 500);

  previewTimer_.setSingleShot(true);
  connect(&previewTimer_, &QTimer::timeout, this, &RawImportDialog::showSlice);
  const auto changed = [this] { describedAnew(); };
  for (QSpinBox* box : dims_) connect(box, &QSpinBox::valueChanged, this, changed);
  for (NumberSpinBox* box : spacing_) connect(box, &NumberSpinBox::valueChanged, this, changed);
  connect(header_, &QSpinBox::valueChanged, this, changed);
  connect(type_, &QComboBox::currentIndexChanged, this, changed);
  connect(endianness_, &QComboBox::currentIndexChanged, this, changed);
  connect(slice_, &QSlider::valueChanged, this, [this] { previewTimer_.start(0); });
  connect(suggestions_, &QComboBox::activated, this, [this](int index) {
    if (index > 0) setDescription(guesses_[static_cast<std::size_t>(index - 1)]);
  });
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);

  if (guesses_.empty()) {
    setDescription({.dims = glm::ivec3(64)});
  } else {
    suggestions_->setCurrentIndex(1);
    setDescription(guesses_.front());
  }
}

RawDescription RawImportDialog::description() const {
  RawDescription result;
  result.dims = {dims_[0]->value(), dims_[1]->value(), dims_[2]->value()};
  result.type = static_cast<VoxelType>(type_->currentData().toInt());
  result.endianness = static_cast<Endianness>(endianness_->currentData().toInt());
  result.spacingMm = {spacing_[0]->value(), spacing_[1]->value(), spacing_[2]->value()};
  result.headerBytes = static_cast<std::size_t>(header_->value());
  return result;
}

void RawImportDialog::setDescription(const RawDescription& description) {
  {
    const QSignalBlocker blockType(type_), blockEndianness(endianness_), blockHeader(header_);
    for (std::size_t i = 0; i < 3; ++i) {
      const QSignalBlocker blockDims(dims_[i]);
      dims_[i]->setValue(description.dims[static_cast<int>(i)]);
      spacing_[i]->showValue(description.spacingMm[static_cast<int>(i)]);
    }
    type_->setCurrentIndex(type_->findData(static_cast<int>(description.type)));
    endianness_->setCurrentIndex(endianness_->findData(static_cast<int>(description.endianness)));
    header_->setValue(static_cast<int>(std::min<std::size_t>(description.headerBytes, 1 << 30)));
  }
  slice_->setRange(0, description.dims.z - 1);
  slice_->setValue(description.dims.z / 2);
  describedAnew();
}

bool RawImportDialog::fits() const {
  return bytesNeeded(description()) <= fileBytes_;
}

const QImage& RawImportDialog::previewImage() const {
  return preview_->image();
}

void RawImportDialog::describedAnew() {
  const RawDescription described = description();
  const std::uint64_t needed = bytesNeeded(described);
  QString text = tr("%1 bytes described, the file has %2.").arg(groupedText(needed), groupedText(fileBytes_));
  Ink ink = Ink::quiet;
  if (needed == fileBytes_) {
    text += ' ' + tr("They match.");
    ink = Ink::good;
  } else if (needed < fileBytes_) {
    text += ' ' + tr("The last %1 would be ignored.").arg(groupedText(fileBytes_ - needed));
    ink = Ink::warning;
  } else {
    text += ' ' + tr("%1 are missing.").arg(groupedText(needed - fileBytes_));
    ink = Ink::error;
  }
  size_->setText(text);
  setInk(size_, ink);
  buttons_->button(QDialogButtonBox::Open)->setEnabled(fits());
  endianness_->setEnabled(volume::bytesOf(described.type) > 1);
  slice_->setRange(0, described.dims.z - 1);
  previewTimer_.start(0);  // one preview for a burst of changes
}

void RawImportDialog::showSlice() {
  const RawDescription described = description();
  const int z = slice_->value();
  sliceLabel_->setText(tr("slice %1 of %2").arg(z + 1).arg(described.dims.z));
  const auto image = rawSlice(file_, described, z, 512);
  const double aspect =
      described.dims.x * described.spacingMm.x / std::max(1e-12, described.dims.y * described.spacingMm.y);
  preview_->showSlice(image.value_or(QImage()), aspect, tr("This slice is beyond the end of the file."));
}

}  // namespace isolux::ui
