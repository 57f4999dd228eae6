// Linked programs of a real driver that come from files.
#include <algorithm>
#include <filesystem>

#include "base/destroy_in_background.h"
#include "render/gl/gl.h"
#include "render/gl/program_cache.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

class ProgramCacheGlTest : public RenderGlTest {
 protected:
  void SetUp() override {
    RenderGlTest::SetUp();
    if (context_->gl()->programFormats < 1) GTEST_SKIP() << "the driver has no formats of programs";
  }
  // A renderer as of a new start, and its picture.
  std::vector<std::uint8_t> start() {
    const auto gl = std::make_shared<render::Gl>(*context_->gl());
    gl->programs = std::make_shared<render::ProgramCache>(*gl, store_);
    render::Renderer renderer(gl);
    renderer.setHostSettings({.executor = scene::Executor::gpu});
    renderer.setVolume(volume_);
    render::FrameRequest request;
    request.size = {96, 80};
    scene::Scene scene = pinned({});
    scene::applyAssignment(scene, "look.mode=curvature_2d");
    report_ = renderer.render(scene::resolve(scene, volume_->facts), request);
    EXPECT_TRUE(base::awaitDestroyed(10.0));
    return renderer.readColor().rgba;
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("head", 32);
  render::ProgramStore store_{.folder = temporaryFolder() / "programs", .version = "test", .software = true};
};

TEST_F(ProgramCacheGlTest, ASecondStartCompilesNothingAndDrawsTheSame) {
  const auto expected = start();
  const std::size_t programs = report_.programs.compiled;
  EXPECT_GT(programs, 5u);
  EXPECT_EQ(report_.programs.cached, 0u);
  EXPECT_EQ(start(), expected);
  EXPECT_EQ(report_.programs.compiled, 0u);
  EXPECT_EQ(report_.programs.cached, programs);
}

// A file that is whole, of this driver and text, but whose binary is none: the driver says so.
TEST_F(ProgramCacheGlTest, ABinaryThatTheDriverRejectsIsNoError) {
  const auto expected = start();
  const std::size_t programs = report_.programs.compiled;
  const auto gl = std::make_shared<render::Gl>(*context_->gl());
  gl->GetProgramBinary = [](GLuint, GLsizei most, GLsizei* length, GLenum* format, void* data) {
    *length = most;
    context_->gl()->GetIntegerv(GL_PROGRAM_BINARY_FORMATS, reinterpret_cast<GLint*>(format));
    std::fill_n(static_cast<char*>(data), most, 'x');
  };
  fs::remove_all(store_.folder);
  gl->programs = std::make_shared<render::ProgramCache>(*gl, store_);
  {
    render::Renderer renderer(gl);
    renderer.setHostSettings({.executor = scene::Executor::gpu});
    renderer.setVolume(volume_);
    scene::Scene scene = pinned({});
    scene::applyAssignment(scene, "look.mode=curvature_2d");
    render::FrameRequest request;
    request.size = {96, 80};
    renderer.render(scene::resolve(scene, volume_->facts), request);
  }
  ASSERT_TRUE(base::awaitDestroyed(10.0));
  EXPECT_EQ(render::storedPrograms(store_.folder).count, programs);
  EXPECT_EQ(start(), expected);
  EXPECT_EQ(report_.programs.compiled, programs);
  EXPECT_TRUE(report_.glErrors.empty());
  EXPECT_EQ(start(), expected);
  EXPECT_EQ(report_.programs.cached, programs);
}

}  // namespace
}  // namespace isolux::test
