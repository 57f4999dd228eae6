#include "tests/volume/read/reader_support.h"
#include "volume/read/input/bytes.h"

namespace isolux {
namespace {

using test::expectError;
using test::readFile;
using test::valuesOf;
using test::writeFile;
using volume::parseRawDescription;
using volume::RawDescription;
using volume::VoxelType;

TEST(RawDescription, Parses) {
  const RawDescription d = parseRawDescription("256x128x64 int16 big spacing 0.5,0.5,2 header 512");
  EXPECT_EQ(d.dims, glm::ivec3(256, 128, 64));
  EXPECT_EQ(d.type, VoxelType::int16);
  EXPECT_EQ(d.endianness, volume::Endianness::big);
  EXPECT_EQ(d.spacingMm, glm::dvec3(0.5, 0.5, 2.0));
  EXPECT_EQ(d.headerBytes, 512u);
  EXPECT_EQ(parseRawDescription("2X3X4  FLOAT32").dims, glm::ivec3(2, 3, 4));
}

TEST(RawDescription, TextGoesThereAndBack) {
  for (const char* text : {"2x3x4 uint8 little", "65535x1x1 float64 big spacing 0.1,1e-06,3.25 header 7",
                           "1x1x1 uint64 little header 1"}) {
    EXPECT_EQ(toText(parseRawDescription(text)), text);
  }
  RawDescription third;
  third.spacingMm = glm::dvec3(1.0 / 3.0);
  third.dims = glm::ivec3(1);
  EXPECT_EQ(parseRawDescription(toText(third)).spacingMm, third.spacingMm);
}

TEST(RawDescription, NamesTheBadWord) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "empty"},
      {"2x3 uint8", "\"2x3\""},
      {"2x3x0 uint8", "\"2x3x0\""},
      {"2x3x65536 uint8", "\"2x3x65536\""},
      {"-2x3x4 uint8", "\"-2x3x4\""},
      {"2x3x99999999999999999999 uint8", "99999999999999999999"},
      {"2x3x4", "type is missing"},
      {"2x3x4 int24", "\"int24\""},
      {"2x3x4 uint8 middle", "\"middle\""},
      {"2x3x4 uint8 big little", "twice"},
      {"2x3x4 uint8 spacing", "three numbers"},
      {"2x3x4 uint8 spacing 1,2", "\"1,2\""},
      {"2x3x4 uint8 spacing 1,0,1", "\"1,0,1\""},
      {"2x3x4 uint8 spacing 1,nan,1", "nan"},
      {"2x3x4 uint8 header -1", "\"-1\""},
      {"2x3x4 uint8 header", "number of bytes"},
  };
  for (const auto& [text, part] : cases) {
    try {
      parseRawDescription(text);
      FAIL() << text << " was accepted";
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
  }
}

template <typename T>
void roundTrip(const char* type, std::vector<T> values, bool big) {
  const auto path = test::temporaryFolder() / "volume.raw";
  writeFile(path, "head" + test::bytesOf(values, big));
  volume::ReadOptions options;
  options.raw = std::string("3x2x2 ") + type + (big ? " big" : " little") + " spacing 0.5,1,2 header 4";
  const auto read = readFile(path, options);
  EXPECT_EQ(nameOf(read.fileType), type);
  EXPECT_EQ(read.format, "raw");
  EXPECT_THAT(read.warnings, testing::IsEmpty());
  EXPECT_EQ(read.grid->geometry().spacingMm(), glm::dvec3(0.5, 1.0, 2.0));
  const auto got = valuesOf(read);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(got[i], static_cast<double>(values[i])) << type;
}

TEST(ReadRaw, EveryTypeInBothByteOrders) {
  for (const bool big : {false, true}) {
    roundTrip("int8", test::ramp<std::int8_t>(12, -128, 20), big);
    roundTrip("uint8", test::ramp<std::uint8_t>(12, 3, 20), big);
    roundTrip("int16", test::ramp<std::int16_t>(12, -32768, 5000), big);
    roundTrip("uint16", test::ramp<std::uint16_t>(12, 10, 5900), big);
    roundTrip("int32", test::ramp<std::int32_t>(12, -300000, 77777), big);
    roundTrip("uint32", test::ramp<std::uint32_t>(12, 4000000000u, 12345), big);
    roundTrip("int64", test::ramp<std::int64_t>(12, -9007199254740000, 3), big);
    roundTrip("uint64", test::ramp<std::uint64_t>(12, 1, 65000), big);
    roundTrip("float32", test::ramp<float>(12, -1.5f, 0.25f), big);
    roundTrip("float64", test::ramp<double>(12, 1e6, 0.0009765625), big);
  }
}

