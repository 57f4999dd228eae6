#include <cmath>
#include <tuple>

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

std::string header(const std::string& fields) {
  return "NRRD0005\n# a comment\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n" + fields;
}

TEST(Nrrd, SpacesBecomeLps) {
  const auto folder = test::temporaryFolder();
  const std::string geometry = "space directions: (2,0,0) (0,3,0) (0.5,0,4)\nspace origin: (10,20,30)\n\n";
  const std::string voxels = bytesOf(ramp<std::uint8_t>(8));
  // Signs of x and y from the space to LPS.
  const std::tuple<const char*, double, double> spaces[] = {{"left-posterior-superior", 1, 1},
                                                            {"LPS", 1, 1},
                                                            {"right-anterior-superior", -1, -1},
                                                            {"RAS", -1, -1},
                                                            {"left-anterior-superior", 1, -1},
                                                            {"LAS", 1, -1},
                                                            {"scanner-xyz", 1, 1}};
  for (const auto& [space, sx, sy] : spaces) {
    SCOPED_TRACE(space);
    writeFile(folder / "v.nrrd", header(std::string("space: ") + space + "\n" + geometry) + voxels);
    const auto read = readFile(folder / "v.nrrd");
    EXPECT_EQ(valuesOf(read), zeroToSeven);
    expectNear(worldOf(read, 0, 0, 0), {10 * sx, 20 * sy, 30});
    expectNear(worldOf(read, 1, 0, 0), {12 * sx, 20 * sy, 30});
    expectNear(worldOf(read, 0, 1, 0), {10 * sx, 23 * sy, 30});
    expectNear(worldOf(read, 0, 0, 1), {10.5 * sx, 20 * sy, 34});
    EXPECT_EQ(test::warns(read, "does not state the patient's orientation"),
              std::string(space) == "scanner-xyz");
  }
}

TEST(Nrrd, EncodingsAndSkips) {
  const auto folder = test::temporaryFolder();
  const std::string raw = bytesOf(ramp<std::uint16_t>(8, 0, 1), true);
  const std::string fields =
      "NRRD0004\ntype: unsigned short\ndimension: 3\nsizes: 2 2 2\nendian: big\nspacings: 1 1 1\n";
  const auto check = [&](const std::string& name) {
    SCOPED_TRACE(name);
    EXPECT_EQ(valuesOf(readFile(folder / name)), zeroToSeven);
  };
  writeFile(folder / "gzip.nrrd", fields + "encoding: gzip\n\n" + test::gzipped(raw));
  check("gzip.nrrd");
  writeFile(folder / "gzipskip.nrrd", fields + "encoding: gz\nbyte skip: 3\n\n" + test::gzipped("abc" + raw));
  check("gzipskip.nrrd");
  writeFile(folder / "text.nrrd", fields + "encoding: ascii\n\n0 1 2 3,4\n5 6 7\n");
  check("text.nrrd");
  writeFile(folder / "data.raw", "line one\nline two\nxyz" + raw);
  writeFile(folder / "skip.nhdr", fields + "encoding: raw\nline skip: 2\nbyteskip: 3\ndata file: data.raw\n");
  check("skip.nhdr");
  writeFile(folder / "end.nhdr", fields + "encoding: raw\nbyte skip: -1\ndatafile: data.raw\n");
  check("end.nhdr");
  writeFile(folder / "a.raw", raw.substr(0, 8));
  writeFile(folder / "b.raw", raw.substr(8));
  writeFile(folder / "list.nhdr", fields + "encoding: raw\ndata file: LIST\na.raw\nb.raw\n");
  check("list.nhdr");
  writeFile(folder / "crlf.nrrd",
            "NRRD0001\r\ntype: uchar\r\ndimension: 3\r\nsizes: 2 2 2\r\nencoding: raw\r\n\r\n" +
                bytesOf(ramp<std::uint8_t>(8)));
  check("crlf.nrrd");
  const std::string packed = test::bzip2(raw);
  writeFile(folder / "bzip2.nrrd", fields + "encoding: bzip2\n\n" + packed);
  check("bzip2.nrrd");
  writeFile(folder / "bzip2.nrrd",
            fields + "encoding: bz2\n\n" + test::bzip2(raw.substr(0, 9)) + test::bzip2(raw.substr(9)));
  check("bzip2.nrrd");
  for (const std::size_t cut : {packed.size() - 12, std::size_t{20}, std::size_t{3}}) {
    writeFile(folder / "bzip2.nrrd", fields + "encoding: bzip2\n\n" + packed.substr(0, cut));
    expectError(folder / "bzip2.nrrd", "");
  }
  for (const bool first : {true, false}) {
    const auto share = [&](std::size_t from, bool cut) {
      const std::string bytes = test::gzipped(raw.substr(from, 8));
      return cut ? bytes.substr(0, bytes.size() - 3) : bytes;
    };
    writeFile(folder / "a.gz", share(0, first));
    writeFile(folder / "b.gz", share(8, !first));
    writeFile(folder / "list.nhdr", fields + "encoding: gzip\ndata file: LIST\na.gz\nb.gz\n");
    check("list.nhdr");
    EXPECT_TRUE(test::warns(readFile(folder / "list.nhdr"), "the checksum at the end is missing")) << first;
  }
  std::string damaged = packed;
  damaged[12] ^= 1;
  writeFile(folder / "bzip2.nrrd", fields + "encoding: bzip2\n\n" + damaged);
  expectError(folder / "bzip2.nrrd", "damaged");
  writeFile(folder / "hex.nrrd", fields + "encoding: hex\n\n00");
  expectError(folder / "hex.nrrd", "not supported");
}

