// Zarr folders made by hand: what is refused, and how; parts of what is read. Files by independent writers:
// compare_chunked.py.
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/memory_store.h"
#include "tests/support/test_data.h"
#include "tests/volume/read/reader_support.h"
#include "volume/labels/label_table.h"
#include "volume/read/chunks/checksums.h"
#include "volume/read/volume_file.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::volume {
namespace {

using Files = std::map<std::string, std::string>;
using testing::HasSubstr;

// 4 x 4 x 4 of uint16 in chunks of 2 x 3 x 4 (z, y, x), uncompressed; values z * 100 + y * 10 + x.
Files plainArray() {
  Files files;
  files[".zarray"] = R"({"zarr_format": 2, "shape": [4, 4, 4], "chunks": [2, 3, 4], "dtype": "<u2",
    "compressor": null, "fill_value": 7, "order": "C", "filters": null})";
  for (int cz = 0; cz < 2; ++cz)
    for (int cy = 0; cy < 2; ++cy) {
      std::vector<std::uint16_t> voxels;
      for (int z = 2 * cz; z < 2 * cz + 2; ++z)
        for (int y = 3 * cy; y < 3 * cy + 3; ++y)
          for (int x = 0; x < 4; ++x) voxels.push_back(static_cast<std::uint16_t>(z * 100 + y * 10 + x));
      files[std::to_string(cz) + "." + std::to_string(cy) + ".0"] = test::bytesOf(voxels);
    }
  return files;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::unique_ptr<ArrayVolume> opened(const Files& files) {
  return openZarr(std::make_shared<const test::MemoryStore>(files), "", "test.zarr", "");
}

std::vector<std::uint16_t> readBox(const ChunkedVolume& volume, glm::ivec3 low, glm::ivec3 size) {
  std::vector<std::uint16_t> voxels(static_cast<std::size_t>(size.x * size.y * size.z));
  volume.read({}, 0, low, size, std::as_writable_bytes(std::span(voxels)));
  return voxels;
}

// What opening and reading all of it throws; "" where nothing.
std::string refusal(const Files& files) {
  try {
    const auto zarr = opened(files);
    base::Progress progress;
    wholeVolume(*zarr, {}, progress);
    return {};
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    return error.what();
  }
}

TEST(Zarr, ABoxAcrossChunksHasItsOwnVoxels) {
  const auto zarr = opened(plainArray());
  EXPECT_EQ(zarr->facts().levels[0].chunkDims, glm::ivec3(4, 3, 2));
  EXPECT_THAT(readBox(*zarr, {1, 2, 1}, {2, 2, 2}),
              testing::ElementsAre(121, 122, 131, 132, 221, 222, 231, 232));
}

TEST(Zarr, OfAChunkThatIsNotPackedOnlyWhatIsAskedForIsRead) {
  const auto zarr = opened(plainArray());
  std::vector<std::uint16_t> voxels(2);
  EXPECT_EQ(zarr->read({}, 0, {1, 1, 1}, {2, 1, 1}, std::as_writable_bytes(std::span(voxels))), 4u);
  EXPECT_THAT(voxels, testing::ElementsAre(111, 112));
}

TEST(Zarr, AMissingChunkHasTheFillValue) {
  Files files = plainArray();
  files.erase("1.0.0");
  const auto zarr = opened(files);
  EXPECT_THAT(readBox(*zarr, {0, 2, 1}, {1, 2, 2}), testing::ElementsAre(120, 130, 7, 230));
}

// As a Grid of the whole holds them.
TEST(Zarr, InfiniteVoxelsAreMissing) {
  Files files;
  files[".zarray"] = R"({"zarr_format": 2, "shape": [1, 1, 4], "chunks": [1, 1, 2], "dtype": "<f8",
    "compressor": null, "fill_value": "Infinity", "order": "C", "filters": null})";
  files["0.0.0"] = test::bytesOf(std::vector<double>{2.5, -1e300});
  const auto zarr = opened(files);
  std::vector<float> voxels(4);
  zarr->read({}, 0, {0, 0, 0}, {4, 1, 1}, std::as_writable_bytes(std::span(voxels)));
  EXPECT_THAT(voxels, testing::ElementsAre(2.5f, testing::IsNan(), testing::IsNan(), testing::IsNan()));
  EXPECT_EQ(zarr->facts().wholeVoxelBytes, 12u) << "doubles, and the floats made of them";
}

