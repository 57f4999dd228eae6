// field.glsl, spline.glsl, quintic.glsl and refine.frag.glsl on values like 1e6 + small, and beside missing
// ones.
#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

constexpr float kMissing = 1e30f;
constexpr double kSlope = 0.0625;  // a rounding of 1e6

class FieldShaderGlTest : public ShaderGlTest {
 protected:
  void useDerivatives(const std::string& call) {
    useFunctions({"common.glsl", "field.glsl", "spline.glsl", "quintic.glsl"},
                 "vec3 g = vec3(0.0), d, m; bool known = true; vec3 p = given(0).xyz;\n" + call +
                     "\nresult = vec4(g, known);",
                 "#define HESSIAN\n");
    set("uDims", glm::ivec3(8));
    set("uFour", 4);
    set("uSix", 6);
    setInput(0, {{3.3f, 3.4f, 3.6f, 0}});
  }
  template <class F>
  void setBoth(const F& texelAt) {
    setVolume("uVolume", glm::ivec3(8), texelAt);
    setVolume("uField", glm::ivec3(8), texelAt);
  }
  void expectTheSlope() {
    setBoth([](glm::ivec3 v) { return 1e6 + kSlope * (v.x + 3 * v.z); });
    const glm::vec4 derivatives = result();
    EXPECT_NEAR(derivatives.x, kSlope, 1e-3 * kSlope);
    EXPECT_NEAR(derivatives.y, 0.0, 1e-3 * kSlope);
    EXPECT_NEAR(derivatives.z, 3.0 * kSlope, 1e-3 * kSlope);
  }
};

TEST_F(FieldShaderGlTest, CubicDerivativesOfMillionsAndLittle) {
  useDerivatives("known = splineDerivatives(p, g, d, m);");
  expectTheSlope();
}
TEST_F(FieldShaderGlTest, QuinticDerivativesOfMillionsAndLittle) {
  useDerivatives("quinticDerivatives(p, g, d, m);");
  expectTheSlope();
}
TEST_F(FieldShaderGlTest, TrilinearGradientsOfMillionsAndLittle) {
  useDerivatives("g = trilinearGradient(p);");
  setBoth([](glm::ivec3 v) { return 1e6 + kSlope * v.x * (1 + v.z); });
  const glm::vec4 gradient = result();
  EXPECT_NEAR(gradient.x, 4.6 * kSlope, 1e-5 * kSlope);
  EXPECT_NEAR(gradient.y, 0.0, 1e-5 * kSlope);
  EXPECT_NEAR(gradient.z, 3.3 * kSlope, 1e-5 * kSlope);
}

TEST_F(FieldShaderGlTest, DerivativesBesideAMissingVoxel) {
  const auto texelAt = [](glm::ivec3 v) {
    return v == glm::ivec3(4, 3, 3) ? kMissing : static_cast<float>(v.x);
  };
  useDerivatives("known = splineDerivatives(p, g, d, m);");
  setBoth(texelAt);
  EXPECT_EQ(result().w, 0.0f);
  useDerivatives("g = trilinearGradient(p);");
  setBoth(texelAt);
  EXPECT_EQ(glm::vec3(result()), glm::vec3(0.0f));
}

class RefineShaderGlTest : public ShaderGlTest {
 protected:
  // Where the surface lies between t = 1 and 2 of a ray along z through voxels 3 and 4; t = -1: nowhere.
  float refined(float before, float behind) {
    useShader("refine.frag.glsl");
    setPlainView(1);
    set("uEyeVoxel", glm::vec3(3.5f, 3.5f, 2.0f));
    set("uDims", glm::ivec3(8));
    set("uRefinements", 8);
    set("uIsovalues", glm::vec4(0.0f));
    setVolume("uVolume", glm::ivec3(8),
              [&](glm::ivec3 v) { return v.z < 4 ? before + (3.0f - static_cast<float>(v.z)) : behind; });
    setRow("uBrackets", {{1.0f, 2.0f, 0.0f, 1.0f}});
    return outputs(1)[0][0].w;
  }
};

TEST_F(RefineShaderGlTest, FindsTheCrossing) {
  EXPECT_NEAR(refined(1.0f, -1.0f), 1.5, 1e-5);
}
// The filter of the hardware saw a crossing that is not there by its rounding.
TEST_F(RefineShaderGlTest, ABracketOfOneSideEndsAtItsNearerEnd) {
  EXPECT_EQ(refined(-1e-6f, -1e-6f), 1.0f);
  EXPECT_EQ(refined(-1.0f, -1e-6f), 2.0f);
}
TEST_F(RefineShaderGlTest, AMissingVoxelInTheBracketIsNoSurface) {
  EXPECT_EQ(refined(kMissing, kMissing), -1.0f);
}

}  // namespace
}  // namespace isolux::test
