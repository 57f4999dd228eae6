// DICOM series, written here element by element (explicit VR, little endian).
#include <cstdio>
#include <fstream>
#include <sstream>

#include "tests/volume/read/dicom_file.h"
#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using test::dicom;
using test::expectError;
using test::expectNear;
using test::readFile;
using test::valuesOf;
using test::worldOf;
using test::writeSeries;
using Slice = test::DicomSlice;

std::string number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

// A slice whose pixel (x, y) has the stored value 10 z + 3 y + x, so that values say where they are.
Slice sliceAt(double z, int instance) {
  Slice s;
  s.instance = instance;
  s.position = "10\\20\\" + number(z);
  std::vector<std::int16_t> pixels;
  for (int i = 0; i < 6; ++i) pixels.push_back(static_cast<std::int16_t>(10 * z + i));
  s.pixels = test::bytesOf(pixels);
  return s;
}

TEST(Dicom, SortedByPositionWithRescaleAndGeometry) {
  // Names and instance numbers contradict the positions.
  const auto v = readFile(writeSeries({sliceAt(4, 1), sliceAt(0, 2), sliceAt(2, 3)}));
  EXPECT_EQ(v.format, "DICOM");
  EXPECT_EQ(v.name, "head");
  EXPECT_EQ(v.unit, "HU");
  EXPECT_EQ(v.fileType, volume::VoxelType::int16);
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 3));
  EXPECT_EQ(v.grid->intercept(), -1024.0);
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) EXPECT_EQ(v.grid->value(x, y, z), 20 * z + 3 * y + x - 1024);
  expectNear(worldOf(v, 0, 0, 0), {10, 20, 0});
  expectNear(worldOf(v, 1, 1, 1), {10.5, 20.75, 2});
  EXPECT_THAT(v.warnings, testing::IsEmpty());
  EXPECT_THAT(v.seriesChoices, testing::ElementsAre("1.2.3.4\thead, 3 slices"));
}

TEST(Dicom, OneFileOpensItsSeries) {
  const auto folder = writeSeries({sliceAt(0, 1), sliceAt(2, 2)});
  EXPECT_EQ(readFile(folder / "IM1").grid->dims(), glm::ivec3(3, 2, 2));
}

// A letter of the header is wrong: an assert of GDCM (3.0.21) ends its process.
TEST(Dicom, AFileThatEndsItsReaderIsOneLineThatNamesIt) {
  Slice slice = sliceAt(0, 1);
  slice.syntax = "1.2.840.10008.1.2.4.90";  // JPEG 2000: decoded by GDCM
  std::string bytes = dicom(slice);
  const std::size_t element = bytes.find(test::bytesOf<std::uint16_t>({2, 0x10}) + "UI");
  ASSERT_NE(element, std::string::npos);
  bytes[element + 4] = 'd';
  const fs::path file = test::temporaryFolder() / "a.dcm";
  test::writeFile(file, bytes);
  expectError(file, "");
}

TEST(Dicom, ObliqueOrientation) {
  std::vector<Slice> slices{sliceAt(0, 1), sliceAt(1, 2)};
  for (int i = 0; i < 2; ++i) {
    slices[static_cast<std::size_t>(i)].orientation = "0\\1\\0\\0\\0\\-1";  // sagittal, normal -x
    slices[static_cast<std::size_t>(i)].position = number(-2 * i) + "\\5\\6";
  }
  const auto v = readFile(writeSeries(slices));
  expectNear(worldOf(v, 0, 0, 0), {0, 5, 6});
  expectNear(worldOf(v, 1, 0, 0), {0, 5.5, 6});
  expectNear(worldOf(v, 0, 1, 0), {0, 5, 5.25});
  expectNear(worldOf(v, 0, 0, 1), {-2, 5, 6});
  EXPECT_EQ(v.grid->value(0, 0, 1), 10 - 1024);
  EXPECT_EQ(v.axes, scene::WorldAxes::anatomical);
}