TEST(ReadRaw, TooShortIsRefusedAndTooLongIsReported) {
  const auto path = test::temporaryFolder() / "volume.raw";
  writeFile(path, std::string(11, 'x'));
  volume::ReadOptions options;
  options.raw = "3x2x2 uint8";
  expectError(path, "truncated", options);
  options.raw = "3x2x1 uint8";
  EXPECT_TRUE(test::warns(readFile(path, options), "more data"));
  options.raw = "3x2x1 uint8 header 100";
  expectError(path, "behind the end", options);
  options.raw = "65535x65535x65535 float64";  // 2 PB out of 11 bytes
  expectError(path, "truncated", options);
}

TEST(ReadRaw, BudgetAndStop) {
  const auto path = test::temporaryFolder() / "volume.raw";
  writeFile(path, std::string(8000, 'x'));
  volume::ReadOptions options;
  options.raw = "20x20x20 uint8";
  options.budgetBytes = 7999;
  expectError(path, "budget", options, base::ErrorKind::memory);
  options.budgetBytes = 8000;
  EXPECT_EQ(readFile(path, options).grid->dims(), glm::ivec3(20));
  base::Progress stopped;
  stopped.requestStop();
  try {
    volume::readVolume(path.string(), options, stopped);
    FAIL() << "did not stop";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
}

TEST(ReadRaw, WindowAsksOnlyForUnknownFiles) {
  const auto folder = test::temporaryFolder();
  writeFile(folder / "volume.raw", "some voxels");
  writeFile(folder / "empty.raw", "");
  writeFile(folder / "volume.nrrd", "NRRD0004\n");
  EXPECT_TRUE(volume::needsRawDescription(folder / "volume.raw"));
  EXPECT_FALSE(volume::needsRawDescription(folder / "empty.raw"));
  EXPECT_FALSE(volume::needsRawDescription(folder / "volume.nrrd"));
  EXPECT_FALSE(volume::needsRawDescription(folder / "missing.raw"));
  EXPECT_FALSE(volume::needsRawDescription(folder));
  expectError(folder / "volume.raw", "--raw");
  writeFile(folder / "notes.txt", "1 2 3\nno voxels\n");
  EXPECT_FALSE(volume::needsRawDescription(folder / "notes.txt"));
  expectError(folder / "notes.txt", "is a text file");
  writeFile(folder / "letters.raw", "some\nvoxels");
  EXPECT_TRUE(volume::needsRawDescription(folder / "letters.raw"));
}

TEST(OpenBeside, StaysInItsFolder) {
  const auto folder = test::temporaryFolder();
  std::filesystem::create_directories(folder / "sub");
  writeFile(folder / "outside.raw", "x");
  writeFile(folder / "sub" / "inside.raw", "yy");
  const auto open = volume::openBeside(folder / "sub" / "header.mhd");
  EXPECT_EQ(open("inside.raw")->size(), 2u);
  EXPECT_EQ(volume::openBeside(folder / "header.mhd")("sub\\inside.raw")->size(),
            2u);  // as Windows writes it
  const std::string escapes[] = {"../outside.raw",
                                 (folder / "outside.raw").string(),
                                 "./../outside.raw",
                                 "..\\outside.raw",
                                 "a/../../outside.raw",
                                 "..",
                                 "",
                                 std::string("a\0b", 3)};
  for (const std::string& name : escapes) EXPECT_THROW(open(name), base::Error) << name;
  EXPECT_THROW(open("missing.raw"), base::Error);
}

TEST(ReadVolume, Phantom) {
  base::Progress progress;
  const auto ball = volume::readVolume("phantom:ball:16", {}, progress);
  EXPECT_EQ(ball.grid->dims(), glm::ivec3(16));
  EXPECT_EQ(ball.format, "phantom");
  EXPECT_EQ(ball.name, "ball");
  EXPECT_THROW(volume::readVolume("phantom:unicorn", {}, progress), base::Error);
}

}  // namespace
}  // namespace isolux
