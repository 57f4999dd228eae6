// The renderer through its life: volumes exchanged for equal ones, errors survived.
#include "scene/error.h"
#include "scene/settings.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

class RendererLifeGlTest : public RenderGlTest {
 protected:
  using Settings = std::vector<std::string>;

  render::ColorImage picture(const std::shared_ptr<const volume::PreparedVolume>& volume,
                             const Settings& settings = {}) {
    render::FrameRequest request;
    request.size = {96, 80};
    scene::Scene scene;
    for (const std::string& setting : settings) scene::applyAssignment(scene, setting);
    renderer_->setVolume(volume);
    report_ = renderer_->render(scene::resolve(scene, volume->facts), request);
    return renderer_->readColor();
  }
};

TEST_F(RendererLifeGlTest, AnEqualVolumeShowsTheSamePictureAgain) {
  for (const Settings& settings :
       {Settings{}, Settings{"memory.layout=bricks"}, Settings{"hit.field=cubic"},
        Settings{"look.mode=mean_curvature"}, Settings{"isosurface.opacity=0.5", "look.shadow=1"}}) {
    const auto first = phantom("ball", 48), second = phantom("ball", 48);
    ASSERT_NE(first, second);
    const render::ColorImage before = picture(first, settings);
    ASSERT_GT(report_.blocksActive, 0u);
    const std::size_t blocks = report_.blocksActive;
    for (const auto& volume : {second, first, first}) {
      const render::ColorImage after = picture(volume, settings);
      EXPECT_EQ(report_.blocksActive, blocks);
      EXPECT_EQ(after.rgba, before.rgba) << (settings.empty() ? "" : settings[0]);
      // Another view is drawn from the new copy, whatever of the picture was kept.
      EXPECT_NE(picture(volume, {"camera.fov=20"}).rgba, before.rgba);
      EXPECT_EQ(picture(volume, settings).rgba, before.rgba);
    }
  }
}

// Derivatives are read from bricks at the hits: a new cache has none of them.
TEST_F(RendererLifeGlTest, AnEqualVolumeInBricksHasItsDerivativesToo) {
  const auto first = phantom("ball", 48), second = phantom("ball", 48);
  const Settings lambert = {"memory.layout=bricks", "look.mode=lambert"};
  const Settings curvature = {"memory.layout=bricks", "look.mode=curvature_2d"};
  const render::ColorImage expected = picture(first, curvature);
  renderer_ = std::make_unique<render::Renderer>(context_->gl());
  picture(first, lambert);
  EXPECT_EQ(picture(second, curvature).rgba, expected.rgba);
}

}  // namespace
}  // namespace isolux::test
