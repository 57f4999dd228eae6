#include "gi/file/bake_file.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "gi/bake/light_bake.h"
#include "tests/gi/bake/formula_estimator.h"
#include "tests/support/volumes.h"
#include "volume/hit/nearest_point.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/reader.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::gi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kKey = R"({"volume":"1","lattice_scale":1.5,"bounces":1,"albedo":[0.5,0.5,0.5]})";
constexpr const char* kLampsKey = R"({"volume":"1","lamps":[]})";

class BakeFile : public testing::Test {
 protected:
  BakeFile() : folder_(fs::temp_directory_path() / ("isolux_bake_file_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~BakeFile() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "light.vti"; }
  std::string contents() const {
    std::ifstream stream(file(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  void replace(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }
  StoredLight read(const std::string& key = kKey, const std::string& lampsKey = kLampsKey) {
    return readBakeFile(file(), grid_, {}, key, lampsKey, progress_);
  }
  // The error of reading, as one line.
  std::string refusal(const std::string& key = kKey) {
    try {
      read(key, "");
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::input);
      EXPECT_EQ(error.file(), file().string());
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  base::Progress progress_;
  // Oblique and left-handed, 0.5 x 0.7 x 3 mm.
  volume::Grid grid_{volume::GridGeometry::make({12, 9, 11}, {0.5, 0.7, 3.0}, {10.0, -20.0, 30.0},
                                                glm::dmat3(0.6, 0.8, 0.0, 0.8, -0.6, 0.0, 0.0, 0.0, 1.0)),
                     std::vector<std::uint8_t>(12 * 9 * 11, 3)};
  LatticeGeometry geometry_ = LatticeGeometry::make({12, 9, 11}, 1.5);
};

std::shared_ptr<LightLattice> baked(const LatticeGeometry& geometry, LightContent content,
                                    std::uint32_t samples, const std::string& key = kKey,
                                    std::shared_ptr<LightLattice> from = nullptr) {
  const auto estimator = std::make_shared<FormulaEstimator>(content);
  auto lattice = from ? from : std::make_shared<LightLattice>(geometry, content, key);
  LightBake bake(lattice, estimator, {.samples = samples, .threads = 2});
  bake.want(Priority::rest, texelsWhere(geometry, [](glm::ivec3 t) { return t.x < 10; }));
  EXPECT_TRUE(bake.waitFor(0, 100.0));
  return lattice;
}

const LightContent kIrradiance{LightContent::Kind::irradiance, 3, 0};
const LightContent kGrey{LightContent::Kind::irradiance, 1, 0};
const LightContent kTransfer{LightContent::Kind::transfer, 3, 3};

void expectSameLight(const LightLattice& a, const LightLattice& b) {
  EXPECT_EQ(a.geometry(), b.geometry());
  EXPECT_EQ(a.content(), b.content());
  EXPECT_EQ(a.bakedTexels(), b.bakedTexels());
  for (std::uint32_t block = 0; block < a.geometry().blockCount(); ++block) {
    const auto x = a.at(block), y = b.at(block);
    ASSERT_EQ(x == nullptr, y == nullptr);
    if (!x) continue;
    EXPECT_EQ(x->samples, y->samples);
    EXPECT_EQ(x->normals, y->normals);
    EXPECT_EQ(x->means, y->means);
  }
}

TEST_F(BakeFile, LightComesBackAsItWas) {
  for (const LightContent content : {kIrradiance, kGrey, kTransfer}) {
    const auto sky = baked(geometry_, content, 16);
    const auto lamps = baked(geometry_, kIrradiance, 4, kLampsKey);
    writeBakeFile(file(), grid_, {sky, lamps}, progress_);
    const StoredLight light = read();
    ASSERT_TRUE(light.sky && light.lamps);
    expectSameLight(*sky, *light.sky);
    expectSameLight(*lamps, *light.lamps);
    EXPECT_EQ(light.sky->key(), kKey);
    EXPECT_EQ(light.lamps->key(), kLampsKey);
    EXPECT_EQ(read(kKey, "").lamps, nullptr);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()),
            1);  // nothing left beside
}

// Where texels of a lattice with an isovalue were lit is found again in the volume.
TEST_F(BakeFile, PlacesOnAnIsosurfaceComeBack) {
  std::vector<float> ramp;
  for (int i = 0; i < 12 * 9 * 11; ++i) ramp.push_back(0.9f * static_cast<float>(i % 12) + 0.1f);
  const volume::Grid grid(grid_.geometry(), std::move(ramp));
  const double isovalue = 4.0;
  const std::string key = R"({"lattice_scale":1.5,"isovalue":4.0})";
  const LatticeGeometry geometry = LatticeGeometry::make({12, 9, 11}, 1.5, grid.storedIsovalue(isovalue));
  auto lattice = std::make_shared<LightLattice>(geometry, kIrradiance, key);
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b) {
    LatticeBlock block = lattice->dark();
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = geometry.texelOf(b, static_cast<int>(i));
      const float away = geometry.voxelOf(texel).x - 3.9f / 0.9f;
      if (!geometry.contains(texel) || std::abs(away) > 0.6f) continue;
      block.samples[i] = 16;
      block.normals[i] = {1.0f, 0.0f, 0.0f};
      block.places[i] = geometry.voxelOf(texel) - glm::vec3(away, 0.0f, 0.0f);
    }
    const bool lit = std::any_of(block.samples.begin(), block.samples.end(), [](auto n) { return n > 0; });
    if (lit) lattice->write(b, block);
  }
  ASSERT_GT(lattice->bakedTexels(), 100u);
  writeBakeFile(file(), grid, {lattice, nullptr}, progress_);
  EXPECT_TRUE(isOfOneIsovalue(file()));
  const StoredLight light = readBakeFile(file(), grid, {}, key, "", progress_);
  ASSERT_TRUE(light.sky);
  expectSameLight(*lattice, *light.sky);
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b)
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      if (!lattice->at(b) || lattice->at(b)->samples[i] == 0) continue;
      EXPECT_LT(glm::length(light.sky->at(b)->places[i] - lattice->at(b)->places[i]), 1e-4f);
    }
  EXPECT_THROW(readBakeFile(file(), grid, {}, R"({"lattice_scale":1.5,"isovalue":5.0})", "", progress_),
               base::Error);
  writeBakeFile(file(), grid_, {baked(geometry_, kIrradiance, 4), nullptr}, progress_);
  EXPECT_FALSE(isOfOneIsovalue(file()));
}

// A ball close to a larger one is hidden: texels between them were lit on the larger one.
TEST_F(BakeFile, TexelsStandWhereTheyWereLitBesideAHiddenPiece) {
  const auto balls = test::prepared(test::gridOfVoxels(test::unitGeometry({48, 32, 32}), [](glm::dvec3 p) {
    return std::max(11.0 - glm::distance(p, glm::dvec3(16.3, 15.5, 15.5)),
                    6.5 - glm::distance(p, glm::dvec3(34.3, 15.5, 15.5)));
  }));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.pieces.keep = 1;
  const std::vector<volume::HiddenOfSurface> hidden = volume::hiddenOf(scene, *balls->pieces, progress_);
  const volume::Grid& grid = balls->grid();
  const std::string key = R"({"lattice_scale":1.0,"isovalue":0.0})";
  const LatticeGeometry geometry = LatticeGeometry::make(grid.dims(), 1.0, 0.0f);
  auto lattice = std::make_shared<LightLattice>(geometry, kIrradiance, key);
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b) {
    LatticeBlock block = lattice->dark();
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = geometry.texelOf(b, static_cast<int>(i));
      if (!geometry.contains(texel)) continue;
      const auto place = volume::nearestSurfacePoint(grid, geometry.voxelOf(texel), geometry.reach(), 0.0f,
                                                     volume::hiddenAt(hidden, 0.0));
      if (!place) continue;
      block.samples[i] = 16;
      block.normals[i] = {1.0f, 0.0f, 0.0f};
      block.places[i] = *place;
    }
    if (std::any_of(block.samples.begin(), block.samples.end(), [](auto n) { return n > 0; }))
      lattice->write(b, block);
  }
  writeBakeFile(file(), grid, {lattice, nullptr}, progress_);
  const StoredLight light = readBakeFile(file(), grid, hidden, key, "", progress_);
  ASSERT_TRUE(light.sky);
  expectSameLight(*lattice, *light.sky);
  std::size_t lit = 0;
  for (std::uint32_t b = 0; b < geometry.blockCount(); ++b) {
    if (!lattice->at(b)) continue;
    EXPECT_EQ(light.sky->at(b)->places, lattice->at(b)->places);
    const auto& samples = lattice->at(b)->samples;
    lit +=
        static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(), [](auto n) { return n > 0; }));
  }
  EXPECT_GT(lit, 1000u);
}