TEST(Zarr, DamagedChunksAreNamed) {
  Files files = plainArray();
  files["1.0.0"].resize(47);
  EXPECT_THAT(refusal(files), testing::AllOf(HasSubstr("1.0.0: chunk 1/0/0"), HasSubstr("47 bytes")));
  for (const char* codec : {"zlib", "gzip", "zstd", "bz2", "lz4", "blosc"}) {
    Files packed = plainArray();
    packed[".zarray"] = replaced(packed[".zarray"], R"("compressor": null)",
                                 std::string(R"("compressor": {"id": ")") + codec + R"("})");
    EXPECT_THAT(refusal(packed), testing::AllOf(HasSubstr(": chunk "), HasSubstr("data are damaged")))
        << codec;
    for (auto& [name, bytes] : packed)
      if (name != ".zarray") bytes.clear();
    EXPECT_THAT(refusal(packed), HasSubstr("damaged")) << codec;
  }
}

TEST(Zarr, MetadataThatCannotBeAreRefused) {
  const std::string good = plainArray()[".zarray"];
  const std::pair<const char*, const char*> cases[] = {
      {"[4, 4, 4]", "[4, 4, 0]"},
      {"[4, 4, 4]", "[4, 4, -4]"},
      {"[4, 4, 4]", "[4, 4, 4.5]"},
      {"[4, 4, 4]", "[4, 4]"},
      {"[4, 4, 4]", "[4, 4, 70000]"},
      {"[4, 4, 4]", "4"},
      {"[4, 4, 4]", "[]"},
      {"[2, 3, 4]", "[2, 3, 18446744073709551615]"},
      {"[2, 3, 4]", "[4294967296, 4294967296, 4294967296]"},
      {"[2, 3, 4]", "[0, 3, 4]"},
      {"\"<u2\"", "\"<c8\""},
      {"\"<u2\"", "\"<u3\""},
      {"\"<u2\"", "[[\"a\", \"<u2\"]]"},
      {"\"<u2\"", "\"|u2\""},
      {"\"C\"", "\"D\""},
      {"null", "{\"id\": \"lzma\"}"},
      {"null", "{}"},
      {"\"zarr_format\": 2", "\"zarr_format\": 9"},
      {"7", "\"x\""},
      {"7", "{}"},
      {"{", "["},
      {"\"filters\": null", "\"filters\": [{\"id\": \"delta\"}]"}};
  for (const auto& [what, by] : cases) {
    Files files = plainArray();
    files[".zarray"] = replaced(good, what, by);
    EXPECT_THAT(refusal(files), testing::AnyOf(HasSubstr(".zarray"), HasSubstr("dims: an axis has 70000")))
        << by;
  }
}

TEST(Zarr, APathThatLeavesTheFolderIsRefused) {
  for (const char* path : {"../secret", "/etc", "a/../../b"}) {
    Files files;
    files[".zattrs"] = std::string(R"({"multiscales": [{"axes": ["z", "y", "x"], "datasets": [{"path": ")") +
                       path + R"("}]}]})";
    EXPECT_THAT(refusal(files), HasSubstr("leaves the folder")) << path;
  }
}

