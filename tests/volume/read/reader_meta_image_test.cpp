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
  EXPECT_TRUE(test::warns(last, "3 time steps"));
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
  expectError(folder / "evil.mhd", "no pattern");
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
