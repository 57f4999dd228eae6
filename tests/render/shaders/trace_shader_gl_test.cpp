// The functions of trace.glsl, trace_cubic.glsl and clip.glsl on cells that rounding makes hard.
#include "tests/render/shaders/shader_fixture.h"

namespace isolux::test {
namespace {

const std::vector<std::string> kTrace = {"common.glsl", "field.glsl", "trace.glsl"};
const std::vector<std::string> kCubic = {"common.glsl", "field.glsl", "trace.glsl", "spline.glsl",
                                         "trace_cubic.glsl"};

class TraceShaderGlTest : public ShaderGlTest {
 protected:
  // All cells can hold a surface.
  void setFullMasks() {
    const render::GlPtr& gl = context_->gl();
    masks_ = render::Texture::make3D(gl, GL_RG32UI, {2, 2, 2}, false);
    const std::vector<std::uint32_t> ones(16, 0xffffffffu);
    gl->TextureSubImage3D(masks_.id(), 0, 0, 0, 0, 2, 2, 2, GL_RG_INTEGER, GL_UNSIGNED_INT, ones.data());
    gl->BindTextureUnit(12, masks_.id());
    set("uMasks", 12);
  }
  void TearDown() override {
    masks_ = {};
    ShaderGlTest::TearDown();
  }
  render::Texture masks_;
};

TEST_F(TraceShaderGlTest, ExtremaOfCubics) {
  useFunctions(kTrace, "result.xy = extremaOf(given(0));");
  setInput(0, {{0, 1, -1, 0},       // both
               {0, 1, 2, 3},        // a line: neither
               {0, 1, 1.1f, 2.1f},  // a negative discriminant
               {0, 1, 1, 0},        // a parabola: no leading coefficient
               {0, -1, -1, 0}});
  const ShaderRow extrema = results(5);
  EXPECT_NEAR(extrema[0].x, 0.5 - std::sqrt(1.0 / 12.0), 1e-6);
  EXPECT_NEAR(extrema[0].y, 0.5 + std::sqrt(1.0 / 12.0), 1e-6);
  for (const std::size_t none : {1u, 2u}) {
    EXPECT_EQ(extrema[none].x, 1.0f) << none;
    EXPECT_EQ(extrema[none].y, 1.0f) << none;
  }
  for (const std::size_t one : {3u, 4u}) {
    EXPECT_NEAR(extrema[one].x, 0.5, 1e-6) << one;
    EXPECT_EQ(extrema[one].y, 1.0f) << one;
  }
}

// A change that only the cell's end shows has its crossing before that end.
TEST_F(TraceShaderGlTest, BracketsLieWithinTheirCell) {
  useFunctions(
      kTrace,
      "vec2 bracket; result.x = float(firstChange(given(0), 0, given(1).x > 0.0, bracket)); result.yz "
      "= bracket;");
  // The last one changes behind two extrema, which lie on the side before.
  setInput(0, {{-3, -2, -1, 1}, {-1, 0, 1, 2}, {1, 0.5f, 0.2f, -0.1f}, {-1, -0.2f, -2.5f, 1}});
  setInput(1, {{0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 0}});  // inside
  const ShaderRow found = results(4);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].x, 1.0f) << i;
    EXPECT_GE(found[i].y, 0.0f) << i;
    EXPECT_EQ(found[i].z, 1.0f) << i;
  }
  EXPECT_GT(found[3].y, 0.3f);
}

// Both ends lie on one side where the crossing is the cell's very entry: the nearer to 0 is the root.
TEST_F(TraceShaderGlTest, ABracketOfOneSideEndsAtItsNearerEnd) {
  useFunctions(kTrace, "result.x = rootIn(given(0), vec2(0.0, 1.0));");
  setInput(0, {{1e-9f, 0.5f, 0.8f, 1},
               {1, 0.8f, 0.5f, 1e-9f},
               {-0.5f, -0.5f, -0.5f, -0.5f},
               {0.5f, 0.47f, 0.43f, 0.4f}});
  const ShaderRow roots = results(4);
  EXPECT_EQ(roots[0].x, 0.0f);
  EXPECT_EQ(roots[1].x, 1.0f);
  EXPECT_EQ(roots[2].x, 0.0f);
  EXPECT_EQ(roots[3].x, 1.0f);
}

