// What DICOM files say about themselves is honoured, warned about or refused.
#include <algorithm>
#include <cstdlib>

#include "tests/volume/read/dicom_file.h"
#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using test::dicom;
using test::element;
using test::expectError;
using test::expectNear;
using test::readFile;
using test::sequence;
using test::us;
using test::valuesOf;
using test::warns;
using test::worldOf;
using test::writeSeries;
using Slice = test::DicomSlice;

std::string fd(double value) {
  return test::bytesOf<double>({value});
}

// One slice of 3 x 2 pixels that all hold `value`, without rescale.
Slice flatSlice(int z, int instance, int value) {
  Slice s;
  s.instance = instance;
  s.position = "0\\0\\" + std::to_string(z);
  s.modality = "MR";
  s.slope = "";
  s.pixels = test::bytesOf(std::vector<std::int16_t>(6, static_cast<std::int16_t>(value)));
  return s;
}

// A file of so many frames; pixel i of the file has the value i.
Slice frames(int count) {
  Slice s = flatSlice(0, 1, 0);
  s.frames = count;
  s.pixels = test::bytesOf(test::ramp<std::int16_t>(static_cast<std::size_t>(6 * count)));
  return s;
}

fs::path writeOne(const Slice& slice) {
  return writeSeries({slice}) / "IM0";
}

volume::Volume readStep(const fs::path& path, int step) {
  volume::ReadOptions options;
  options.timeStep = step;
  return readFile(path, options);
}

// Recognition

TEST(DicomFiles, APreambleMayBeThatOfAnotherFormat) {
  Slice s = flatSlice(0, 1, 7);
  for (const std::string& begin : {std::string("II*\0\x10\0\0\0", 8), std::string("MM\0*\0\0\0\x10", 8),
                                   std::string("NRRD0005\n"), std::string("solid x\n")}) {
    s.preamble.replace(0, begin.size(), begin);
    EXPECT_EQ(readFile(writeOne(s)).format, "DICOM");
  }
}

TEST(DicomFiles, OldFilesBeginWithTheirFirstElement) {
  const Slice s = flatSlice(0, 1, 7);
  const fs::path folder = test::temporaryFolder() / "old";
  for (const char* name : {"I0001", "1.2.840.113619.1", "a.ima"}) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    test::writeFile(folder / name, test::dicomElements(s));
    EXPECT_EQ(readFile(folder).grid->value(0, 0, 0), 7) << name;
    EXPECT_EQ(readFile(folder / name).grid->value(0, 0, 0), 7) << name;
  }
  // Numbers are no elements.
  const std::string raw = test::bytesOf(test::ramp<std::int16_t>(2000, 8));
  test::writeFile(folder / "raw.bin", raw);
  expectError(folder / "raw.bin", "unknown volume format");
}

TEST(DicomFiles, TheIndexOfADiscOpensItsFolder) {
  const fs::path disc = test::temporaryFolder() / "disc";
  fs::create_directories(disc / "A" / "B");
  test::writeFile(disc / "A" / "B" / "IM0", dicom(flatSlice(0, 1, 7)));
  Slice index;
  index.sopClass = "1.2.840.10008.1.3.10";
  index.modality = "";
  for (const char* name : {"DICOMDIR", "dicomdir"}) {
    test::writeFile(disc / name, dicom(index));
    EXPECT_EQ(readFile(disc / name).grid->value(0, 0, 0), 7);
    EXPECT_THAT(readFile(disc).warnings, testing::IsEmpty());
    fs::remove(disc / name);
  }
  test::writeFile(disc / "index.dcm", dicom(index));
  expectError(disc / "index.dcm", "is the index of a disc");
}

// Kinds of objects

TEST(DicomObjects, WhatIsNoScanIsRefusedByName) {
  struct Object {
    const char *sopClass, *modality, *name;
  };
  const std::string storage = "1.2.840.10008.5.1.4.1.1.";
  for (const auto& [sopClass, modality, name] :
       {Object{"66.4", "SEG", "a segmentation (SEG)"}, Object{"66.7", "SEG", "segmentation (SEG)"},
        Object{"88.33", "SR", "a structured report (SR)"}, Object{"481.3", "RTSTRUCT", "contours (RTSTRUCT)"},
        Object{"481.5", "RTPLAN", "a radiotherapy plan"}, Object{"77.1.6", "SM", "a whole-slide image"},
        Object{"11.1", "PR", "a presentation state"}, Object{"104.1", "DOC", "an encapsulated document"},
        Object{"2", "SEG", "a segmentation (SEG)"}, Object{"66.4", "", "a segmentation (SEG)"}}) {
    Slice s = flatSlice(0, 1, 1);
    s.sopClass = storage + sopClass;
    s.modality = modality;
    for (const bool hasPixels : {true, false}) {
      if (!hasPixels) s.pixels.clear();
      const fs::path file = writeOne(s);
      expectError(file, name);
      expectError(file.parent_path(), name);  // also what is read by itself, if it is damaged
    }
  }
}

