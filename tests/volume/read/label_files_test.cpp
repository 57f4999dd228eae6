// Files that state labels, and files that name them.
#include "volume/read/label_files.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/volume/read/reader_support.h"
#include "volume/labels/freesurfer_labels.h"
#include "volume/labels/label_table.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/label_names.h"

namespace isolux::volume {
namespace {

namespace fs = std::filesystem;
using test::bytesOf;
using test::expectError;
using test::readFile;
using test::writeFile;
using testing::HasSubstr;

std::shared_ptr<const PreparedVolume> load(const fs::path& path, const scene::Source& how = {}) {
  scene::Source source = how;
  source.path = path.string();
  base::Progress progress;
  return loadVolume(source, progress);
}

scene::Source ofComponent(int component) {
  scene::Source source;
  source.component = component;
  return source;
}
scene::Source ofStep(double step) {
  scene::Source source;
  source.timeStep = step;
  return source;
}
scene::Source ofLevel(int level) {
  scene::Source source;
  source.level = level;
  return source;
}
scene::Source ofKind(scene::DataKind kind) {
  scene::Source source;
  source.kind = kind;
  return source;
}

void expectColor(const LabelTable* table, std::int64_t label, glm::dvec3 srgb) {
  const glm::vec3 wanted = linearFromSrgb(srgb), got = labelColor(table, label);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], wanted[i], 1e-6) << label;
}

// 4 x 4 x 4 voxels, two layers: slices z < 2 have label 1 in the first, x < 2 label 2 in the second.
std::string segNrrd(const std::string& segments, int layers = 2) {
  std::string voxels;
  for (int i = 0; i < 64; ++i) {
    voxels += i / 16 < 2 ? '\1' : '\0';
    if (layers > 1) voxels += i % 4 < 2 ? '\2' : '\0';
  }
  const std::string axes = layers > 1
                               ? "dimension: 4\nsizes: 2 4 4 4\nspace directions: none (1,0,0) (0,1,0) "
                                 "(0,0,1)\nkinds: list domain domain domain\n"
                               : "dimension: 3\nsizes: 4 4 4\nspace directions: (1,0,0) (0,1,0) "
                                 "(0,0,1)\n";
  return "NRRD0004\ntype: uint8\nspace: LPS\nencoding: raw\n" + axes + segments + "\n" + voxels;
}

const std::string kSegments =
    "Segment0_ID:=a\nSegment0_Name:=left lung\nSegment0_Color:=0.5 0.25 1\nSegment0_LabelValue:=1\n"
    "Segment0_Layer:=0\nSegment1_Name:=heart\nSegment1_LabelValue:=2\nSegment1_Layer:=1\n";

TEST(LabelFiles, LayersOfASegNrrdHaveTheirOwnNames) {
  const fs::path path = test::temporaryFolder() / "named.nrrd";
  writeFile(path, segNrrd(kSegments));
  const auto first = load(path);
  EXPECT_EQ(first->kind.kind, scene::DataKind::labels);
  EXPECT_EQ(first->kind.reason, "its header lists segments");
  EXPECT_EQ(first->volume.labels, 1);
  EXPECT_EQ(labelName(first->volume.labelTable.get(), 1), "left lung");
  EXPECT_EQ(labelName(first->volume.labelTable.get(), 2), "");
  expectColor(first->volume.labelTable.get(), 1, {0.5, 0.25, 1.0});
  EXPECT_TRUE(test::warns(first->volume, "2 layers of labels, layer 0 (left lung) is shown"));
  EXPECT_EQ(first->facts.suggestedIsovalue, 0.0);
  base::Progress progress;
  EXPECT_EQ(first->derivativeChoices->noise(progress).at(0.5), 0.0);
  const auto second = load(path, ofComponent(1));
  EXPECT_EQ(labelName(second->volume.labelTable.get(), 2), "heart");
  EXPECT_EQ(second->labels->grid().value(1, 0, 3), 2.0);
  expectError(path, "labels have no magnitude", readOptions(ofComponent(-1)), base::ErrorKind::usage);
}

