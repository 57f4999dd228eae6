// C++ and GLSL must agree on the numbers they share; shader files must resolve.
#include "render/gl/constants.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "render/gl/shader_library.h"
#include "scene/settings/settings.h"

namespace isolux::render {
namespace {

TEST(ConstantsTest, MissingTexelIsTheSameInGlsl) {
  const std::string source = shaderSource("field.glsl");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(source, match, std::regex("const float missingTexel = ([^;]+);")));
  EXPECT_EQ(std::stof(match[1]), missingTexel);
}

TEST(ConstantsTest, WhatStandsForNothingIsTheSameInGlsl) {
  for (const auto& [file, name, number] : {std::tuple{"edge.frag.glsl", "noEdge", kNoEdge},
                                           {"measures.glsl", "noEdge", kNoEdge},
                                           {"second_volume.glsl", "noValue", kNoValue}}) {
    const std::string source = shaderSource(file);
    std::smatch match;
    ASSERT_TRUE(
        std::regex_search(source, match, std::regex("const float " + std::string(name) + " = ([^;,]+)")));
    EXPECT_EQ(std::stof(match[1]), number) << file;
  }
}

// The look's shader compares with names that are made of the settings' choices: one that no choice has would
// never be equal to anything.
TEST(ConstantsTest, TheLookComparesWithNamesOfChoices) {
  const std::string source = shaderSource("shade.frag.glsl");
  for (const auto& [path, prefix] :
       {std::pair{"look.mode", "LOOK_"}, {"look.shading", "SHADING_"}, {"look.texture", "TEXTURE_"}}) {
    std::set<std::string> known;
    for (std::string name : scene::setting(path).choices) {
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
      known.insert(prefix + name);
    }
    const std::regex used("\\b" + std::string(prefix) + "[A-Z0-9_]+");
    int found = 0;
    for (std::sregex_iterator at(source.begin(), source.end(), used), end; at != end; ++at, ++found)
      EXPECT_EQ(known.count(at->str()), 1u) << at->str();
    EXPECT_GT(found, 2) << prefix;
  }
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