TEST(DicomObjects, ThoseBesideAScanAreCountedAndAScanIsChosen) {
  Slice report = flatSlice(0, 9, 1);
  report.sopClass = "1.2.840.10008.5.1.4.1.1.88.11";
  report.pixels.clear();
  Slice mask = flatSlice(0, 8, 1);
  mask.sopClass = "1.2.840.10008.5.1.4.1.1.66.4";
  mask.series = "7";
  mask.frames = 3;
  const fs::path folder = writeSeries({flatSlice(0, 1, 1), flatSlice(2, 2, 2), report, mask});
  const auto v = readFile(folder);
  EXPECT_EQ(v.grid->dims().z, 2);
  EXPECT_TRUE(warns(v, "2 DICOM objects are not scans"));
  EXPECT_EQ(v.seriesChoices.size(), 1u);
  volume::ReadOptions options;
  options.series = "7";
  expectError(folder, "segmentation", options);
}

TEST(DicomObjects, AFileWithoutImageIsNamed) {
  Slice s = flatSlice(0, 1, 1);
  s.pixels.clear();
  expectError(writeOne(s), "has no DICOM image");
}

TEST(DicomObjects, ScreenshotsAndRadiographsAreCalledSo) {
  Slice s = flatSlice(0, 1, 1);
  s.modality = "CT";
  s.sopClass = "1.2.840.10008.5.1.4.1.1.7";
  const auto screenshot = readFile(writeOne(s));
  EXPECT_TRUE(warns(screenshot, "is a secondary capture"));
  EXPECT_EQ(screenshot.unit, "");
  s.sopClass = "1.2.840.10008.5.1.4.1.1.1.1";
  s.modality = "DX";
  s.spacing = "";
  s.more = {element(0x18, 0x1164, "DS", "0.2\\0.1")};
  const auto radiograph = readFile(writeOne(s));
  EXPECT_TRUE(warns(radiograph, "is a radiograph"));
  EXPECT_TRUE(warns(radiograph, "at the detector"));
}

TEST(DicomObjects, TransferSyntaxesThatAreNotReadAreNamed) {
  Slice s = flatSlice(0, 1, 1);
  for (const auto& [uid, name] :
       {std::pair("1.2.840.10008.1.2.1.99", "deflated"), std::pair("1.2.840.10008.1.2.4.201", "HTJ2K"),
        std::pair("1.2.840.10008.1.2.4.110", "JPEG XL"),
        std::pair("1.2.840.10008.1.2.4.102", "MPEG video")}) {
    s.syntax = uid;
    expectError(writeOne(s), std::string(uid) + " (" + name + ") is not read; convert it with");
  }
}

// Which slices belong together

TEST(DicomIdentity, DirectionsAndSpacingsAreComparedWithATolerance) {
  std::vector<Slice> slices;
  for (int i = 0; i < 8; ++i) {
    slices.push_back(flatSlice(2 * i, i + 1, i));
    slices.back().orientation =
        i % 2 ? "1\\0.00050001\\0\\-0.00050001\\1\\0" : "1\\0.00049999\\0\\-0.00049999\\1\\0";
    slices.back().spacing = i % 2 ? "0.3125\\0.3125" : "0.31249999\\0.31249999";
  }
  const auto v = readFile(writeSeries(slices));
  EXPECT_EQ(v.grid->dims().z, 8);
  EXPECT_NEAR(v.grid->geometry().spacingMm().z, 2.0, 1e-9);
  EXPECT_THAT(v.warnings, testing::IsEmpty());
}

// Per-frame groups: position, orientation, and more groups.
std::string frameGroups(const std::string& position, const std::string& orientation,
                        const std::string& more = "") {
  return sequence(0x20, 0x9113, {element(0x20, 0x32, "DS", position)}) +
         sequence(0x20, 0x9116, {element(0x20, 0x37, "DS", orientation)}) + more;
}

Slice enhanced(const std::vector<std::string>& groups) {
  Slice s = frames(static_cast<int>(groups.size()));
  s.position.clear();
  s.more = {sequence(0x5200, 0x9230, groups)};
  return s;
}

TEST(DicomIdentity, FramesOfOneFileToo) {
  const auto v = readFile(writeOne(enhanced({frameGroups("0\\0\\0", "1\\0.00049999\\0\\0\\1\\0"),
                                             frameGroups("0\\0\\2", "1\\0.00050001\\0\\0\\1\\0")})));
  EXPECT_EQ(v.grid->dims().z, 2);
  expectError(writeOne(enhanced(
                  {frameGroups("0\\0\\0", "1\\0\\0\\0\\1\\0"), frameGroups("0\\0\\2", "0\\1\\0\\0\\0\\-1")})),
              "the frames of one file differ in orientation");
}

