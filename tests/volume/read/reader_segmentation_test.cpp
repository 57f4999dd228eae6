// DICOM segmentations, frame by frame; compare_readers.py compares whole files with pydicom.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/volume/read/dicom_file.h"
#include "tests/volume/read/reader_support.h"
#include "volume/labels/label_table.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using test::element;
using test::expectError;
using test::expectNear;
using test::readFile;
using test::sequence;
using test::us;
using test::valuesOf;

struct SegFrame {
  int segment = 1;
  std::string position, pixels;  // of bits: '0' and '1'; else bytes
};

struct SegFile {
  std::string type = "BINARY", sopClass = "66.4", distance = "2", spacing = "0.75\\0.5";
  int bits = 1;
  std::vector<int> segments{1, 2};
  std::vector<SegFrame> frames{
      {1, "0\\0\\0", "111000"}, {1, "0\\0\\2", "101010"}, {2, "0\\0\\2", "010000"}, {2, "0\\0\\6", "000001"}};
  std::vector<std::string> more;

  std::string pixels() const {
    std::string all, packed;
    for (const SegFrame& frame : frames) all += frame.pixels;
    if (bits > 1) return all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % 8 == 0) packed += '\0';
      if (all[i] == '1') packed.back() = static_cast<char>(packed.back() | 1 << (i % 8));
    }
    return packed;
  }

  fs::path write() const {
    test::DicomSlice s;
    s.modality = "SEG";
    s.description = "organs";
    s.patient = "Doe^Jane";
    s.sopClass = "1.2.840.10008.5.1.4.1.1." + sopClass;
    s.position = s.spacing = s.thickness = s.slope = "";
    s.bits = bits;
    s.frames = static_cast<int>(frames.size());
    s.pixels = pixels();
    std::vector<std::string> listed, places;
    for (const int segment : segments)
      listed.push_back(element(0x62, 4, "US", us(segment)) +
                       element(0x62, 5, "LO", "organ " + std::to_string(segment)));
    for (const SegFrame& frame : frames) {
      std::string item;
      if (!frame.position.empty())
        item += sequence(0x20, 0x9113, {element(0x20, 0x32, "DS", frame.position)});
      if (type != "LABELMAP") item += sequence(0x62, 0xa, {element(0x62, 0xb, "US", us(frame.segment))});
      places.push_back(item);
    }
    std::string measures;
    if (!distance.empty()) measures += element(0x18, 0x88, "DS", distance);
    if (!spacing.empty()) measures += element(0x28, 0x30, "DS", spacing);
    s.more = {element(0x62, 1, "CS", type), sequence(0x62, 2, listed), element(0x62, 0xe, "US", us(200)),
              sequence(0x5200, 0x9229,
                       {sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")}) +
                        sequence(0x28, 0x9110, {measures})}),
              sequence(0x5200, 0x9230, places)};
    s.more.insert(s.more.end(), more.begin(), more.end());
    const fs::path path = test::temporaryFolder() / "seg.dcm";
    test::writeFile(path, test::dicom(s));
    return path;
  }
};

std::shared_ptr<const volume::PreparedVolume> load(const fs::path& path) {
  scene::Source source;
  source.path = path.string();
  base::Progress progress;
  return volume::loadVolume(source, progress);
}

TEST(DicomSegmentations, FramesLieWhereTheySayAndGapsAreEmpty) {
  const fs::path path = SegFile().write();
  const auto v = readFile(path);
  EXPECT_EQ(v.format, "DICOM SEG");
  EXPECT_EQ(v.name, "organs");
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 4));
  EXPECT_EQ(valuesOf(v),
            (std::vector<double>{1, 1, 1, 0, 0, 0, 1, 2, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2}));
  expectNear(test::worldOf(v, 1, 1, 3), {0.5, 0.75, 6});
  EXPECT_EQ(v.axes, scene::WorldAxes::anatomical);
  const auto prepared = load(path);
  EXPECT_EQ(prepared->kind.reason, "it is a DICOM segmentation");
  EXPECT_EQ(prepared->volume.labels, 2);
  EXPECT_EQ(labelName(prepared->volume.labelTable.get(), 2), "organ 2");
  EXPECT_EQ(prepared->facts.suggestedIsovalue, 0.0);
}

