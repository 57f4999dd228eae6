// A dozen pictures that were looked at once, and are compared ever since: what no formula says of a look as a
// whole. tests/README.md says how a picture that is meant to change is written anew.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/files/image_io.h"
#include "app/light/light_controller.h"
#include "render/still_picture.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/picture_difference.h"
#include "tests/support/paths.h"
#include "tests/support/picture_flip.h"
#include "tests/support/png_reader.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

using Settings = std::vector<std::string>;

struct Case {
  const char* name;
  const char* phantom;
  int voxels;
  Settings settings;
  const char* smallChange;  // of one setting, which must be told from rounding
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

const Case kCases[] = {
    {"blinn_phong",
     "head",
     96,
     {"look.mode=blinn_phong", "look.ambient_variation=0.5", "look.background_top=0.1,0.12,0.15",
      "camera.eye=90,-480,50"},
     "look.specular=0.23"},
    {"lambert",
     "gyroid",
     48,
     {"look.mode=lambert", "hit.field=cubic", "camera.eye=40,-120,50"},
     "look.ambient=0.122"},
    {"tone",
     "marschner_lobb",
     48,
     {"look.mode=tone", "camera.eye=50,-75,110"},
     "look.tone_warm=0.95,0.72,0.4"},
    {"mean_curvature",
     "torus",
     48,
     {"look.mode=mean_curvature", "isosurface.value=0", "camera.eye=25,-70,55"},
     "look.range_high=0.11"},
    {"curvature_2d",
     "head",
     96,
     {"look.mode=curvature_2d", "light.headlight=0.3", "camera.eye=90,-480,50"},
     "derivatives.field=cubic_interpolating"},
    {"flow", "saddle", 48, {"look.mode=flow", "flow.length=30", "camera.eye=50,-75,90"}, "flow.length=31"},
    {"gi",
     "head",
     64,
     {"look.mode=gi", "isosurface.value=300", "gi.samples=16", "lamp1.shown=1", "lamp1.kind=sphere",
      "camera.eye=90,-480,50"},
     "gi.bounces=2"},
    {"transparent",
     "head",
     96,
     {"look.mode=blinn_phong", "isosurface.value=-300", "isosurface.opacity=0.45", "isosurface2.shown=1",
      "isosurface2.value=400", "isosurface2.opacity=0.8", "camera.eye=90,-480,50"},
     "isosurface.opacity=0.455"},
    {"lines",
     "head",
     96,
     {"look.mode=lambert", "look.ridges=0.8", "look.contours=1", "look.suggestive_contours=1",
      "look.background_top=1,1,1", "look.background_bottom=1,1,1", "camera.eye=90,-480,50"},
     "look.contour_width=2.1"},
    {"shadow",
     "head",
     96,
     {"look.mode=lambert", "look.shadow=0.8", "light.direction=-1,1,0.4", "camera.eye=90,-480,50"},
     "look.shadow=0.77"},
    {"fog_and_texture",
     "head",
     96,
     {"look.mode=blinn_phong", "look.fog=0.9", "look.texture=marble", "isosurface.value=-300",
      "look.background_top=0.3,0.45,0.6", "look.background_bottom=0.5,0.5,0.5", "camera.eye=-300,-330,150"},
     "look.fog=0.88"},
    {"orthographic_sampled",
     "gyroid",
     48,
     {"look.mode=blinn_phong", "camera.projection=orthographic", "hit.method=sampled", "memory.layout=bricks",
      "derivatives.field=trilinear", "camera.eye=30,-120,60"},
     "hit.refinements=0"},
};

class BaselineGlTest : public RenderGlTest, public testing::WithParamInterface<Case> {
 protected:
  render::ColorImage draw(const Case& c, const Settings& changes = {}) {
    const auto volume = phantom(c.phantom, c.voxels);
    scene::Scene scene;
    scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.0);  // smaller files
    Settings settings = c.settings;
    settings.insert(settings.end(), changes.begin(), changes.end());
    scene = scene::resolve(assigned(settings, scene), volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {256, 256};
    request.supersampling = 2;
    if (scene.look.mode == scene::LookMode::gi) bakeLight(scene, volume, request);
    base::Progress progress;
    return render::drawStill(*renderer_, scene, request, progress).color;
  }