// Level 1 has half of the voxels of level 0, at twice their distance.
Files image(const std::string& spacing, const std::string& levelOne) {
  Files files;
  for (const auto& [name, text] : plainArray()) files["0/" + name] = text;
  files["1/.zarray"] = replaced(plainArray()[".zarray"], "[4, 4, 4]", "[2, 2, 2]");
  files[".zattrs"] =
      R"({"multiscales": [{"version": "0.4", "axes": [{"name": "z", "type": "space", "unit": "mm"},
    {"name": "y", "type": "space", "unit": "mm"}, {"name": "x", "type": "space", "unit": "mm"}], "datasets": [
    {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": )" +
      spacing + R"(}]}, {"path": "1", "coordinateTransformations": [)" + levelOne + "]}]}]}";
  return files;
}

TEST(Zarr, LevelsWithoutAPlaceShareTheirOuterFaces) {
  const auto zarr = opened(image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})"));
  const ChunkedFacts& facts = zarr->facts();
  ASSERT_EQ(facts.levels.size(), 2u);
  EXPECT_EQ(facts.levels[0].geometry.spacingMm(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(facts.levels[1].geometry.originMm(), glm::dvec3(0.5, 1, 1.5));
}

TEST(Zarr, ALevelThatLiesElsewhereIsLeftOut) {
  const auto zarr = opened(image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]},
    {"type": "translation", "translation": [0, 0, 40]})"));
  EXPECT_EQ(zarr->facts().levels.size(), 1u);
  EXPECT_THAT(zarr->facts().warnings, testing::Contains(HasSubstr("is not at the position of level 0")));
}

TEST(Zarr, ImagesBeforeVersion03HaveAlwaysTheSameAxes) {
  for (const char* version : {"0.1", "0.2"}) {
    Files files = plainArray();
    std::string& array = files[".zarray"];
    array = replaced(replaced(array, "[4, 4, 4]", "[1, 1, 4, 4, 4]"), "[2, 3, 4]", "[1, 1, 2, 3, 4]");
    Files image;
    for (const auto& [name, bytes] : files) image[name[0] == '.' ? "0/" + name : "0/0.0." + name] = bytes;
    image[".zattrs"] =
        std::string(R"({"multiscales": [{"version": ")") + version + R"(", "datasets": [{"path": "0"}]}]})";
    const ChunkedFacts facts = opened(image)->facts();
    EXPECT_EQ(facts.levels[0].geometry.dims, glm::ivec3(4)) << version;
  }
}

TEST(Zarr, CodecsAndTypesThatAreNotReadAreNamed) {
  const std::string array = R"({"zarr_format": 3, "node_type": "array", "shape": [4, 4, 4], "data_type": TYPE,
    "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [4, 4, 4]}},
    "chunk_key_encoding": {"name": "default"}, "fill_value": 0, "codecs": [{"name": "CODEC"}]})";
  EXPECT_THAT(refusal({{"zarr.json", replaced(replaced(array, "TYPE", "\"uint8\""), "CODEC", "zfpy")}}),
              HasSubstr("the codec \"zfpy\" is not read"));
  EXPECT_THAT(refusal({{"zarr.json", replaced(replaced(array, "TYPE", "\"uint8\""), "CODEC", "gzip")}}),
              HasSubstr("the codec bytes is missing before it"));
  EXPECT_THAT(refusal({{"zarr.json", replaced(replaced(array, "TYPE", R"({"name": "numpy.datetime64"})"),
                                              "CODEC", "bytes")}}),
              HasSubstr("the type \"numpy.datetime64\" is not read"));
}

Volume whole(const Files& files, const ReadOptions& options = {}) {
  base::Progress progress;
  return wholeVolume(*opened(files), options, progress);
}

// An array as xarray writes it: its words, those of the array's axes, and their positions in m.
Files labelled(const std::string& words, const std::string& unit = "m") {
  Files files;
  for (const auto& [name, text] : plainArray()) files["v/" + name] = text;
  files[".zgroup"] = R"({"zarr_format": 2})";
  files["v/.zattrs"] = R"({"_ARRAY_DIMENSIONS": ["z", "y", "x"])" + words + "}";
  const double steps[] = {2, -0.5, 0.25}, firsts[] = {1, 2, 3};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "zyx"[axis]);
    files[name + "/.zarray"] =
        R"({"zarr_format": 2, "shape": [4], "chunks": [3], "dtype": "<f8", "compressor": null,
      "fill_value": "NaN", "order": "C", "filters": null})";
    files[name + "/.zattrs"] = R"({"_ARRAY_DIMENSIONS": [")" + name + R"("], "units": ")" + unit + "\"}";
    std::vector<double> positions = test::ramp<double>(6, firsts[axis], steps[axis]);
    files[name + "/0"] = test::bytesOf(std::vector<double>(positions.begin(), positions.begin() + 3));
    files[name + "/1"] = test::bytesOf(std::vector<double>(positions.begin() + 3, positions.end()));
  }
  return files;
}

