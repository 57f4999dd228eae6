// Shaders of looks on points that have no normal, no curvature, no size on screen, or no width of what they
// are shown over.
#include "base/color.h"
#include "scene/rules/tone_curve.h"
#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

using glm::vec3;
using glm::vec4;

class LookShaderGlTest : public ShaderGlTest {
 protected:
  static constexpr float kFacing =
      4.0f + 1.0f;  // packed knowledge of a hit: surface 0, outside before it; see cast.frag.glsl

  // A point at z = 10 that a ray along +z meets, with this gradient.
  void setPoint(vec3 gradient) {
    setPlainView(1);
    setRow("uSurface", {{0, 0, 10, 10}});
    setRow("uInfo", {{0, kFacing - 1.0f, 0, 0}});
    setRow("uGradient", {vec4(gradient, 1.0f)});
  }
  // `p` in GLSL, seen along +z, with its normal toward the viewer.
  static inline const std::string kPlainPoint =
      "Point p; p.position = vec3(0.3, 0.4, 0.6); p.ray = vec3(0, 0, 1); p.depth = 1.0; p.footprint = 0.1;"
      "p.outward = p.normal = vec3(0, 0, -1); p.side = 1.0;\n";
};

TEST_F(LookShaderGlTest, NormalsOfAllSizes) {
  useFunctions({"common.glsl", "surface.glsl"}, "result.xyz = safeNormalize(given(0).xyz, vec3(0, 1, 0));");
  setInput(0, {{0, 0, 0, 0}, {3e-30f, 0, 4e-30f, 0}, {3e30f, 0, 4e30f, 0}, {3, 0, 4, 0}});
  const ShaderRow normals = results(4);
  EXPECT_EQ(vec3(normals[0]), vec3(0, 1, 0));
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(normals[i].x, 0.6, 1e-6) << i;
    EXPECT_NEAR(normals[i].z, 0.8, 1e-6) << i;
  }
}

TEST_F(LookShaderGlTest, APointWithoutAGradientFacesTheViewer) {
  useFunctions(
      {"common.glsl", "surface.glsl"},
      "Point p = pointAt(ivec2(0), texelFetch(uSurface, ivec2(0), 0)); result = vec4(p.outward, p.side);");
  setPoint(vec3(0));
  EXPECT_EQ(vec3(result()), vec3(0, 0, -1));
}

TEST_F(LookShaderGlTest, ANormalThatTurnsAwayIsSeenEdgeOn) {
  useFunctions({"common.glsl", "surface.glsl"},
               "Point p = pointAt(ivec2(0), texelFetch(uSurface, ivec2(0), 0)); result = vec4(p.normal, "
               "dot(p.normal, p.ray));");
  setPoint(vec3(1.0f, 0.0f, -0.2f));
  const vec4 one = result();
  setPoint(vec3(1.0f, 0.0f, 0.2f));
  const vec4 other = result();
  EXPECT_LT(std::abs(std::max(one.w, other.w)), 1e-6) << "one of the two turns away";
  EXPECT_LT(std::min(one.w, other.w), -0.1);
}

TEST_F(LookShaderGlTest, AtTheEyeAFootprintIsMoreThanNothing) {
  useFunctions({"common.glsl", "surface.glsl"},
               "Point p = pointAt(ivec2(0), vec4(0)); result.x = p.footprint;");
  setPoint(vec3(0, 0, -1));
  set("uOrthographic", 0);
  EXPECT_GT(result().x, 0.0f);
}

