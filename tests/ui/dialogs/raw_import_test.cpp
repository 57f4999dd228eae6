// Files without a header: guesses from name and size, the slice preview, and the dialog on the way to a
// volume.
#include "tests/support/ui/window_fixture.h"

#include <fstream>
#include <vector>

#include <QDialogButtonBox>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "tests/support/test_data.h"
#include "ui/dialogs/raw_import_dialog.h"

namespace isolux::test {

namespace {

using volume::Endianness;
using volume::VoxelType;

// 20 x 30 x 10 uint16, big endian, after `header` bytes: brighter with x, and from slice 5 on with y.
QString writeRamp(const std::string& name, std::size_t header = 0) {
  const std::filesystem::path file = temporaryFolder() / name;
  std::vector<char> bytes(header, '\x7f');
  for (int z = 0; z < 10; ++z) {
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 20; ++x) {
        const int value = 1000 + 100 * (z < 5 ? x : y);
        bytes.push_back(static_cast<char>(value >> 8));
        bytes.push_back(static_cast<char>(value & 0xff));
      }
    }
  }
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return QString::fromStdString(file.string());
}

QPushButton* openButton(const QDialog* dialog) {
  return dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
}

}  // namespace

TEST(RawSlice, DecodesByteOrderHeaderAndSlice) {
  const QString file = writeRamp("ramp.raw", 37);
  volume::RawDescription right{{20, 30, 10}, VoxelType::uint16, Endianness::big, glm::dvec3(1.0), 37};
  const auto first = ui::rawSlice(file, right, 0, 512), last = ui::rawSlice(file, right, 9, 512);
  ASSERT_TRUE(first && last);
  EXPECT_EQ(first->size(), QSize(20, 30));
  for (int x = 2; x < 18; ++x) EXPECT_LT(qGray(first->pixel(x, 7)), qGray(first->pixel(x + 1, 7)));
  EXPECT_EQ(first->pixel(9, 3), first->pixel(9, 28));
  for (int y = 2; y < 28; ++y) EXPECT_LT(qGray(last->pixel(7, y)), qGray(last->pixel(7, y + 1)));
  volume::RawDescription wrong = right;
  wrong.endianness = Endianness::little;
  EXPECT_NE(*ui::rawSlice(file, wrong, 0, 512), *first);
  EXPECT_FALSE(ui::rawSlice(file, right, 10, 512));
  wrong = right;
  wrong.dims.y = 31;
  EXPECT_FALSE(ui::rawSlice(file, wrong, 9, 512));  // beyond the end of the file
  EXPECT_EQ(ui::rawSlice(file, right, 0, 10)->size(), QSize(10, 10));
}

TEST(RawImportDialog, ShowsTheSliceAndRefusesWhatDoesNotFit) {
  ui::RawImportDialog dialog(writeRamp("ramp_20x30x10_uint16_be.raw"));
  dialog.show();
  ASSERT_TRUE(waitUntil([&] { return !dialog.previewImage().isNull(); }));
  EXPECT_EQ(dialog.description().dims, glm::ivec3(20, 30, 10));
  EXPECT_TRUE(openButton(&dialog)->isEnabled());
  EXPECT_TRUE(dialog.sizeText().contains("match"));
  dialog.findChild<QSlider*>()->setValue(0);
  const QImage before = dialog.previewImage();
  ASSERT_TRUE(waitUntil([&] { return dialog.previewImage() != before; }));
  EXPECT_LT(qGray(dialog.previewImage().pixel(3, 3)), qGray(dialog.previewImage().pixel(15, 3)));

  volume::RawDescription tooLarge = dialog.description();
  tooLarge.dims.z = 11;
  dialog.setDescription(tooLarge);
  EXPECT_FALSE(openButton(&dialog)->isEnabled());
  EXPECT_TRUE(dialog.sizeText().contains("missing")) << dialog.sizeText().toStdString();
  tooLarge.dims.z = 9;
  dialog.setDescription(tooLarge);
  EXPECT_TRUE(openButton(&dialog)->isEnabled());
  EXPECT_TRUE(dialog.sizeText().contains("ignored"));
}

TEST_F(WindowTest, ARawFileIsAskedForAndOpened) {
  const QString file = writeRamp("ramp_20x30x10_uint16_be.raw");
  window_->openPath(file);
  auto* dialog = window_->findChild<ui::RawImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  QTest::mouseClick(openButton(dialog), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
  const volume::Grid& grid = window_->document()->volume()->grid();
  EXPECT_EQ(grid.dims(), glm::ivec3(20, 30, 10));
  EXPECT_EQ(grid.value(3, 0, 0), 1300.0);
  EXPECT_EQ(grid.value(3, 7, 9), 1700.0);
  EXPECT_FALSE(window_->document()->scene().source.raw.empty());  // the session can open it again
}

}  // namespace isolux::test