TEST(Zarr, AnArrayOfXarrayHasItsPlaceAndItsValues) {
  const Volume volume =
      whole(labelled(R"(, "scale_factor": 0.5, "add_offset": 3, "_FillValue": 121, "units": "K")"));
  EXPECT_EQ(volume.unit, "K");
  EXPECT_EQ(volume.fileType, VoxelType::uint16);
  EXPECT_EQ(volume.grid->value(3, 2, 1), 123 * 0.5 + 3);
  EXPECT_TRUE(std::isnan(volume.grid->value(1, 2, 1)));
  EXPECT_EQ(volume.grid->missingCount(), 1u);
  test::expectNear(test::worldOf(volume, 0, 0, 0), {3000, 2000, 1000});
  test::expectNear(test::worldOf(volume, 1, 2, 3), {3250, 1000, 7000});
  EXPECT_THAT(volume.warnings, testing::Each(HasSubstr("missing")));
}

TEST(Zarr, TheFillValueOfXarrayIsMissing) {
  Files files = labelled("");
  files.erase("v/1.0.0");
  const Volume volume = whole(files);
  EXPECT_TRUE(std::isnan(volume.grid->value(0, 0, 2)));
  EXPECT_EQ(volume.grid->value(0, 3, 2), 230);
  EXPECT_EQ(whole({{".zarray", plainArray()[".zarray"]}}).grid->value(0, 0, 0), 7)
      << "elsewhere it is a value";
}

TEST(Zarr, OtherUnitsOfAxesAreNoLengths) {
  EXPECT_THAT(whole(labelled("", "degrees_north")).warnings,
              testing::Contains(HasSubstr(R"("degrees_north" is not known: 1 mm assumed)")));
  EXPECT_THAT(whole(labelled("", "")).warnings, testing::Contains(HasSubstr("names no unit of length")));
}

TEST(Zarr, UnevenPositionsAreSaid) {
  Files files = labelled("");
  files["x/1"] = test::bytesOf(std::vector<double>{6, 9, 9});
  const Volume volume = whole(files);
  EXPECT_THAT(volume.warnings, testing::Contains(HasSubstr("along x are unevenly spaced")));
  EXPECT_EQ(volume.grid->geometry().spacingMm().x, 1000);
}

TEST(Zarr, BareWordsOfPythonAreRead) {
  const Volume volume =
      whole(labelled(R"(, "a": NaN, "b": [Infinity, -Infinity], "c": "NaN \" NaN", "valid_max": NaN)"));
  EXPECT_EQ(volume.grid->value(1, 0, 0), 1);
  EXPECT_THAT(volume.warnings, testing::Contains(HasSubstr("valid range")));
  Files files = labelled("");
  files["v/.zattrs"] = R"({"a": NaN, "b": nil})";
  EXPECT_THAT(refusal(files), HasSubstr("v/.zattrs: byte 18: is not JSON"));
}

TEST(Zarr, AKeyThatStandsTwiceIsSaid) {
  EXPECT_THAT(whole(labelled(R"(, "scale_factor": 2, "scale_factor": 3)")).warnings,
              testing::Contains(HasSubstr(R"("scale_factor" occurs twice in .zattrs)")));
  Files files = image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})");
  files[".zattrs"] = replaced(files[".zattrs"], R"("unit": "mm")", R"("unit": "m", "unit": "mm")");
  EXPECT_THAT(whole(files).warnings, testing::Contains(HasSubstr(R"("unit" occurs twice)")));
}