// The crossing that a ray comes from lies at the next cell's entry, on either side of it by rounding.
TEST_F(TraceShaderGlTest, TheEntryBehindACrossingIsOnTheRaysSide) {
  useFunctions(
      kTrace,
      "vec2 bracket; result.x = float(firstChange(ofSurface(given(0), 0, int(given(1).x), given(1).y > 0.0), "
      "0, given(1).x > 0.0, bracket));");
  set("uIsovalueShifts", glm::vec4(0.0f));
  setInput(0, {{-1e-7f, 1, 2, 3}, {1e-7f, -1, -2, -3}, {-1e-7f, 1, 2, 3}});
  setInput(1, {{1, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});  // inside, first
  const ShaderRow found = results(3);
  EXPECT_EQ(found[0].x, 0.0f);
  EXPECT_EQ(found[1].x, 0.0f);
  EXPECT_EQ(found[2].x, 1.0f) << "a ray that comes from no crossing";
}

TEST_F(TraceShaderGlTest, TheEntryBehindACrossingIsOnTheRaysSideCubic) {
  useFunctions(kCubic, R"(
    float c[10];
    for (int i = 0; i < 10; ++i) c[i] = i == 0 ? given(0).x : given(0).y * float(i);
    float s;
    bool certain = true;
    result.x = float(firstRoot9(c, given(1).x > 0.0, given(1).y > 0.0, s, certain));)");
  setInput(0, {{-1e-7f, 1, 0, 0}, {1e-7f, -1, 0, 0}, {-1e-7f, 1, 0, 0}});
  setInput(1, {{1, 1, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}});  // inside, first
  const ShaderRow found = results(3);
  EXPECT_EQ(found[0].x, 0.0f);
  EXPECT_EQ(found[1].x, 0.0f);
  EXPECT_EQ(found[2].x, 1.0f) << "a ray that comes from no crossing";
}

TEST_F(TraceShaderGlTest, ARayBesideTheVolumeEndsAtOnce) {
  useFunctions(kTrace,
               "float t = 0.0, tEnd = 100.0; clipToDomain(pathOf(given(0).xyz, given(1).xyz), t, tEnd); "
               "result = vec4(t, tEnd, 0, 0);");
  set("uDims", glm::ivec3(8));
  setInput(0, {{-1, 3, 4, 0}, {9, 3, 4, 0}, {3, 3, -5, 0}});
  setInput(1, {{0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}});
  const ShaderRow t = results(3);
  EXPECT_GT(t[0].x, t[0].y);
  EXPECT_GT(t[1].x, t[1].y);
  EXPECT_EQ(t[2].x, 5.0f);
  EXPECT_EQ(t[2].y, 12.0f);
}

// The eye is so far away that a position on a ray is rounded to hundredths of a voxel. Before the volume,
// where there is none, the field goes on to the surface; in the volume it does not reach it.
TEST_F(TraceShaderGlTest, AStretchEndsWithItsCell) {
  useFunctions(kTrace, R"(
    Crossing crossing = trace(vec3(given(0).x, 3.5, 3.5), vec3(given(0).y, 0.0, 0.0), 0.0, 1e7, false, 0);
    result = vec4(crossing.found, crossing.t * given(0).y + given(0).x, 0, 0);)");
  set("uDims", glm::ivec3(8));
  set("uIsovalues", glm::vec4(0.0f));
  set("uIsovalueShifts", glm::vec4(0.0f));
  setVolume("uVolume", glm::ivec3(8), [](glm::ivec3 v) { return -1e-4 - v.x; });
  setFullMasks();
  ShaderRow rays;
  for (int i = 0; i < 64; ++i)
    rays.emplace_back(-1e5f - 37.3f * static_cast<float>(i), 0.3f + 0.001f * static_cast<float>(i), 0.0f,
                      0.0f);
  setInput(0, rays);
  const ShaderRow hits = results(64);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(hits[i].x, 0.0f) << i << ": " << hits[i].y;
}

// Floats of a million are sixteenths apart; what is small about the isovalue is not.
TEST_F(TraceShaderGlTest, TheIsovalueIsTakenOffFirst) {
  useFunctions(kTrace, R"(
    Crossing crossing = trace(vec3(-1.0, 3.5, 3.5), vec3(1.0, 0.0, 0.0), 0.0, 100.0, false, 0);
    result = vec4(crossing.found, crossing.t - 1.0, 0, 0);)");
  set("uDims", glm::ivec3(8));
  set("uIsovalues", glm::vec4(1e6f + 2.3125f));
  set("uIsovalueShifts", glm::vec4(0.0f));
  setVolume("uVolume", glm::ivec3(8), [](glm::ivec3 v) { return 1e6 + v.x; });
  setFullMasks();
  EXPECT_EQ(result().x, 1.0f);
  EXPECT_NEAR(result().y, 2.3125, 1e-5);
}

TEST_F(TraceShaderGlTest, ARayAlongACutIsKeptByItsSide) {
  useFunctions({"common.glsl", "field.glsl", "trace.glsl", "clip.glsl"},
               "result.xy = keptOf(given(0).xyz, given(1).xyz).between;", "#define CLIP 1\n");
  setInput(0, {{3, 3, 1, 0}, {3, 3, 7, 0}, {3, 3, 4, 0}, {3, 3, 1, 0}});
  setInput(1, {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}});
  set("uClip[0]", glm::vec4(0, 0, 1, -4));  // z <= 4 is kept
  const ShaderRow kept = results(4);
  for (const std::size_t whole : {0u, 2u}) {
    EXPECT_EQ(kept[whole].x, -1e30f) << whole;
    EXPECT_EQ(kept[whole].y, 1e30f) << whole;
  }
  EXPECT_GT(kept[1].x, -2e30f);
  EXPECT_EQ(kept[1].y, -1e30f);
  EXPECT_EQ(kept[3].y, 3.0f);
}