TEST(DicomSegmentations, SegmentsThatOverlapLieInLayers) {
  SegFile file;
  file.frames[2].pixels = "110000";  // voxel 0 is of segment 1, too
  const fs::path path = file.write();
  const auto first = readFile(path);
  EXPECT_EQ(first.components, 2);
  EXPECT_EQ(first.grid->maximum(), 1.0);
  EXPECT_TRUE(test::warns(first, "2 layers of labels, layer 0 (organ 1) is shown"));
  volume::ReadOptions options;
  options.component = 1;
  const auto second = readFile(path, options);
  EXPECT_EQ(second.grid->value(0, 0, 1), 2.0);
  EXPECT_EQ(second.grid->value(2, 1, 3), 2.0);
  EXPECT_EQ(labelName(second.labelTable.get(), 2), "organ 2");
  options.component = -1;
  expectError(path, "no magnitude", options, base::ErrorKind::usage);
  options.component = 2;
  expectError(path, "does not exist", options, base::ErrorKind::usage);
}

TEST(DicomSegmentations, FractionsAreValuesFromZeroToOne) {
  SegFile file;
  file.type = "FRACTIONAL";
  file.bits = 8;
  const std::string half(6, static_cast<char>(100)), whole(6, static_cast<char>(200));
  file.frames = {{1, "0\\0\\0", half}, {2, "0\\0\\2", whole}};
  const fs::path path = file.write();
  const auto first = load(path);
  EXPECT_EQ(first->volume.components, 2);
  EXPECT_EQ(first->volume.labelTable, nullptr);
  EXPECT_NE(first->kind.kind, scene::DataKind::labels);
  EXPECT_EQ(first->facts.suggestedIsovalue, 0.5);
  EXPECT_EQ(first->grid().value(1, 1, 0), 0.5);
  EXPECT_EQ(first->grid().value(1, 1, 1), 0.0) << "segment 2 is another component";
  EXPECT_TRUE(test::warns(first->volume, "component 0 is segment 1 (organ 1), 1 is segment 2 (organ 2)"));
  volume::ReadOptions options;
  options.component = 1;
  EXPECT_EQ(readFile(path, options).grid->value(0, 0, 1), 1.0);
}

TEST(DicomSegmentations, DistancesOfSlicesAreThoseOfThePositions) {
  SegFile file;
  file.distance = "";
  EXPECT_EQ(readFile(file.write()).grid->dims().z, 4);
  file.frames[3].position = "0\\0\\5";  // 0, 2 and 5: every millimetre
  EXPECT_EQ(readFile(file.write()).grid->dims().z, 6);
  file.frames[3].position = "0\\0\\6";
  file.distance = "3.3";
  const auto contradicted = readFile(file.write());
  EXPECT_EQ(contradicted.grid->dims().z, 4);
  EXPECT_TRUE(test::warns(contradicted, "SpacingBetweenSlices 3.3 mm contradicts"));
  file.distance = "1";  // more slices than frames: all others are empty
  EXPECT_EQ(readFile(file.write()).grid->dims().z, 7);
  file.spacing = "";
  EXPECT_TRUE(test::warns(readFile(file.write()), "PixelSpacing is missing; 1 mm assumed"));
  SegFile one;
  one.frames.resize(1);
  one.distance = "";
  EXPECT_TRUE(test::warns(readFile(one.write()), "the distance of slices is missing; 1 mm assumed"));
}

TEST(DicomSegmentations, WhatIsWrongIsRefused) {
  const auto refuse = [](const auto& change, const std::string& reason) {
    SegFile file;
    change(file);
    expectError(file.write(), reason);
  };
  refuse([](SegFile& f) { f.frames[1].position = ""; }, "frame 2 states no position");
  refuse([](SegFile& f) { f.frames[1].segment = 3; }, "is of segment 3, which SegmentSequence does not list");
  refuse([](SegFile& f) { f.segments = {1, 1}; }, "has no SegmentNumber of its own");
  refuse([](SegFile& f) { f.segments = {}; }, "names no segments");
  refuse([](SegFile& f) { f.type = "OTHER"; }, "BINARY, FRACTIONAL and LABELMAP are");
  refuse([](SegFile& f) { f.bits = 8; }, "8 bits are not those of a BINARY segmentation");
  refuse([](SegFile& f) { f.frames[3].position = "0\\0\\2.7183"; }, "unevenly spaced");
  refuse([](SegFile& f) { f.frames[1].position = "0.3\\0\\2"; }, "half a pixel beside a common line");
  refuse([](SegFile& f) { f.frames[3].position = "0\\0\\1e9"; }, "frames");
  refuse([](SegFile& f) { f.more = {element(0x48, 6, "UL", test::bytesOf<std::uint32_t>({100}))}; },
         "whole-slide image");
  refuse([](SegFile& f) { f.more = {element(0x7fe0, 0x10, "OB", "ab")}; }, "truncated");
  refuse(
      [](SegFile& f) {
        f.type = "LABELMAP";
        f.sopClass = "66.7";
        f.bits = 8;
        f.frames = {{1, "0\\0\\0", "111111"}, {1, "0\\0\\0", "222222"}};
      },
      "two frames of the label map lie at one place");
}

}  // namespace
}  // namespace isolux