TEST(Zarr, OfTransformationsScaleAndTranslationAreRead) {
  const Volume volume = whole(image("[3, -2, 1]", R"({"type": "scale", "scale": [6, -4, 2]})"));
  test::expectNear(test::worldOf(volume, 0, 1, 0), {0, -2, 0});
  for (const char* other : {"affine", "rotation"}) {
    Files files = image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})");
    files[".zattrs"] = replaced(files[".zattrs"], R"({"type": "scale", "scale": [3, 2, 1]})",
                                std::string(R"({"type": ")") + other + R"("})");
    EXPECT_THAT(refusal(files), HasSubstr(std::string("the transformation \"") + other + "\" is not read"));
  }
}

TEST(Zarr, AnImageWithoutAScaleSaysSo) {
  Files files = image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})");
  files[".zattrs"] = replaced(files[".zattrs"], R"({"type": "scale", "scale": [3, 2, 1]})", "");
  EXPECT_THAT(whole(files).warnings, testing::Contains(HasSubstr("1 mm assumed")));
}

TEST(Zarr, NamesOfChannelsAreSaid) {
  Files files = image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})");
  files[".zattrs"] =
      replaced(files[".zattrs"], "{", R"({"omero": {"channels": [{"label": "DAPI"}, {"label": "GFP"}]}, )");
  EXPECT_THAT(whole(files).warnings, testing::Contains(HasSubstr("DAPI, GFP")));
}

TEST(Zarr, ImageLabelStatesLabelsWithNamesAndColours) {
  Files files = image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})");
  const std::string plain = files[".zattrs"];
  const auto withLabels = [&](const std::string& content) {
    files[".zattrs"] = replaced(plain, "{", "{\"image-label\": " + content + ", ");
  };
  withLabels(R"({"colors": [{"label-value": 2, "rgba": [0, 255, 255, 128]}, {"label-value": 1}],
                 "properties": [{"label-value": 2, "class": "nucleus"}, {"label-value": 7, "area": 3}]})");
  const auto table = opened(files)->facts().labels;
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->reason, "its metadata say image-label");
  ASSERT_EQ(table->labels.size(), 3u);
  EXPECT_EQ(labelName(table.get(), 2), "nucleus");
  EXPECT_EQ(labelColor(table.get(), 2), glm::vec3(0, 1, 1));
  EXPECT_EQ(labelName(table.get(), 7), "");
  EXPECT_EQ(whole(files).labelTable->labels.size(), 3u);
  for (const char* wrong : {R"({"colors": [{"label-value": 1.5}]})", R"({"properties": [{"class": "a"}]})",
                            R"({"colors": [{"label-value": 1, "rgba": [1, 2]}]})", R"({"colors": 3})"}) {
    withLabels(wrong);
    EXPECT_THAT(refusal(files), HasSubstr("image-label")) << wrong;
  }
}

TEST(Zarr, AGroupShowsItsVolumeNotItsPositions) {
  Files files = labelled("");
  EXPECT_THAT(opened(files)->facts().choices, testing::IsEmpty());
  for (const auto& [name, text] : plainArray()) files["a/" + name] = text;
  EXPECT_THAT(opened(files)->facts().choices, testing::ElementsAre("a\ta", "v\tv"));
}

TEST(Zarr, APlateShowsItsFirstWell) {
  Files files;
  files[".zattrs"] = R"({"plate": {"wells": [{"path": "A/1"}, {"path": "B/2"}]}})";
  for (const char* well : {"A/1/0/", "B/2/0/", "B/2/1/"})
    for (const auto& [name, text] : image("[3, 2, 1]", R"({"type": "scale", "scale": [6, 4, 2]})"))
      files[well + name] = text;
  const auto plate = opened(files);
  EXPECT_EQ(plate->facts().levels[0].geometry.spacingMm(), glm::dvec3(1, 2, 3));
  EXPECT_THAT(plate->facts().choices, testing::ElementsAre("A/1/0\tA/1/0", "B/2/0\tB/2/0", "B/2/1\tB/2/1"));
  files[".zattrs"] = R"({"plate": {"wells": [{"path": "../A/1"}]}})";
  EXPECT_THAT(refusal(files), HasSubstr("leaves the folder"));
}