TEST_F(BakeFile, LampsAloneAreAFileToo) {
  const auto lamps = baked(geometry_, kIrradiance, 4, kLampsKey);
  writeBakeFile(file(), grid_, {nullptr, lamps}, progress_);
  const StoredLight light = read();
  EXPECT_EQ(light.sky, nullptr);
  ASSERT_TRUE(light.lamps);
  expectSameLight(*lamps, *light.lamps);
}

TEST_F(BakeFile, BakesGoOnFromItBitByBit) {
  for (const LightContent content : {kIrradiance, kGrey, kTransfer}) {
    writeBakeFile(file(), grid_, {baked(geometry_, content, 64), nullptr}, progress_);
    const auto resumed = baked(geometry_, content, 100, kKey, read().sky);
    expectSameLight(*resumed, *baked(geometry_, content, 100));
    EXPECT_EQ(differenceFrom(*resumed, 100), "");
  }
}

// VTK's own reader, where and what it says.
TEST_F(BakeFile, VtkReadsItInItsPlace) {
  for (const LightContent content : {kIrradiance, kGrey, kTransfer}) {
    const auto sky = baked(geometry_, content, 16);
    writeBakeFile(file(), grid_, {sky, nullptr}, progress_);
    const int written = content.kind == LightContent::Kind::transfer ? content.components() : 3;
    for (int component = 0; component < written; component += 2) {
      volume::ReadOptions options;
      options.component = component;
      const volume::Volume volume = volume::readVolume(file().string(), options, progress_);
      EXPECT_EQ(volume.components, written);
      ASSERT_EQ(volume.grid->dims(), geometry_.dims);
      for (const glm::ivec3& texel : {glm::ivec3(0), glm::ivec3(3, 5, 9), geometry_.dims - 1}) {
        const glm::dvec4 there = volume.grid->geometry().worldFromVoxel * glm::dvec4(texel, 1.0);
        const glm::dvec4 here =
            grid_.geometry().worldFromVoxel * glm::dvec4(glm::dvec3(texel) * geometry_.voxelsPerTexel(), 1.0);
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(there[a], here[a], 1e-9);
        const auto block = sky->at(geometry_.blockOf(texel));
        const auto i = static_cast<std::size_t>(LatticeGeometry::indexInBlock(texel));
        const auto stored = static_cast<std::size_t>(content.components());
        const float expected =
            block && block->samples[i] > 0
                ? block->means[i * stored + (stored == 1 ? 0 : static_cast<std::size_t>(component))]
                : 0.0f;
        EXPECT_EQ(volume.grid->value(texel.x, texel.y, texel.z), static_cast<double>(expected));
      }
    }
  }
}

