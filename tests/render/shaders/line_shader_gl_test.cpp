// Shaders of lines where a line has no direction, no length or no slope.
#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

using glm::vec3;
using glm::vec4;

constexpr float kFar = 1000.0f;  // line_field.frag.glsl
const std::string kRidges = "#define RIDGES\n#define AT_RIDGES 0\n#define AT_VALLEYS 1\n";
const std::string kContours = "#define CONTOURS\n#define AT_CONTOURS 0\n";
const std::string kSuggestive = "#define SUGGESTIVE\n#define AT_SUGGESTIVE 0\n";

class LineShaderGlTest : public ShaderGlTest {
 protected:
  // A row of points that rays along +z meet, with one gradient, curvature and direction of it.
  void setPoints(int count, vec3 gradient, vec4 kappa, vec3 direction) {
    setPlainView(count);
    ShaderRow surface, info, gradients, kappas, directions;
    for (int i = 0; i < count; ++i) {
      surface.emplace_back(static_cast<float>(i), 0.0f, 10.0f, 10.0f);
      info.emplace_back(0.0f, 4.0f, 0.0f, 0.0f);
      gradients.emplace_back(gradient, 1.0f);
      kappas.push_back(kappa);
      directions.emplace_back(direction, 0.0f);
    }
    setRow("uSurface", surface);
    setRow("uInfo", info);
    setRow("uGradient", gradients);
    setRow("uKappa", kappas);
    setRow("uDirection", directions);
    set("uDetail", 1.0f);
  }
};

TEST_F(LineShaderGlTest, WhatDoesNotChangeHasNoZero) {
  useFunctions({"line_field.frag.glsl"}, "result = lineAlong(given(0).xy, given(0).z, 1.0);", kRidges);
  setInput(0, {{0, 0, 1, 0}, {0, 0, 0, 0}, {1e-10f, 0, 1, 0}, {0, 2, 1, 0}});
  const ShaderRow lines = results(4);
  EXPECT_EQ(lines[0], vec4(0, 0, kFar, 0));
  EXPECT_EQ(lines[1], vec4(0, 0, kFar, 0));
  EXPECT_EQ(lines[2].z, kFar);
  EXPECT_FLOAT_EQ(lines[3].z, 0.5f);
}

TEST_F(LineShaderGlTest, AnUnknownDerivativeIsNone) {
  useFunctions({"line_field.frag.glsl"},
               "Point p = pointAt(ivec2(0), texelFetch(uSurface, ivec2(0), 0)); float d;"
               "result.x = float(extremumAt(ivec2(int(gl_FragCoord.x), 0), p, 4.0, vec3(1, 0, 0), false, "
               "d)); result.y = d;",
               kRidges);
  setPoints(2, vec3(0, 0, -1), vec4(1, 0, 1, 1), vec3(1, 0, 0));
  setRow("uExtrema", {{3e38f, 3e38f, 0, 0}, {2, 2, 0, 0}});
  const ShaderRow derivatives = results(2);
  EXPECT_EQ(derivatives[0].x, 0.0f);
  EXPECT_EQ(derivatives[1].x, 1.0f);
  EXPECT_EQ(derivatives[1].y, 2.0f);
}

TEST_F(LineShaderGlTest, ARidgeAlongTheViewHasNoDirectionOnScreen) {
  useShader("line_field.frag.glsl", kRidges);
  // Seen edge on, with the first direction across the view: the line runs along it.
  setPoints(1, vec3(1, 0, 0), vec4(1, 0, 1, 1), vec3(0, 1, 0));
  set("uRidgeThresholds", glm::vec2(0.1f));
  setRow("uExtrema", {{0, 0, 0, 0}});
  const vec4 ridge = outputs(1)[0][0];
  EXPECT_EQ(ridge, vec4(0, 0, kFar, 0));
}

TEST_F(LineShaderGlTest, AnOutlineOfWhatFacesTheViewerIsNone) {
  useShader("line_field.frag.glsl", kContours);
  setPoints(1, vec3(0, 0, -1), vec4(1, 1, 1, 1), vec3(1, 0, 0));
  set("uContourWidth", 2.0f);
  const vec4 facing = outputs(1)[0][0];
  EXPECT_EQ(facing, vec4(0, 0, kFar, 0));
}

TEST_F(LineShaderGlTest, AnOutlineOfWhatIsFlatIsNone) {
  useShader("line_field.frag.glsl", kContours);
  set("uContourWidth", 2.0f);
  setPoints(1, vec3(1, 0, 0.1f), vec4(0, 0, 1, 1), vec3(0, 1, 0));
  EXPECT_EQ(outputs(1)[0][0].w, 0.0f);
  setPoints(1, vec3(1, 0, 0.1f), vec4(0.01f, 0.01f, 1, 1), vec3(0, 1, 0));
  EXPECT_EQ(outputs(1)[0][0].w, 1.0f);
}