TEST_F(LookShaderGlTest, AHighlightBesideTheSurfaceIsNone) {
  useFunctions(
      {"common.glsl", "surface.glsl", "lighting.glsl"},
      kPlainPoint + "p.normal = given(0).xyz; p.ray = given(1).xyz; result.x = highlight(p, given(2).xyz);",
      "#define SHADING 1\n#define SHADING_TONE 2\n#define SHADING_GI 3\n#define SHADING_UNLIT 4\n"
      "#define SHADING_BLINN_PHONG 5\n");
  set("uShininess", 40.0f);
  setInput(0, {{1, 0, 0, 0}, {0, 0, -1, 0}});
  setInput(1, {{0.1f, 0, 0.995f, 0}, {0, 0, 1, 0}});       // turned away by a rounding, and more
  setInput(2, {{0.01f, 0, -0.99995f, 0}, {0, 0, -1, 0}});  // toward the light
  const ShaderRow highlights = results(2);
  EXPECT_EQ(highlights[0].x, 0.0f);
  EXPECT_EQ(highlights[1].x, 1.0f);
}

TEST_F(LookShaderGlTest, ACheckerOfNoFootprintIsSharp) {
  useFunctions(
      {"solid_texture.glsl"}, "result.xyz = textured(vec3(1.0), given(0).xyz, given(0).w);",
      "#define TEXTURE 3\n#define TEXTURE_MARBLE 1\n#define TEXTURE_WOOD 2\n#define TEXTURE_CHECKER 3\n");
  setInput(0, {{0.5f, 0.5f, 0.5f, 0}, {1.5f, 0.5f, 0.5f, 0}, {0.5f, 0.5f, 0.5f, 0.01f}});
  const ShaderRow colours = results(3);
  EXPECT_NEAR(std::abs(colours[0].x - colours[1].x), 0.78, 1e-3);
  EXPECT_NEAR(colours[0].x, colours[2].x, 1e-3);
}

TEST_F(LookShaderGlTest, ARangeOfNoWidthIsTheMiddle) {
  useFunctions({"color_row.glsl", "measures.glsl"}, "result.x = inRange(given(0).x);");
  set("uRange", glm::vec2(2.0f));
  setInput(0, {{1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}});
  for (const vec4& at : results(3)) EXPECT_EQ(at.x, 0.5f);
}

TEST_F(LookShaderGlTest, APointWithoutAnEdgeIsGrey) {
  useFunctions({"color_row.glsl", "measures.glsl"}, "result.xyz = edgeColor(ivec2(int(gl_FragCoord.x), 0));",
               "#define EDGE\n");
  set("uRange", glm::vec2(-1.0f, 1.0f));
  setRow("uEdge", {{1e30f, 0, 0, 0}, {0, 0, 0, 0}});
  setRow("uColorMap", {{0, 0, 1, 1}, {1, 0, 0, 1}});
  const ShaderRow colours = results(2);
  EXPECT_EQ(vec3(colours[0]), vec3(0.30f));
  EXPECT_EQ(vec3(colours[1]), vec3(0.5f, 0.0f, 0.5f));
}

class SecondShaderGlTest : public LookShaderGlTest {
 protected:
  void SetUp() override {
    LookShaderGlTest::SetUp();
    useFunctions({"common.glsl", "surface.glsl", "color_row.glsl", "second_volume.glsl"},
                 kPlainPoint + "result.xyz = withSecond(vec3(1.0), p, ivec2(int(gl_FragCoord.x), 0));");
    setPlainView(1);
    set("uSecondStrength", 1.0f);
    setRow("uSecondColors", {{0, 0, 0, 1}, {1, 0, 0, 1}});
  }
};