TEST(Nrrd, AxesThatAreNotSpatial) {
  const auto folder = test::temporaryFolder();
  const std::string common = "NRRD0005\ntype: uint8\nencoding: raw\nspace: LPS\n";
  const std::string voxels = bytesOf(ramp<std::uint8_t>(24));
  volume::ReadOptions options;

  writeFile(folder / "rgb.nrrd", common +
                                     "dimension: 4\nsizes: 3 2 2 2\nkinds: RGB-color domain domain domain\n"
                                     "space directions: none (1,0,0) (0,1,0) (0,0,1)\n\n" +
                                     voxels);
  options.component = 2;
  const auto rgb = readFile(folder / "rgb.nrrd", options);
  EXPECT_EQ(rgb.components, 3);
  EXPECT_THAT(valuesOf(rgb), testing::ElementsAre(2, 5, 8, 11, 14, 17, 20, 23));

  writeFile(folder / "list.nrrd", common +
                                      "dimension: 4\nsizes: 2 2 2 3\nkinds: domain domain domain list\n"
                                      "space directions: (1,0,0) (0,1,0) (0,0,1) none\n\n" +
                                      voxels);
  options = {};
  options.timeStep = 1;
  const auto list = readFile(folder / "list.nrrd", options);
  EXPECT_EQ(list.timeSteps, 3);
  EXPECT_THAT(valuesOf(list), testing::ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));

  writeFile(folder / "vector.nrrd", common +
                                        "dimension: 4\nsizes: 2 2 2 3\nkinds: domain domain domain vector\n"
                                        "space directions: (1,0,0) (0,1,0) (0,0,1) none\n\n" +
                                        voxels);
  options = {};
  options.component = -1;
  const auto vector = readFile(folder / "vector.nrrd", options);
  EXPECT_EQ(vector.components, 3);
  EXPECT_NEAR(valuesOf(vector)[1], std::sqrt(1.0 + 81.0 + 289.0), 1e-5);

  writeFile(folder / "middle.nrrd", common +
                                        "dimension: 4\nsizes: 2 3 2 2\nkinds: domain vector domain domain\n"
                                        "space directions: (1,0,0) none (0,1,0) (0,0,1)\n\n" +
                                        voxels);
  expectError(folder / "middle.nrrd", "between spatial ones");
}

TEST(Nrrd, SpacingsAndMissingFields) {
  const auto folder = test::temporaryFolder();
  const std::string voxels = bytesOf(ramp<std::uint8_t>(8));
  writeFile(folder / "s.nrrd", header("spacings: 0.5 1 2\n\n") + voxels);
  EXPECT_EQ(readFile(folder / "s.nrrd").grid->geometry().spacingMm(), glm::dvec3(0.5, 1, 2));
  writeFile(folder / "m.nrrd",
            header("axis mins: 0 0 0\naxis maxs: 1 2 4\ncenters: node cell cell\n\n") + voxels);
  EXPECT_EQ(readFile(folder / "m.nrrd").grid->geometry().spacingMm(), glm::dvec3(1, 1, 2));
  writeFile(folder / "n.nrrd", header("\n") + voxels);
  EXPECT_TRUE(test::warns(readFile(folder / "n.nrrd"), "spacing is missing"));
  writeFile(folder / "e.nrrd",
            "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 1\nspacings: 1 1 1\nencoding: raw\n\n" +
                bytesOf(ramp<std::int16_t>(4)));
  EXPECT_TRUE(test::warns(readFile(folder / "e.nrrd"), "endian"));
}

