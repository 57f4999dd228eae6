// A legend stands in the corner that shows least of the surface, as pixels are counted, whatever casts the
// rays.
#include <algorithm>
#include <array>
#include <set>

#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

constexpr glm::ivec2 kPicture{200, 160};
constexpr int kMargin = 3;

class LegendPlaceGlTest : public ExecutorsGlTest {
 protected:
  // The corner in which the legend stands, as numbered below, and in which it should.
  struct Corners {
    std::size_t is = 4, best = 0;
  };
  Corners cornersOf(const std::shared_ptr<const volume::PreparedVolume>& volume, const scene::Scene& scene) {
    const Images seen = images(volume, scene, kPicture);
    if (!report_.legend) return {};
    const glm::ivec2 legend = report_.legend->size, far = kPicture - legend - kMargin;
    // Lower right, lower left, upper right, upper left: the order in which they are preferred.
    const std::array<glm::ivec2, 4> places{glm::ivec2(far.x, kMargin), glm::ivec2(kMargin), far,
                                           glm::ivec2(kMargin, far.y)};
    Corners corners;
    std::array<int, 4> covered{};
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (report_.legend->origin == places[k]) corners.is = k;
      for (int y = 0; y < legend.y; ++y)
        for (int x = 0; x < legend.x; ++x) {
          const int row = kPicture.y - 1 - (places[k].y + y);
          covered[k] += seen.hit.values[static_cast<std::size_t>(row * kPicture.x + places[k].x + x)] == 1.0f;
        }
      if (k > 0 && covered[k] + legend.x * legend.y / 50 < covered[corners.best]) corners.best = k;
    }
    return corners;
  }
};

TEST_P(LegendPlaceGlTest, IsTheCornerWithFewestPixelsOfTheSurface) {
  const auto volume = phantom("head", 48);
  std::set<std::size_t> seen;
  for (const char* target : {"60,0,40", "-60,0,40", "60,0,-50", "-70,0,-40", "20,0,30", "0,0,-70"}) {
    const Corners corners =
        cornersOf(volume, assigned({"look.mode=edge_offset", "isosurface.value=-300", "camera.eye=20,-330,30",
                                    std::string("camera.target=") + target, "camera.up=0,0,1"}));
    EXPECT_EQ(corners.is, corners.best) << target;
    seen.insert(corners.best);
  }
  EXPECT_GE(seen.size(), 3u) << "corners, of the views";
}

// A bar on either side of the lower right corner: nothing of the surface is there, though in strips of rows
// between the first hit and the last it is.
TEST_P(LegendPlaceGlTest, WhatSeesNothingBetweenSurfacesIsFree) {
  const auto volume = prepared(gridOfVoxels(unitGeometry({200, 8, 160}), [](glm::dvec3 p) {
    const double bars = std::max(3.0 - std::abs(p.x - 55.0), 1.0 - std::abs(p.x - 198.2));
    return std::min(bars, 105.0 - p.z);
  }));
  // A voxel in each pixel.
  const Corners corners = cornersOf(
      volume, assigned({"look.mode=mean_curvature", "isosurface.value=0", "camera.projection=orthographic",
                        "camera.fov=30", "camera.eye=99.5,-295.06,79.5", "camera.target=99.5,3.5,79.5",
                        "camera.up=0,0,1"}));
  EXPECT_EQ(corners.best, 0u);
  EXPECT_EQ(corners.is, corners.best);
}

ISOLUX_ON_BOTH_EXECUTORS(LegendPlaceGlTest);

}  // namespace
}  // namespace isolux::test