TEST(DicomIdentity, ImagesThatAreThereTwiceAreReadOnce) {
  std::vector<Slice> slices;
  for (int i = 0; i < 6; ++i) slices.push_back(flatSlice(2 * (i % 3), i % 3 + 1, i % 3));
  const auto v = readFile(writeSeries(slices));
  EXPECT_EQ(v.timeSteps, 1);
  EXPECT_EQ(v.grid->dims().z, 3);
  EXPECT_TRUE(warns(v, "3 files are copies of others"));
  // The same UID for different images is a fault of the writer: nothing is lost.
  for (int i = 0; i < 3; ++i) slices[static_cast<std::size_t>(i)].more = {element(8, 0x18, "UI", "1.1")};
  slices.resize(3);
  const auto clash = readFile(writeSeries(slices));
  EXPECT_EQ(clash.grid->dims().z, 3);
  EXPECT_TRUE(warns(clash, "2 files have the SOPInstanceUID of a different image"));
}

TEST(DicomIdentity, PatientsAndSensesOfGreyAreNotMixed) {
  std::vector<Slice> slices;
  for (int i = 0; i < 4; ++i) slices.push_back(flatSlice(2 * i, i + 1, i));
  slices[3].more = {element(0x28, 4, "CS", "MONOCHROME1")};
  const auto grey = readFile(writeSeries(slices));
  EXPECT_EQ(grey.grid->dims().z, 3);
  EXPECT_TRUE(warns(grey, "1 of 4 slices differ from the rest (photometric interpretation)"));
  slices[3].more.clear();
  slices[3].id = "another";
  const auto patients = readFile(writeSeries(slices));
  EXPECT_EQ(patients.grid->dims().z, 3);
  EXPECT_TRUE(warns(patients, "differ from the rest (patient)"));
  slices[3].id.clear();
  slices[3].patient = "DOE^J";
  EXPECT_TRUE(warns(readFile(writeSeries(slices)), "name several patients"));
  slices[3].patient.clear();
  slices[3].more = {element(0x20, 0x52, "UI", "1.9")};
  EXPECT_TRUE(warns(readFile(writeSeries(slices)), "several frames of reference"));
}

TEST(DicomIdentity, FilesOfNoSeriesMayNotBelongTogether) {
  std::vector<Slice> slices{flatSlice(0, 1, 1), flatSlice(2, 2, 2)};
  for (Slice& s : slices) s.series.clear();
  EXPECT_TRUE(warns(readFile(writeSeries(slices)), "state no SeriesInstanceUID"));
}

TEST(DicomIdentity, UnitsAreNotMixedInSilence) {
  std::vector<Slice> slices{flatSlice(0, 1, 1), flatSlice(2, 2, 2)};
  for (Slice& s : slices) s.more = {element(0x28, 0x1054, "LO", "Hz")};
  EXPECT_EQ(readFile(writeSeries(slices)).unit, "Hz");
  slices[1].more.clear();
  const auto v = readFile(writeSeries(slices));
  EXPECT_EQ(v.unit, "");
  EXPECT_TRUE(warns(v, "different units"));
  Slice ct = flatSlice(0, 1, 1);
  ct.modality = "CT";
  EXPECT_EQ(readFile(writeOne(ct)).unit, "HU");
  ct.more = {element(0x28, 0x1054, "LO", "US")};
  EXPECT_EQ(readFile(writeOne(ct)).unit, "");
  Slice pet = flatSlice(0, 1, 1);
  pet.modality = "PT";
  pet.more = {element(0x54, 0x1001, "CS", "BQML")};
  EXPECT_EQ(readFile(writeOne(pet)).unit, "Bq/ml");
}

// Repeated positions

// Three steps of four slices; `tag(step)` is written into each, instance numbers are shuffled.
std::vector<Slice> shuffledSteps(const std::function<std::string(int)>& tag) {
  const int numbers[] = {7, 2, 11, 4, 9, 1, 12, 5, 3, 10, 8, 6};
  std::vector<Slice> slices;
  for (int step = 0; step < 3; ++step)
    for (int z = 0; z < 4; ++z) {
      slices.push_back(flatSlice(2 * z, numbers[slices.size()], 100 * step + z));
      slices.back().more = {tag(step)};
    }
  return slices;
}

