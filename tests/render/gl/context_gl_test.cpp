// Contexts without a window, and a renderer that survives their loss and whatever others do in them.
#include <algorithm>
#include <functional>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "render/gl/gl.h"
#include "render/gl/gl_objects.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

using render::ContextChoice;
using render::OffscreenContext;

render::ColorImage pictureOf(OffscreenContext& context,
                             const std::shared_ptr<const volume::PreparedVolume>& volume,
                             scene::Scene scene = {}) {
  context.makeCurrent();
  render::Renderer renderer(context.gl());
  renderer.setVolume(volume);
  render::FrameRequest request;
  request.size = {96, 80};
  request.supersampling = 2;
  renderer.render(scene::resolve(scene, volume->facts), request);
  return renderer.readColor();
}

// The contexts that work here: OSMesa is none of Mesa 25.1 and later, and EGL with a driver is on every
// machine.
std::vector<std::string> workingKinds() {
  std::vector<std::string> kinds;
  for (const render::ContextProbe& probe : render::probeContexts())
    if (probe.works) kinds.push_back(probe.kind);
  return kinds;
}

TEST(ContextGlTest, SoftwareGives45Core) {
  const auto context = OffscreenContext::create(ContextChoice::software);
  EXPECT_TRUE(context->description().software);
  EXPECT_GE(context->gl()->max3dTexture, 2048);
  EXPECT_THAT(workingKinds(), ::testing::Contains(context->description().kind));
}

TEST(ContextGlTest, OsMesaIsTakenForSoftwareWhereItIs) {
  const std::vector<std::string> kinds = workingKinds();
  if (std::find(kinds.begin(), kinds.end(), "OSMesa") != kinds.end()) {
    for (const ContextChoice choice : {ContextChoice::osmesa, ContextChoice::software})
      EXPECT_EQ(OffscreenContext::create(choice)->description().kind, "OSMesa");
  } else {
    EXPECT_THAT([] { OffscreenContext::create(ContextChoice::osmesa); },
                ::testing::ThrowsMessage<base::Error>(::testing::HasSubstr("libOSMesa")));
  }
}

TEST(ContextGlTest, EglDrawsThePictureOfTheSoftwareContext) {
  const auto volume = phantom("torus", 48);
  const auto software = OffscreenContext::create(ContextChoice::software);
  const render::ColorImage expected = pictureOf(*software, volume);
  const auto egl = OffscreenContext::create(ContextChoice::egl);
  EXPECT_THAT(egl->description().kind, ::testing::StartsWith("EGL"));
  const render::ColorImage picture = pictureOf(*egl, volume);
  ASSERT_EQ(picture.rgba.size(), expected.rgba.size());
  int worst = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i)
    worst = std::max(worst, std::abs(picture.rgba[i] - expected.rgba[i]));
  EXPECT_LE(worst, 2);
}

TEST(ContextGlTest, ProbingFindsWhatAutomaticTakes) {
  const auto probes = render::probeContexts();
  std::string chosen;
  for (const render::ContextProbe& probe : probes) {
    EXPECT_FALSE(probe.detail.empty()) << probe.kind;
    if (probe.chosen) chosen = probe.kind;
  }
  EXPECT_EQ(OffscreenContext::create(ContextChoice::automatic)->description().kind, chosen);
}

TEST(ContextGlTest, ALoaderWithoutFunctionsIsAnError) {
  try {
    render::Gl::load([](const char*) -> void* { return nullptr; });
    FAIL() << "no error";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::graphics);
  }
}

TEST(ContextGlTest, ALostContextIsReplacedByTheSamePicture) {
  const auto volume = phantom("gyroid", 32);
  auto context = OffscreenContext::create(ContextChoice::software);
  const render::ColorImage before = pictureOf(*context, volume);
  context.reset();
  context = OffscreenContext::create(ContextChoice::software);
  EXPECT_EQ(pictureOf(*context, volume).rgba, before.rgba);
}

class RendererGlTest : public RenderGlTest {
 protected:
  std::vector<std::uint8_t> draw(const scene::Scene& scene, int supersampling = 1) {
    render::FrameRequest request;
    request.size = {96, 80};
    request.supersampling = supersampling;
    report_ = renderer_->render(scene, request);
    return renderer_->readColor().rgba;
  }
  // Of the last frame, without those it did not need.
  std::vector<render::PassReport> usedPasses() const {
    std::vector<render::PassReport> used;
    for (const render::PassReport& pass : report_.passes)
      if (pass.state != render::PassState::skipped) used.push_back(pass);
    return used;
  }
};

