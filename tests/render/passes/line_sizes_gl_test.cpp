// The lines of one surface in pictures of several sizes and pixel ratios.
#include <algorithm>
#include <vector>

#include "base/progress.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/passes/line_points.h"
#include "tests/support/test_data.h"
#include "volume/read/reader.h"

namespace isolux::test {
namespace {

struct Lines {
  std::vector<glm::dvec3> seen, drawn;  // surface points that lines cover by half, and by a quarter, mm
};

struct Picture {
  int size;
  double pixelRatio;
};

// Every n-th, a thousand at most.
std::vector<glm::dvec3> someOf(const std::vector<glm::dvec3>& points) {
  std::vector<glm::dvec3> some;
  for (std::size_t i = 0; i < points.size(); i += points.size() / 1000 + 1) some.push_back(points[i]);
  return some;
}

class LineSizesGlTest : public RenderGlTest {
 protected:
  Lines linesOf(const std::shared_ptr<const volume::PreparedVolume>& volume,
                const std::vector<std::string>& settings, const Picture& picture) {
    base::Progress progress;
    scene::Scene black =
        assigned({"look.mode=lambert", "look.ambient=1", "isosurface.albedo=0,0,0", "look.ridge_color=1,1,1",
                  "look.valley_color=1,1,1", "look.contour_color=1,1,1"});
    // Two pixels wide in each: of wider lines the sides are not where the line is.
    black.look.ridgeWidth = black.look.contourWidth = 2.0 / picture.pixelRatio;
    scene_ = scene::resolve(assigned(settings, black), volume->facts);
    volume->derivativeChoices->complete(scene_, progress);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = glm::ivec2(picture.size);
    request.pixelRatio = picture.pixelRatio;
    request.aovs = {render::Aov::hit, render::Aov::position};
    renderer_->render(scene_, request);
    const render::LinearImage color = renderer_->readLinear();
    const render::AovImage hit = renderer_->readAov(render::Aov::hit);
    const render::AovImage position = renderer_->readAov(render::Aov::position);
    Lines lines;
    for (std::size_t i = 0; i < hit.values.size(); ++i) {
      if (hit.values[i] != 1.0f) continue;
      if (color.rgba[4 * i] >= 0.5f) lines.seen.push_back(at(position, i));
      if (color.rgba[4 * i] >= 0.25f) lines.drawn.push_back(at(position, i));
    }
    return lines;
  }

  // Lines of each picture lie within a voxel of those of each other one, but for 5 % of their length. What
  // fades may be seen in one alone.
  void expectSame(const std::shared_ptr<const volume::PreparedVolume>& volume,
                  const std::vector<std::string>& settings, const std::vector<Picture>& pictures) {
    const glm::dvec3 spacing = volume->grid().geometry().spacingMm();
    const double voxel = std::min({spacing.x, spacing.y, spacing.z});
    std::vector<Lines> lines;
    for (const Picture& picture : pictures) lines.push_back(linesOf(volume, settings, picture));
    EXPECT_GT(lines[0].seen.size(), 200u);
    for (std::size_t i = 0; i < pictures.size(); ++i)
      for (std::size_t k = 0; k < pictures.size(); ++k) {
        if (i == k) continue;
        const double share = shareNear(someOf(lines[i].seen), lines[k].drawn, voxel);
        std::printf("%d (pixel ratio %g) near %d (%g): %.1f %% of %zu\n", pictures[i].size,
                    pictures[i].pixelRatio, pictures[k].size, pictures[k].pixelRatio, 100.0 * share,
                    lines[i].seen.size());
        EXPECT_GE(share, 0.95) << pictures[i].size << " and " << pictures[k].size;
      }
  }
};

}  // namespace

TEST_F(LineSizesGlTest, RidgesAndValleysOfAHead) {
  expectSame(phantom("head", 64),
             {"isosurface.value=300", "look.ridges=1", "camera.eye=120,-620,130", "camera.target=0,0,20",
              "camera.fov=22"},
             {{400, 1.0}, {800, 1.0}, {800, 4.0}});
}

TEST_F(LineSizesGlTest, SuggestiveContoursOfAHead) {
  expectSame(phantom("head", 64),
             {"isosurface.value=300", "look.suggestive_contours=1", "camera.eye=120,-620,130",
              "camera.target=0,0,20", "camera.fov=22"},
             {{400, 1.0}, {800, 1.0}, {800, 4.0}});
}

TEST_F(LineSizesGlTest, RidgesAndValleysOfATooth) {
  ISOLUX_NEEDS_DATA();
  base::Progress progress;
  expectSame(
      prepared(*volume::readVolume((dataFolder() / "volumes" / "tooth.mhd").string(), {}, progress).grid),
      {"isosurface.value=620", "look.ridges=1", "camera.eye=240,-300,120", "camera.target=51,46,80",
       "camera.fov=24"},
      {{400, 1.0}, {800, 1.0}, {800, 4.0}});
}

}  // namespace isolux::test