volume::Volume nrrdWith(const std::string& fields) {
  const auto path = test::temporaryFolder() / "v.nrrd";
  writeFile(path, header(fields + "\n") + bytesOf(ramp<std::uint8_t>(8)));
  return readFile(path);
}

TEST(Nrrd, UnitsBecomeMillimetres) {
  const std::string space =
      "space: LPS\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,2)\nspace origin: (10,0,0)\n";
  const auto v = nrrdWith(space + "space units: \"microns\" \"microns\" \"microns\"\n");
  expectNear(v.grid->geometry().spacingMm(), {0.0005, 0.0005, 0.002}, 1e-12);
  expectNear(worldOf(v, 0, 0, 0), {0.01, 0, 0}, 1e-12);
  expectNear(nrrdWith(space + "space units: mm mm cm\n").grid->geometry().spacingMm(), {0.5, 0.5, 20});
  expectNear(nrrdWith("spacings: 0.5 1 2\nunits: \"um\" \"um\" \"mm\"\n").grid->geometry().spacingMm(),
             {0.0005, 0.001, 2}, 1e-12);
  EXPECT_TRUE(test::warns(nrrdWith(space + "space units: \"pixel\" \"pixel\" \"pixel\"\n"), "1 mm assumed"));
  const auto unsaid = nrrdWith(space + "space units: \"\" \"\" \"\"\n");
  expectNear(unsaid.grid->geometry().spacingMm(), {0.5, 0.5, 2});
  EXPECT_FALSE(test::warns(unsaid, "unit of length"));
  EXPECT_THROW(nrrdWith(space + "space units: \"mm\" \"mm\"\n"), base::Error);
  EXPECT_THROW(nrrdWith(space + "space units: \"mm\" \"mm\" \"mm\n"), base::Error);
}

TEST(Nrrd, AxisMinimumsPlaceTheGrid) {
  expectNear(
      worldOf(nrrdWith("axis mins: 10 20 30\naxis maxs: 12 22 32\ncenters: node node cell\n"), 0, 0, 0),
      {10, 20, 30.5});
  expectNear(worldOf(nrrdWith("axis mins: 10 20 30\nspacings: 1 2 4\ncenters: node node node\n"), 1, 1, 1),
             {11, 22, 34});
}

TEST(Nrrd, ALeftHandedSpaceIsNotShownMirrored) {
  const std::string geometry = "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (5,0,0)\n";
  EXPECT_FALSE(nrrdWith("space: 3D-right-handed\n" + geometry).grid->geometry().leftHanded());
  const auto left = nrrdWith("space: 3D-left-handed\n" + geometry);
  EXPECT_TRUE(left.grid->geometry().leftHanded());
  expectNear(worldOf(left, 1, 0, 0), {-6, 0, 0});
}

TEST(Nrrd, WhatValuesMean) {
  EXPECT_EQ(nrrdWith("spacings: 1 1 1\nsample units: \"HU\"\n").unit, "HU");
  EXPECT_TRUE(
      test::warns(nrrdWith("spacings: 1 1 1\nold min: -3\nold max: 12\n"), "quantised from -3 to 12"));
  const auto path = test::temporaryFolder() / "vector.nrrd";
  writeFile(path,
            "NRRD0005\ntype: uint8\ndimension: 4\nsizes: 3 2 2 2\nencoding: raw\nkinds: vector domain domain "
            "domain\nspace: LPS\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nmeasurement frame: (0,1,0) "
            "(1,0,0) (0,0,1)\n\n" +
                bytesOf(ramp<std::uint8_t>(24)));
  EXPECT_TRUE(test::warns(readFile(path), "measurement frame"));
}

TEST(Nrrd, StatementsThatContradictEachOther) {
  const std::string directions = "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n";
  EXPECT_TRUE(test::warns(nrrdWith(directions + "spacings: 1 1 2\n"), "directions are taken"));
  EXPECT_FALSE(test::warns(nrrdWith(directions + "spacings: 1 1 1\n"), "disagree"));
  EXPECT_TRUE(test::warns(nrrdWith(directions + "space dimension: 4\n"), "the space is taken"));
  EXPECT_TRUE(
      test::warns(nrrdWith("spacings: 1 1 1\naxis mins: 0 0 0\naxis maxs: 2 2 4\n"), "spacings are taken"));
  EXPECT_TRUE(test::warns(nrrdWith("spacings: 1 1 1\nspacings: 1 1 1\n"), "given twice"));
  EXPECT_THROW(nrrdWith("spacings: 1 1 1\nspacings: 1 1 2\n"), base::Error);
}

}  // namespace
}  // namespace isolux
