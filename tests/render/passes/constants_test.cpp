// C++ and GLSL must agree on the numbers they share; shader files must resolve.
#include "render/constants.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include <gtest/gtest.h>

#include "render/gl/shader_library.h"
#include "scene/scene.h"
#include "scene/settings.h"

namespace isolux::render {
namespace {

TEST(ConstantsTest, MissingTexelIsTheSameInGlsl) {
  const std::string source = shaderSource("field.glsl");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(source, match, std::regex("const float missingTexel = ([^;]+);")));
  EXPECT_EQ(std::stof(match[1]), missingTexel);
}

// A choice's names stand in the order of its enumeration; look_modes.glsl numbers them the same way.
void expectNumbered(const std::string& path, const std::string& prefix) {
  const std::string source = shaderSource("look_modes.glsl");
  const scene::Setting& setting = scene::setting(path);
  for (std::size_t i = 0; i < setting.choices.size(); ++i) {
    std::string name = setting.choices[i];
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    const std::string line = "#define " + prefix + name + " " + std::to_string(i) + "\n";
    EXPECT_NE(source.find(line), std::string::npos) << line;
  }
}

TEST(ConstantsTest, LookNumbersAreThoseOfTheEnumerations) {
  expectNumbered("look.mode", "LOOK_");
  expectNumbered("look.shading", "SHADING_");
  expectNumbered("look.texture", "TEXTURE_");
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
