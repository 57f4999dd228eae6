// Draws that are cut as for a graphics card give the picture of uncut ones.
#include <algorithm>
#include <stop_token>

#include "base/error.h"
#include "render/gl/gl.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

// Counts draw calls and flushes of the driver that it passes them on to.
struct CountedCalls {
  static inline PFNGLDRAWARRAYSPROC drawArrays = nullptr;
  static inline PFNGLFLUSHPROC flush = nullptr;
  static inline int draws = 0, flushes = 0;
  static inline std::stop_source* stopsAfterFlush = nullptr;

  static std::shared_ptr<render::Gl> of(const render::Gl& gl) {
    auto counted = std::make_shared<render::Gl>(gl);
    drawArrays = gl.DrawArrays;
    flush = gl.Flush;
    draws = flushes = 0;
    stopsAfterFlush = nullptr;
    counted->DrawArrays = [](GLenum mode, GLint first, GLsizei count) {
      ++draws;
      drawArrays(mode, first, count);
    };
    counted->Flush = [] {
      ++flushes;
      flush();
      if (stopsAfterFlush) stopsAfterFlush->request_stop();
    };
    return counted;
  }
};

class DrawPartsGlTest : public RenderGlTest {
 protected:
  // A table that takes this context for a graphics card's.
  static std::shared_ptr<render::Gl> card() {
    const auto gl = CountedCalls::of(*context_->gl());
    gl->software = false;
    return gl;
  }
  std::map<std::string, std::uint64_t> hashes(render::Renderer& renderer, const std::vector<std::string>& set,
                                              int frames = 1) {
    scene::HostSettings host{.executor = scene::Executor::gpu};
    scene::Scene scene = pinned({});
    for (const std::string& one : set)
      if (scene::isHostSetting(one))
        scene::applyAssignment(host, one);
      else
        scene::applyAssignment(scene, one);
    renderer.setHostSettings(host);
    renderer.setVolume(volume_);
    render::FrameRequest request;
    request.size = {320, 240};
    request.supersampling = 2;
    for (int frame = 0; frame < frames; ++frame) {
      renderer.invalidate();
      report_ = renderer.render(scene::resolve(scene, volume_->facts), request);
    }
    picture_ = renderer.readColor().rgba;
    return renderer.imageHashes();
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("head", 48);
  std::vector<std::uint8_t> picture_;
};

TEST_F(DrawPartsGlTest, PartsGiveTheSameBits) {
  const std::vector<std::vector<std::string>> looks{
      {"look.mode=lambert"},
      {"look.mode=curvature_2d", "look.shadow=1", "look.occlusion=1"},
      {"look.mode=flow"},
      {"look.mode=lambert", "isosurface.opacity=0.4", "isosurface.layers=3"},
      {"look.mode=lambert", "memory.layout=bricks", "hit.field=cubic"}};
  for (const std::vector<std::string>& set : looks) {
    SCOPED_TRACE(set[0] + set[1 % set.size()]);
    const auto whole = hashes(*renderer_, set);
    const auto wholePicture = picture_;
    render::Renderer cut(card());
    const auto first = hashes(cut, set);
    EXPECT_EQ(first, whole);
    EXPECT_EQ(picture_, wholePicture);
    const auto ran = std::count_if(report_.passes.begin(), report_.passes.end(),
                                   [](const auto& pass) { return pass.state == render::PassState::ran; });
    EXPECT_GT(CountedCalls::flushes, ran);
    EXPECT_EQ(hashes(cut, set, 3), whole);  // with parts of other sizes
    EXPECT_EQ(picture_, wholePicture);
  }
}

TEST_F(DrawPartsGlTest, AStopLeavesTheRestUndrawn) {
  render::Renderer cut(card());
  const std::vector<std::string> set{"look.mode=lambert"};
  hashes(cut, set);
  const int all = CountedCalls::flushes;
  const auto expected = picture_;
  std::stop_source stop;
  CountedCalls::flushes = 0;
  CountedCalls::stopsAfterFlush = &stop;
  render::FrameRequest request;
  request.size = {320, 240};
  request.supersampling = 2;
  request.stop = stop.get_token();
  cut.invalidate();
  EXPECT_THROW(cut.render(scene::resolve(pinned({}), volume_->facts), request), base::Error);
  EXPECT_EQ(CountedCalls::flushes, 1);
  EXPECT_GT(all, 1);
  CountedCalls::stopsAfterFlush = nullptr;
  hashes(cut, set);
  EXPECT_EQ(picture_, expected);
}

// Timers of no bits: parts are cut as for a software rasteriser, which needs none.
TEST_F(DrawPartsGlTest, WithoutTimersNothingIsMeasured) {
  const auto whole = hashes(*renderer_, {"look.mode=lambert"});
  const auto gl = card();
  gl->timestampBits = 0;
  render::Renderer cut(gl);
  EXPECT_EQ(hashes(cut, {"look.mode=lambert"}), whole);
  EXPECT_EQ(CountedCalls::flushes, 0);
}

}  // namespace
}  // namespace isolux::test
