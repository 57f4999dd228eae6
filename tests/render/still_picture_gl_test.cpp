// Pictures in tiles are the pictures drawn in one frame; linear pictures are what the encoded ones come from;
// far cameras lose no precision; pictures without anything in them say why.
#include "base/color.h"
#include "render/still_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "render/gl/gl.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/picture_difference.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using Settings = std::vector<std::string>;

class StillPictureGlTest : public RenderGlTest {
 protected:
  scene::Scene sceneOf(const std::shared_ptr<const volume::PreparedVolume>& volume,
                       const Settings& settings) {
    const scene::Scene scene = assigned(settings);
    renderer_->setVolume(volume);
    return scene::resolve(scene, volume->facts);
  }
  static render::FrameRequest requestOf(glm::ivec2 size, int supersampling = 1) {
    render::FrameRequest request;
    request.size = size;
    request.supersampling = supersampling;
    return request;
  }
  base::Progress progress_;
};

// Pixel for pixel and bit for bit, whatever the look: rays, dither, background, fog and legend are the whole
// picture's.
TEST_F(StillPictureGlTest, ATileIsCutOutOfThePicture) {
  const auto volume = phantom("head", 48);
  const render::Tile tile{{37, 11}, {150, 61}};
  for (const Settings& settings :
       {Settings{}, Settings{"camera.projection=orthographic", "look.mode=depth"},
        Settings{"look.mode=curvature_2d", "look.legend_corner=lower_right"},
        Settings{"isosurface.opacity=0.4", "look.shadow=1", "look.fog=0.5"}, Settings{"look.mode=gi"},
        Settings{"hit.method=sampled"}, Settings{"memory.layout=bricks"}}) {
    const scene::Scene scene = sceneOf(volume, settings);
    render::FrameRequest request = requestOf({200, 120}, 2);
    renderer_->render(scene, request);
    const render::ColorImage whole = renderer_->readColor();
    request.tile = tile;
    renderer_->render(scene, request);
    const render::ColorImage part = renderer_->readColor();
    ASSERT_EQ(part.size, tile.size);
    std::size_t differing = 0;
    for (int y = 0; y < tile.size.y; ++y)
      for (int x = 0; x < tile.size.x * 4; ++x) {
        const int row = whole.size.y - tile.origin.y - tile.size.y + y;
        const auto at = [](int line, int width, int byte) {
          return static_cast<std::size_t>(line * width * 4 + byte);
        };
        if (whole.rgba[at(row, whole.size.x, tile.origin.x * 4 + x)] != part.rgba[at(y, tile.size.x, x)])
          ++differing;
      }
    EXPECT_EQ(differing, 0u) << (settings.empty() ? "" : settings[0]);
  }
}

// Wider than one frame is allowed to be, but not than the driver's images: both ways can be compared.
TEST_F(StillPictureGlTest, TilesMakeThePictureOfOneFrame) {
  const auto volume = phantom("torus", 32);
  const glm::ivec2 size{8400, 20};
  for (const Settings& settings :
       {Settings{}, Settings{"look.mode=flow"}, Settings{"look.suggestive_contours=1"},
        Settings{"look.contours=1", "look.ridges=1"}}) {
    const scene::Scene scene = sceneOf(volume, settings);
    const render::FrameRequest request = requestOf(size);
    ASSERT_GT(render::tilesOf(scene, request).size(), 4u);
    const render::StillPicture still = render::drawStill(*renderer_, scene, request, progress_);
    renderer_->render(scene, request);
    const render::ColorImage frame = renderer_->readColor();
    ASSERT_EQ(still.color.rgba.size(), frame.rgba.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < frame.rgba.size(); ++i)
      if (std::abs(frame.rgba[i] - still.color.rgba[i]) > (settings.empty() ? 0 : 2)) ++differing;
    EXPECT_LE(static_cast<double>(differing),
              settings.empty() ? 0.0 : 1e-3 * static_cast<double>(frame.rgba.size()))
        << (settings.empty() ? "" : settings[0]);
  }
}

