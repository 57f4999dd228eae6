// The text of cases, and how failing ones become simple.
#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/properties/property_run.h"

namespace isolux::test {
namespace {

TEST(PropertyCase, ItsTextMakesTheSameAgain) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const PropertyCase made = randomCase(seed);
    const PropertyCase again = parseCase(textOf(made));
    EXPECT_EQ(textOf(again), textOf(made));
    EXPECT_EQ(again.grid().hash(), made.grid().hash());
    const volume::Grid grid = made.grid();
    EXPECT_EQ(again.isovalueIn(grid), made.isovalueIn(grid));
  }
}

TEST(PropertyCase, WrongTextsAreRefused) {
  for (const char* text : {"field=none", "field=add(const:1)", "field=const:1)", "field=noise", "dims=1,2",
                           "depth=3", "fov=wide", "type=int8 seed"})
    EXPECT_THROW(parseCase(text), std::invalid_argument) << text;
  EXPECT_THROW(parseCase("type=int4").grid(), std::invalid_argument);
}

// All kinds of volumes are among the cases.
TEST(PropertyCase, CasesAreOfManyKinds) {
  int gaps = 0, constant = 0, integers = 0, denormal = 0, ofVoxels = 0, inside = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const PropertyCase made = randomCase(seed);
    const volume::Grid grid = made.grid();
    gaps += grid.missingCount() > 0;
    constant += grid.minimum() == grid.maximum();
    integers += grid.storedType() != volume::VoxelType::float32;
    denormal += grid.maximum() != 0.0 && std::abs(grid.maximum()) < 1e-38;
    ofVoxels += made.ofVoxel;
    inside += glm::min(made.eye, 1.0 - made.eye).x >= 0.0 && glm::min(made.eye, 1.0 - made.eye).y >= 0.0;
  }
  for (const int count : {gaps, denormal, ofVoxels, inside}) EXPECT_GT(count, 8);
  EXPECT_GT(integers, 100);
  EXPECT_LT(constant, 120);
}

// What fails wherever a volume has a needle shrinks to little more than that.
TEST(PropertyCase, FailingCasesShrink) {
  const Property hasNeedles = [](const PropertyCase& made) {
    return textOf(made.field).find("needles") != std::string::npos ? "a needle" : "";
  };
  int tried = 0;
  for (std::uint64_t seed = 0; tried < 5; ++seed) {
    const PropertyCase made = randomCase(seed);
    if (hasNeedles(made).empty()) continue;
    ++tried;
    const PropertyCase simple = shrunk(made, hasNeedles, 3000);
    EXPECT_EQ(simple.field.name, "needles");
    EXPECT_EQ(simple.dims, glm::ivec3(2));
    EXPECT_EQ(simple.picture, glm::ivec2(1));
    EXPECT_EQ(simple.type, "float32");
  }
}

}  // namespace
}  // namespace isolux::test