TEST(Zarr, ManyTinyChunksAreRefused) {
  Files files;
  files[".zarray"] = R"({"zarr_format": 2, "shape": [1000, 1000, 1000], "chunks": [1, 1, 1], "dtype": "|u1",
    "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
  EXPECT_THAT(refusal(files), HasSubstr("more than 16777216 chunks"));
}

// One shard of 2 x 2 x 2 chunks of one voxel each.
Files shard(bool damagedIndex, std::uint64_t offset) {
  Files files;
  files["zarr.json"] = R"({"zarr_format": 3, "node_type": "array", "shape": [2, 2, 2], "data_type": "uint16",
    "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [2, 2, 2]}},
    "chunk_key_encoding": {"name": "default"}, "fill_value": 5, "codecs": [{"name": "sharding_indexed",
    "configuration": {"chunk_shape": [1, 1, 1], "codecs": [{"name": "bytes", "configuration": {"endian": "little"}}],
    "index_codecs": [{"name": "bytes", "configuration": {"endian": "little"}}, {"name": "crc32c"}]}}]})";
  std::string data = test::bytesOf(std::vector<std::uint16_t>{10, 11, 12, 13, 14, 15, 16, 17});
  std::vector<std::uint64_t> index;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const bool missing = i == 6;
    index.push_back(missing ? ~std::uint64_t{0} : i == 3 ? offset : 2 * i);
    index.push_back(missing ? ~std::uint64_t{0} : 2);
  }
  const std::string table = test::bytesOf(index);
  std::uint32_t sum = crc32c(std::as_bytes(std::span(table)));
  if (damagedIndex) ++sum;
  files["c/0/0/0"] = data + table + test::bytesOf(std::vector<std::uint32_t>{sum});
  return files;
}

TEST(Zarr, ShardsAreReadByTheirIndex) {
  const auto zarr = opened(shard(false, 6));
  EXPECT_THAT(readBox(*zarr, {0, 0, 0}, {2, 2, 2}), testing::ElementsAre(10, 11, 12, 13, 14, 15, 5, 17));
  EXPECT_THAT(refusal(shard(true, 6)), HasSubstr("checksum of the shard's index is wrong"));
  EXPECT_THAT(refusal(shard(false, 1000)), HasSubstr("chunk 0/1/1: damaged: beyond the end"));
}

TEST(Zarr, TheFillValueOfXarrayInZarr3IsInBase64) {
  Files files = shard(false, 6);
  files["zarr.json"] = replaced(files["zarr.json"], R"("fill_value": 5)", R"("fill_value": 5, "attributes":
    {"_FillValue": "CwA="})");
  EXPECT_TRUE(std::isnan(whole(files).grid->value(1, 0, 0)));
}

TEST(Zarr, AVanishedArrayIsNoEmptyOne) {
  const std::filesystem::path path = test::temporaryFolder() / "a.zarr";
  std::filesystem::create_directories(path);
  for (const auto& [name, bytes] : plainArray()) test::writeFile(path / name, bytes);
  base::Progress progress;
  const auto volume = openVolume(path.string(), {}, progress).parts;
  ASSERT_TRUE(volume);
  EXPECT_EQ(readBox(*volume, {0, 0, 0}, {1, 1, 1}).front(), 0);
  std::filesystem::remove_all(path);
  EXPECT_THROW(readBox(*volume, {0, 0, 0}, {1, 1, 1}), base::Error);
}

TEST(Zarr, SumsAreThoseOfTheirStandards) {
  const std::string digits = "123456789";
  EXPECT_EQ(crc32c(std::as_bytes(std::span(digits))), 0xe3069283u);  // RFC 3720's check value
  const std::string word = "abcde";
  // 0x6162 + 0x6364 + 0x6500 and the sums of these sums, modulo 65535, by hand.
  const std::uint32_t a = 0x6162, b = 0x6364, c = 0x6500;
  const std::uint32_t first = (a + b + c) % 65535, second = (3 * a + 2 * b + c) % 65535;
  EXPECT_EQ(fletcher32(std::as_bytes(std::span(word))), second << 16 | first);
}

}  // namespace
}  // namespace isolux::volume