// As large as is allowed, with supersampling: 32768 rays on an axis are more than any driver's image takes.
TEST_F(StillPictureGlTest, TheLargestPictureIsDrawn) {
  const auto volume = phantom("ball", 24);
  const scene::Scene scene = sceneOf(volume, {});
  render::FrameRequest request = requestOf({16384, 4}, 2);
  const render::StillPicture still = render::drawStill(*renderer_, scene, request, progress_);
  ASSERT_EQ(still.color.size, request.size);
  EXPECT_FALSE(still.report.empty);
  request.tile = render::Tile{{8000, 0}, {400, 4}};
  renderer_->render(scene, request);
  const render::ColorImage middle = renderer_->readColor();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 1600; ++x)
      ASSERT_EQ(still.color.rgba[static_cast<std::size_t>(y * 16384 * 4 + 32000 + x)],
                middle.rgba[static_cast<std::size_t>(y * 1600 + x)]);
  request.tile.reset();
  if (onCard()) return;                                          // whose textures may be as large
  EXPECT_THROW(renderer_->render(scene, request), base::Error);  // in one frame
}

// Twice as many pixels for the same picture: what settings state in pixels is as wide and as long as before.
TEST_F(StillPictureGlTest, OnAFineScreenLinesAndStreaksLookTheSame) {
  const auto volume = phantom("saddle", 48);
  const auto halved = [](const render::ColorImage& fine) {
    render::ColorImage result{fine.size / 2, {}};
    const auto row = static_cast<std::size_t>(4 * fine.size.x);
    for (std::size_t y = 0; y < static_cast<std::size_t>(result.size.y); ++y)
      for (std::size_t x = 0; x < row / 2; ++x) {
        const std::uint8_t* const at = &fine.rgba[2 * y * row + x / 4 * 8 + x % 4];
        result.rgba.push_back(static_cast<std::uint8_t>((at[0] + at[4] + at[row] + at[row + 4]) / 4));
      }
    return result;
  };
  for (const Settings& settings :
       {Settings{"look.mode=flow", "flow.grain=3", "camera.eye=50,-75,90"},
        Settings{"look.mode=lambert", "look.contours=1", "look.contour_width=6", "camera.eye=50,-75,90"}}) {
    const scene::Scene scene = sceneOf(volume, settings);
    const auto draw = [&](glm::ivec2 size, double pixelRatio) {
      render::FrameRequest request = requestOf(size, size.x > 200 ? 1 : 2);
      request.pixelRatio = pixelRatio;
      renderer_->render(scene, request);
      return renderer_->readColor();
    };
    const render::ColorImage coarse = draw({200, 200}, 1.0);
    const double same = differenceOf(coarse, halved(draw({400, 400}, 2.0))).mean;
    const double other = differenceOf(coarse, halved(draw({400, 400}, 1.0))).mean;
    std::printf("%s: %.3f steps on a fine screen, %.3f if pixels were pixels\n", settings[0].c_str(), same,
                other);
    EXPECT_LT(same, 0.5 * other);
  }
}

TEST_F(StillPictureGlTest, AovsOfTilesAreThoseOfOneFrame) {
  const auto volume = phantom("ball", 24);
  const scene::Scene scene = sceneOf(volume, {"camera.fov=10"});
  render::FrameRequest request = requestOf({8400, 8});
  request.color = false;
  request.aovs = {render::Aov::depth, render::Aov::normal};
  const render::StillPicture still = render::drawStill(*renderer_, scene, request, progress_);
  renderer_->render(scene, request);
  for (std::size_t i = 0; i < request.aovs.size(); ++i) {
    const render::AovImage whole = renderer_->readAov(request.aovs[i]);
    ASSERT_EQ(still.aovs[i].values.size(), whole.values.size());
    EXPECT_EQ(
        std::memcmp(still.aovs[i].values.data(), whole.values.data(), whole.values.size() * sizeof(float)),
        0);
  }
}

