// Automatic views leave room for what is drawn over the picture.
#include "app/overlay_text/free_rooms.h"

#include <algorithm>

#include "app/overlay_text/annotation.h"
#include "app/ready/ready_fields.h"
#include "app/series/camera_request.h"
#include "scene/named_camera.h"
#include "tests/render/gl_fixture.h"
#include "volume/prepared/surface_outline.h"

namespace isolux::app {
namespace {

constexpr glm::ivec2 kSizes[] = {{360, 240}, {240, 360}, {300, 300}};

class FreeRoomsGlTest : public test::RenderGlTest {
 protected:
  struct Drawn {
    scene::Scene scene;
    render::FrameReport report;
    render::ColorImage colors;
    std::vector<float> hit;  // row 0 at the top
  };
  Drawn draw(scene::Scene scene, glm::ivec2 size, const CameraRequest& asked = {}) {
    scene.camera = requestedCamera(asked, scene, *volume_, size, progress_);
    Drawn drawn;
    drawn.scene = scene::resolve(scene, volume_->facts);
    completeFields(drawn.scene, *volume_, false, progress_);
    renderer_->setVolume(volume_);
    render::FrameRequest request;
    request.size = size;
    drawn.report = renderer_->render(drawn.scene, request);
    drawn.colors = renderer_->readColor();
    request.color = false;
    request.aovs = {render::Aov::hit};
    renderer_->render(drawn.scene, request);
    drawn.hit = renderer_->readAov(render::Aov::hit).values;
    return drawn;
  }
  // Across and up, of the surface that is seen.
  static glm::dvec2 extentOf(const Drawn& drawn) {
    glm::ivec2 low = drawn.colors.size, high(-1);
    for (int y = 0; y < drawn.colors.size.y; ++y)
      for (int x = 0; x < drawn.colors.size.x; ++x)
        if (isHit(drawn, {x, y})) {
          low = glm::min(low, glm::ivec2(x, y));
          high = glm::max(high, glm::ivec2(x, y));
        }
    return glm::dvec2(high - low + 1);
  }
  static bool isHit(const Drawn& drawn, glm::ivec2 p) {
    return drawn.hit[static_cast<std::size_t>(p.y * drawn.colors.size.x + p.x)] > 0.0F;
  }

  base::Progress progress_;
  std::shared_ptr<const volume::PreparedVolume> volume_ = test::phantom("head", 32);
};

TEST_F(FreeRoomsGlTest, NothingOfTheSurfaceIsUnderTheLegend) {
  for (const glm::ivec2& size : kSizes)
    for (const char* const look : {"kappa1", "gaussian_curvature", "curvature_2d"})
      for (const char* const corner : {"auto", "lower_left", "upper_right"})
        for (const bool fit : {false, true}) {
          SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y) + " " + look + " " + corner);
          scene::Scene scene;
          scene::applyAssignment(scene, std::string("look.mode=") + look);
          scene::applyAssignment(scene, std::string("look.legend_corner=") + corner);
          CameraRequest asked;
          if (fit) asked.fit = Framing::surface;
          const Drawn drawn = draw(scene, size, asked);
          ASSERT_TRUE(drawn.report.legend);
          const render::Tile legend = *drawn.report.legend;
          int covered = 0;
          for (int y = legend.origin.y; y < legend.origin.y + legend.size.y; ++y)
            for (int x = legend.origin.x; x < legend.origin.x + legend.size.x; ++x)
              covered += isHit(drawn, {x, size.y - 1 - y});
          EXPECT_EQ(covered, 0);
          const glm::dvec2 part = extentOf(drawn) / glm::dvec2(size - legend.size);
          EXPECT_GT(std::max(part.x, part.y), 0.6) << "what is free is filled";
        }
}

TEST_F(FreeRoomsGlTest, NothingOfTheSurfaceIsUnderLettersAndTexts) {
  for (const glm::ivec2& size : kSizes)
    for (const char* const look : {"lambert", "mean_curvature"})
      for (const bool texts : {false, true}) {
        SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y) + " " + look);
        scene::Scene scene;
        scene::applyAssignment(scene, std::string("look.mode=") + look);
        scene.picture.letters = true;
        scene.picture.scaleBar = scene.picture.isovalue = texts;
        const Drawn drawn = draw(scene, size);
        render::ColorImage written = drawn.colors;
        annotate(drawn.scene, *volume_, drawn.report, written);
        int changed = 0, covered = 0;
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x) {
            const auto at = 4 * static_cast<std::size_t>(y * size.x + x);
            const bool differs =
                !std::equal(&written.rgba[at], &written.rgba[at + 4], &drawn.colors.rgba[at]);
            changed += differs;
            covered += differs && isHit(drawn, {x, y});
          }
        EXPECT_GT(changed, 200);
        EXPECT_EQ(covered, 0);
      }
}

TEST_F(FreeRoomsGlTest, WithoutLegendAndLettersTheWholePictureIsFilled) {
  for (const glm::ivec2& size : kSizes) {
    scene::Scene scene;
    const double aspect = static_cast<double>(size.x) / size.y;
    const scene::Scene resolved = scene::resolve(scene, volume_->facts);
    EXPECT_EQ(freeRooms(resolved, *volume_, size), scene::wholePicture(aspect));
    const auto outline = volume::surfaceOutline(*volume_, resolved, false, progress_).pointsMm;
    const scene::Camera whole = scene::framing(scene::rolled(scene::turned(resolved.camera, 0.0, 0.0), 0.0),
                                               scene::wholePicture(aspect), outline);
    EXPECT_EQ(requestedCamera({}, scene, *volume_, size, progress_), whole);
    scene.look.mode = scene::LookMode::kappa1;
    EXPECT_NE(requestedCamera({}, scene, *volume_, size, progress_), whole);
    scene.look.legend = false;
    EXPECT_EQ(requestedCamera({}, scene, *volume_, size, progress_), whole);
    scene.look.legend = true;
    scene::Scene before = scene;
    before.camera.frames = scene::Frames::volume;
    const scene::Camera box = requestedCamera({}, before, *volume_, size, progress_);
    before.look.legend = false;
    EXPECT_EQ(requestedCamera({}, before, *volume_, size, progress_), box)
        << "sessions of before keep their view";
    scene.camera = whole;
    EXPECT_EQ(requestedCamera({}, scene, *volume_, size, progress_), whole)
        << "a camera that was given stays";
  }
}

// A turntable turns about the middle of the picture.
TEST_F(FreeRoomsGlTest, AllViewsOfATurntableAreClearOfTheLegend) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::kappa1;
  const glm::ivec2 size(360, 240);
  const scene::Camera start =
      turntableStart({}, true, scene::resolve(scene, volume_->facts), *volume_, size, progress_);
  for (int view = 0; view < 4; ++view) {
    scene.camera = turntableCamera(start, volume_->facts.axes, view, 4);
    const Drawn drawn = draw(scene, size);
    ASSERT_TRUE(drawn.report.legend);
    const render::Tile legend = *drawn.report.legend;
    int covered = 0;
    for (int y = legend.origin.y; y < legend.origin.y + legend.size.y; ++y)
      for (int x = legend.origin.x; x < legend.origin.x + legend.size.x; ++x)
        covered += isHit(drawn, {x, size.y - 1 - y});
    EXPECT_EQ(covered, 0) << view;
  }
}

}  // namespace
}  // namespace isolux::app