TEST(DicomRepeats, TagsTellTimeStepsApartNotInstanceNumbers) {
  const std::function<std::string(int)> tags[] = {
      [](int step) { return element(0x20, 0x100, "IS", std::to_string(step + 1)); },  // temporal position
      [](int step) { return element(0x20, 0x12, "IS", std::to_string(9 + step)); },   // acquisition number
      [](int step) { return element(0x18, 0x1060, "DS", std::to_string(90.5 + 20 * step)); },  // trigger time
      [](int step) { return element(0x18, 0x81, "DS", std::to_string(5 * step + 5)); },        // echo time
      [](int step) { return element(0x18, 0x9087, "FD", fd(500.0 * step)); },                  // b-value
      [](int step) { return element(8, 0x32, "TM", "10000" + std::to_string(step)); },  // acquisition time
      [](int step) { return element(8, 8, "CS", std::string("ORIGINAL\\PRIMARY\\") + "ABC"[step]); }};
  for (const auto& tag : tags) {
    const fs::path folder = writeSeries(shuffledSteps(tag));
    for (int step = 0; step < 3; ++step) {
      const auto v = readStep(folder, step);
      EXPECT_EQ(v.timeSteps, 3);
      for (int z = 0; z < 4; ++z) EXPECT_EQ(v.grid->value(0, 0, z), 100 * step + z);
      EXPECT_TRUE(warns(v, "instance numbers and "));
    }
  }
}

TEST(DicomRepeats, StepsThatAreNoMomentsAreNamed) {
  const auto kinds = readFile(writeSeries(shuffledSteps(
      [](int step) { return element(8, 8, "CS", std::string("ORIGINAL\\PRIMARY\\") + "MPR"[step]); })));
  EXPECT_TRUE(
      warns(kinds, "the time steps differ in image type: ORIGINAL\\PRIMARY\\M, ORIGINAL\\PRIMARY\\P"));
  const auto echoes = readFile(writeSeries(
      shuffledSteps([](int step) { return element(0x18, 0x81, "DS", std::to_string(8 + step)); })));
  EXPECT_TRUE(warns(echoes, "the time steps differ in echo time: 8, 9, 10"));
  std::vector<Slice> unnamed = shuffledSteps([](int) { return element(8, 8, "CS", "ORIGINAL"); });
  EXPECT_TRUE(warns(readFile(writeSeries(unnamed)), "only instance numbers tell repeated slices apart"));
}

TEST(DicomRepeats, MagnitudeAndFieldMapOfOneFileHaveTheirOwnScales) {
  std::vector<std::string> groups;
  for (int kind = 0; kind < 2; ++kind)
    for (int z = 0; z < 2; ++z)
      groups.push_back(frameGroups(
          "0\\0\\" + std::to_string(z), "1\\0\\0\\0\\1\\0",
          sequence(0x18, 0x9226,
                   {element(8, 0x9007, "CS", kind ? "ORIGINAL\\PRIMARY\\B0" : "ORIGINAL\\PRIMARY\\A")}) +
              sequence(0x28, 0x9145,
                       {element(0x28, 0x1052, "DS", kind ? "-100" : "0") +
                        element(0x28, 0x1053, "DS", kind ? "0.5" : "2") +
                        element(0x28, 0x1054, "LO", kind ? "Hz" : "US")})));
  const fs::path file = writeOne(enhanced(groups));
  const auto magnitude = readStep(file, 0), map = readStep(file, 1);
  EXPECT_TRUE(warns(map, "the time steps differ in image type"));
  EXPECT_FALSE(warns(map, "rescale slope differs"));
  EXPECT_EQ(magnitude.grid->value(1, 0, 0), 2);
  EXPECT_EQ(map.grid->value(1, 0, 0), 13 * 0.5 - 100);
  EXPECT_EQ(map.unit, "Hz");
  EXPECT_EQ(magnitude.unit, "");
}

TEST(DicomRepeats, ACompleteStepIsTakenWhereOthersAreNot) {
  std::vector<Slice> slices;
  for (int step = 0; step < 2; ++step)
    for (int z = 0; z < 4; ++z) {
      if (step == 0 && z > 1) continue;
      slices.push_back(flatSlice(2 * z, static_cast<int>(slices.size()) + 1, 100 * step + z));
      slices.back().more = {element(0x20, 0x100, "IS", std::to_string(step + 1))};
    }
  const auto v = readFile(writeSeries(slices));
  EXPECT_TRUE(warns(v, "2 slices belong to no complete time step (temporal position)"));
  for (int z = 0; z < 4; ++z) EXPECT_EQ(v.grid->value(0, 0, z), 100 + z);
}

TEST(DicomRepeats, KindsOfImageInOneStepAreSaid) {
  std::vector<Slice> slices;
  for (int z = 0; z < 4; ++z) {
    slices.push_back(flatSlice(2 * z, z + 1, z));
    slices.back().more = {element(8, 8, "CS", z < 2 ? "ORIGINAL\\PRIMARY\\M" : "ORIGINAL\\PRIMARY\\P")};
  }
  EXPECT_TRUE(warns(readFile(writeSeries(slices)), "slices of one time step differ in image type"));
}

