// C++ and GLSL must agree on the numbers they share; shader files must resolve.
#include "render/constants.h"

#include <regex>

#include <gtest/gtest.h>

#include "render/shader_library.h"
#include "scene/scene.h"

namespace isolux::render {
namespace {

TEST(ConstantsTest, MissingTexelIsTheSameInGlsl) {
  const std::string source = shaderSource("field.glsl");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(source, match, std::regex("const float missingTexel = ([^;]+);")));
  EXPECT_EQ(std::stof(match[1]), missingTexel);
}

TEST(ConstantsTest, LookNumbersAreThoseOfTheEnumeration) {
  // shade.frag.glsl compares LOOK with these.
  EXPECT_EQ(static_cast<int>(scene::LookMode::blinn_phong), 0);
  EXPECT_EQ(static_cast<int>(scene::LookMode::lambert), 1);
  EXPECT_EQ(static_cast<int>(scene::LookMode::normal), 12);
  EXPECT_EQ(static_cast<int>(scene::LookMode::depth), 13);
}

TEST(ShaderLibraryTest, ExpandsEachIncludeOnce) {
  const std::string source = shaderSource("cast.frag.glsl", "#define EXACT\n");
  EXPECT_EQ(source.rfind("#version 450 core\n#define EXACT\n", 0), 0u);
  EXPECT_EQ(source.find("#include"), std::string::npos);
  const std::size_t first = source.find("void pixelRay");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(source.find("void pixelRay", first + 1), std::string::npos);
}

TEST(ShaderLibraryTest, UnknownNameIsOurOwnMistake) {
  EXPECT_THROW(shaderSource("no_such.glsl"), std::logic_error);
}

}  // namespace
}  // namespace isolux::render
