// Blends of two time steps, and files that are time steps, against values written out.
#include <cmath>
#include <fstream>
#include <limits>

#include "tests/volume/read/reader_support.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/source_files.h"
#include "volume/read/step_files.h"

namespace isolux::volume {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kVoxels = 4 * 4 * 4, kSteps = 3;
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

std::string headerOf(const std::string& type, const std::string& spacing = "1") {
  return "NRRD0004\ntype: " + type + "\nencoding: raw\nendian: little\nspacings: " + spacing + " 1 1";
}

// Of step s, voxel i: s squared + i; the voxel s is missing.
std::vector<float> valuesOfStep(int step) {
  std::vector<float> values(kVoxels);
  for (int i = 0; i < kVoxels; ++i) values[static_cast<std::size_t>(i)] = static_cast<float>(step * step + i);
  values[static_cast<std::size_t>(step)] = kMissing;
  return values;
}

std::string fileOfStep(int step) {
  return headerOf("float") + "\ndimension: 3\nsizes: 4 4 4\n\n" + test::bytesOf(valuesOfStep(step));
}

// t_8.nrrd, t_9.nrrd, t_10.nrrd
fs::path writeSteps() {
  const fs::path folder = test::temporaryFolder();
  for (int step = 0; step < kSteps; ++step)
    test::writeFile(folder / ("t_" + std::to_string(8 + step) + ".nrrd"), fileOfStep(step));
  return folder;
}

std::string writeFourDimensions(const fs::path& folder) {
  std::string voxels;
  for (int step = 0; step < kSteps; ++step) voxels += test::bytesOf(valuesOfStep(step));
  test::writeFile(folder / "all.nrrd", headerOf("float") +
                                           " nan\ndimension: 4\nsizes: 4 4 4 3\n"
                                           "kinds: domain domain domain list\n\n" +
                                           voxels);
  return (folder / "all.nrrd").string();
}

std::shared_ptr<const PreparedVolume> load(const std::string& path, double step, int level = 0) {
  scene::Source source;
  source.path = path;
  source.timeStep = step;
  source.level = level;
  base::Progress unwatched;
  return loadVolume(source, unwatched);
}

void expectRefused(const std::string& path, double step, const std::string& file, const std::string& reason) {
  try {
    load(path, step);
    ADD_FAILURE() << path << " at " << step;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.file(), file);
    EXPECT_THAT(error.reason(), HasSubstr(reason));
  }
}

bool sameValues(const Grid& a, const Grid& b) {
  return a.hash() == b.hash() && a.storedType() == b.storedType();
}

TEST(TimeSteps, AFractionBlendsVoxelByVoxelAndWhatIsMissingInEitherIsMissing) {
  const std::string path = writeFourDimensions(test::temporaryFolder());
  for (const double at : {0.25, 1.5}) {
    const auto blend = load(path, at);
    EXPECT_EQ(blend->volume.timeSteps, kSteps);
    EXPECT_EQ(blend->grid().missingCount(), 2u);
    const int step = static_cast<int>(at);
    const auto first = valuesOfStep(step), second = valuesOfStep(step + 1);
    const auto got = test::valuesOf(blend->volume);
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double fraction = at - step, wanted = (1.0 - fraction) * first[i] + fraction * second[i];
      if (std::isnan(wanted))
        ASSERT_TRUE(std::isnan(got[i])) << i;
      else
        ASSERT_EQ(got[i], wanted) << i;
    }
  }
  EXPECT_TRUE(test::warns(load(path, 1.5)->volume, "3 time steps, step 1.5, a blend of 1 and 2, is shown"));
  EXPECT_TRUE(test::warns(load(path, 1)->volume, "3 time steps, step 1 is shown"));
}

TEST(TimeSteps, IntegersBlendInDataUnits) {
  const fs::path folder = test::temporaryFolder();
  test::NiftiFile file;
  file.dims = {2, 1, 1, 2};
  file.slope = 0.5;
  file.intercept = -10;
  file.voxels = std::string("\x00\x64\x32\x64", 4);  // 0 100, 50 100
  test::writeFile(folder / "a.nii", file.bytes());
  EXPECT_THAT(test::valuesOf(load((folder / "a.nii").string(), 0.5)->volume), ElementsAre(2.5, 40.0));
}

TEST(TimeSteps, FilesAreTheStepsOfOneFileInNaturalOrder) {
  const fs::path folder = writeSteps();
  const std::string whole = writeFourDimensions(folder), series = (folder / "t_*.nrrd").string();
  for (const double step : {0.0, 1.0, 2.0, 0.5}) {
    const auto a = load(series, step), b = load(whole, step);
    EXPECT_TRUE(sameValues(a->grid(), b->grid())) << step;
    EXPECT_EQ(a->volume.timeSteps, kSteps);
    EXPECT_TRUE(test::warns(a->volume, "3 time steps"));
  }
  const std::string list = (folder / "t_10.nrrd;t_8.nrrd").string();
  EXPECT_TRUE(sameValues(load(list, 0)->grid(), load(whole, 2)->grid()));
  EXPECT_TRUE(sameValues(load(list, 1)->grid(), load(whole, 0)->grid()));
  EXPECT_EQ(filesOfVolume(series).size(), 3u);
}

