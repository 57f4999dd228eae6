// Shaders of light: lookups without a texel, lamps at the point itself, skies that are dark, gaps that are
// narrow.
#include <cstring>

#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

using glm::vec3;
using glm::vec4;

class LocalLightShaderGlTest : public ShaderGlTest {
 protected:
  vec3 lampAt(vec3 place, float radius) {
    useFunctions({"local_light.glsl"}, "result.xyz = localLamps(given(0).xyz, vec3(0, 0, 1));",
                 "#define LAMP_COUNT 1\n");
    setInput(0, {{1, 2, 3, 0}});
    set("uLamps[0].place", vec4(place, 1.0f));
    set("uLamps[0].power", vec4(8, 8, 8, radius));
    return vec3(result());
  }
};

TEST_F(LocalLightShaderGlTest, ALampAtThePointItselfGivesNone) {
  EXPECT_EQ(lampAt(vec3(1, 2, 3), 0.0f), vec3(0));
}
TEST_F(LocalLightShaderGlTest, ALampIsNoNearerThanItsRadius) {
  EXPECT_NEAR(lampAt(vec3(1, 2, 3.25f), 2.0f).x, 2.0, 1e-5);
  EXPECT_NEAR(lampAt(vec3(1, 2, 7), 2.0f).x, 0.5, 1e-5);
}
TEST_F(LocalLightShaderGlTest, ASkyIsNeverLessThanDark) {
  useFunctions({"local_light.glsl"}, "result.xyz = localSky(given(0).xyz);", "#define LAMP_COUNT 0\n");
  set("uLocalSky[0]", vec3(0.25f));
  set("uLocalSky[2]", vec3(1.0f));
  setInput(0, {{0, 0, 1, 0}, {0, 0, -1, 0}});
  const ShaderRow sky = results(2);
  EXPECT_FLOAT_EQ(sky[0].x, 1.25f);
  EXPECT_EQ(sky[1].x, 0.0f);
}

class LatticeShaderGlTest : public ShaderGlTest {
 protected:
  // One block of the lattice. page 0: nothing is stored.
  void use(const std::string& defines, const std::string& body, std::uint32_t page, std::uint32_t state) {
    useFunctions(
        {"local_light.glsl", "light_lattice.glsl"}, body,
        "#define LAMP_COUNT 0\n#define WORDS 2\n#define LAMPS PACKED_NONE\n"
        "#define INTERPOLATION TRILINEAR\n#define CODE_WORDS 1\n#define CODE_COUNT 0\n#define CODE_FIELDS\n" +
            defines);
    const render::GlPtr& gl = context_->gl();
    std::vector<std::uint32_t> texels;
    const float one = 1.0f;
    std::uint32_t light = 0;
    std::memcpy(&light, &one, sizeof light);
    for (int i = 0; i < 512; ++i) texels.insert(texels.end(), {state, light});
    buffers_[0] = render::Buffer(gl);
    buffers_[0].setData(&page, sizeof page);
    buffers_[1] = render::Buffer(gl);
    buffers_[1].setData(texels.data(), texels.size() * sizeof texels[0]);
    views_[0] = render::BufferTexture(buffers_[0], GL_R32UI);
    views_[1] = render::BufferTexture(buffers_[1], GL_RG32UI);
    gl->BindTextureUnit(13, views_[0].id());
    gl->BindTextureUnit(14, views_[1].id());
    set("uLightPages", 13);
    set("uLightTexels", 14);
    set("uLatticeDims", glm::ivec3(8));
    set("uLatticeBlocks", glm::ivec3(1));
    set("uTexelsPerVoxel", vec3(1));
    set("uSkyScale", vec3(1));
  }
  void TearDown() override {
    for (render::BufferTexture& view : views_) view = {};
    for (render::Buffer& buffer : buffers_) buffer = {};
    ShaderGlTest::TearDown();
  }
  static constexpr std::uint32_t kLit = 0xff00007fu,
                                 kUnlit = 0xff000000u;  // baked both; a normal along x, or none
  static inline const std::string kLookUp =
      "lookUp(vec3(3.25), vec3(0, 0, 1), 0.0); result = vec4(skySum, covered.x);";
  render::Buffer buffers_[2];
  render::BufferTexture views_[2];
};

TEST_F(LatticeShaderGlTest, ALookupOfNothingIsDark) {
  use("#define SKY PACKED_SINGLE\n", kLookUp, 0, kLit);
  EXPECT_EQ(result(), vec4(0));
  use("#define SKY PACKED_SINGLE\n", kLookUp, 1, kLit);
  const vec4 lit = result();
  EXPECT_NEAR(lit.x, 1.0, 1e-6);
  EXPECT_NEAR(lit.w, 1.0, 1e-6);
}
TEST_F(LatticeShaderGlTest, WhatIsBakedAndNotLitHasNoWeight) {
  use("#define SKY PACKED_SINGLE\n", kLookUp, 1, kUnlit);
  EXPECT_EQ(result(), vec4(0));
}
TEST_F(LatticeShaderGlTest, BandsThatRingAreNeverLessThanDark) {
  use("#define SKY PACKED_CODES\n", kLookUp, 1, kLit);
  set("uTransferOffset", vec3(-0.5f, 0.5f, 0.0f));
  const vec4 light = result();
  EXPECT_EQ(light.x, 0.0f);
  EXPECT_EQ(light.y, 0.5f);
}
// Light is stored in parts of what an open sky gives; where that is dark, of a fifth of its mean.
TEST_F(LatticeShaderGlTest, PartsOfAnOpenSkyThatIsDark) {
  use("#define SKY PACKED_SINGLE\n#define PARTS_OF_OPEN_SKY\n", kLookUp, 1, kLit);
  set("uPerMeanSky", vec3(1));
  EXPECT_NEAR(result().x, 0.2, 1e-6);
  set("uLocalSky[0]", vec3(0.5f));
  EXPECT_NEAR(result().x, 0.5, 1e-6);
}