// Behind voxels that are missing the side is not known: what stands there is no surface until the ray leaves
// it.
TEST_F(TraceShaderGlTest, BehindAGapThatIsSteppedOverTheSideIsUnknown) {
  useFunctions(kCubic, R"(
    Crossing crossing = traceCubic(vec3(-1.0, 3.5, 3.5), vec3(1.0, 0.0, 0.0), 0.0, 100.0, false, 0);
    result = vec4(crossing.found, crossing.t - 1.0, 0, 0);)");
  set("uDims", glm::ivec3(32, 8, 8));
  set("uIsovalues", glm::vec4(0.0f));
  set("uIsovalueShifts", glm::vec4(0.0f));
  set("uGaps", 1);
  set("uFour", 4);
  const auto texelAt = [](glm::ivec3 v) { return v.x < 6 ? -1.0 : v.x < 14 ? 1e30 : v.x < 22 ? 1.0 : -1.0; };
  setVolume("uVolume", {32, 8, 8}, texelAt);
  setVolume("uField", {32, 8, 8}, texelAt);
  const render::GlPtr& gl = context_->gl();
  masks_ = render::Texture::make3D(gl, GL_RG32UI, {8, 2, 2}, false);
  std::vector<std::uint32_t> masks(64, 0xffffffffu);
  for (std::size_t i = 0; i < 32; ++i)
    if (i % 8 >= 1 && i % 8 <= 4) masks[2 * i] = masks[2 * i + 1] = 0;  // cells 4 to 19
  gl->TextureSubImage3D(masks_.id(), 0, 0, 0, 0, 8, 2, 2, GL_RG_INTEGER, GL_UNSIGNED_INT, masks.data());
  gl->BindTextureUnit(12, masks_.id());
  set("uMasks", 12);
  const glm::vec4 hit = result();
  EXPECT_EQ(hit.x, 1.0f);
  EXPECT_NEAR(hit.y, 21.5, 0.1);
}

}  // namespace
}  // namespace isolux::test