TEST_F(SecondShaderGlTest, WithoutAValueTheSurfaceKeepsItsColour) {
  set("uSecondRange", glm::vec2(0.0f, 1.0f));
  setRow("uSecond", {{kHuge, 0, 0, 0}, {0.25f, 0, 0, 0}});
  const ShaderRow colours = results(2);
  EXPECT_EQ(vec3(colours[0]), vec3(1.0f));
  EXPECT_EQ(vec3(colours[1]), vec3(0.25f, 0, 0));
}
TEST_F(SecondShaderGlTest, ARangeOfNoWidthIsTheMiddle) {
  set("uSecondRange", glm::vec2(2.0f));
  setRow("uSecond", {{2, 0, 0, 0}, {7, 0, 0, 0}});
  for (const vec4& colour : results(2)) EXPECT_EQ(vec3(colour), vec3(0.5f, 0, 0));
}
// A plateau between two isolines has none, one at an isoline is one.
TEST_F(SecondShaderGlTest, IsolinesOfAPlateau) {
  set("uSecondRange", glm::vec2(0.0f, 4.0f));
  set("uIsolines", 1.0f);
  set("uIsolineWidth", 1.5f);
  setRow("uSecond", {{2.5f, 0, 0, 0}, {2, 0, 0, 0}});
  const ShaderRow colours = results(2);
  EXPECT_NEAR(colours[0].x, 0.625, 1e-6);
  EXPECT_NEAR(colours[1].x, 0.5 * 0.15, 1e-6);
}

TEST_F(LookShaderGlTest, AHollowOfAFlatPointIsNone) {
  useFunctions({"shade.frag.glsl"}, "result.x = hollowness(given(0), 1.0);",
               "#define ACCESSIBILITY\n#define LOOK 0\n#define LOOK_CURVATURE_DIRECTION 9\n#define "
               "LOOK_DEPTH 1\n#define LOOK_NORMAL 2\n#define "
               "LOOK_ACCESSIBILITY 0\n"
               "#define SHADING 1\n#define SHADING_TONE 2\n#define SHADING_GI 3\n#define SHADING_UNLIT 1\n"
               "#define TEXTURE 0\n#define TEXTURE_NONE 0\n");
  set("uHollow", 1.0f);
  setInput(0, {{0, 0, 0, 1}, {1, 1, 0, 1}, {-1, -1, 0, 1}});
  const ShaderRow hollow = results(3);
  EXPECT_EQ(hollow[0].x, 0.0f);
  EXPECT_EQ(hollow[1].x, 0.0f);
  EXPECT_NEAR(hollow[2].x, 1.0 - std::exp(-6.0 / 1.12), 1e-5);
}

TEST_F(LookShaderGlTest, ADepthInAVolumeOfNoDepthIsANumber) {
  useFunctions({"shade.frag.glsl"}, kPlainPoint + "result.x = depthFraction(p);",
               "#define LOOK 0\n#define LOOK_CURVATURE_DIRECTION 9\n#define LOOK_DEPTH 1\n#define "
               "LOOK_NORMAL 2\n#define LOOK_ACCESSIBILITY 3\n"
               "#define SHADING 1\n#define SHADING_TONE 2\n#define SHADING_GI 3\n#define SHADING_UNLIT 1\n"
               "#define TEXTURE 0\n#define TEXTURE_NONE 0\n");
  set("uDepthRange", glm::vec2(1.0f));
  EXPECT_EQ(result().x, 0.0f);
}

// Seen at a grazing angle a texture is as coarse as at a cosine of a fifth, no coarser.
TEST_F(LookShaderGlTest, ATextureAtAGrazingAngle) {
  useFunctions(
      {"shade.frag.glsl"},
      kPlainPoint +
          "p.normal = normalize(vec3(1.0, 0.0, -given(0).x)); p.footprint = given(0).y;"
          "result.xyz = baseColor(p, vec3(1.0), vec4(0.0), ivec2(0));",
      "#define LOOK 0\n#define LOOK_CURVATURE_DIRECTION 9\n#define LOOK_DEPTH 1\n#define LOOK_NORMAL "
      "2\n#define LOOK_ACCESSIBILITY 3\n"
      "#define SHADING 1\n#define SHADING_TONE 2\n#define SHADING_GI 3\n#define SHADING_UNLIT 1\n"
      "#define TEXTURE 1\n#define TEXTURE_NONE 0\n#define TEXTURE_MARBLE 1\n#define TEXTURE_WOOD 2\n");
  set("uTextureScale", 1.0f);
  const float fifth = 0.2f / std::sqrt(1.0f - 0.04f);  // the tangent whose cosine is 0.2
  setInput(0, {{fifth, 0.02f, 0, 0}, {1e-3f, 0.02f, 0, 0}, {fifth, 0.3f, 0, 0}});
  const ShaderRow colours = results(3);
  EXPECT_NEAR(colours[0].x, colours[1].x, 1e-4);
  EXPECT_GT(std::abs(colours[0].x - colours[2].x), 1e-3);
}

