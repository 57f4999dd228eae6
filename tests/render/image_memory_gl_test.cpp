// Images of a frame are freed behind their last reader or within a budget, and pictures stay what they are.
#include <algorithm>
#include <cmath>

#include "render/still_picture.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

using Settings = std::vector<std::string>;

class ImageMemoryGlTest : public ExecutorsGlTest {
 protected:
  scene::Scene sceneOf(const Settings& settings) {
    const scene::Scene scene = assigned(settings);
    renderer_->setVolume(volume_);
    return scene::resolve(scene, volume_->facts);
  }
  render::FrameRequest requestOf(bool keepImages) const {
    render::FrameRequest request;
    request.size = size_;
    request.supersampling = 2;
    request.keepImages = keepImages;
    return request;
  }
  render::ColorImage draw(const scene::Scene& scene, bool keepImages) {
    report_ = renderer_->render(scene, requestOf(keepImages));
    return renderer_->readColor();
  }
  std::vector<std::string> ran() const {
    std::vector<std::string> names;
    for (const render::PassReport& pass : report_.passes)
      if (pass.state == render::PassState::ran) names.push_back(pass.name);
    return names;
  }
  // How many bytes differ by more than `steps`.
  static std::size_t differing(const render::ColorImage& a, const render::ColorImage& b, int steps = 0) {
    std::size_t count = a.rgba.size() == b.rgba.size() ? 0 : a.rgba.size();
    for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i)
      count += std::abs(a.rgba[i] - b.rgba[i]) > steps ? 1 : 0;
    return count;
  }

  const std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("torus", 48);
  glm::ivec2 size_{240, 136};
};
ISOLUX_ON_BOTH_EXECUTORS(ImageMemoryGlTest);

const Settings kHeavy = {"look.mode=kappa1", "look.ridges=1", "flow.strength=0.5"};

// Bytes of 1920 x 1080 pixels of 2 x 2 rays, scaled to the size drawn: of the processor, which software
// drivers use.
TEST_P(ImageMemoryGlTest, AStillPictureHoldsFewImages) {
  size_ = {480, 270};
  const double scale = 1920.0 * 1080.0 / (480.0 * 270.0);
  struct Case {
    Settings settings;
    double most, mostOfShaders;  // MB
  };
  for (const Case& one : {Case{kHeavy, 450.0, 800.0}, Case{{}, 200.0, 420.0}}) {
    scene::Scene scene = assigned(one.settings);
    scene.camera.frames =
        scene::Frames::surface;  // as in a picture of the program, it fills most of the width
    scene = scene::resolve(scene, volume_->facts);
    scene.camera.fov *= 0.85;
    renderer_->setVolume(volume_);
    draw(scene, false);
    const double held = 1e-6 * static_cast<double>(report_.imageBytes) * scale;
    draw(scene, true);
    std::printf("%s, %s: %.0f MB, %.0f MB if images are kept\n", GetParam(),
                one.settings.empty() ? "blinn_phong" : one.settings[0].c_str(), held,
                1e-6 * static_cast<double>(report_.imageBytes) * scale);
    EXPECT_LE(held, std::string(GetParam()) == "cpu" ? one.most : one.mostOfShaders);
    EXPECT_GE(report_.gpuBytes, report_.imageBytes);
  }
}

// Bit for bit but for walks over many pixels, whose floats count from the images' corner.
TEST_P(ImageMemoryGlTest, APictureIsTheSameWhetherImagesAreKept) {
  for (const Settings& settings :
       {Settings{}, Settings{"look.mode=depth"}, Settings{"look.mode=curvature_2d"},
        Settings{"isosurface.opacity=0.4", "look.shadow=1", "look.fog=0.5"}, Settings{"look.mode=gi"},
        Settings{"hit.method=sampled", "look.shadow=1"}, Settings{"picture.transparent=1"},
        Settings{"clip.planes=24,24,24 0,0,1"}, Settings{"look.mode=edge_offset"},
        Settings{"camera.projection=orthographic", "look.texture=marble"}, kHeavy}) {
    const scene::Scene scene = sceneOf(settings);
    const render::ColorImage kept = draw(scene, true), freed = draw(scene, false);
    const bool walks = settings == kHeavy;
    EXPECT_LE(differing(kept, freed, walks ? 2 : 0), walks ? kept.rgba.size() / 1000 : 0)
        << (settings.empty() ? "" : settings[0]);
    EXPECT_EQ(differing(kept, draw(scene, true)), 0u);  // nothing that was freed counts as there
  }
}

// Passes whose images had to go run again for those that read them, and for no others.
TEST_P(ImageMemoryGlTest, ASmallBudgetChangesNoPicture) {
  render::Renderer small(context_->gl());
  scene::HostSettings host = host_;
  host.memory.gpuBudgetMb = 8;
  small.setHostSettings(host);
  small.setVolume(volume_);
  Settings settings = kHeavy;
  std::size_t all = 0, held = 0;
  for (const char* change :
       {"look.mode=kappa1", "look.ridge_color=0,1,0", "flow.length=20", "look.mode=kappa2", "camera.fov=25",
        "look.mode=blinn_phong", "look.background_top=1,0,0", "look.mode=gaussian_curvature"}) {
    settings.emplace_back(change);
    const scene::Scene scene = sceneOf(settings);
    const render::ColorImage wanted = draw(scene, true);
    all = std::max(all, report_.imageBytes);
    report_ = small.render(scene, requestOf(true));
    held = std::max(held, report_.imageBytes);
    EXPECT_EQ(differing(wanted, small.readColor()), 0u) << change;
    report_ = small.render(scene, requestOf(true));
    EXPECT_TRUE(ran().empty()) << change << ": " << ran().front();
    EXPECT_EQ(differing(wanted, small.readColor()), 0u) << change;
  }
  std::printf("%s: %.1f MB of %.1f\n", GetParam(), 1e-6 * static_cast<double>(held),
              1e-6 * static_cast<double>(all));
  EXPECT_LT(held, all * 4 / 5);
}

// With what is kept as it was: the budget of a window suffices.
TEST_P(ImageMemoryGlTest, TheUsualBudgetKeepsWhatAWindowShows) {
  size_ = {640, 360};
  Settings settings = kHeavy;
  draw(sceneOf(settings), true);
  settings.emplace_back("look.ridge_color=0,1,0");
  draw(sceneOf(settings), true);
  EXPECT_EQ(ran(), (std::vector<std::string>{"shade", "resolve"}));
}

// Occlusion is found in a small picture of the whole, if there are tiles: without it they are cut out of the
// picture.
TEST_P(ImageMemoryGlTest, APictureBeyondTheBudgetIsDrawnInTiles) {
  size_ = {640, 480};
  base::Progress progress;
  for (Settings settings : {Settings{"light.setup=key"}, Settings{"light.setup=key", "look.mode=kappa1"}}) {
    const render::ColorImage whole = draw(sceneOf(settings), false);
    settings.emplace_back("memory.gpu_budget_mb=16");
    const scene::Scene scene = sceneOf(settings);
    EXPECT_GT(render::tilesOf(scene, requestOf(false), renderer_->imageBudget()).size(), 3u);
    const render::StillPicture still = render::drawStill(*renderer_, scene, requestOf(false), progress);
    EXPECT_EQ(differing(whole, still.color), 0u) << settings.back();
    EXPECT_LE(still.report.imageBytes, std::size_t{16} << 20);
  }
}

}  // namespace
}  // namespace isolux::test
