// The deferred image `piece`: which piece each hit is of, against balls at known places and a flood of
// voxels.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/support/flooded_pieces.h"
#include "tests/support/hidden_balls.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::test {
namespace {

using render::Aov;

constexpr glm::ivec2 kPieceSize{96, 80};

class PieceGlTest : public ExecutorsGlTest {
 protected:
  static scene::Scene view(int k, glm::dvec3 target = glm::dvec3(23.5), double distance = 90.0) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    const double azimuth = 2.4 * k, height = -0.8 + 0.4 * k;
    scene.camera.target = target;
    scene.camera.up = {0.0, 0.0, 1.0};
    scene.camera.eye = target + distance * glm::dvec3(std::cos(azimuth), std::sin(azimuth), height);
    return scene;
  }
  // Ids, and where the hits are.
  struct Seen {
    render::AovImage voxel;
    std::vector<float> ids;
  };
  Seen piecesSeen(const std::shared_ptr<const volume::PreparedVolume>& volume, const scene::Scene& scene) {
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = kPieceSize;
    request.color = false;
    request.aovs = {Aov::hit, Aov::voxel, Aov::piece};
    renderer_->render(scene::resolve(scene, volume->facts), request);
    const std::vector<float> hit = renderer_->readAov(Aov::hit).values;
    Seen seen{renderer_->readAov(Aov::voxel), renderer_->readAov(Aov::piece).values};
    for (std::size_t i = 0; i < hit.size(); ++i) EXPECT_EQ(hit[i] == 1.0f, !std::isnan(seen.ids[i])) << i;
    return seen;
  }
};
ISOLUX_ON_BOTH_EXECUTORS(PieceGlTest);

// Ids are the order of the radii.
int ballOf(const std::vector<PieceBall>& balls, const glm::dvec3& voxel) {
  const auto nearest = std::min_element(balls.begin(), balls.end(), [&](const auto& a, const auto& b) {
    return glm::length(voxel - a.middle) - a.radius < glm::length(voxel - b.middle) - b.radius;
  });
  return static_cast<int>(
      std::count_if(balls.begin(), balls.end(), [&](const auto& b) { return b.radius > nearest->radius; }));
}

TEST_P(PieceGlTest, EachBallHasTheIdOfItsSize) {
  const std::vector<PieceBall> balls = pieceBalls();
  const auto above = prepared(gridOfBalls(balls, true)), below = prepared(gridOfBalls(balls, true, -1.0));
  std::set<float> all;
  for (const char* setting : {"hit.field=trilinear", "isosurface.inside=below", "hit.field=cubic",
                              "hit.method=sampled", "isosurface.opacity=0.5", "pieces.keep=2"})
    for (int k = 0; k < 5; ++k) {
      const scene::Scene scene = assigned({setting}, view(k));
      const auto volume = scene.isosurface.inside == scene::Inside::below ? below : above;
      const auto [voxel, ids] = piecesSeen(volume, scene);
      int wrong = 0;
      for (std::size_t i = 0; i < ids.size(); ++i) {
        if (std::isnan(ids[i])) continue;
        wrong += ids[i] != static_cast<float>(ballOf(balls, at(voxel, i)));
        all.insert(ids[i]);
      }
      EXPECT_EQ(wrong, 0) << setting << ' ' << k;
    }
  EXPECT_EQ(all.size(), balls.size());
}

TEST_P(PieceGlTest, InCellsOfTwoPiecesTheFieldDecides) {
  const auto volume = prepared(SplitCells::grid());
  std::map<bool, std::set<float>> ids;
  for (int k = 0; k < 3; ++k) {
    const Seen seen = piecesSeen(volume, view(k, {15.5, 15.5, 11.5}, 54.0));
    const std::vector<float>& found = seen.ids;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const glm::dvec3 voxel = at(seen.voxel, i);
      if (std::isnan(found[i]) || std::abs(voxel.x + voxel.y - SplitCells::k) < 1e-2) continue;
      ids[SplitCells::shows(voxel)].insert(found[i]);
    }
  }
  EXPECT_EQ(ids[false].size(), 1u);
  EXPECT_EQ(ids[true].size(), 1u);
  EXPECT_NE(ids[false], ids[true]);
}