TEST_F(ShaderGlTest, TheEnvironmentStraightUpAndDown) {
  useFunctions({"environment.glsl"}, "result.xyz = environmentAt(vec2(0.5));");
  setRows(4);
  setImage("uEnvironment", {{{4, 0, 0, 1}}, {{3, 0, 0, 1}}, {{2, 0, 0, 1}}, {{1, 0, 0, 1}}});
  set("uEnvironmentScale", 1.0f);
  set("uForwardWorld", vec3(0, 0, 1));
  set("uEnvironmentFromWorld", glm::mat3(1.0001f));  // longer than 1 by more than a rounding
  EXPECT_EQ(result().x, 4.0f);
  set("uForwardWorld", vec3(0, 0, -1));
  EXPECT_EQ(result().x, 1.0f);
}

// A floor under a ceiling, a fiftieth of a voxel apart; light comes in all but along them. The way along the
// normal would end above the ceiling.
TEST_F(ShaderGlTest, LightComesIntoANarrowGap) {
  useShader("shadow.frag.glsl", "#define EXACT\n#define SURFACES 1\n");
  setPlainView(1);
  set("uDims", glm::ivec3(8));
  set("uIsovalues", vec4(0.0f));
  set("uIsovalueShifts", vec4(0.0f));
  set("uOpaqueBits", 1);
  setVolume("uVolume", glm::ivec3(8), [](glm::ivec3 v) { return v.z == 3 ? -0.01 : 1.0; });
  const render::GlPtr& gl = context_->gl();
  render::Texture masks = render::Texture::make3D(gl, GL_RG32UI, {2, 2, 2}, false);
  const std::vector<std::uint32_t> ones(16, 0xffffffffu);
  gl->TextureSubImage3D(masks.id(), 0, 0, 0, 0, 2, 2, 2, GL_RG_INTEGER, GL_UNSIGNED_INT, ones.data());
  gl->BindTextureUnit(12, masks.id());
  set("uMasks", 12);
  const float floor = 2.0f + 1.0f / 1.01f;
  setRow("uSurface", {{3.5f, 3.5f, floor, 10.0f}});
  setRow("uInfo", {{0.0f, 4.0f, 0, 0}});  // inside is behind
  setRow("uGradient", {{0, 0, -1, 1}});
  // The viewer looks down from the gap.
  set("uForwardWorld", vec3(0, 0, -1));
  set("uForwardVoxel", vec3(0, 0, -1));
  const auto lit = [&](vec3 light) {
    set("uLight", glm::normalize(light));
    return outputs(1)[0][0].x;
  };
  EXPECT_EQ(lit(vec3(1, 0, 5e-4f)), 1.0f);
  EXPECT_EQ(lit(vec3(1, 0, 0.5f)), 0.0f);
}

class EdgeShaderGlTest : public ShaderGlTest {
 protected:
  void use(const std::string& body) {
    useFunctions({"edge.frag.glsl"}, body);
    set("uDims", glm::ivec3(8));
    set("uFour", 4);
    set("uLow", vec3(1));
    set("uHigh", vec3(6));
    set("uUnit", 1.0f);
    set("uFieldPerVolume", 1.0f);
    set("uOutward", -1.0f);
    set("uVoxelFromWorld", glm::mat3(1.0f));
  }
};

TEST_F(EdgeShaderGlTest, LengthsOfAllSizes) {
  use("result.x = lengthOf(given(0).xyz);");
  setInput(0, {{3e-30f, 0, 4e-30f, 0}, {3e30f, 0, 4e30f, 0}, {0, 0, 0, 0}});
  const ShaderRow lengths = results(3);
  EXPECT_FLOAT_EQ(lengths[0].x, 5e-30f);
  EXPECT_FLOAT_EQ(lengths[1].x, 5e30f);
  EXPECT_EQ(lengths[2].x, 0.0f);
}

TEST_F(EdgeShaderGlTest, WhereNothingSlopesNothingIsKnown) {
  use("origin = vec3(3.5); Slope at = slopeAt(0.0); result = vec4(at.known, at.size, normal.x, haveNormal);");
  setVolume("uField", glm::ivec3(8), [](glm::ivec3) { return 5.0; });
  EXPECT_EQ(result(), vec4(0));
}

TEST_F(EdgeShaderGlTest, BeyondTheFieldNothingIsKnown) {
  use("origin = vec3(3.5); Slope here = slopeAt(0.0), near = slopeAt(2.0), far = slopeAt(3.0);"
      "result = vec4(here.known, near.known, far.known, direction.x);");
  setVolume("uField", glm::ivec3(8), [](glm::ivec3 v) { return -v.x; });
  EXPECT_EQ(result(), vec4(1, 1, 0, 1));
}

// Where the gradient is small against the curvature, smoothing has moved the edge by half its width at most.
TEST_F(EdgeShaderGlTest, WhatSmoothingMovesHasABound) {
  use("result.x = movedInward(vec3(0, 0, 1), given(0).x, mat3(given(0).y));");
  set("uSmoothing", glm::mat3(4.0f));
  setInput(0, {{1, -0.01f, 0, 0}, {1e-6f, -1, 0, 0}, {1e-6f, 1, 0, 0}});
  const ShaderRow moved = results(3);
  EXPECT_NEAR(moved[0].x, 0.04, 1e-6);
  EXPECT_FLOAT_EQ(moved[1].x, 1.0f);
  EXPECT_FLOAT_EQ(moved[2].x, -1.0f);
}

}  // namespace
}  // namespace isolux::test
