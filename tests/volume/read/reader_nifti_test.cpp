#include <cmath>

#include <zstd.h>

#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

using test::bytesOf;
using test::expectError;
using test::expectNear;
using test::NiftiFile;
using test::ramp;
using test::readFile;
using test::valuesOf;
using test::worldOf;
using test::writeFile;
using test::zeroToSeven;

NiftiFile small() {
  NiftiFile file;
  file.voxels = bytesOf(ramp<std::uint8_t>(8));
  file.sformCode = 1;
  return file;
}

volume::Volume read(const NiftiFile& file, const volume::ReadOptions& options = {}) {
  const auto path = test::temporaryFolder() / "v.nii";
  writeFile(path, file.bytes());
  return readFile(path, options);
}

TEST(Nifti, SformIsConvertedFromRasToLps) {
  NiftiFile file = small();
  file.srow = {0, -2, 0.5, 10, 1, 0, 0, -20, 0, 0, 3, 30};
  const auto v = read(file);
  EXPECT_EQ(v.format, "NIfTI-1");
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  expectNear(worldOf(v, 0, 0, 0), {-10, 20, 30});
  expectNear(worldOf(v, 1, 0, 0), {-10, 19, 30});    // RAS (0,1,0)
  expectNear(worldOf(v, 0, 1, 0), {-8, 20, 30});     // RAS (-2,0,0)
  expectNear(worldOf(v, 0, 0, 1), {-10.5, 20, 33});  // RAS (0.5,0,3)
}

TEST(Nifti, QformWithQfac) {
  NiftiFile file = small();
  file.sformCode = 0;
  file.qformCode = 1;
  // A turn of 90 degrees about z: x -> y, y -> -x (RAS).
  file.quaternion = {0, 0, static_cast<float>(std::sqrt(0.5))};
  file.qoffset = {1, 2, 3};
  file.pixdim = {-1, 2, 3, 4};
  const auto v = read(file);
  expectNear(worldOf(v, 0, 0, 0), {-1, -2, 3}, 1e-5);
  expectNear(worldOf(v, 1, 0, 0), {-1, -4, 3}, 1e-5);
  expectNear(worldOf(v, 0, 1, 0), {2, -2, 3}, 1e-5);
  expectNear(worldOf(v, 0, 0, 1), {-1, -2, -1}, 1e-5);  // qfac -1
  EXPECT_TRUE(v.grid->geometry().leftHanded());
  // Half a turn about x, rounded beyond 1: a = 0.
  file.quaternion = {1.0000001f, 0, 0};
  file.pixdim[0] = 1;
  expectNear(worldOf(read(file), 0, 1, 0), {-1, 1, 3}, 1e-5);
}

TEST(Nifti, NoOrientationIsSaid) {
  NiftiFile file = small();
  file.sformCode = 0;
  file.pixdim = {1, 2, 3, 4};
  const auto v = read(file);
  EXPECT_TRUE(test::warns(v, "left and right are not certain"));
  expectNear(worldOf(v, 1, 1, 1), {-2, -3, 4});
  file.pixdim = {1, 0, 3, std::nanf("")};
  const auto degenerate = read(file);
  EXPECT_TRUE(test::warns(degenerate, "pixdim[1]"));
  expectNear(worldOf(degenerate, 1, 1, 1), {-1, -3, 1});
}

TEST(Nifti, SingularSformFallsBack) {
  NiftiFile file = small();
  file.srow = std::vector<float>(12, 0.0f);
  file.qformCode = 1;
  const auto v = read(file);
  EXPECT_TRUE(test::warns(v, "sform is singular"));
  expectNear(worldOf(v, 1, 0, 0), {-1, 0, 0});
}

TEST(Nifti, UnitsBecomeMillimetres) {
  NiftiFile file = small();
  file.units = 3;  // micrometres
  expectNear(worldOf(read(file), 0, 0, 1), {0, 0, 0.001}, 1e-12);
  file.units = 1 | 8;  // metres, seconds
  expectNear(worldOf(read(file), 0, 0, 1), {0, 0, 1000});
  EXPECT_FALSE(test::warns(read(file), "xyzt_units"));
  for (const int other : {0, 7}) {
    file.units = other;
    expectNear(worldOf(read(file), 0, 0, 1), {0, 0, 1});
    EXPECT_EQ(test::warns(read(file), "xyzt_units names no known unit of length"), other == 7);
  }
}

