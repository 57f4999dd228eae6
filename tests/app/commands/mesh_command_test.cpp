// isolux mesh: an isosurface as triangles in each format, with what is known at its points.
#include <cmath>
#include <cstring>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"
#include "volume/read/mesh/mesh.h"

namespace isolux::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kRadius = 0.35 * 31.0;  // of phantom:ball:32, mm, about the world's origin

// The Float32 array of this name of a .vtp as Isolux writes them.
std::vector<float> arrayOf(const std::string& vtp, const std::string& name) {
  const std::size_t tag = vtp.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::string key = "offset=\"";
  const std::size_t offset = std::stoul(vtp.substr(vtp.find(key, tag) + key.size()));
  const std::size_t begin = vtp.find('_', vtp.find("<AppendedData")) + 1 + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, vtp.data() + begin, sizeof(bytes));
  std::vector<float> values(bytes / sizeof(float));
  std::memcpy(values.data(), vtp.data() + begin + sizeof(bytes), bytes);
  return values;
}

class MeshCommand : public testing::Test {
 protected:
  RunResult run(std::vector<std::string> arguments) {
    std::vector<std::string> all{"mesh"};
    for (std::string& argument : arguments) all.push_back(std::move(argument));
    return callIsolux(all, folder_);
  }
  std::filesystem::path folder_ = temporaryFolder();
};

TEST_F(MeshCommand, EveryFormatReadsBackAsTheBall) {
  for (const char* name : {"ball.stl", "ball.ply", "ball.obj", "ball.vtp"}) {
    const RunResult result = run({"phantom:ball:32", "--out", name, "--json"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json said = json::parse(result.out);
    EXPECT_TRUE(said["closed"].get<bool>());
    EXPECT_LT(said["largest_distance_mm"].get<double>(), 0.1);
    base::Progress progress;
    const volume::BoxMm box = volume::readMeshBounds(folder_ / name, {}, progress);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(box.low[axis], -kRadius, 0.1) << name;
      EXPECT_NEAR(box.high[axis], kRadius, 0.1) << name;
    }
  }
}

// A ball about the origin, a cube of voxels of 0.01 mm, moved by `far` mm along each axis.
std::string farBall(const std::filesystem::path& folder, double far) {
  const std::string name = "far.mha";
  std::ofstream file(folder / name, std::ios::binary);
  file << "ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\nElementSpacing = 0.01 0.01 0.01\nOffset = "
       << far << ' ' << far << ' ' << far << "\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const float value = 8.0F - static_cast<float>(std::hypot(x - 11.5, y - 11.5, z - 11.5));
        file.write(reinterpret_cast<const char*>(&value), sizeof(value));
      }
  return name;
}

TEST_F(MeshCommand, ThePrecisionOfStlIsPartOfItsDistanceOrRefused) {
  const auto distance = [&](double far, const std::string& out) {
    const RunResult result = run({farBall(folder_, far), "--isovalue", "0", "--out", out, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(result.out)["largest_distance_mm"].get<double>();
  };
  // At 100 mm floats lie 7.6e-6 mm apart.
  const double exact = distance(100.0, "far.ply"), rounded = distance(100.0, "far.stl");
  EXPECT_GT(rounded, exact + 1e-6);
  EXPECT_LE(rounded, exact + std::sqrt(3.0) * 0.5 * 7.63e-6);
  farBall(folder_, 1e6);
  const RunResult refused = run({"far.mha", "--isovalue", "0", "--out", "b.stl"});
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_TRUE(refused.isOneErrorLine()) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("b.stl: so far from the origin"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.stl"));
  EXPECT_NEAR(distance(1e6, "b.ply"), exact, 1e-3 * exact);
}

TEST_F(MeshCommand, VtpHasWhatIsKnownAtThePoints) {
  const RunResult result =
      run({"phantom:ball:32", "--out", "ball.vtp", "--set", "color.volume=phantom:ball:32", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto points = json::parse(result.out)["points"].get<std::size_t>();
  const std::string vtp = contentOf(folder_ / "ball.vtp");
  const std::vector<float> kappa1 = arrayOf(vtp, "kappa1"), normals = arrayOf(vtp, "normals"),
                           second = arrayOf(vtp, "color_value");
  ASSERT_EQ(kappa1.size(), points);
  ASSERT_EQ(normals.size(), 3 * points);
  ASSERT_EQ(second.size(), points);
  ASSERT_EQ(arrayOf(vtp, "kappa2").size(), points);
  ASSERT_EQ(arrayOf(vtp, "confidence").size(), points);
  for (std::size_t i = 0; i < points; ++i) {
    EXPECT_NEAR(static_cast<double>(kappa1[i]), 1.0 / kRadius, 0.05 / kRadius);
    EXPECT_NEAR(std::hypot(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]), 1.0, 1e-5);
    EXPECT_NEAR(static_cast<double>(second[i]), 0.0, 1e-5);  // the same volume: the isovalue
  }
}

TEST_F(MeshCommand, WhatCannotBeMadeIsOneLineAndNoFile) {
  const RunResult wrongName = run({"phantom:ball:32", "--out", "ball.txt"});
  EXPECT_EQ(wrongName.exitCode, 2);
  EXPECT_THAT(wrongName.err, HasSubstr(".stl, .ply, .obj or .vtp"));
  for (const char* empty : {"isosurface.value=1e6", "pieces.hidden=0,0,0"}) {
    const RunResult result = run({"phantom:ball:32", "--out", "ball.stl", "--set", empty});
    EXPECT_EQ(result.exitCode, 3);
    EXPECT_THAT(result.err, HasSubstr("no file is written"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "ball.stl"));
  }
}

}  // namespace
}  // namespace isolux::test
