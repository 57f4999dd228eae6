#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

using test::bytesOf;
using test::expectError;
using test::expectNear;
using test::ramp;
using test::readFile;
using test::valuesOf;
using test::worldOf;
using test::writeFile;
using test::zeroToSeven;

TEST(MetaImage, LocalDataWithDirections) {
  const auto path = test::temporaryFolder() / "volume.mha";
  // Axis 0 points to +y, axis 1 to +z, axis 2 to -x: row i of the matrix is the direction of axis i.
  writeFile(path,
            "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "TransformMatrix = 0 1 0 0 0 1 -1 0 0\nOffset = 10 20 30\nElementSpacing = 0.5 1 2\n"
            "DimSize = 2 2 2\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
                bytesOf(ramp<std::int16_t>(8)));
  const auto read = readFile(path);
  EXPECT_EQ(read.format, "MetaImage");
  EXPECT_EQ(read.fileType, volume::VoxelType::int16);
  EXPECT_EQ(valuesOf(read), zeroToSeven);
  expectNear(worldOf(read, 0, 0, 0), {10, 20, 30});
  expectNear(worldOf(read, 1, 0, 0), {10, 20.5, 30});
  expectNear(worldOf(read, 0, 1, 0), {10, 20, 31});
  expectNear(worldOf(read, 0, 0, 1), {8, 20, 30});
  EXPECT_THAT(read.warnings, testing::IsEmpty());
}

TEST(MetaImage, ExternalDataBigEndianCompressed) {
  const auto folder = test::temporaryFolder();
  const std::string data = test::zlibbed(bytesOf(ramp<float>(8, 0.5f, 0.25f), true));
  writeFile(folder / "v.zraw", data);
  writeFile(folder / "v.mhd",
            "ObjectType = Image\r\nNDims = 3\r\nElementByteOrderMSB = True\r\nCompressedData = True\r\n"
            "CompressedDataSize = " +
                std::to_string(data.size()) +
                "\r\nDimSize = 2 2 2\r\nElementSpacing = 1 1 1\r\nElementType = MET_FLOAT\r\nElementDataFile "
                "= v.zraw\r\n");
  EXPECT_THAT(valuesOf(readFile(folder / "v.mhd")),
              testing::ElementsAre(0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25));
  writeFile(folder / "cut.mha",
            "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nCompressedData = "
            "True\nElementDataFile = LOCAL\n" +
                test::zlibbed(bytesOf(ramp<std::uint8_t>(8))).substr(0, 12));
  const auto cut = readFile(folder / "cut.mha");
  EXPECT_EQ(valuesOf(cut), zeroToSeven);
  EXPECT_TRUE(test::warns(cut, "the checksum at the end is missing"));
}

TEST(MetaImage, HeaderSizes) {
  const auto folder = test::temporaryFolder();
  writeFile(folder / "v.raw", "some header" + bytesOf(ramp<std::uint8_t>(8)));
  const std::string header =
      "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nHeaderSize = ";
  writeFile(folder / "a.mhd", header + "11\nElementDataFile = v.raw\n");
  writeFile(folder / "b.mhd", header + "-1\nElementDataFile = v.raw\n");
  writeFile(folder / "c.mhd", header + "12\nElementDataFile = v.raw\n");
  EXPECT_EQ(valuesOf(readFile(folder / "a.mhd")), zeroToSeven);
  EXPECT_EQ(valuesOf(readFile(folder / "b.mhd")), zeroToSeven);
  expectError(folder / "v.raw", "--raw");
  EXPECT_THROW(readFile(folder / "c.mhd"), base::Error);
}

TEST(MetaImage, TextChannelsAndTime) {
  const auto folder = test::temporaryFolder();
  writeFile(folder / "text.mha",
            "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nBinaryData = False\nElementType = MET_INT\n"
            "ElementDataFile = LOCAL\n0 1 2 3\n4 5 6\t-70000\n");
  EXPECT_THAT(valuesOf(readFile(folder / "text.mha")), testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, -70000));

  writeFile(folder / "rgb.mha",
            "NDims = 3\nDimSize = 2 1 1\nElementSpacing = 1 1 1\nElementNumberOfChannels = 3\n"
            "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                bytesOf<std::uint8_t>({3, 4, 0, 12, 5, 0}));
  const auto first = readFile(folder / "rgb.mha");
  EXPECT_EQ(first.components, 3);
  EXPECT_TRUE(test::warns(first, "3 components"));
  EXPECT_THAT(valuesOf(first), testing::ElementsAre(3, 12));
  volume::ReadOptions options;
  options.component = 1;
  EXPECT_THAT(valuesOf(readFile(folder / "rgb.mha", options)), testing::ElementsAre(4, 5));
  options.component = -1;
  EXPECT_THAT(valuesOf(readFile(folder / "rgb.mha", options)), testing::ElementsAre(5, 13));
  options.component = 3;
  expectError(folder / "rgb.mha", "source.component", options, base::ErrorKind::usage);

  writeFile(folder / "time.mha",
            "NDims = 4\nDimSize = 2 1 1 3\nElementSpacing = 1 1 1 1\nElementType = MET_UCHAR\n"
            "ElementDataFile = LOCAL\n" +
                bytesOf<std::uint8_t>({1, 2, 3, 4, 5, 6}));
  options = {};
  options.timeStep = 2;
  const auto last = readFile(folder / "time.mha", options);
  EXPECT_EQ(last.timeSteps, 3);
  EXPECT_THAT(valuesOf(last), testing::ElementsAre(5, 6));
  options.timeStep = 3;
  expectError(folder / "time.mha", "source.time_step", options, base::ErrorKind::usage);
}