TEST_F(RendererGlTest, KeepsNoStateBetweenFrames) {
  const auto volume = phantom("gyroid", 32);
  renderer_->setVolume(volume);
  const scene::Scene scene = scene::resolve({}, volume->facts);
  const auto expected = draw(scene);
  // What Qt or anybody may leave behind.
  const render::Gl& gl = *context_->gl();
  for (const GLenum on : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                          GL_FRAMEBUFFER_SRGB, GL_COLOR_LOGIC_OP, GL_DEPTH_CLAMP, GL_PRIMITIVE_RESTART,
                          GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE3, GL_SAMPLE_MASK})
    gl.Enable(on);
  const render::Buffer theirs(context_->gl());
  for (const GLenum buffer : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
    gl.BindBuffer(buffer, theirs.id());
  for (const GLenum swap : {GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES}) gl.PixelStorei(swap, 1);
  gl.BlendEquation(GL_MAX);
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 7);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 3);
  gl.Viewport(3, 3, 5, 5);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  renderer_->invalidate();
  EXPECT_EQ(draw(scene), expected);
}

TEST_F(RendererGlTest, CachedPassesGiveTheSamePixelsAsFreshOnes) {
  const auto volume = phantom("head", 48);
  renderer_->setVolume(volume);
  scene::Scene scene = scene::resolve({}, volume->facts);
  draw(scene);
  // A walk over settings that leave different passes cached; each picture must equal a fresh renderer's.
  const auto check = [&] {
    const auto cached = draw(scene);
    renderer_->invalidate();
    EXPECT_EQ(draw(scene), cached);
  };
  scene.surfaces.front().albedo = {0.2, 0.4, 0.9};
  check();
  scene.look.mode = scene::LookMode::depth;
  check();
  scene.surfaces.front().value = -300.0;
  check();
  scene.look.mode = scene::LookMode::lambert;
  check();
  scene.derivatives.field = scene::Field::trilinear;
  check();
  scene.hit.method = scene::HitMethod::sampled;
  check();
  *scene.camera.eye += glm::dvec3(30.0, 0.0, 10.0);
  check();
  scene.camera.projection = scene::Projection::orthographic;
  check();
  scene.isosurface.inside = scene::Inside::below;
  check();
}

TEST_F(RendererGlTest, SizesMayAlternateAndAFailedFrameLeavesNoTrace) {
  const auto volume = phantom("head", 48);
  renderer_->setVolume(volume);
  scene::Scene scene = scene::resolve({}, volume->facts);
  const auto small = draw(scene), large = draw(scene, 2);
  EXPECT_EQ(draw(scene), small);
  EXPECT_EQ(draw(scene, 2), large);
  for (const render::PassReport& pass : usedPasses())  // the active blocks do not depend on the size
    EXPECT_EQ(pass.state, pass.name == "blocks" ? render::PassState::cached : render::PassState::ran)
        << pass.name;
  scene::Scene tooMuch = scene;
  renderer_->setHostSettings({.memory = {.gpuBudgetMb = 0}, .executor = scene::Executor::gpu});
  tooMuch.derivatives.field = scene::Field::cubic_interpolating;  // needs another texture
  EXPECT_THROW(draw(tooMuch), base::Error);
  renderer_->setHostSettings({});
  EXPECT_EQ(draw(scene, 2), large);
  EXPECT_EQ(draw(scene), small);
}

TEST_F(RendererGlTest, EverySettingOfThePictureChangesIt) {
  const auto volume = phantom("head", 48);
  renderer_->setVolume(volume);
  scene::Scene start = scene::resolve({}, volume->facts);
  start.derivatives.scale = start.derivatives.normalScale = 0.0;  // smoothed fields are alike
  const auto before = draw(start);
  const auto changes = [&](const std::function<void(scene::Scene&)>& edit, bool lambert = false) {
    scene::Scene scene = start;
    if (lambert) scene.look.mode = scene::LookMode::lambert;
    edit(scene);
    return draw(scene) != before;
  };
  EXPECT_TRUE(changes([](scene::Scene& s) { s.surfaces.front().value = 0.0; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.surfaces.front().albedo = {0.1, 0.2, 0.3}; }));
  EXPECT_TRUE(changes([](scene::Scene& s) {
    s.hit.method = scene::HitMethod::sampled;
    s.hit.rate = 0.3;
  }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.derivatives.field = scene::Field::trilinear; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.derivatives.field = scene::Field::cubic_interpolating; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.mode = scene::LookMode::normal; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.ambient = 0.9; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.specular = 1.0; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.shininess = 3.0; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.backgroundTop = {1.0, 0.0, 0.0}; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.look.backgroundBottom = {1.0, 0.0, 0.0}; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.light.direction = {1.0, 0.0, 0.0}; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.light.intensity = 0.1; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.camera.fov = 10.0; }));
  EXPECT_TRUE(changes([](scene::Scene& s) { s.camera.projection = scene::Projection::orthographic; }));
  EXPECT_NE(draw(start, 2), before);
  // Inside below turns the outward normal round; the two-sided looks stay, the normal map does not.
  scene::Scene normals = start, turned = start;
  normals.look.mode = turned.look.mode = scene::LookMode::normal;
  turned.isosurface.inside = scene::Inside::below;
  EXPECT_NE(draw(normals), draw(turned));
  // Refinements act on sampled hits.
  scene::Scene coarse = start, fine = start;
  coarse.hit.method = fine.hit.method = scene::HitMethod::sampled;
  coarse.hit.refinements = 0;
  fine.hit.refinements = 8;
  coarse.hit.rate = fine.hit.rate = 1.0;
  EXPECT_NE(draw(coarse), draw(fine));
}