TEST(Nifti, SlopeAndIntercept) {
  NiftiFile file = small();
  file.slope = 2;
  file.intercept = -10;
  const auto scaled = read(file);
  EXPECT_EQ(scaled.grid->storedType(), volume::VoxelType::uint8);
  EXPECT_EQ(scaled.grid->minimum(), -10.0);
  EXPECT_EQ(scaled.grid->maximum(), 4.0);
  for (const float none : {0.0f, std::nanf(""), INFINITY}) {
    file.slope = none;
    EXPECT_EQ(read(file).grid->maximum(), 7.0);
  }
  file.slope = 2;
  file.intercept = std::nanf("");
  EXPECT_EQ(read(file).grid->maximum(), 14.0);
}

TEST(Nifti, AScalingThatMapsAllValuesToOneIsLeftOut) {
  NiftiFile file = small();
  file.slope = 1e-20f;
  file.intercept = 1;
  const auto volume = read(file);
  EXPECT_EQ(volume.grid->minimum(), 0.0);
  EXPECT_EQ(volume.grid->maximum(), 7.0);
  EXPECT_TRUE(test::warns(volume, "too extreme to apply"));
}

TEST(Nifti, ComplexNumbersAreScaledColoursAreNot) {
  NiftiFile file = small();
  file.dims = {1, 1, 1};
  file.datatype = 32;
  file.bitpix = 64;
  file.slope = 2;
  file.voxels = bytesOf<float>({3, 4});
  volume::ReadOptions options;
  options.component = 1;
  EXPECT_EQ(valuesOf(read(file, options))[0], 8.0);
  options.component = -1;
  EXPECT_EQ(valuesOf(read(file, options))[0], 10.0);
}

TEST(Nifti, FormsThatContradictEachOther) {
  NiftiFile file = small();
  file.qformCode = 1;
  EXPECT_FALSE(test::warns(read(file), "qform"));
  file.srow = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const auto mirrored = read(file);
  EXPECT_TRUE(test::warns(mirrored, "mirror each other"));
  EXPECT_EQ(mirrored.axes, scene::WorldAxes::zUp);
  expectNear(worldOf(mirrored, 1, 0, 0), {1, 0, 0});  // of the sform
  file.sformCode = 4;                                 // whatever the space
  EXPECT_TRUE(test::warns(read(file), "mirror each other"));
  file.srow = {1, 0, 0, 20, 0, 1, 0, 0, 0, 0, 1, 0};
  EXPECT_FALSE(test::warns(read(file), "qform"));  // another space may begin elsewhere
  file.sformCode = 1;
  const auto moved = read(file);
  EXPECT_TRUE(test::warns(moved, "up to 20 mm apart"));
  EXPECT_EQ(moved.axes, scene::WorldAxes::anatomical);
  file.srow = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
  file.sformCode = 4;
  EXPECT_TRUE(test::warns(read(file), "different voxel sizes"));
}

TEST(Nifti, AxesThatAreNotFilledInAreOne) {
  NiftiFile file = small();
  file.dims = {2, 2, 2, 0, 0};
  EXPECT_EQ(valuesOf(read(file)), zeroToSeven);
  EXPECT_TRUE(test::warns(read(file), "dim[4] is 0"));
}

TEST(Nifti, APairMarkedAsOneFile) {
  NiftiFile file = small();
  const auto folder = test::temporaryFolder();
  writeFile(folder / "p.hdr", file.header());
  writeFile(folder / "p.img", file.voxels);
  const auto v = readFile(folder / "p.hdr");
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  EXPECT_TRUE(test::warns(v, "the .img file are read"));
}

TEST(Nifti, KindsOfNumbers) {
  NiftiFile file = small();
  file.intent = 1002;
  ASSERT_NE(read(file).labelTable, nullptr);
  EXPECT_EQ(read(file).labelTable->reason, "its intent_code is 1002, labels");
  const auto path = test::temporaryFolder() / "surface.nii";
  for (const auto& [intent, reason] : {std::pair(3006, "CIFTI"), std::pair(1008, "not voxels")}) {
    file.intent = intent;
    writeFile(path, file.bytes());
    expectError(path, reason);
  }
}