TEST_F(BakeFile, OtherLightIsRefusedByName) {
  writeBakeFile(file(), grid_, {baked(geometry_, kIrradiance, 4), nullptr}, progress_);
  EXPECT_EQ(refusal(), "");
  EXPECT_THAT(refusal(R"({"volume":"1","lattice_scale":1.5,"bounces":1,"albedo":[0.5,0.6,0.5]})"),
              HasSubstr("albedo differs"));
  EXPECT_THAT(refusal(R"({"volume":"1","lattice_scale":1.5,"bounces":0})"), HasSubstr("bounces differs"));
  EXPECT_THAT(refusal(R"({"volume":"2","lattice_scale":1.5,"bounces":0})"),
              HasSubstr("the volume is another one"));
  EXPECT_THAT(
      refusal(R"({"volume":"1","lattice_scale":1.5,"bounces":1,"albedo":[0.5,0.5,0.5],"sh_order":5})"),
      HasSubstr("sh order differs"));
  grid_ = volume::Grid(grid_.geometry(), std::vector<std::uint8_t>(12 * 9 * 11, 4));
  EXPECT_THAT(refusal(), HasSubstr("the volume is another one"));
  EXPECT_THAT(refusal(R"({"format":3,"volume":"1","lattice_scale":1.5,"bounces":1,"albedo":[0.5,0.5,0.5]})"),
              HasSubstr("another version of Isolux"));
}

