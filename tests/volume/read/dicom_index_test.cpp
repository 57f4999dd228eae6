// Lists of DICOM series by their headers, and small pictures of slices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/paths.h"
#include "tests/support/test_data.h"
#include "tests/volume/read/dicom_disc.h"
#include "volume/read/process/dicom_index.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using volume::DicomSeries;

struct Listed {
  std::map<std::string, DicomSeries> series;
  volume::DicomIndexEnd end;
};

Listed listed(const fs::path& folder) {
  Listed list;
  base::Progress progress;
  list.end = volume::indexDicom(
      folder, [&](DicomSeries series) { list.series[series.series] = std::move(series); }, progress);
  return list;
}

TEST(DicomIndex, ADiscIsListedByItsHeaders) {
  const fs::path disc = test::temporaryFolder() / "disc";
  test::writeDicomDisc(disc);
  const Listed list = listed(disc);
  ASSERT_EQ(list.series.size(), 6u);
  const DicomSeries& bone = list.series.at("1.1");
  EXPECT_EQ(bone.patient, (volume::Patient{"DOE^JANE", "ID4711", "19600102"}));
  EXPECT_EQ(bone.study, "1");
  EXPECT_EQ(bone.studyDescription, "Head CT");
  EXPECT_EQ(bone.date, "20240131");
  EXPECT_EQ(bone.description, "axial bone");
  EXPECT_EQ(bone.kernel, "H60s");
  EXPECT_EQ(bone.modality, "CT");
  EXPECT_EQ(bone.number, "1");
  EXPECT_EQ(bone.folder, (disc / "DICOM" / "PA0" / "ST0" / "SE0").string());
  EXPECT_EQ(bone.columns, 16);
  EXPECT_EQ(bone.slices, 16);
  EXPECT_NEAR(bone.spacingMm.x, 2.0, 1e-9);
  EXPECT_NEAR(bone.spacingMm.z, 2.0, 1e-9);
  EXPECT_EQ(bone.problem, "");
  EXPECT_THAT(bone.warnings, testing::IsEmpty());
  EXPECT_EQ(bone.middleFile, (fs::path(bone.folder) / "IM8").string());
  EXPECT_THAT(list.series.at("1.2").warnings, ElementsAre(HasSubstr("gantry tilt of 26.57 degrees")));
  EXPECT_THAT(list.series.at("1.3").warnings, testing::Contains(HasSubstr("slices are missing in 1 place")));
  EXPECT_EQ(list.series.at("1.4").studyDescription, "Head MR");
  EXPECT_THAT(list.series.at("2.1").warnings, ElementsAre(HasSubstr("1 of 5 slices differ")));
  EXPECT_EQ(list.series.at("2.1").slices, 4);
  EXPECT_EQ(list.series.at("2.2").patient.name, "MUSTER^MAX");
  // 38 slices, and one that is cut off.
  EXPECT_EQ(list.end.dicomFiles, 40);
  EXPECT_EQ(list.end.unreadable, 1);
  EXPECT_THAT(list.end.firstReason, HasSubstr("IM9"));
}

TEST(DicomIndex, WhatItSaysIsWhatOpeningFinds) {
  const fs::path disc = test::temporaryFolder() / "disc";
  test::writeDicomDisc(disc);
  for (const auto& [uid, series] : listed(disc).series) {
    volume::ReadOptions options;
    options.series = uid;
    base::Progress progress;
    const volume::Volume volume = volume::readVolume(series.folder, options, progress);
    EXPECT_EQ(volume.grid->dims().x, series.columns) << uid;
    EXPECT_EQ(volume::patientOf(volume.grid), series.patient) << uid;
    for (const std::string& warning : series.warnings)
      EXPECT_THAT(volume.warnings, testing::Contains(warning)) << uid;
    const auto spacing = volume.grid->geometry().spacingMm();
    EXPECT_NEAR(spacing.z, series.spacingMm.z, 1e-9) << uid;
  }
  // The root of a disc opens as well, however deep the slices lie.
  volume::ReadOptions options;
  options.series = "1.4";
  base::Progress progress;
  EXPECT_EQ(volume::readVolume(disc.string(), options, progress).grid->dims().z, 5);
}