TEST(DicomRepeats, TagsThatContradictEachOtherAreSaid) {
  std::vector<Slice> slices =
      shuffledSteps([](int step) { return element(0x20, 0x100, "IS", std::to_string(step + 1)); });
  slices[0].more = {element(0x20, 0x100, "IS", "9")};
  EXPECT_TRUE(warns(readFile(writeSeries(slices)), "slices of one time step differ in temporal position"));
}

// Frames of one file

TEST(DicomFrames, OnePositionForAllOfThem) {
  Slice s = frames(4);
  s.position = "1\\2\\3";
  s.more = {element(0x18, 0x88, "DS", "0.3")};
  const auto v = readFile(writeOne(s));
  EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 4));
  EXPECT_EQ(v.timeSteps, 1);
  EXPECT_TRUE(warns(v, "frames have one position; placed every 0.3 mm by SpacingBetweenSlices"));
  expectNear(worldOf(v, 0, 0, 3), {1, 2, 3.9});
  s.more.clear();
  EXPECT_TRUE(warns(readFile(writeOne(s)), "by SliceThickness"));
  s.thickness.clear();
  expectError(writeOne(s), "no distance between them is stated");
}

TEST(DicomFrames, CineIsTime) {
  for (const std::string& position : {std::string("0\\0\\0"), std::string()}) {
    Slice s = frames(5);
    s.modality = "US";
    s.sopClass = "1.2.840.10008.5.1.4.1.1.3.1";
    s.position = position;
    s.spacing.clear();
    s.more = {element(0x28, 9, "AT", test::bytesOf<std::uint16_t>({0x18, 0x1063})),
              element(0x18, 0x1063, "DS", "33.3"),
              sequence(0x18, 0x6011,
                       {element(0x18, 0x6024, "US", us(3)) + element(0x18, 0x6026, "US", us(3)) +
                        element(0x18, 0x602c, "FD", fd(0.02)) + element(0x18, 0x602e, "FD", fd(0.05))})};
    const fs::path file = writeOne(s);
    const auto v = readStep(file, 2);
    EXPECT_EQ(v.timeSteps, 5);
    EXPECT_EQ(v.grid->dims(), glm::ivec3(3, 2, 1));
    EXPECT_THAT(valuesOf(v), testing::ElementsAre(12, 13, 14, 15, 16, 17));
    EXPECT_NEAR(v.grid->geometry().spacingMm().x, 0.2, 1e-9);
    EXPECT_NEAR(v.grid->geometry().spacingMm().y, 0.5, 1e-9);
  }
}

TEST(DicomFrames, ClipsOfOneSeriesAreNotJoined) {
  std::vector<Slice> clips;
  for (int i = 0; i < 2; ++i) {
    clips.push_back(frames(3));
    clips.back().instance = i + 1;
    clips.back().position.clear();
    clips.back().more = {element(0x28, 9, "AT", test::bytesOf<std::uint16_t>({0x18, 0x1063})),
                         element(0x18, 0x1063, "DS", "33.3")};
  }
  clips[1].pixels = test::bytesOf(test::ramp<std::int16_t>(18, 500));
  const fs::path folder = writeSeries(clips);
  const auto v = readFile(folder);
  EXPECT_EQ(v.timeSteps, 3);
  EXPECT_TRUE(warns(v, "1 other files of the series"));
  EXPECT_EQ(readFile(folder / "IM1").grid->value(0, 0, 0), 500);
}