TEST_F(BakeFile, WhatIsNoSuchFileIsRefused) {
  EXPECT_THAT(refusal(), HasSubstr("light.vti"));  // missing
  replace("");
  EXPECT_THAT(refusal(), HasSubstr("light"));
  replace("P6 1 1 255 abc");
  EXPECT_THAT(refusal(), HasSubstr("light"));
  fs::remove(file());
  fs::create_directories(file());
  EXPECT_THAT(refusal(), HasSubstr("light.vti"));
}

// Every shortening is refused; every damaged byte is refused, or changes nothing.
TEST_F(BakeFile, DamageIsNoticed) {
  const auto sky = baked(geometry_, kGrey, 4);
  writeBakeFile(file(), grid_, {sky, nullptr}, progress_);
  const std::string whole = contents();
  std::mt19937 random(9);
  const std::size_t tail = std::string("\n  </AppendedData>\n</VTKFile>\n").size();
  for (int i = 0; i < 100; ++i) {
    replace(whole.substr(0, random() % (whole.size() - tail)));
    EXPECT_NE(refusal(), "");
  }
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    // The first half of the damages goes to the header.
    const std::size_t at = random() % (i % 2 ? whole.size() : whole.find("<AppendedData") + 40);
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    replace(damaged);
    try {
      const StoredLight light = read(kKey, "");
      if (light.sky) expectSameLight(*sky, *light.sky);
    } catch (const base::Error& error) {
      EXPECT_NE(error.kind(), base::ErrorKind::interrupted);
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST_F(BakeFile, StoppedOrImpossibleWritingLeavesTheOldFile) {
  const auto sky = baked(geometry_, kIrradiance, 4);
  writeBakeFile(file(), grid_, {sky, nullptr}, progress_);
  const std::string before = contents();
  base::Progress stopped;
  stopped.requestStop();
  EXPECT_THROW(writeBakeFile(file(), grid_, {baked(geometry_, kIrradiance, 16), nullptr}, stopped),
               base::Error);
  EXPECT_EQ(contents(), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  EXPECT_THROW(writeBakeFile(folder_ / "none" / "light.vti", grid_, {sky, nullptr}, progress_), base::Error);
  EXPECT_THROW(writeBakeFile(folder_, grid_, {sky, nullptr}, progress_), base::Error);
}

TEST_F(BakeFile, IsWholeWheneverTheWriterIsKilled) {
  const std::array<std::shared_ptr<LightLattice>, 2> lights{baked(geometry_, kTransfer, 4),
                                                            baked(geometry_, kTransfer, 16)};
  writeBakeFile(file(), grid_, {lights[0], nullptr}, progress_);
  std::mt19937 random(3);
  for (int i = 0; i < 25; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (std::size_t n = 0;; ++n) {
        base::Progress progress;
        writeBakeFile(file(), grid_, {lights[n % 2], nullptr}, progress);
      }
    }
    ::usleep(static_cast<useconds_t>(random() % 30000));  // any moment will do
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    const StoredLight light = read(kKey, "");
    ASSERT_TRUE(light.sky);
    const bool first = light.sky->at(0)->samples == lights[0]->at(0)->samples;
    expectSameLight(*lights[first ? 0 : 1], *light.sky);
  }
}

}  // namespace
}  // namespace isolux::gi