TEST(Nifti, PackedWithZstd) {
  NiftiFile file = small();
  const auto zstd = [](const std::string& bytes) {
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
    return packed;
  };
  const auto path = test::temporaryFolder() / "v.nii.zst";
  const std::string good = zstd(file.bytes());
  writeFile(path, good);
  EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven);
  writeFile(path, zstd(file.bytes().substr(0, 354)) + zstd(file.bytes().substr(354)));
  EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven);
  writeFile(path, good.substr(0, good.size() - 3));
  expectError(path, "");
  file.dims = {4096, 4096, 2400};
  writeFile(path, zstd(file.bytes()));
  expectError(path, "cannot hold");
}

TEST(Nifti, PackedWithBzip2) {
  NiftiFile file = small();
  const auto path = test::temporaryFolder() / "v.nii.bz2";
  writeFile(path, test::bzip2(file.bytes()));
  EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven);
  file.dims = {4096, 4096, 2400};
  writeFile(path, test::bzip2(file.bytes()));
  expectError(path, "cannot hold");
}

// Damaged so that more comes out: the sum at the end says so.
TEST(Nifti, PackedDataThatGoOnAreCheckedToTheirEnd) {
  NiftiFile file = small();
  const auto path = test::temporaryFolder() / "v.nii.gz";
  const std::string longer = file.bytes() + std::string(100, '\1');
  writeFile(path, test::gzipped(longer));
  EXPECT_TRUE(test::warns(readFile(path), "more data than the header announces"));
  std::string wrong = test::gzipped(longer);
  wrong[wrong.size() - 8] ^= 1;  // of the sum
  writeFile(path, wrong);
  expectError(path, "damaged");
}

// Files are read in parts of 64 KiB: of one of these the checksum begins a part, when all voxels are there.
TEST(Nifti, ACutChecksumIsSaidAndAWrongOneRefused) {
  NiftiFile file;
  file.dims = {48, 48, 48};
  std::uint32_t state = 1;
  for (int i = 0; i < 48 * 48 * 48; ++i) {
    state = state * 1664525u + 1013904223u;
    file.voxels += static_cast<char>(state >> 24);
  }
  const auto folder = test::temporaryFolder();
  const auto frame = [](const std::string& bytes) {
    std::string packed(ZSTD_compressBound(bytes.size()) + 4, '\0');
    ZSTD_CCtx* const context = ZSTD_createCCtx();
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
    packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), bytes.data(), bytes.size()));
    ZSTD_freeCCtx(context);
    return packed;
  };
  std::string aligned = test::gzipped(file.bytes());
  aligned[3] = 8;  // a name follows
  aligned.insert(10, std::string((65536 - (aligned.size() - 8 + 1) % 65536) % 65536, 'n') + '\0');
  ASSERT_EQ((aligned.size() - 8) % 65536, 0u);
  struct Packed {
    const char* name;
    std::string bytes;
    std::size_t trailer;
  };
  for (const Packed& packed :
       {Packed{"v.nii.gz", test::gzipped(file.bytes()), 8}, Packed{"aligned.nii.gz", aligned, 8},
        Packed{"v.nii.bz2", test::bzip2(file.bytes()), 9}, Packed{"v.nii.zst", frame(file.bytes()), 4}}) {
    SCOPED_TRACE(packed.name);
    const auto path = folder / packed.name;
    writeFile(path, packed.bytes);
    const auto whole = readFile(path);
    EXPECT_FALSE(test::warns(whole, "checksum"));
    for (std::size_t cut = 1; cut <= packed.trailer; ++cut) {
      writeFile(path, packed.bytes.substr(0, packed.bytes.size() - cut));
      const auto read = readFile(path);
      EXPECT_TRUE(test::warns(read, "the checksum at the end is missing")) << cut;
      EXPECT_EQ(read.grid->hash(), whole.grid->hash());
    }
    std::string wrong = packed.bytes;
    wrong[wrong.size() - packed.trailer + 3] ^= 1;
    writeFile(path, wrong);
    expectError(path, "damaged");
    for (const char* rubbish : {"rubbish", "\x1f rubbish", "BZh"}) {
      writeFile(path, packed.bytes + rubbish);
      EXPECT_FALSE(test::warns(readFile(path), "checksum")) << rubbish;
    }
  }
}