TEST(DicomFrames, NuclearSlicesLieWhereTheDetectorSays) {
  Slice s = frames(3);
  s.modality = "NM";
  s.sopClass = "1.2.840.10008.5.1.4.1.1.20";
  s.position.clear();
  s.more = {
      element(8, 8, "CS", "ORIGINAL\\PRIMARY\\RECON TOMO\\EMISSION"), element(0x18, 0x88, "DS", "-4"),
      element(0x54, 0x80, "US", test::bytesOf<std::uint16_t>({1, 2, 3})),
      sequence(0x54, 0x22,
               {element(0x20, 0x32, "DS", "-24\\-20\\100") + element(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0")})};
  const auto v = readFile(writeOne(s));
  EXPECT_EQ(v.axes, scene::WorldAxes::anatomical);
  // Sorted along the normal: the last frame, at 92 mm, is the first slice.
  expectNear(worldOf(v, 0, 0, 0), {-24, -20, 92});
  EXPECT_EQ(v.grid->value(0, 0, 0), 12);
  EXPECT_THAT(v.warnings, testing::IsEmpty());

  s.more.pop_back();
  const auto unplaced = readFile(writeOne(s));
  EXPECT_NE(unplaced.axes, scene::WorldAxes::anatomical);
  EXPECT_TRUE(warns(unplaced, "it may be a mirror image"));

  s.more = {element(8, 8, "CS", "ORIGINAL\\PRIMARY\\TOMO\\EMISSION")};
  expectError(writeOne(s), "views or projections");
}

TEST(DicomFrames, DosesAreScaledAndPlacedByTheirOffsets) {
  Slice s = frames(3);
  s.modality = "RTDOSE";
  s.sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  s.position = "1\\2\\30";
  s.more = {element(0x3004, 2, "CS", "GY"), element(0x3004, 0xe, "DS", "0.25"),
            element(0x3004, 0xc, "DS", "0\\5\\10"),
            element(0x28, 9, "AT", test::bytesOf<std::uint16_t>({0x3004, 0xc}))};
  const auto v = readFile(writeOne(s));
  EXPECT_EQ(v.unit, "Gy");
  EXPECT_EQ(v.grid->value(0, 0, 2), 12 * 0.25);
  expectNear(worldOf(v, 0, 0, 2), {1, 2, 40});
  s.more[2] = element(0x3004, 0xc, "DS", "30\\35\\40");  // coordinates
  expectNear(worldOf(readFile(writeOne(s)), 0, 0, 2), {1, 2, 40});
  s.more.erase(s.more.begin() + 1);
  expectError(writeOne(s), "DoseGridScaling");
}

// A CSA header of version 2 with one tag a line: name and values.
std::string csaHeader(const std::vector<std::pair<std::string, std::vector<std::string>>>& tags) {
  const auto integers = [](std::vector<std::int32_t> values) { return test::bytesOf(values); };
  std::string out =
      "SV10" + std::string("\4\3\2\1", 4) + integers({static_cast<std::int32_t>(tags.size()), 77});
  for (const auto& [name, values] : tags) {
    std::string field = name;
    field.resize(64, '\0');
    const auto count = static_cast<std::int32_t>(values.size());
    out += field + integers({count}) + std::string("IS\0\0", 4) + integers({6, count, 77});
    for (std::string value : values) {
      const auto length = static_cast<std::int32_t>(value.size());
      value.resize((value.size() + 3) / 4 * 4, '\0');
      out += integers({length, length, 77, length}) + value;
    }
  }
  return out;
}

Slice mosaic() {  // three tiles of 2 x 2 in an image of 4 x 4
  Slice s = flatSlice(0, 1, 0);
  s.columns = s.rows = 4;
  s.position = "-10\\-20\\5";
  s.spacing = "2\\2";
  s.pixels = test::bytesOf(test::ramp<std::int16_t>(16));
  s.more = {element(8, 8, "CS", "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC"), element(0x18, 0x88, "DS", "3"),
            element(0x29, 0x10, "LO", "SIEMENS CSA HEADER"),
            element(0x29, 0x1010, "OB",
                    csaHeader({{"EchoLinePosition", {"64"}},
                               {"NumberOfImagesInMosaic", {"3", ""}},
                               {"SliceNormalVector", {"0.0", "0.0", "-1.0"}}}))};
  return s;
}

TEST(DicomFrames, AMosaicIsItsSlices) {
  const auto v = readFile(writeOne(mosaic()));
  EXPECT_EQ(v.grid->dims(), glm::ivec3(2, 2, 3));
  // Slices go down from z = 5; the corner is that of a tile in the middle of the mosaic.
  expectNear(worldOf(v, 0, 0, 2), {-8, -18, 5});
  expectNear(worldOf(v, 0, 0, 0), {-8, -18, -1});
  EXPECT_EQ(v.grid->value(0, 0, 2), 0);
  EXPECT_EQ(v.grid->value(1, 1, 2), 5);
  EXPECT_EQ(v.grid->value(0, 0, 1), 2);
  EXPECT_EQ(v.grid->value(1, 1, 0), 13);

  std::vector<Slice> volumes{mosaic(), mosaic()};
  for (int i = 0; i < 2; ++i) {
    volumes[static_cast<std::size_t>(i)].instance = 2 - i;
    volumes[static_cast<std::size_t>(i)].more.push_back(element(0x20, 0x12, "IS", std::to_string(i + 1)));
  }
  volumes[1].pixels = test::bytesOf(test::ramp<std::int16_t>(16, 100));
  const fs::path folder = writeSeries(volumes);
  EXPECT_EQ(readStep(folder, 0).timeSteps, 2);
  EXPECT_EQ(readStep(folder, 0).grid->value(0, 0, 2), 0);
  EXPECT_EQ(readStep(folder, 1).grid->value(0, 0, 2), 100);
}

TEST(DicomFrames, AMosaicOfUnknownTilesIsRefused) {
  Slice s = mosaic();
  s.more.pop_back();
  expectError(writeOne(s), "without the number of slices");
  s.more.push_back(
      element(0x29, 0x1010, "OB", csaHeader({{"NumberOfImagesInMosaic", {"3"}}}).substr(0, 110)));
  expectError(writeOne(s), "without the number of slices");
}

// United Imaging's: five tiles of 1 x 2 in an image of 3 x 4, and where each lies.
Slice unitedMosaic() {
  Slice s = flatSlice(0, 1, 0);
  s.columns = 3, s.rows = 4;
  s.position = "";
  s.pixels = test::bytesOf(test::ramp<std::int16_t>(12));
  std::vector<std::string> places;
  for (int k = 0; k < 5; ++k)
    places.push_back(element(0x20, 0x32, "DS", "1\\2\\" + std::to_string(10 + 4 * k)));
  s.more = {element(8, 8, "CS", "ORIGINAL\\PRIMARY\\M\\VFRAME"),
            element(0x20, 0x37, "DS", "-1\\0\\0\\0\\-1\\0"),
            element(0x65, 0x10, "LO", "Image Private Header"), element(0x65, 0x1050, "DS", "5"),
            sequence(0x65, 0x1051, places)};
  return s;
}

TEST(DicomFrames, AMosaicOfUnitedImagingIsItsSlices) {
  const auto v = readFile(writeOne(unitedMosaic()));
  EXPECT_EQ(v.grid->dims(), glm::ivec3(1, 2, 5));
  expectNear(worldOf(v, 0, 0, 0), {1, 2, 10});
  expectNear(worldOf(v, 0, 1, 4), {1, 1.25, 26});
  EXPECT_EQ(valuesOf(v), (std::vector<double>{0, 3, 1, 4, 2, 5, 6, 9, 7, 10}));
  EXPECT_EQ(v.axes, scene::WorldAxes::anatomical);
  Slice s = unitedMosaic();
  s.more.pop_back();
  expectError(writeOne(s), "does not say where its tiles lie");
  s = unitedMosaic();
  s.more.back() = sequence(0x65, 0x1051, std::vector<std::string>(5, element(0x20, 0x1041, "DS", "1")));
  expectError(writeOne(s), "ImagePositionPatient");
}

// Values

// The file in another transfer syntax.
fs::path packed(const fs::path& file, const std::string& how) {
  const fs::path made = test::temporaryFolder() / "packed.dcm";
  const std::string line =
      "gdcmconv " + how + " '" + file.string() + "' '" + made.string() + "' >/dev/null 2>&1";
  EXPECT_EQ(std::system(line.c_str()), 0) << line;
  return made;
}

TEST(DicomValues, PixelsThatCannotBeDecodedAreRefused) {
  Slice s = flatSlice(0, 1, 0);
  s.columns = s.rows = 32;
  s.pixels = test::bytesOf(test::ramp<std::int16_t>(1024));
  for (const char* how : {"--j2k", "--jpeg", "--jpegls"}) {
    const fs::path file = packed(writeOne(s), how);
    EXPECT_EQ(readFile(file).grid->value(3, 1, 0), 35) << how;
    std::string bytes = test::contentOfFile(file);
    const std::size_t stream = bytes.find(std::string(how) == "--j2k" ? "\xff\x4f\xff" : "\xff\xd8\xff");
    ASSERT_NE(stream, std::string::npos) << how;
    for (std::size_t i = 2; i < 40; ++i) bytes[stream + i] = '\x11';
    test::writeFile(file, bytes);
    expectError(file, "packed.dcm: pixel data: ");
  }
}

TEST(DicomValues, RgbOfJpegIsWhatTheFileSays) {
  Slice s = flatSlice(0, 1, 0);
  s.columns = s.rows = 16, s.samples = 3, s.bits = 8;
  for (int i = 0; i < 256; ++i) s.pixels += "\xff\x02\x01";
  const fs::path file = packed(writeOne(s), "--jpeg --lossy");
  volume::ReadOptions options;
  const double wanted[] = {255, 2, 1};
  for (options.component = 0; options.component < 3; ++options.component)
    EXPECT_NEAR(readFile(file, options).grid->value(5, 5, 0), wanted[options.component], 3)
        << options.component;
  // It is YCbCr; with names of components that do not say so, the file's word counts.
  std::string bytes = test::contentOfFile(file);
  const std::size_t frame = bytes.find("\xff\xc0"), scan = bytes.find("\xff\xda");
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(bytes[frame + 10 + 3 * i], static_cast<char>(i + 1));
    ASSERT_EQ(bytes[scan + 5 + 2 * i], static_cast<char>(i + 1));
    bytes[frame + 10 + 3 * i] = bytes[scan + 5 + 2 * i] = static_cast<char>(i);
  }
  test::writeFile(file, bytes);
  options.component = 0;
  EXPECT_NEAR(readFile(file, options).grid->value(5, 5, 0), 0.299 * 255 + 0.587 * 2 + 0.114, 3);
}

TEST(DicomValues, AModalityLutIsApplied) {
  Slice s = flatSlice(0, 1, 0);
  s.pixels = test::bytesOf<std::int16_t>({-5, -2, -1, 0, 1, 9});
  const auto lut = [](const std::string& vr, int first, const std::string& data) {
    return sequence(0x28, 0x3000,
                    {element(0x28, 0x3002, "SS", us(4) + us(first) + us(16)) +
                     element(0x28, 0x3004, "LO", "OD") + element(0x28, 0x3006, vr, data)});
  };
  s.more = {lut("US", -2, us(100) + us(40000) + us(65535) + us(7))};
  const auto v = readFile(writeOne(s));
  EXPECT_THAT(valuesOf(v), testing::ElementsAre(100, 100, 40000, 65535, 7, 7));
  EXPECT_EQ(v.unit, "OD");
  s.more = {lut("OW", -2, us(100) + us(40000) + us(65535) + us(7))};
  EXPECT_THAT(valuesOf(readFile(writeOne(s))), testing::ElementsAre(100, 100, 40000, 65535, 7, 7));
  s.more = {lut("US", -2, us(100))};
  expectError(writeOne(s), "shorter than stated");
}

TEST(DicomValues, RealWorldValuesAreUsedWhereNoRescaleIs) {
  Slice s = flatSlice(0, 1, 10);
  const auto unit = [](const char* code) { return sequence(0x40, 0x8ea, {element(8, 0x100, "SH", code)}); };
  s.more = {
      sequence(0x40, 0x9096,
               {unit("mm2/s") + element(0x40, 0x9224, "FD", fd(3)) + element(0x40, 0x9225, "FD", fd(0.5))})};
  const auto v = readFile(writeOne(s));
  EXPECT_EQ(v.grid->value(0, 0, 0), 8);
  EXPECT_EQ(v.unit, "mm2/s");
  s.slope = "2";
  s.intercept = "0";
  EXPECT_EQ(readFile(writeOne(s)).grid->value(0, 0, 0), 20);
  s.slope = "";
  s.more = {sequence(0x40, 0x9096, {element(0x40, 0x9212, "FD", fd(1) + fd(2))})};
  EXPECT_TRUE(warns(readFile(writeOne(s)), "RealWorldValueMapping is a table"));
}

TEST(DicomValues, PaddingAndColourTablesAreSaid) {
  Slice s = flatSlice(0, 1, 7);
  s.more = {element(0x28, 0x120, "SS", us(7))};
  EXPECT_TRUE(warns(readFile(writeOne(s)), "PixelPaddingValue 7 marks pixels"));
  s.more = {element(0x28, 0x120, "SS", us(8))};
  EXPECT_THAT(readFile(writeOne(s)).warnings, testing::IsEmpty());
  s.more = {element(0x28, 4, "CS", "MONOCHROME1")};
  EXPECT_TRUE(warns(readFile(writeOne(s)), "MONOCHROME1"));
}

TEST(DicomValues, MoreOrFewerBytesThanAnnounced) {
  Slice s = flatSlice(0, 1, 7);
  s.bits = 8;
  s.pixels = std::string(12, '\1');
  EXPECT_TRUE(warns(readFile(writeOne(s)), "the pixel data hold more than the header announces"));
  s.more = {element(0x28, 0x101, "US", us(16))};
  expectError(writeOne(s), "16 bits do not fit");
  s = flatSlice(0, 1, 7);
  s.more = {element(0x28, 0x101, "US", us(12))};
  EXPECT_TRUE(warns(readFile(writeOne(s)), "HighBit 15 contradicts BitsStored 12"));
  s = flatSlice(0, 1, 7);
  s.pixels.resize(8);
  s.more = {element(0xfffc, 0xfffc, "OB", std::string(500, '\0'))};  // padding of the file
  expectError(writeOne(s), "truncated");
}

TEST(DicomValues, DistancesThatContradictPositionsAreSaid) {
  std::vector<Slice> slices{flatSlice(0, 1, 1), flatSlice(2, 2, 2), flatSlice(4, 3, 3)};
  for (Slice& s : slices) s.more = {element(0x18, 0x88, "DS", "3")};
  const auto v = readFile(writeSeries(slices));
  EXPECT_EQ(v.grid->geometry().spacingMm().z, 2);
  EXPECT_TRUE(warns(v, "SpacingBetweenSlices states 3 mm, the positions 2 mm"));
}

}  // namespace
}  // namespace isolux