TEST(Dicom, MissingSliceIsInterpolatedAndSaid) {
  const auto v =
      readFile(writeSeries({sliceAt(0, 1), sliceAt(2, 2), sliceAt(4, 3), sliceAt(8, 4), sliceAt(10, 5)}));
  EXPECT_EQ(v.grid->dims().z, 6);
  EXPECT_TRUE(test::warns(v, "missing in 1 place"));
  for (int z = 0; z < 6; ++z) EXPECT_EQ(v.grid->value(1, 1, z), 20 * z + 4 - 1024) << z;
  EXPECT_EQ(v.grid->storedType(), volume::VoxelType::int16);
}

TEST(Dicom, UnevenDistancesPutValuesWhereTheyBelong) {
  // The value is linear in z, so linear resampling must give it back (to the rounding of int16).
  const auto v =
      readFile(writeSeries({sliceAt(0, 1), sliceAt(1, 2), sliceAt(2.5, 3), sliceAt(3.5, 4), sliceAt(6, 5)}));
  EXPECT_TRUE(test::warns(v, "uneven"));
  for (int z = 0; z < v.grid->dims().z; ++z)
    EXPECT_NEAR(v.grid->value(0, 0, z), 10 * worldOf(v, 0, 0, z).z - 1024, 0.5) << z;
}

TEST(Dicom, GantryTiltKeepsEveryVoxelAtItsPlace) {
  std::vector<Slice> slices;
  for (int i = 0; i < 4; ++i) {
    slices.push_back(sliceAt(2 * i, i + 1));
    slices.back().position = "10\\" + number(20 + i) + "\\" + number(2 * i);
  }
  const auto v = readFile(writeSeries(slices));
  EXPECT_TRUE(test::warns(v, "gantry tilt of 26.57 degrees"));
  for (int i = 0; i < 4; ++i) expectNear(worldOf(v, 0, 0, i), {10, 20.0 + i, 2.0 * i});
  expectNear(worldOf(v, 1, 1, 3), {10.5, 23.75, 6});
}

TEST(Dicom, SeveralSeries) {
  std::vector<Slice> slices{sliceAt(0, 1), sliceAt(2, 2), sliceAt(4, 3), sliceAt(0, 4)};
  slices[3].series = "9.9";
  slices[3].description = "scout";
  slices[3].modality = "MR";
  const auto folder = writeSeries(slices);
  const auto v = readFile(folder);
  EXPECT_EQ(v.grid->dims().z, 3);
  EXPECT_THAT(v.seriesChoices, testing::ElementsAre("1.2.3.4\thead, 3 slices", "9.9\tscout, 1 slices"));
  volume::ReadOptions options;
  options.series = "9.9";
  const auto other = readFile(folder, options);
  EXPECT_EQ(other.grid->dims().z, 1);
  EXPECT_EQ(other.unit, "");
  options.series = "7";
  expectError(folder, "source.series", options, base::ErrorKind::usage);
}

TEST(Dicom, OddSlicesAreLeftOut) {
  std::vector<Slice> slices{sliceAt(0, 1), sliceAt(2, 2), sliceAt(4, 3), sliceAt(6, 4)};
  slices[3].orientation = "0\\1\\0\\0\\0\\-1";
  const auto v = readFile(writeSeries(slices));
  EXPECT_EQ(v.grid->dims().z, 3);
  EXPECT_TRUE(test::warns(v, "1 of 4 slices differ"));
}

TEST(Dicom, RescaleThatChangesIsAppliedPerSlice) {
  std::vector<Slice> slices{sliceAt(0, 1), sliceAt(2, 2)};
  slices[1].slope = "0.5";
  slices[1].intercept = "7";
  const auto v = readFile(writeSeries(slices));
  EXPECT_TRUE(test::warns(v, "rescale slope differs"));
  EXPECT_EQ(v.grid->value(1, 0, 0), 1 - 1024);
  EXPECT_EQ(v.grid->value(1, 0, 1), 21 * 0.5 + 7);
}