 private:
  void bakeLight(const scene::Scene& scene, const std::shared_ptr<const volume::PreparedVolume>& volume,
                 const render::FrameRequest& request) {
    app::LightController light{{}};
    light.setScene(scene, volume);
    renderer_->render(scene, request);
    light.setVisible(renderer_->hitVoxels());
    base::Progress progress;
    ASSERT_TRUE(light.finish(progress, 120.0));
    renderer_->setLight(light.light());
  }
};

// Mean FLIP. A processor of another kind left 0.00025 at most, the small changes below 0.0028 at least.
constexpr double kFlipOfRounding = 0.002;

fs::path fileOf(const Case& c) {
  return fs::path(ISOLUX_SOURCE_DIR) / "tests" / "render" / "baselines" / (std::string(c.name) + ".png");
}

// What somebody who looks into it needs to see.
fs::path saveFailure(const Case& c, const render::ColorImage& picture, const render::ColorImage& baseline) {
  const fs::path folder = fs::path(ISOLUX_BINARY_DIR) / "baseline_failures";
  fs::create_directories(folder);
  const auto save = [&](const char* what, const render::ColorImage& image) {
    app::writePng(image, folder / (std::string(c.name) + '_' + what + ".png"), "");
  };
  save("picture", picture);
  save("baseline", baseline);
  save("difference", amplifiedDifference(picture, baseline));
  return folder;
}

TEST_P(BaselineGlTest, ThePictureIsItsBaseline) {
  const Case& c = GetParam();
  const render::ColorImage picture = draw(c);
  if (std::getenv("ISOLUX_UPDATE_BASELINES") != nullptr) {
    app::writePng(picture, fileOf(c), "");
    GTEST_SKIP() << "written, not compared: " << fileOf(c).string();
  }
  const render::ColorImage baseline = test::readPng(fileOf(c));
  ASSERT_EQ(picture.size, baseline.size);
  const PictureDifference difference = differenceOf(picture, baseline);
  RecordProperty("mean", std::to_string(difference.mean));
  RecordProperty("visible", std::to_string(difference.visible));
  const double flip = flipOf(baseline, picture);
  RecordProperty("flip", std::to_string(flip));
  EXPECT_LE(flip, kFlipOfRounding) << c.name << " looks different; see the difference that is saved";
  if (mayBeRounding(difference) && flip <= kFlipOfRounding) return;
  ADD_FAILURE() << c.name << " differs by " << difference.mean << " steps of 255 in the mean, "
                << 100.0 * difference.visible << " % of the pixels visibly, at most by " << difference.largest
                << "; see " << saveFailure(c, picture, baseline).string() << '/' << c.name
                << "_{picture,baseline,difference}.png";
}

TEST_P(BaselineGlTest, ASmallChangeIsNoRounding) {
  const Case& c = GetParam();
  const render::ColorImage picture = draw(c, {c.smallChange}), baseline = test::readPng(fileOf(c));
  const PictureDifference difference = differenceOf(picture, baseline);
  EXPECT_GT(flipOf(baseline, picture), kFlipOfRounding) << c.name << " with " << c.smallChange;
  EXPECT_FALSE(mayBeRounding(difference))
      << c.name << " with " << c.smallChange << ": " << difference.mean << " steps of 255 in the mean, "
      << 100.0 * difference.visible << " % of the pixels visibly";
}

INSTANTIATE_TEST_SUITE_P(Looks, BaselineGlTest, testing::ValuesIn(kCases),
                         [](const testing::TestParamInfo<Case>& one) { return one.param.name; });

}  // namespace
}  // namespace isolux::test