// Ids are those of the isosurface that is hit: of the two balls the smaller one is the only one at 1.5.
TEST_P(PieceGlTest, IdsAreThoseOfTheIsosurfaceThatIsHit) {
  const glm::dvec3 small(14.2, 16.1, 15.3), large(32.7, 31.4, 33.8);
  const auto volume = prepared(gridOfVoxels(unitGeometry({48, 48, 48}), [&](glm::dvec3 p) {
    return std::max(
        {std::min(7.3 - glm::length(p - small), 3.0), std::min(9.6 - glm::length(p - large), 1.0), -2.0});
  }));
  const std::vector<std::string> both = {"isosurface.value=0.5", "isosurface2.shown=1",
                                         "isosurface2.value=1.5"};
  std::set<float> ids;
  for (const float id : piecesSeen(volume, assigned(both, view(1))).ids)
    if (!std::isnan(id)) ids.insert(id);
  EXPECT_EQ(ids, (std::set<float>{0.0f, 1.0f}));

  std::vector<std::string> second = both;
  second.emplace_back("isosurface.opacity=0");
  for (scene::Scene scene : {assigned(second, view(1)), assigned(both, view(1, small, 0.5))}) {
    ids.clear();
    for (const float id : piecesSeen(volume, scene).ids)
      if (!std::isnan(id)) ids.insert(id);
    EXPECT_EQ(ids, std::set<float>{0.0f});
  }
}

TEST_P(PieceGlTest, IdsOfTheHeadAreThoseOfAFlood) {
  const auto volume = phantom("head", 64);
  scene::Scene scene;
  scene.surfaces.front().value = 1400.0;
  const auto [voxel, ids] = piecesSeen(volume, scene);
  const volume::Grid& grid = volume->grid();
  const FloodedPieces flood = floodedPieces(grid, 1400.0, scene::Inside::above).joined;
  base::Progress progress;
  const auto pieces = volume->pieces->at(1400.0, scene::Inside::above, progress);
  ASSERT_GT(pieces->list().size(), 1u);
  std::set<float> all;
  int judged = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (std::isnan(ids[i])) continue;
    all.insert(ids[i]);
    const glm::ivec3 cell = glm::min(glm::ivec3(at(voxel, i)), grid.dims() - 2);
    std::set<std::uint32_t> labels;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 v = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      labels.insert(flood.label[grid.index(v.x, v.y, v.z)]);
    }
    labels.erase(0xffffffffu);
    if (labels.size() != 1) continue;
    ++judged;
    EXPECT_EQ(pieces->list()[static_cast<std::size_t>(ids[i])].voxels, flood.voxels[*labels.begin()]);
  }
  EXPECT_GT(judged, 50);
  EXPECT_GT(all.size(), 1u);
}

// Nobody labels pieces who is not asked to.
TEST_P(PieceGlTest, CostsNothingWhereItIsNotAskedFor) {
  const auto volume = prepared(gridOfBalls(pieceBalls(), true));
  renderer_->setVolume(volume);
  render::FrameRequest request;
  request.size = kPieceSize;
  const auto stateOf = [](const render::FrameReport& report) {
    const auto at = std::find_if(report.passes.begin(), report.passes.end(),
                                 [](const auto& pass) { return pass.name == "piece"; });
    return at->state;
  };
  const scene::Scene scene = scene::resolve(view(0), volume->facts);
  for (const bool images : {false, true}) {
    request.aovs.clear();
    if (images) request.aovs = {Aov::voxel, Aov::kappa, Aov::color_value};
    EXPECT_EQ(stateOf(renderer_->render(scene, request)), render::PassState::skipped);
    EXPECT_FALSE(volume->pieces->any());
  }
  request.aovs = std::vector{Aov::piece};
  EXPECT_EQ(stateOf(renderer_->render(scene, request)), render::PassState::ran);
  EXPECT_EQ(stateOf(renderer_->render(scene, request)), render::PassState::cached);
}

}  // namespace
}  // namespace isolux::test