// The encoded picture is the linear one, clamped and encoded (IEC 61966-2-1) within a step and its dither;
// bright light is not cut off, and the legend is the encoded picture's alone.
TEST_F(StillPictureGlTest, TheLinearPictureIsWhatIsEncoded) {
  const auto volume = phantom("ball", 32);
  const auto draw = [&](const Settings& settings) {
    render::FrameRequest request = requestOf({160, 120}, 2);
    request.linear = true;
    return render::drawStill(*renderer_, sceneOf(volume, settings), request, progress_);
  };
  const render::StillPicture picture =
      draw({"look.mode=lambert", "light.intensity=0.6", "look.background_top=0.1,0.2,0.3"});
  for (std::size_t i = 0; i < picture.linear.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const double c = static_cast<double>(picture.linear.rgba[i]);
    ASSERT_LE(c, 1.0);
    const double encoded = base::encodeSrgb(c);
    ASSERT_NEAR(picture.color.rgba[i], 255.0 * encoded, 1.1) << i;
  }
  const std::vector<float> bright = draw({"look.mode=lambert", "light.intensity=4"}).linear.rgba;
  EXPECT_GT(*std::max_element(bright.begin(), bright.end()), 1.5f);
  const render::StillPicture with = draw({"look.mode=mean_curvature"});
  const render::StillPicture without = draw({"look.mode=mean_curvature", "look.legend=0"});
  EXPECT_NE(with.color.rgba, without.color.rgba);
  EXPECT_EQ(with.linear.rgba, without.linear.rgba);
}

// An eye 100 m away under 1 degree: hits and depths as near the exact ones as those of an eye close by.
TEST_F(StillPictureGlTest, AFarNarrowCameraLosesNoPrecision) {
  const auto volume = phantom("ball", volume::GridGeometry::make({48, 48, 48}, glm::dvec3(24.0)));
  for (const char* projection : {"perspective", "orthographic"}) {
    scene::Scene scene = sceneOf(volume, {std::string("camera.projection=") + projection});
    const glm::dvec3 centre = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
    scene.camera.target = centre;
    scene.camera.eye = centre + 1e5 * glm::normalize(glm::dvec3(-0.3, -1.0, 0.2));
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    scene.camera.fov = 1.0;
    const glm::ivec2 size{96, 96};
    const Images seen = images(volume, scene, size);
    double worst = 0.0, worstDepth = 0.0;
    int hits = 0, wrong = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const auto i = static_cast<std::size_t>(y * size.x + x);
        const scene::Ray line = ray({x, y}, size);
        const glm::dmat4 voxelFromWorld = volume->grid().geometry().voxelFromWorld();
        const auto exact = volume::firstHit(volume->grid(), *volume->blocks, *scene_.surfaces.front().value,
                                            {glm::dvec3(voxelFromWorld * glm::dvec4(line.origin, 1.0)),
                                             glm::dmat3(voxelFromWorld) * line.direction});
        wrong += exact.has_value() != (seen.hit.values[i] == 1.0f);
        if (!exact || seen.hit.values[i] == 0.0f) continue;
        ++hits;
        worst = std::max(worst, glm::distance(at(seen.voxel, i), exact->voxel));
        worstDepth = std::max(worstDepth, std::abs(static_cast<double>(seen.depth.values[i]) - exact->t));
      }
    std::printf("%s: %d hits, at most %.1e voxel and %.1e mm off\n", projection, hits, worst, worstDepth);
    EXPECT_GT(hits, 800);
    EXPECT_LE(wrong, 2);
    EXPECT_LT(worst, 1e-3);
    EXPECT_LT(worstDepth, 0.03);  // float32 of 1e5 mm: 0.008
  }
}

TEST_F(StillPictureGlTest, APictureWithoutAnythingSaysWhy) {
  const auto volume = phantom("ball", 24);
  const auto why = [&](const Settings& settings) {
    const render::FrameReport& report = renderer_->render(sceneOf(volume, settings), requestOf({64, 48}));
    return report.empty ? report.empty->reason : std::string();
  };
  EXPECT_EQ(why({}), "");
  EXPECT_EQ(why({"isosurface.value=7000"}).rfind("No surface at 7000: the data range is -", 0), 0u);
  EXPECT_EQ(why({"isosurface.opacity=0"}), "The isosurface is fully transparent");
  EXPECT_EQ(why({"camera.eye=0,-200,0", "camera.target=0,-300,0"}), "The camera looks away from the volume");
  EXPECT_EQ(why({"camera.eye=0,-200,0", "camera.target=150,0,0", "camera.fov=5"}),
            "The volume is outside the image");
  EXPECT_EQ(why({"camera.eye=0,-200,0", "camera.target=11,0,11", "camera.fov=1"}),
            "No surface is visible from here");
  EXPECT_EQ(why({}), "");
}

}  // namespace
}  // namespace isolux::test