// Unit vectors of floats are longer than 1 by a rounding, some of them; a curvature that changes sign goes
// through the row.
TEST_F(LineShaderGlTest, ASuggestiveContourOfWhatFacesTheViewerIsNone) {
  constexpr int kCount = 17;
  setRows(kCount);
  useShader("line_field.frag.glsl", kSuggestive);
  for (int i = 0; i < 200; ++i) {
    const vec3 forward =
        glm::normalize(vec3(0.013f * static_cast<float>(i), 1.0f, 2.0f + 0.031f * static_cast<float>(i)));
    const vec3 right = glm::normalize(glm::cross(forward, vec3(0, 1, 0)));
    setPoints(kCount, -forward, vec4(0), right);
    set("uForwardWorld", forward);
    set("uRightWorld", right);
    set("uUpWorld", glm::cross(right, forward));
    set("uContourWidth", 2.0f);
    set("uCurvatureScale", 0.01f);
    ShaderRow kappas;
    for (int x = 0; x < kCount; ++x)
      kappas.emplace_back(vec4(glm::vec2(0.01f * static_cast<float>(x - kCount / 2)), 1, 1));
    setRow("uKappa", kappas);
    const ShaderRow lines = outputs(kCount)[0];
    for (const vec4& line : lines) EXPECT_EQ(line.w, 0.0f) << i;
  }
}

class DrawnLineShaderGlTest : public LineShaderGlTest {
 protected:
  // One pixel of a line, and nothing around it.
  vec4 drawnOfOne(float length) {
    useShader("lines.frag.glsl", kRidges);
    setPoints(3, vec3(0, 0, -1), vec4(1, 0, 1, 1), vec3(1, 0, 0));
    const ShaderRow field = {{0, 0, kFar, 0}, {1, 0, 0, 2}, {0, 0, kFar, 0}};
    setRow("uRidgeField", field);
    setRow("uValleyField", field);
    set("uRidgeLengths", glm::vec2(length));
    set("uRidgeRays", 2.0f);
    set("uMostRays", 40.0f);
    set("uPixel", 0.1f);
    return outputs(3)[0][1];
  }
};

TEST_F(DrawnLineShaderGlTest, ALineOfOnePointHasNoStrength) {
  const vec4 lines = drawnOfOne(1.0f);
  EXPECT_EQ(lines, vec4(0));
}
TEST_F(DrawnLineShaderGlTest, ALengthOfNothingIsReachedByNoLine) {
  const vec4 lines = drawnOfOne(0.0f);
  EXPECT_EQ(lines, vec4(0));
}

TEST_F(DrawnLineShaderGlTest, TheDistanceToASegmentOfNoLength) {
  useFunctions({"lines.frag.glsl"}, "result.x = distanceToSegment(given(0).xy, given(1).xy, given(1).zw);",
               kRidges);
  setInput(0, {{3, 4, 0, 0}, {3, 4, 0, 0}});
  setInput(1, {{0, 0, 0, 0}, {0, 0, 6, 0}});
  const ShaderRow distances = results(2);
  EXPECT_FLOAT_EQ(distances[0].x, 5.0f);
  EXPECT_FLOAT_EQ(distances[1].x, 4.0f);
}

TEST_F(DrawnLineShaderGlTest, AnOutlineWithoutStrengthIsNone) {
  useShader("lines.frag.glsl", kContours);
  setPoints(3, vec3(0, 0, -1), vec4(1, 0, 1, 1), vec3(1, 0, 0));
  setRow("uContourField", {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}});
  set("uContourWidth", 2.0f);
  set("uPixel", 1.0f);
  EXPECT_EQ(outputs(3)[0][1], vec4(0));
}

class ExtremaShaderGlTest : public LineShaderGlTest {
 protected:
  // Of the middle one of three by three points, apart by these from pixel to pixel; kappa1 rises along both.
  float extremumOf(vec3 right, vec3 up, float kappaStep) {
    setRows(3);
    useShader("extrema.frag.glsl");
    setPoints(3, vec3(0, 0, -1), vec4(1, 0, 1, 1), vec3(1, 0, 0));
    std::vector<ShaderRow> surface(3), kappa(3);
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const auto i = static_cast<float>(x), j = static_cast<float>(y);
        surface[static_cast<std::size_t>(y)].emplace_back(i * right + j * up + vec3(0, 0, 10), 10.0f);
        kappa[static_cast<std::size_t>(y)].emplace_back(1.0f + kappaStep * (i + j), 0.0f, 1.0f, 1.0f);
      }
    setImage("uSurface", surface);
    setImage("uKappa", kappa);
    return outputs(3)[0][1].x;
  }
  static constexpr float kUnknown = 3e38f;  // extrema.frag.glsl
};

TEST_F(ExtremaShaderGlTest, AreTheSlopeOfTheCurvature) {
  EXPECT_NEAR(extremumOf(vec3(1, 0, 0), vec3(0, 1, 0), 0.1f), 0.1, 1e-6);
}
TEST_F(ExtremaShaderGlTest, OfPointsAllButInALineAreUnknown) {
  EXPECT_EQ(extremumOf(vec3(1, 1, 1e-3f), vec3(1, 1, 0), 0.1f), kUnknown);
}
TEST_F(ExtremaShaderGlTest, BeyondAllNumbersAreUnknown) {
  EXPECT_EQ(extremumOf(vec3(1e-3f, 0, 0), vec3(0, 1e-3f, 0), 1e37f), kUnknown);
}

}  // namespace
}  // namespace isolux::test