TEST_F(LookShaderGlTest, APictureOfNothingIsNothing) {
  useShader("resolve.frag.glsl", "#define TRANSPARENT\n");
  set("uSupersampling", 1);
  set("uPictureSize", glm::ivec2(2, 1));
  setRow("uColor", {{0, 0, 0, 0}, {0.5f, 0.5f, 0.5f, 0.5f}});
  const ShaderRow picture = outputs(2)[0];
  EXPECT_EQ(picture[0], vec4(0));
  EXPECT_NEAR(picture[1].x, 1.0, 0.01);
}

// As scene/rules/tone_curve.h has it, where the surface covers a part of the pixel; the background stays as
// it is.
TEST_F(LookShaderGlTest, TheToneCurveIsOfWhatIsShaded) {
  const auto pictureOf = [&](const char* defines) {
    useShader("resolve.frag.glsl", defines);
    set("uSupersampling", 1);
    set("uPictureSize", glm::ivec2(3, 1));
    set("uBackgroundTop", vec3(0.8f));
    set("uBackgroundBottom", vec3(0.8f));
    setRow("uColor", {{0, 0, 0, 0}, {0.9f, 0.3f, 0.1f, 0.5f}, {0.4f, 0.2f, 0.1f, 1}});
    return outputs(3)[0];
  };
  const ShaderRow plain = pictureOf("\n"), filmic = pictureOf("#define FILMIC\n");
  EXPECT_EQ(filmic[0], plain[0]);
  EXPECT_EQ(filmic[2], plain[2]) << "below the knee";
  const glm::dvec3 seen = 0.5 * scene::filmic(glm::dvec3(1.8, 0.6, 0.2)) + 0.5 * 0.8;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(filmic[1][c], base::encodeSrgb(seen[c]), 0.6 / 255.0);
}

class FlowShaderGlTest : public LookShaderGlTest {};

TEST_F(FlowShaderGlTest, ADirectionAlongTheViewHasNoneOnScreen) {
  useShader("flow_field.frag.glsl");
  setPoint(vec3(1, 0, 0));
  set("uGrain", 1.0f);
  setRow("uDirection", {{0, 0, 1, 0}});
  setRow("uKappa", {{1, 0, 1, 1}});
  const auto images = outputs(1);
  EXPECT_EQ(images[0][0].x, 0.0f);
  EXPECT_EQ(images[0][0].y, 0.0f);
  EXPECT_EQ(images[1][0].z, 0.0f) << "confidence";
}

TEST_F(FlowShaderGlTest, DepthMayDifferByTenFootprintsAtAGrazingAngle) {
  useShader("flow_field.frag.glsl");
  setPoint(vec3(1, 0, 0));
  set("uGrain", 1.0f);
  setRow("uDirection", {{0, 1, 0, 0}});
  setRow("uKappa", {{1, 0, 1, 1}});
  EXPECT_FLOAT_EQ(outputs(1)[0][0].w, 30.0f);  // three times, in rays of 1 mm
}

// No step is taken, and the ripple is 0 where the streak begins.
TEST_F(FlowShaderGlTest, AStreakOfNoWeightIsNone) {
  useShader("flow.frag.glsl");
  set("uHalfLength", 0.5f);
  set("uStep", 1.0f);
  set("uPhase", 3.14159274f);
  set("uGrain", 2.0f);
  setRow("uField", {{1, 0, 10, 3}});
  setRow("uNoise", {{1, 0.5f, 1, 0}});
  EXPECT_EQ(outputs(1)[0][0].x, 0.0f);
}

}  // namespace
}  // namespace isolux::test