TEST(MetaImage, ListsAndPatterns) {
  const auto folder = test::temporaryFolder();
  for (int i = 0; i < 2; ++i)
    writeFile(folder / ("slice0" + std::to_string(i + 8) + ".raw"),
              bytesOf(ramp<std::uint8_t>(4, static_cast<std::uint8_t>(4 * i))));
  const std::string header = "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n";
  writeFile(folder / "list.mhd", header + "ElementDataFile = LIST\nslice08.raw\nslice09.raw\n");
  writeFile(folder / "pattern.mhd", header + "ElementDataFile = slice%02d.raw 8 9 1\n");
  EXPECT_EQ(valuesOf(readFile(folder / "list.mhd")), zeroToSeven);
  EXPECT_EQ(valuesOf(readFile(folder / "pattern.mhd")), zeroToSeven);
  writeFile(folder / "evil.mhd", header + "ElementDataFile = slice%n.raw 8 9 1\n");
  expectError(folder / "evil.mhd", "is not a pattern");
}

TEST(MetaImage, RangesOfFileNumbersEndAtTheGreatestNumber) {
  const auto folder = test::temporaryFolder();
  const std::string header = "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n";
  writeFile(folder / "last.mhd",
            header + "ElementDataFile = s%d.raw 9223372036854775806 9223372036854775807\n");
  writeFile(folder / "s9223372036854775806.raw", bytesOf(ramp<std::uint8_t>(4)));
  writeFile(folder / "s9223372036854775807.raw", bytesOf(ramp<std::uint8_t>(4, 4)));
  EXPECT_EQ(valuesOf(readFile(folder / "last.mhd")), zeroToSeven);
}

TEST(MetaImage, DegenerateGeometryHasDocumentedDefaults) {
  const auto path = test::temporaryFolder() / "volume.mha";
  const auto with = [&](const std::string& fields) {
    writeFile(path, "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n" + fields +
                        "ElementDataFile = LOCAL\n" + bytesOf(ramp<std::uint8_t>(8)));
    return readFile(path);
  };
  const auto zero = with("ElementSpacing = 1 0 nan\n");
  EXPECT_EQ(zero.grid->geometry().spacingMm(), glm::dvec3(1.0));
  EXPECT_TRUE(test::warns(zero, "spacing along y is 0"));
  EXPECT_TRUE(test::warns(zero, "spacing along z is nan"));
  const auto singular = with("ElementSpacing = 1 1 1\nTransformMatrix = 1 0 0 1 0 0 0 0 1\n");
  EXPECT_EQ(singular.grid->geometry().directions(), glm::dmat3(1.0));
  EXPECT_TRUE(test::warns(singular, "singular"));
  EXPECT_TRUE(test::warns(with("ElementSpacing = 1 1 1\nOffset = 0 inf 0\n"), "origin"));
  EXPECT_TRUE(test::warns(with("Comment = no spacing\n"), "ElementSpacing is missing"));
  const auto backwards = with("ElementSpacing = -1 1 1\n");
  EXPECT_TRUE(backwards.grid->geometry().leftHanded());
  EXPECT_TRUE(test::warns(backwards, "negative"));
  EXPECT_THROW(with("ElementSpacing = 1e300 1 1\n"), base::Error);
  EXPECT_THROW(with("ElementSpacing = 1 1 1\nOffset = 1e300 0 0\n"), base::Error);
}

volume::Volume metaImageWith(const std::string& fields, const std::string& dims = "2 2 2", int axes = 3) {
  const auto path = test::temporaryFolder() / "volume.mha";
  writeFile(path, "NDims = " + std::to_string(axes) + "\nDimSize = " + dims + "\nElementType = MET_UCHAR\n" +
                      fields + "ElementDataFile = LOCAL\n" + bytesOf(ramp<std::uint8_t>(8)));
  return readFile(path);
}