TEST(Dicom, TimeStepsAndColours) {
  std::vector<Slice> slices;
  for (int i = 0; i < 4; ++i) {
    slices.push_back(sliceAt(2 * (i % 2), i + 1));
    slices.back().pixels =
        test::bytesOf(std::vector<std::int16_t>(6, static_cast<std::int16_t>(100 * (i / 2) + i % 2)));
  }
  volume::ReadOptions options;
  options.timeStep = 1;
  const auto v = readFile(writeSeries(slices), options);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_EQ(v.grid->value(0, 0, 1), 101 - 1024);

  Slice rgb = sliceAt(0, 1);
  rgb.bits = 8;
  rgb.samples = 3;
  rgb.slope = "";
  rgb.pixels = test::bytesOf(test::ramp<std::uint8_t>(18));
  options = {};
  options.component = 2;
  const auto colours = readFile(writeSeries({rgb}), options);
  EXPECT_EQ(colours.components, 3);
  EXPECT_THAT(valuesOf(colours), testing::ElementsAre(2, 5, 8, 11, 14, 17));
}

TEST(Dicom, ADescriptionThatNobodyGaveIsNoName) {
  Slice s = sliceAt(0, 1);
  s.description = "None";
  const auto folder = writeSeries({s});
  EXPECT_EQ(readFile(folder).name, folder.filename().string());
}

TEST(Dicom, WithoutPositions) {
  std::vector<Slice> slices{sliceAt(0, 2), sliceAt(2, 1)};
  for (Slice& s : slices) s.position.clear();
  const auto v = readFile(writeSeries(slices));
  EXPECT_TRUE(test::warns(v, "instance numbers"));
  EXPECT_EQ(v.axes, scene::WorldAxes::zUp);
  EXPECT_EQ(v.grid->value(0, 0, 0), 20 - 1024);  // instance 1
  EXPECT_EQ(v.grid->geometry().spacingMm(), glm::dvec3(0.5, 0.75, 2));
}

TEST(Dicom, MultiFrameFile) {
  Slice s = sliceAt(0, 1);
  s.frames = 2;
  s.position.clear();
  s.pixels = test::bytesOf(test::ramp<std::int16_t>(12));
  const auto v = readFile(writeSeries({s}));
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 2));
  EXPECT_EQ(v.grid->value(2, 1, 1), 11 - 1024);
}

TEST(Dicom, BrokenFiles) {
  const auto with = [&](const std::function<void(Slice&)>& change, const std::string& reason) {
    Slice s = sliceAt(0, 1);
    change(s);
    expectError(writeSeries({s}), reason);
  };
  with(
      [](Slice& s) {
        s.rows = 60000;
        s.columns = 60000;
      },
      "truncated");
  with([](Slice& s) { s.rows = 0; }, "no pixels");
  with([](Slice& s) { s.bits = 128; }, "not supported");
  with([](Slice& s) { s.frames = 1000000; }, "at most 65535");
  with([](Slice& s) { s.frames = 60000; }, "truncated");
  with([](Slice& s) { s.orientation = "1\\0\\0\\1\\0\\0"; }, "perpendicular");
  with([](Slice& s) { s.samples = 200; }, "not supported");

  Slice whole = sliceAt(0, 1);
  const auto folder = writeSeries({whole});
  const std::string bytes = dicom(whole);
  for (const std::size_t size : {std::size_t{140}, std::size_t{200}, bytes.size() / 2, bytes.size() - 30}) {
    test::writeFile(folder / "IM0", bytes.substr(0, size));
    EXPECT_THROW(readFile(folder), base::Error) << size;
  }
  // One broken file among good ones is reported, not fatal.
  const auto mixed = writeSeries({sliceAt(0, 1), sliceAt(2, 2), sliceAt(4, 3)});
  Slice lying = sliceAt(6, 4);
  lying.rows = 60000;
  test::writeFile(mixed / "IM9", dicom(lying));
  const auto v = readFile(mixed);
  EXPECT_EQ(v.grid->dims().z, 3);
  EXPECT_TRUE(test::warns(v, "1 DICOM files are unreadable"));
}

TEST(Dicom, NothingReachesStderr) {
  Slice s = sliceAt(0, 1);
  const auto folder = writeSeries({s});
  test::writeFile(folder / "IM0", dicom(s).substr(0, 300));
  testing::internal::CaptureStderr();
  EXPECT_THROW(readFile(folder), base::Error);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace isolux