TEST(LabelFiles, SegmentsThatAreWrongAreRefusedOrSaid) {
  const fs::path path = test::temporaryFolder() / "wrong.nrrd";
  writeFile(path, segNrrd("Segment0_Layer:=2\n"));
  expectError(path, "layer 2 does not exist");
  writeFile(path, segNrrd("Segment0_LabelValue:=one\n"));
  expectError(path, "is not a whole number");
  writeFile(path, segNrrd("Segment0_Color:=red\nSegment0_Layer:=0\n"));
  EXPECT_TRUE(test::warns(readFile(path), "color is not three numbers"));
  writeFile(path, segNrrd("Segmentation_SourceRepresentation:=Fractional labelmap\nSegment0_Name:=a\n", 1));
  EXPECT_EQ(readFile(path).labelTable, nullptr) << "shares are no labels";
  writeFile(path, segNrrd("Segment0_Name:=a\nSegment1_Name:=b\n"));
  EXPECT_EQ(labelName(readFile(path, readOptions(ofComponent(1))).labelTable.get(), 1), "b")
      << "without a layer each segment is a component of its own, with the value 1";
}

TEST(LabelFiles, AnEmptySegmentationIsStillLabels) {
  const fs::path path = test::temporaryFolder() / "empty.seg.nrrd";
  writeFile(path, "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nspacings: 1 1 1\nencoding: raw\n\n" +
                      std::string(64, '\0'));
  const auto empty = load(path);
  EXPECT_EQ(empty->kind.kind, scene::DataKind::labels);
  EXPECT_EQ(empty->volume.labels, 0);
  EXPECT_EQ(load(path, ofKind(scene::DataKind::other))->kind.kind, scene::DataKind::other)
      << "who says what the values are has the last word";
}

TEST(LabelFiles, StatedLabelsThatAreFractionsAreQuantities) {
  const fs::path path = test::temporaryFolder() / "a_dseg.nrrd";
  writeFile(path,
            "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: raw\n"
            "endian: little\n\n" +
                bytesOf(test::ramp<float>(8, 0.0f, 0.5f)));
  const auto fractions = load(path);
  EXPECT_NE(fractions->kind.kind, scene::DataKind::labels);
  EXPECT_TRUE(test::warns(fractions->volume, "values are no whole numbers"));
}

test::NiftiFile niftiLabels() {
  test::NiftiFile file;
  file.sformCode = 1;
  file.voxels = bytesOf<std::uint8_t>({0, 0, 1, 1, 2, 2, 2, 5});
  return file;
}

std::string extension(const std::string& content) {
  const std::size_t size = (8 + content.size() + 15) / 16 * 16;
  std::string bytes = bytesOf<std::int32_t>({static_cast<std::int32_t>(size), 0}) + content;
  bytes.resize(size, '\0');
  return bytes;
}

TEST(LabelFiles, ExtensionsOfNiftiNameLabels) {
  const std::string table = extension(
      "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation Index=\"0\"><LabelTable>"
      "<Label Key=\"1\" Red=\"0.5\" Green=\"0\" Blue=\"1\" Alpha=\"1\"><![CDATA[spleen]]></Label>"
      "<Label Key=\"2\">kidney</Label></LabelTable></VolumeInformation></CaretExtension>");
  test::NiftiFile file = niftiLabels();
  const std::string other = extension("<other/>");
  file.voxOffset = static_cast<float>(352 + other.size() + table.size());
  std::string bytes = file.header() + std::string("\1\0\0\0", 4) + other + table + file.voxels;
  const auto folder = test::temporaryFolder();
  writeFile(folder / "t.nii", bytes);
  writeFile(folder / "t.nii.gz", test::gzipped(bytes));
  for (const char* name : {"t.nii", "t.nii.gz"}) {
    const auto v = load(folder / name);
    EXPECT_EQ(v->kind.reason, "its header has a table of labels") << name;
    EXPECT_EQ(v->volume.labels, 3);
    const LabelTable* const labels = v->volume.labelTable.get();
    EXPECT_EQ(labelName(labels, 1), "spleen");
    EXPECT_EQ(labelName(labels, 2), "kidney");
    expectColor(labels, 1, {0.5, 0.0, 1.0});
  }
  for (const std::size_t at : {std::size_t{352}, std::size_t{352 + 4}}) {  // a size that is none
    std::string damaged = bytes;
    damaged[at] = '\xff';
    damaged[at + 3] = '\xff';
    writeFile(folder / "d.nii", damaged);
    EXPECT_EQ(readFile(folder / "d.nii").grid->value(1, 1, 1), 5.0);
  }
}

TEST(LabelFiles, NamesOfFilesStateLabels) {
  for (const char* name : {"sub-01_dseg.nii.gz", "aparc+aseg.mgz", "aseg.nii", "wmparc.mgz", "x.seg.nrrd"})
    EXPECT_NE(labelsByName(name), "") << name;
  for (const char* name : {"T1.mgz", "brain.nii.gz", "aseg.nrrd", "dseg_T1.nii", "seg.nrrd"})
    EXPECT_EQ(labelsByName(name), "") << name;
  EXPECT_EQ(labelsByName("a/sub-01_dseg.nii.gz"), "its name ends in _dseg");
}

