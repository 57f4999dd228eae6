#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/color.h"
#include "base/error.h"
#include "gi/sampling/environment.h"
#include "tests/support/test_data.h"

namespace isolux::gi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

double luminance(glm::dvec3 c) {
  return base::luminance(c);
}

std::string write(const std::string& name, const std::string& bytes) {
  const fs::path path = test::temporaryFolder() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

// Four bytes per pixel: mantissas and the exponent they share. Each is mantissa / 256 * 2^(exponent - 128).
std::string radianceFile(const std::string& resolution, const std::string& pixels) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n" + pixels;
}

const std::string sixPixels(
    "\x80\x80\x80\x81\x80\x80\x80\x82\x80\x80\x80\x83"
    "\x80\x80\x80\x84\x80\x80\x80\x85\x80\x00\x00\x86",
    24);  // grey of 1, 2, 4; 8, 16, and red of 32, each plus half a step at most

double greyAt(const Environment& e, int column, int row) {
  return e.pixels()[row * e.width() + column].r;
}

void expectRefusal(const std::string& path, const std::string& place, const std::string& reason) {
  try {
    Environment::load(path);
    ADD_FAILURE() << path << " was read";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_EQ(error.file(), path);
    EXPECT_THAT(error.place(), HasSubstr(place));
    EXPECT_THAT(error.reason(), HasSubstr(reason));
    EXPECT_THAT(error.reason(), testing::Not(HasSubstr("\n")));
  }
}

TEST(EnvironmentLoad, ReadsRadianceFilesTopRowFirst) {
  const Environment e = Environment::load(write("a.hdr", radianceFile("-Y 2 +X 3", sixPixels)));
  ASSERT_EQ(e.width(), 3);
  ASSERT_EQ(e.height(), 2);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(greyAt(e, i % 3, i / 3), std::exp2(i), std::exp2(i) / 128) << i;
  EXPECT_EQ(e.pixels()[5].g, 0.0f);
  EXPECT_EQ(e.badPixels(), 0u);
}

// Portable float maps are written from the bottom up; grey ones have one channel.
TEST(EnvironmentLoad, ReadsFloatMapsOfOneAndThreeChannels) {
  const std::vector<float> grey{5, 6, 1, 2};
  std::string bytes(16, '\0');
  std::memcpy(bytes.data(), grey.data(), 16);
  const Environment e = Environment::load(write("a.pfm", "Pf\n2 2\n-1.0\n" + bytes));
  EXPECT_EQ(e.pixels(), (std::vector<glm::vec3>{glm::vec3(1), glm::vec3(2), glm::vec3(5), glm::vec3(6)}));
  const std::vector<float> color{1, 2, 3, NAN, 0.5f, 0.5f};
  bytes.resize(24);
  std::memcpy(bytes.data(), color.data(), 24);
  const Environment c = Environment::load(write("b.pfm", "PF\n2 1\n-1.0\n" + bytes));
  EXPECT_EQ(c.pixels()[0], glm::vec3(1, 2, 3));
  EXPECT_EQ(c.pixels()[1], glm::vec3(1, 2, 3));
  EXPECT_EQ(c.badPixels(), 1u);
}

// 8-bit samples are on the sRGB curve: 188 is 0.5029.
TEST(EnvironmentLoad, DecodesIntegerSamples) {
  const Environment e =
      Environment::load(write("a.ppm", std::string("P6\n3 1\n255\n\0\0\0\xff\xff\xff\xbc\xbc\xbc", 20)));
  EXPECT_EQ(e.pixels()[0], glm::vec3(0));
  EXPECT_EQ(e.pixels()[1], glm::vec3(1));
  EXPECT_NEAR(e.pixels()[2].g, 0.5029, 1e-4);
}

TEST(EnvironmentLoad, RefusesWhatIsNoImageWithFilePlaceAndReason) {
  expectRefusal((test::temporaryFolder() / "absent.hdr").string(), "", "not a file");
  expectRefusal(test::temporaryFolder().string(), "", "not a file");
  expectRefusal(write("text.hdr", "this is no picture"), "", "");
  expectRefusal(write("empty.exr", ""), "", "");
  expectRefusal(write("text.unknown", "this is no picture"), "", "");
  expectRefusal(write("short.hdr", radianceFile("-Y 2 +X 3", sixPixels.substr(0, 16))), "row 2", "");
  expectRefusal(write("large.hdr", radianceFile("-Y 100000 +X 100000", sixPixels)), "header", "too many");
  expectRefusal(write("zero.hdr", radianceFile("-Y 0 +X 3", sixPixels)), "", "");
}

// The figure of the data folder's README: the largest luminance over the mean of the sphere.
TEST(EnvironmentLoad, SharedProbesHaveTheirKnownLight) {
  ISOLUX_NEEDS_DATA();
  struct Probe {
    const char* name;
    int width;
    double contrast;
  };
  for (const Probe& probe :
       {Probe{"grace_cathedral_1k.hdr", 1024, 1005}, Probe{"grace_latlong.exr", 1024, 1005},
        Probe{"grace_256.hdr", 256, 11317}, Probe{"uffizi_256.hdr", 256, 16}, Probe{"wells_256.hdr", 256, 21},
        Probe{"venice_sunset_1k.hdr", 1024, 4213}}) {
    const Environment e = Environment::load((test::dataFolder() / "hdr" / probe.name).string());
    EXPECT_EQ(e.width(), probe.width);
    EXPECT_EQ(e.height(), probe.width / 2);
    EXPECT_EQ(e.badPixels(), 0u) << probe.name;
    double largest = 0;
    for (const glm::vec3& pixel : e.pixels()) largest = std::max(largest, luminance(pixel));
    // Theirs is of pixels weighted by the sine of their middle and of rounded luminance weights.
    EXPECT_NEAR(largest / luminance(e.mean()) / probe.contrast, 1.0, probe.contrast < 100 ? 0.03 : 0.005)
        << probe.name;
  }
}

// The .hdr is the .exr turned by half a turn in its plane: up and down swapped, left and right swapped.
TEST(EnvironmentLoad, GraceIsUprightAndItsSourceUpsideDown) {
  ISOLUX_NEEDS_DATA();
  const Environment hdr = Environment::load((test::dataFolder() / "hdr/grace_cathedral_1k.hdr").string());
  const Environment exr = Environment::load((test::dataFolder() / "hdr/grace_latlong.exr").string());
  EXPECT_NEAR(luminance(hdr.mean()), 0.0147, 0.0001);
  const std::size_t count = hdr.pixels().size();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 a = hdr.pixels()[i], b = exr.pixels()[count - 1 - i];
    const float step = std::max({b.r, b.g, b.b}) / 127.0f;  // of the shared exponent
    ASSERT_LT(glm::length(a - b), 2.0f * step + 1e-9f) << i;
  }
}

}  // namespace
}  // namespace isolux::gi