TEST(DicomIndex, SlicesInSeveralFoldersAreOneSeries) {
  const fs::path folder = test::temporaryFolder() / "parts";
  test::DicomSlice slice;
  test::writeDicomSeries(folder / "a", slice, 3, [](int i) { return test::placeAt(0, 2.0 * i); });
  test::writeDicomSeries(folder / "b" / "c", slice, 3, [](int i) { return test::placeAt(0, 6.0 + 2.0 * i); });
  const Listed list = listed(folder);
  ASSERT_EQ(list.series.size(), 1u);
  EXPECT_EQ(list.series.begin()->second.slices, 6);
  EXPECT_EQ(list.series.begin()->second.folder, folder.string());
}

TEST(DicomIndex, NoDicomIsAnEmptyListAndNoFolderAnError) {
  const fs::path folder = test::temporaryFolder() / "empty";
  test::writeBytes(folder / "notes.txt", "nothing");
  const Listed list = listed(folder);
  EXPECT_TRUE(list.series.empty());
  EXPECT_EQ(list.end.files, 1);
  EXPECT_EQ(list.end.dicomFiles, 0);
  EXPECT_THROW(listed(folder / "missing"), base::Error);
}

TEST(DicomIndex, ASegmentationIsListedAsWhatItIs) {
  const fs::path folder = test::temporaryFolder() / "mask";
  test::DicomSlice slice;
  slice.sopClass = "1.2.840.10008.5.1.4.1.1.66.4";
  test::writeDicomSeries(folder, slice, 1, [](int) { return test::placeAt(0, 0); });
  EXPECT_THAT(listed(folder).series.at("1.2.3.4").problem, HasSubstr("is a segmentation (SEG), not a scan"));
}

TEST(DicomIndex, DamagedHeadersAreCountedWhateverTheyHold) {
  const fs::path folder = test::temporaryFolder() / "damaged";
  test::DicomSlice slice;
  test::writeDicomSeries(folder, slice, 4, [](int i) { return test::placeAt(0, 2.0 * i); });
  const std::string whole = test::dicom(slice);
  for (std::size_t cut = 140; cut < whole.size(); cut += 37)
    test::writeBytes(folder / ("cut" + std::to_string(cut)), whole.substr(0, cut));
  for (std::size_t at = 132; at < whole.size(); at += 11) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x5a);
    test::writeBytes(folder / ("flip" + std::to_string(at)), bytes);
  }
  const Listed list = listed(folder);
  EXPECT_TRUE(list.series.contains("1.2.3.4"));
  EXPECT_GT(list.end.unreadable, 0);
}

// It ends at "bad1", then at "bad2", each time it is not told to pass them by.
TEST(DicomIndex, AFileThatEndsTheReaderIsLeftOut) {
  std::vector<std::string> found;
  base::Progress progress;
  const auto end = volume::indexDicom(
      "/index", [&](const DicomSeries& series) { found.push_back(series.description); }, progress,
      ISOLUX_FAKE_READER);
  EXPECT_EQ(end.unreadable, 2);
  EXPECT_THAT(end.firstReason, HasSubstr("/index/bad1"));
  EXPECT_THAT(end.firstReason, HasSubstr("segmentation fault"));
  EXPECT_EQ(found.back(), "skipped 2");
  EXPECT_THROW(volume::indexDicom(
                   "/crashes everywhere", [](const DicomSeries&) {}, progress, ISOLUX_FAKE_READER),
               base::Error);
}

TEST(DicomIndex, AStopEndsIt) {
  base::Progress progress;
  progress.requestStop();
  try {
    volume::indexDicom(
        "sleep", [](const DicomSeries&) {}, progress, ISOLUX_FAKE_READER);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
}

TEST(DicomPreview, ShowsTheSliceInSquarePixels) {
  const fs::path folder = test::temporaryFolder() / "slice";
  test::DicomSlice slice;
  slice.spacing = "1\\2";  // rows 1 mm apart, columns 2 mm: twice as wide as high
  test::writeDicomSeries(
      folder, slice, 1, [](int) { return test::placeAt(0, 0); }, 64);
  base::Progress progress;
  const volume::DecodedImage image = volume::previewDicom(folder / "IM0", 0, progress);
  EXPECT_EQ(image.width, 160);
  EXPECT_EQ(image.height, 80);
  const auto at = [&](int x, int y) { return image.pixels[static_cast<std::size_t>(y * image.width + x)].x; };
  EXPECT_GT(at(80, 40), 0.9F) << "the ball is bright";
  EXPECT_LT(at(2, 2), 0.1F) << "the corner is dark";
  EXPECT_THROW(volume::previewDicom(folder / "IM0", 7, progress), base::Error);
  EXPECT_THROW(volume::previewDicom(folder / "missing", 0, progress), base::Error);
}

}  // namespace
}  // namespace isolux