TEST(LabelFiles, FreeSurfersTableNamesFreeSurfersVolumes) {
  const fs::path folder = test::temporaryFolder(), home = test::temporaryFolder();
  for (const char* name : {"aseg.nii", "brain.nii"}) writeFile(folder / name, niftiLabels().bytes());
  writeFile(home / "FreeSurferColorLUT.txt",
            "#No. Label Name:  R  G  B  A\n0 Unknown 0 0 0 0\n\n5 Left-Inf-Lat-Vent 196 58 250 0\n");
  ASSERT_EQ(setenv("FREESURFER_HOME", home.c_str(), 1), 0);
  const auto named = load(folder / "aseg.nii"), other = load(folder / "brain.nii");
  ASSERT_EQ(unsetenv("FREESURFER_HOME"), 0);
  EXPECT_EQ(named->kind.reason, "its name is that of FreeSurfer's labels");
  EXPECT_EQ(labelName(named->volume.labelTable.get(), 5), "Left-Inf-Lat-Vent");
  expectColor(named->volume.labelTable.get(), 5, {196 / 255.0, 58 / 255.0, 250 / 255.0});
  EXPECT_EQ(named->volume.labelTable->source, "FreeSurferColorLUT.txt");
  EXPECT_EQ(other->volume.labelTable, nullptr);
  const auto builtIn = load(folder / "aseg.nii");
  EXPECT_EQ(builtIn->volume.labelTable->source, "FreeSurfer");
  EXPECT_EQ(labelName(builtIn->volume.labelTable.get(), 5), "Left-Inf-Lat-Vent");
  EXPECT_EQ(labelName(builtIn->volume.labelTable.get(), 1035), "ctx-lh-insula");
  EXPECT_EQ(labelName(builtIn->volume.labelTable.get(), 4001), "wm-rh-bankssts");
  EXPECT_TRUE(std::ranges::is_sorted(freesurferLabels(), {}, &Label::value));
  fs::copy_file(home / "FreeSurferColorLUT.txt", folder / "FreeSurferColorLUT.txt");
  EXPECT_EQ(labelName(load(folder / "aseg.nii")->volume.labelTable.get(), 5), "Left-Inf-Lat-Vent");
}

TEST(LabelNames, OfEveryFormat) {
  const auto bids = labelNamesIn("name\tindex\tcolor\nliver\t1\t#8000FF\n\nspleen\t5\tn/a\n", "a_dseg.tsv");
  ASSERT_EQ(bids.size(), 2u);
  EXPECT_EQ(bids[1].name, "spleen");
  EXPECT_EQ(bids[1].value, 5);
  EXPECT_EQ(bids[0].color, linearFromSrgb({128 / 255.0, 0.0, 1.0}));
  EXPECT_FALSE(bids[1].color);
  const auto newer =
      labelNamesIn(R"({"labels": {"background": 0, "liver": 1, "whole": [1, 2]}})", "dataset.json");
  ASSERT_EQ(newer.size(), 2u);
  EXPECT_EQ(newer[1].name, "liver");
  const auto older = labelNamesIn(R"({"labels": {"0": "background", "7": "heart"}})", "dataset.json");
  ASSERT_EQ(older.size(), 2u);
  EXPECT_EQ(older[1].value, 7);
  EXPECT_EQ(older[1].name, "heart");
  const auto snap = labelNamesIn(
      "# ITK-SnAP\n  0 0 0 0 0 0 0 \"Clear Label\"\n  3 255 0 128 1 1 1 \"left lung\"\n", "labels.txt");
  ASSERT_EQ(snap.size(), 2u);
  EXPECT_EQ(snap[1].name, "left lung");
  EXPECT_EQ(snap[1].color, linearFromSrgb({1.0, 0.0, 128 / 255.0}));
  const auto slicer = labelNamesIn("# Color table\r\n17 Left-Hippocampus 220 216 20 0\r\n", "a.ctbl");
  ASSERT_EQ(slicer.size(), 1u);
  EXPECT_EQ(slicer[0].value, 17);
  EXPECT_EQ(slicer[0].name, "Left-Hippocampus");
}

