// curvature.frag.glsl on gradients and Hessians at the ends of what floats hold.
#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

class CurvatureShaderGlTest : public ShaderGlTest {
 protected:
  void SetUp() override {
    ShaderGlTest::SetUp();
    useShader("curvature.frag.glsl");
    set("uOutward", -1.0f);
    set("uFlat", 1e-6f);
  }
  // Normal along -x. The Hessian's yy, zz and yz; diagonalKnown: as the pass before says of it.
  std::vector<ShaderRow> at(float gradient, glm::vec3 hessian, float diagonalKnown = 1.0f) {
    setRow("uGradient", {{gradient, 0.0f, 0.0f, 1.0f}});
    setRow("uHessianDiagonal", {{0.0f, hessian.x, hessian.y, diagonalKnown}});
    setRow("uHessianMixed", {{0.0f, 0.0f, hessian.z, 1.0f}});
    return outputs(1);
  }
};

TEST_F(CurvatureShaderGlTest, IsTheHessianOverTheGradient) {
  const auto images = at(2.0f, {-8.0f, -2.0f, 0.0f});
  EXPECT_FLOAT_EQ(images[0][0].x, 4.0f);
  EXPECT_FLOAT_EQ(images[0][0].y, 1.0f);
  EXPECT_NEAR(std::abs(images[1][0].y), 1.0, 1e-6);
  EXPECT_EQ(images[0][0].z, 1.0f);
}

TEST_F(CurvatureShaderGlTest, AnUnknownHessianHasNone) {
  const auto images = at(2.0f, {-8.0f, -2.0f, 0.0f}, 0.0f);
  EXPECT_EQ(images[0][0], glm::vec4(0.0f));
}

// Curvatures of 1e-20 have squares that floats hold badly, or not at all.
TEST_F(CurvatureShaderGlTest, TheDirectionOfWhatIsAllButFlatIsUnit) {
  for (float curvature = 1e-18f; curvature > 1e-24f; curvature *= 0.7f) {
    const auto images = at(1.0f, {-curvature, 0.0f, 0.0f});
    EXPECT_NEAR(glm::length(glm::vec3(images[1][0])), 1.0, 1e-4) << curvature;
  }
}

TEST_F(CurvatureShaderGlTest, NoiseOverATinyGradientStaysANumber) {
  set("uHessianNoise", 1e10f);
  const auto images = at(1e-37f, {-1e-38f, -1e-38f, 0.0f});
  EXPECT_FLOAT_EQ(images[1][0].w, 60000.0f);  // over uFlat, as half floats hold it
}

TEST_F(CurvatureShaderGlTest, CurvatureBeyondAllNumbersIsNone) {
  const auto images = at(1e-5f, {-1e36f, -1e35f, 0.0f});
  EXPECT_EQ(images[0][0], glm::vec4(0.0f));
}

}  // namespace
}  // namespace isolux::test