TEST(TimeSteps, CoarseLevelsBlend) {
  const fs::path folder = test::temporaryFolder();
  for (int step = 0; step < 2; ++step) {
    std::vector<float> voxels(32 * 16 * 16);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<float>(i % 7 + 10 * step);
    test::writeFile(folder / ("t" + std::to_string(step) + ".nrrd"),
                    headerOf("float") + "\ndimension: 3\nsizes: 32 16 16\n\n" + test::bytesOf(voxels));
  }
  const std::string series = (folder / "t*.nrrd").string();
  const auto a = test::valuesOf(load(series, 0, 1)->volume), b = test::valuesOf(load(series, 0.5, 1)->volume);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_LT(a.size(), 32u * 16 * 16);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_FLOAT_EQ(b[i], a[i] + 5.0);
}

TEST(TimeSteps, StepsThatAreNotThereAreRefused) {
  const fs::path folder = writeSteps();
  const std::string whole = writeFourDimensions(folder), series = (folder / "t_*.nrrd").string();
  expectRefused(whole, 3, whole, "time step 3 does not exist; the file has 3");
  for (const std::string& path : {whole, series})
    expectRefused(path, 2.5, path, "time step 2.5 does not exist; the file has 3");
  expectRefused(series, 3, series, "time step 3 does not exist");
  expectRefused("phantom:ball:8", 0.5, "phantom:ball:8", "time step 0.5 does not exist; the file has 1");
  expectRefused((folder / "u_*.nrrd").string(), 0, (folder / "u_*.nrrd").string(), "");
}

TEST(TimeSteps, FilesThatDoNotFitAreNamed) {
  const fs::path folder = writeSteps();
  const auto refuses = [&](const std::string& name, const std::string& content, const std::string& reason) {
    test::writeFile(folder / name, content);
    for (const double step : {0, 1})
      expectRefused((folder / ("t_8.nrrd;" + name)).string(), step, (folder / name).string(), reason);
  };
  const std::string voxels = test::bytesOf(valuesOfStep(0));
  refuses("size.nrrd", headerOf("float") + "\ndimension: 3\nsizes: 4 4 2\n\n" + voxels,
          "is no time step of t_8.nrrd: its voxels differ in size (4x4x2, not 4x4x4)");
  refuses("spacing.nrrd", headerOf("float", "2") + "\ndimension: 3\nsizes: 4 4 4\n\n" + voxels,
          "spacing or position");
  refuses("type.nrrd", headerOf("uint8") + "\ndimension: 3\nsizes: 4 4 4\n\n" + voxels,
          "differ in type (uint8, not float32)");
  writeFourDimensions(folder);
  expectRefused((folder / "t_8.nrrd;all.nrrd").string(), 1, (folder / "all.nrrd").string(),
                "it has 3 of its own");
  expectRefused((folder / "t_8.nrrd;none.nrrd").string(), 1, (folder / "none.nrrd").string(), "");
}

TEST(StepFiles, AFileWithTheCharactersOfASeriesInItsNameIsItself) {
  const fs::path folder = writeSteps();
  for (const char* name : {"t_*.nrrd", "t_8.nrrd;t_9.nrrd"}) {
    test::writeFile(folder / name, fileOfStep(2));
    EXPECT_THAT(stepFiles((folder / name).string()), testing::IsEmpty());
    EXPECT_EQ(load((folder / name).string(), 0)->volume.timeSteps, 1);
  }
  EXPECT_THAT(stepFiles("phantom:ball;torus"), testing::IsEmpty());
}

TEST(StepFiles, ThePathOfFilesIsAPatternWhereItStandsForNoOthers) {
  const fs::path folder = writeSteps();
  const auto at = [&](const char* name) { return (folder / name).string(); };
  EXPECT_EQ(pathOfSteps({at("t_10.nrrd"), at("t_8.nrrd"), at("t_9.nrrd")}), at("t_*.nrrd"));
  EXPECT_EQ(pathOfSteps({at("t_10.nrrd"), at("t_8.nrrd")}), at("t_8.nrrd;t_10.nrrd"));
  EXPECT_EQ(pathOfSteps({at("t_8.nrrd")}), "");
  EXPECT_EQ(pathOfSteps({at("t_8.nrrd"), "/elsewhere/t_9.nrrd"}), "");
  EXPECT_THAT(stepFiles(at("t_8*;t_9.nrrd")), ElementsAre(at("t_8.nrrd"), at("t_9.nrrd")));
}

}  // namespace
}  // namespace isolux::volume