TEST(LabelNames, WhatIsWrongIsRefusedWithItsLine) {
  const auto refuse = [](const char* text, const char* file, const char* reason) {
    try {
      labelNamesIn(text, file);
      ADD_FAILURE() << text;
    } catch (const base::Error& error) {
      EXPECT_THAT(std::string(error.what()), HasSubstr(reason));
    }
  };
  refuse("index\tlabel\n", "a.tsv", "no columns \"index\" and \"name\"");
  refuse("index\tname\n1\n", "a.tsv", "line 2");
  refuse("index\tname\nx\ty\n", "a.tsv", "not the number of a label");
  refuse("index\tname\n", "a.tsv", "names no labels");
  refuse("{\"labels\": 3}", "dataset.json", "labels");
  refuse("{\"labels\": {\"liver\": \"one\"}}", "dataset.json", "has no number");
  refuse("{", "dataset.json", "labels");
  refuse("1 2 3 \"x\"\n", "a.label", "line 1");
  refuse("1 name 300 0 0 0\n", "a.ctbl", "from 0 to 255");
  refuse("some notes\n", "a.txt", "line 1");
}

TEST(LabelFiles, FilesBesideNameLabelsAndStateThemWhereTheyFit) {
  const fs::path folder = test::temporaryFolder() / "labelsTr";
  fs::create_directories(folder);
  writeFile(folder / "case.nii.gz", test::gzipped(niftiLabels().bytes()));
  EXPECT_EQ(load(folder / "case.nii.gz")->volume.labelTable, nullptr);
  writeFile(folder.parent_path() / "dataset.json",
            R"({"labels": {"background": 0, "liver": 1, "heart": 5}})");
  const auto network = load(folder / "case.nii.gz");
  EXPECT_EQ(network->kind.reason, "dataset.json beside it names labels");
  EXPECT_EQ(network->volume.labelTable->source, "dataset.json");
  EXPECT_EQ(labelName(network->volume.labelTable.get(), 5), "heart");
  writeFile(folder / "case.txt", "notes that name nothing\n");
  EXPECT_EQ(load(folder / "case.nii.gz")->volume.labelTable, nullptr)
      << "the file of its own name comes first";
  fs::remove(folder / "case.txt");
  writeFile(folder / "case.ctbl", "1 liver 255 0 0 255\n2 heart 0 255 0 255\n");
  const auto table = load(folder / "case.nii.gz");
  EXPECT_NE(table->kind.reason, "case.ctbl beside it names labels") << "5 is not in the table";
  EXPECT_EQ(labelName(table->volume.labelTable.get(), 2), "heart");
  writeFile(folder / "case.ctbl", "nonsense\n");
  EXPECT_TRUE(test::warns(readFile(folder / "case.nii.gz"), "names of labels are not read: case.ctbl"));
}

// Labels have no means: no blended steps, no coarse levels.
TEST(LabelFiles, LabelsAreNotBlended) {
  const fs::path folder = test::temporaryFolder();
  for (const int step : {0, 1}) {
    test::NiftiFile file = niftiLabels();
    file.intent = 1002;
    if (step == 1) file.voxels = bytesOf<std::uint8_t>({7, 7, 7, 7, 7, 7, 7, 0});
    writeFile(folder / ("t" + std::to_string(step) + ".nii"), file.bytes());
  }
  const fs::path steps = folder / "t*.nii";
  const auto at = [&](double step) { return load(steps, ofStep(step)); };
  EXPECT_EQ(at(0.25)->labels->grid().value(1, 1, 1), 5.0);
  EXPECT_EQ(at(0.75)->labels->grid().value(0, 0, 0), 7.0);
  EXPECT_TRUE(test::warns(at(0.75)->volume, "labels are not blended"));
  EXPECT_FALSE(test::warns(at(1.0)->volume, "labels are not blended"));
}

TEST(LabelFiles, LabelsHaveNoCoarseLevels) {
  const fs::path path = test::temporaryFolder() / "big.nrrd";
  const std::string head =
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 32 32 32\nspacings: 1 1 1\nencoding: raw\n";
  writeFile(path, head + "Segment0_Name:=liver\n\n" + std::string(32768, '\1'));
  try {
    load(path, ofLevel(1));
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_THAT(std::string(error.what()), HasSubstr("labels, which have no means"));
  }
  scene::Source source;
  source.path = path.string();
  scene::HostSettings host;
  host.voxels = scene::VoxelPlace::file;
  base::Progress progress;
  const auto inFile = loadVolume(source, host, progress);
  EXPECT_EQ(inFile->kind.kind, scene::DataKind::labels) << "also where voxels are not counted";
  EXPECT_EQ(labelName(inFile->volume.labelTable.get(), 1), "liver");
  EXPECT_EQ(inFile->facts.suggestedIsovalue, 0.5);
  writeFile(path, head + "\n" + std::string(32768, '\1'));
  EXPECT_EQ(load(path, ofLevel(1))->grid().dims(), glm::ivec3(16));
}

}  // namespace
}  // namespace isolux::volume