TEST(MetaImage, DistanceUnitsBecomeMillimetres) {
  const std::string spacing = "ElementSpacing = 0.5 1 2\nOffset = 10 20 30\n";
  const auto um = metaImageWith(spacing + "DistanceUnits = um\n");
  test::expectNear(um.grid->geometry().spacingMm(), {0.0005, 0.001, 0.002}, 1e-12);
  test::expectNear(worldOf(um, 0, 0, 0), {0.01, 0.02, 0.03}, 1e-12);
  test::expectNear(metaImageWith(spacing + "DistanceUnits = cm\n").grid->geometry().spacingMm(), {5, 10, 20});
  const auto unsaid = metaImageWith(spacing + "DistanceUnits = ?\n");
  test::expectNear(unsaid.grid->geometry().spacingMm(), {0.5, 1, 2});
  EXPECT_FALSE(test::warns(unsaid, "unit of length"));
  EXPECT_TRUE(test::warns(metaImageWith(spacing + "DistanceUnits = ell\n"), "1 mm assumed"));
}

TEST(MetaImage, FramesOfASequenceAreTimeSteps) {
  const std::string spacing = "ElementSpacing = 0.2 0.2 1\n";
  for (const std::string& statement :
       {std::string("Kinds = domain domain list\n"), std::string("Seq_Frame0000_Status = OK\n")}) {
    const auto v = metaImageWith(spacing + statement);
    EXPECT_EQ(v.grid->dims(), glm::ivec3(2, 2, 1));
    EXPECT_EQ(v.timeSteps, 2);
    EXPECT_TRUE(test::warns(v, "frames of this sequence are time steps"));
  }
  std::string many = "Kinds = domain domain list\n";  // more keys than any other header has
  for (int i = 0; i < 30000; ++i)
    many += "Seq_Frame" + std::to_string(i) + "_ProbeToTrackerTransform = 1 0 0 0\n";
  EXPECT_EQ(metaImageWith(spacing + many).timeSteps, 2);
  EXPECT_EQ(metaImageWith(spacing + "Kinds = domain domain domain\n").grid->dims().z, 2);
  EXPECT_THROW(metaImageWith(spacing + "Kinds = list domain domain\n"), base::Error);
}

TEST(MetaImage, TwoAxesMayHaveTheNumbersOfThree) {
  const auto v = metaImageWith(
      "ElementSpacing = 0.5 0.5 3\nOffset = 1 2 3\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n", "4 2", 2);
  test::expectNear(v.grid->geometry().spacingMm(), {0.5, 0.5, 3});
  test::expectNear(worldOf(v, 0, 0, 0), {1, 2, 3});
  EXPECT_THROW(metaImageWith("ElementSpacing = 0.5\n", "4 2", 2), base::Error);
}

TEST(MetaImage, ScalingOfValues) {
  const auto v = metaImageWith(
      "ElementSpacing = 1 1 1\nElementToIntensityFunctionSlope = 2\nElementToIntensityFunctionOffset = -1\n");
  EXPECT_EQ(v.grid->value(1, 0, 0), 1.0);
  EXPECT_EQ(v.grid->value(1, 1, 1), 13.0);
}

TEST(MetaImage, StatementsThatContradictEachOther) {
  const std::string spacing = "ElementSpacing = 1 1 1\n";
  EXPECT_TRUE(
      test::warns(metaImageWith(spacing + "Offset = 1 2 3\nPosition = 1 2 4\n"), "different origins"));
  EXPECT_FALSE(test::warns(metaImageWith(spacing + "Offset = 1 2 3\nPosition = 1.0 2 3\n"), "different"));
  EXPECT_TRUE(test::warns(metaImageWith(spacing + "TransformMatrix = 1 0 0 0 1 0 0 0 1\n"
                                                  "Orientation = 1 0 0 0 1 0 0 0 -1\n"),
                          "different directions"));
  EXPECT_TRUE(test::warns(metaImageWith(spacing + spacing), "given twice"));
  EXPECT_THROW(metaImageWith(spacing + "ElementSpacing = 1 1 2\n"), base::Error);
  EXPECT_NO_THROW(metaImageWith(spacing + "Comment = a\nComment = b\n"));
}

TEST(MetaImage, MissingVoxelsAreCounted) {
  const auto path = test::temporaryFolder() / "volume.mha";
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  writeFile(path,
            "NDims = 3\nDimSize = 2 2 1\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\nElementDataFile = "
            "LOCAL\n" +
                bytesOf<float>({1, nan, -inf, 4}));
  const auto read = readFile(path);
  EXPECT_EQ(read.grid->missingCount(), 2u);
  EXPECT_EQ(read.grid->maximum(), 4.0);
  EXPECT_TRUE(test::warns(read, "2 of 4 voxels"));
}

}  // namespace
}  // namespace isolux