TEST(Nifti, BigEndianGzipAndPairs) {
  NiftiFile file;
  file.big = true;
  file.datatype = 4;
  file.bitpix = 16;
  file.sformCode = 1;
  file.voxels = bytesOf(ramp<std::int16_t>(8), true);
  EXPECT_EQ(valuesOf(read(file)), zeroToSeven);
  const auto folder = test::temporaryFolder();
  writeFile(folder / "v.nii.gz", test::gzipped(file.bytes()));
  EXPECT_EQ(valuesOf(readFile(folder / "v.nii.gz")), zeroToSeven);
  // Two gzip members, as parallel compressors write them.
  const std::string bytes = file.bytes();
  writeFile(folder / "two.nii.gz", test::gzipped(bytes.substr(0, 355)) + test::gzipped(bytes.substr(355)));
  EXPECT_EQ(valuesOf(readFile(folder / "two.nii.gz")), zeroToSeven);

  file.magic = "ni1";
  file.voxOffset = 0;
  writeFile(folder / "p.hdr", file.header());
  expectError(folder / "p.hdr", ".img file of this header is missing");
  writeFile(folder / "p.img", file.voxels);
  EXPECT_EQ(valuesOf(readFile(folder / "p.hdr")), zeroToSeven);
  EXPECT_EQ(valuesOf(readFile(folder / "p.img")), zeroToSeven);
  writeFile(folder / "q.hdr", file.header());
  writeFile(folder / "q.img.gz", test::gzipped(file.voxels));
  EXPECT_EQ(valuesOf(readFile(folder / "q.hdr")), zeroToSeven);
  EXPECT_EQ(valuesOf(readFile(folder / "q.img.gz")), zeroToSeven);
}

TEST(Nifti, Version2) {
  std::string header(540, '\0');
  const auto put = [&](std::size_t at, auto value) {
    const std::string raw = bytesOf(std::vector{value});
    header.replace(at, raw.size(), raw);
  };
  put(0, std::int32_t{540});
  header.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
  put(12, std::int16_t{2});
  put(14, std::int16_t{8});
  const std::int64_t dim[] = {3, 2, 2, 2, 1, 1, 1, 1};
  for (std::size_t i = 0; i < 8; ++i) put(16 + 8 * i, dim[i]);
  for (std::size_t i = 0; i < 8; ++i) put(104 + 8 * i, 1.0);
  put(168, std::int64_t{544});
  put(176, 0.5);
  put(348, std::int32_t{1});
  const double srow[] = {1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7};
  for (std::size_t i = 0; i < 12; ++i) put(400 + 8 * i, srow[i]);
  put(500, std::int32_t{2});
  const auto path = test::temporaryFolder() / "v.nii";
  writeFile(path, header + std::string(4, '\0') + bytesOf(ramp<std::uint8_t>(8)));
  const auto v = readFile(path);
  EXPECT_EQ(v.format, "NIfTI-2");
  EXPECT_EQ(v.grid->maximum(), 3.5);
  expectNear(worldOf(v, 0, 0, 0), {-5, -6, 7});
}

TEST(Nifti, TimeStepsVectorsAndColours) {
  NiftiFile file = small();
  file.dims = {2, 1, 1, 2, 3};  // 2 time steps, 3 components, one volume after the other
  file.voxels = bytesOf(ramp<std::uint8_t>(12));
  volume::ReadOptions options;
  options.timeStep = 1;
  options.component = 2;
  const auto v = read(file, options);
  EXPECT_EQ(v.components, 3);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_THAT(valuesOf(v), testing::ElementsAre(10, 11));
  options.component = -1;
  EXPECT_NEAR(valuesOf(read(file, options))[0], std::sqrt(4.0 + 36.0 + 100.0), 1e-5);

  file = small();
  file.dims = {2, 1, 1};
  file.datatype = 128;  // RGB
  file.bitpix = 24;
  file.slope = 5;  // not applied to colours
  file.voxels = bytesOf<std::uint8_t>({1, 2, 2, 4, 5, 6});
  options = {};
  options.component = -1;
  EXPECT_EQ(valuesOf(read(file, options))[0], 3.0);
}

TEST(Nifti, Float64KeepsSmallDifferences) {
  NiftiFile file = small();
  file.dims = {3, 1, 1};
  file.datatype = 64;
  file.bitpix = 64;
  file.slope = 2;
  file.intercept = 1;
  file.voxels = bytesOf<double>({1e6, 1e6 + 1e-4, 1e6 + 2e-4});
  const auto values = valuesOf(read(file));
  EXPECT_NEAR(values[1] - values[0], 2e-4, 1e-9);
  EXPECT_NEAR(values[0], 2e6 + 1, 1e-9);
}

}  // namespace
}  // namespace isolux