TEST_F(RendererGlTest, ReportsWhatItDid) {
  const auto volume = phantom("ball", 48);
  renderer_->setHostSettings({.executor = scene::Executor::gpu});
  renderer_->setVolume(volume);
  const scene::Scene scene = scene::resolve({}, volume->facts);
  draw(scene);
  EXPECT_EQ(report_.blocksTotal, 216u);
  EXPECT_GT(report_.blocksActive, 20u);
  EXPECT_LT(report_.blocksActive, 216u);
  EXPECT_GE(report_.gpuBytes, 48u * 48u * 48u * 4u);
  EXPECT_EQ(usedPasses().size(), 9u);  // exact hits need no refinement
  for (const render::PassReport& pass : usedPasses()) {
    EXPECT_EQ(pass.state, render::PassState::ran) << pass.name;
    EXPECT_GT(pass.bytes, 0u) << pass.name;
  }
  draw(scene);
  for (const render::PassReport& pass : usedPasses())
    EXPECT_EQ(pass.state, render::PassState::cached) << pass.name;
}

// Nothing of the volume is uploaded, no faces are rasterised, and the report says where passes ran.
TEST_F(RendererGlTest, TheProcessorNeedsNoTextureOfTheVolume) {
  const auto volume = phantom("ball", 48);
  renderer_->setHostSettings({.executor = scene::Executor::cpu});
  renderer_->setVolume(volume);
  const scene::Scene scene = scene::resolve(pinned({}), volume->facts);
  draw(scene);
  EXPECT_LT(report_.gpuBytes, 48u * 48u * 48u * 4u);
  std::vector<std::string> processor;
  for (const render::PassReport& pass : usedPasses()) {
    EXPECT_EQ(pass.state, render::PassState::ran) << pass.name;
    if (pass.onProcessor) processor.push_back(pass.name);
  }
  EXPECT_EQ(processor, (std::vector<std::string>{"cast", "gradient"}));
  // Nor for the cubic fields and their shadows.
  scene::Scene shadowed = scene;
  shadowed.look.shadow = 1.0;
  for (const auto field : {scene::Field::cubic, scene::Field::cubic_interpolating}) {
    shadowed.hit.field = shadowed.derivatives.field = field;
    draw(shadowed);
    EXPECT_LT(report_.gpuBytes, 48u * 48u * 48u * 4u);
    for (const render::PassReport& pass : usedPasses()) {
      const bool reads = pass.name == "cast" || pass.name == "gradient" || pass.name == "shadow";
      EXPECT_EQ(pass.onProcessor, reads) << pass.name;
    }
  }
}

// Images of a size that comes back were dropped on the way: a pass that was not needed then draws anew.
TEST_F(RendererGlTest, ImagesOfAnEarlierSizeAreNotTakenForDrawn) {
  const auto volume = phantom("ball", 32);
  renderer_->setVolume(volume);
  scene::Scene sampled = scene::resolve({}, volume->facts);
  const scene::Scene exact = sampled;
  sampled.hit.method = scene::HitMethod::sampled;
  const auto before = draw(sampled);
  draw(exact, 2);
  draw(exact);
  EXPECT_EQ(draw(sampled), before);
}

TEST_F(RendererGlTest, WithoutAVolumeThereIsTheBackground) {
  scene::Scene scene = scene::resolve({}, scene::VolumeFacts{glm::dvec3(-1.0), glm::dvec3(1.0), 0.0});
  const auto picture = draw(scene);
  EXPECT_GT(picture[1], picture[picture.size() - 3]);  // brighter at the top
}

}  // namespace
}  // namespace isolux::test
