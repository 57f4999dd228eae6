// Pieces that are not shown: pictures are those of a volume without them.
#include <algorithm>
#include <cmath>

#include "tests/render/gl_fixture.h"
#include "tests/support/hidden_balls.h"

namespace isolux::test {
namespace {

constexpr glm::ivec2 kHiddenPiecesSize{96, 80};

class HiddenPiecesGlTest : public ExecutorsGlTest {
 protected:
  static scene::Scene hiding(const std::vector<PieceBall>& balls, scene::Scene scene) {
    for (const PieceBall& ball : balls)
      if (!ball.shown) scene.pieces.hidden.push_back(ball.middle);
    return scene;
  }
  static scene::Scene view(int k) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    const double azimuth = 2.4 * k, height = -0.8 + 0.4 * k;
    scene.camera.target = glm::dvec3(23.5);
    scene.camera.up = {0.0, 0.0, 1.0};
    scene.camera.eye = *scene.camera.target + 90.0 * glm::dvec3(std::cos(azimuth), std::sin(azimuth), height);
    return scene;
  }
  static scene::Scene splitView(int k) {
    scene::Scene scene = view(k);
    scene.camera.target = {15.5, 15.5, 11.5};
    scene.camera.eye = *scene.camera.target + 0.6 * (*scene.camera.eye - glm::dvec3(23.5));
    scene.pieces.hidden = {{2.0, 2.0, 10.0}};
    return scene;
  }
  // Cubic fields: the hits of this test's executor are the processor's.
  void expectAsTheProcessor(const std::shared_ptr<const volume::PreparedVolume>& volume, scene::Scene scene,
                            std::size_t leastHits) {
    scene::applyAssignment(scene, "hit.field=cubic");
    const Images seen = images(volume, scene, kHiddenPiecesSize);
    scene::applyAssignment(host_, "picture.executor=cpu");
    renderer_->setHostSettings(host_);
    const Images expected = images(volume, scene, kHiddenPiecesSize);
    scene::applyAssignment(host_, std::string("picture.executor=") + GetParam());
    renderer_->setHostSettings(host_);
    std::size_t hits = 0, different = 0;
    for (std::size_t i = 0; i < expected.hit.values.size(); ++i) {
      const bool hit = expected.hit.values[i] == 1.0f;
      hits += hit;
      different += seen.hit.values[i] != expected.hit.values[i] ||
                   (hit && glm::distance(at(seen.voxel, i), at(expected.voxel, i)) > 1e-2);
    }
    EXPECT_GT(hits, leastHits);
    EXPECT_LE(different, hits / 200);
  }
  render::ColorImage colors(const std::shared_ptr<const volume::PreparedVolume>& volume,
                            const scene::Scene& scene) {
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = kHiddenPiecesSize;
    renderer_->render(scene::resolve(scene, volume->facts), request);
    return renderer_->readColor();
  }
};
ISOLUX_ON_BOTH_EXECUTORS(HiddenPiecesGlTest);

TEST_P(HiddenPiecesGlTest, PicturesAreThoseOfAVolumeWithoutTheHiddenBalls) {
  const std::vector<PieceBall> balls = pieceBalls();
  const auto all = prepared(gridOfBalls(balls, true)), shown = prepared(gridOfBalls(balls, false));
  for (const char* setting : {"hit.field=trilinear", "look.shadow=1", "isosurface.opacity=0.5",
                              "hit.field=cubic", "hit.method=sampled"})
    for (int k = 0; k < 5; ++k) {
      const scene::Scene scene = assigned({"look.mode=lambert", setting}, view(k));
      const Images expected = images(shown, scene, kHiddenPiecesSize);
      const render::ColorImage expectedColors = colors(shown, scene);
      const Images seen = images(all, hiding(balls, scene), kHiddenPiecesSize);
      EXPECT_EQ(seen.hit.values, expected.hit.values) << setting << ' ' << k;
      for (std::size_t i = 0; i < seen.hit.values.size(); ++i)
        if (expected.hit.values[i] == 1.0f && seen.hit.values[i] == 1.0f) {
          ASSERT_EQ(at(seen.voxel, i), at(expected.voxel, i)) << setting << ' ' << k;
        }
      EXPECT_EQ(colors(all, hiding(balls, scene)).rgba, expectedColors.rgba) << setting << ' ' << k;
      // From the second picture on shaders step over single cells.
      EXPECT_EQ(colors(all, hiding(balls, scene)).rgba, expectedColors.rgba) << setting << ' ' << k;
    }
}

// Where pieces are shown again, the passes that they are seen in run, and no others.
TEST_P(HiddenPiecesGlTest, ShowingThemAgainIsSeen) {
  const std::vector<PieceBall> balls = pieceBalls();
  const auto all = prepared(gridOfBalls(balls, true));
  const scene::Scene scene = view(1);
  const auto whole = colors(all, scene).rgba, part = colors(all, hiding(balls, scene)).rgba;
  EXPECT_NE(whole, part);
  EXPECT_EQ(colors(all, scene).rgba, whole);
}

// The eye stands in a hidden ball and looks at others.
TEST_P(HiddenPiecesGlTest, FromWithinAHiddenPieceTheOthersAreSeen) {
  const std::vector<PieceBall> balls = pieceBalls();
  const auto all = prepared(gridOfBalls(balls, true)), shown = prepared(gridOfBalls(balls, false));
  for (const char* field : {"hit.field=trilinear", "hit.field=cubic"})
    for (const std::size_t eye : {1u, 3u})
      for (const std::size_t target : {0u, 2u, 4u}) {
        scene::Scene scene = assigned({"look.mode=lambert", field}, view(0));
        scene.camera.eye = balls[eye].middle + glm::dvec3(0.3, 0.2, 0.1);
        scene.camera.target = balls[target].middle;
        scene.camera.fov = 60.0;
        const Images expected = images(shown, scene, kHiddenPiecesSize),
                     seen = images(all, hiding(balls, scene), kHiddenPiecesSize);
        EXPECT_EQ(seen.hit.values, expected.hit.values) << field << ' ' << eye << ' ' << target;
        EXPECT_GT(std::count(expected.hit.values.begin(), expected.hit.values.end(), 1.0f), 200);
      }
}

// In cells of two pieces too: what is seen is of the shown one.
TEST_P(HiddenPiecesGlTest, InCellsOfTwoPiecesTheShownOneIsSeen) {
  const auto volume = prepared(SplitCells::grid());
  for (const char* method : {"hit.method=exact", "hit.method=sampled"}) {
    int hits = 0;
    for (int k = 0; k < 5; ++k) {
      const Images seen = images(volume, assigned({method}, splitView(k)), kHiddenPiecesSize);
      int wrong = 0;
      for (std::size_t i = 0; i < seen.hit.values.size(); ++i) {
        if (seen.hit.values[i] != 1.0f) continue;
        ++hits;
        wrong += !SplitCells::shows(at(seen.voxel, i) + glm::dvec3(1e-3, 1e-3, 0.0));
      }
      EXPECT_EQ(wrong, 0) << method << ' ' << k;
    }
    EXPECT_GT(hits, 2000) << method;
  }
}

// Splines round the gap off, and the pieces touch: shaders decide as the processor does whose a point is.
TEST_P(HiddenPiecesGlTest, InCellsOfTwoPiecesOfASplineAsTheProcessorHasIt) {
  const auto volume = prepared(SplitCells::grid());
  for (int k = 0; k < 5; ++k) expectAsTheProcessor(volume, splitView(k), 400);
}

// A gap of two samples that the spline bridges: there no sample of a cell is inside, and what is seen follows
// from the nearest one. In the middle of a cell those of both pieces are as near.
TEST_P(HiddenPiecesGlTest, WhereASplineBridgesAGapAsTheProcessorHasIt) {
  const auto volume = prepared(gridOfVoxels(unitGeometry({32, 32, 24}), [](glm::dvec3 p) {
    return std::abs(p.y - 15.5) > 8.0 ? -10.0 : std::abs(p.x - 15.5) < 1.0 ? -0.1 : 10.0;
  }));
  for (int k = 0; k < 5; ++k) {
    scene::Scene scene = splitView(k);
    scene.pieces.hidden = {{8.0, 15.0, 11.0}};
    expectAsTheProcessor(volume, scene, 400);
  }
}

// An interpolating spline overshoots between eight voxels just outside: no piece has that surface.
TEST_P(HiddenPiecesGlTest, StraysOfASplineAreHiddenWhereThePiecesShownAreNamed) {
  const auto volume = prepared(gridOfVoxels(unitGeometry({40, 20, 20}), [](glm::dvec3 p) {
    if (glm::distance(p, glm::dvec3(10.0)) < 6.0) return 10.0;
    const glm::dvec3 apart = glm::abs(p - glm::dvec3(29.5, 9.5, 9.5));
    return std::max({apart.x, apart.y, apart.z}) < 1.0 ? -0.05 : -10.0;
  }));
  for (const char* pieces : {"pieces.keep=0", "pieces.keep=1", "pieces.smallest=20"}) {
    int ofBall = 0, ofStray = 0;
    for (int k = 0; k < 3; ++k) {
      scene::Scene scene = assigned({"hit.field=cubic_interpolating", pieces}, view(k));
      scene.camera.target = {19.5, 9.5, 9.5};
      scene.camera.eye = *scene.camera.target + 0.6 * (*scene.camera.eye - glm::dvec3(23.5));
      const Images seen = images(volume, scene, kHiddenPiecesSize);
      for (std::size_t i = 0; i < seen.hit.values.size(); ++i)
        if (seen.hit.values[i] == 1.0f) ++(at(seen.voxel, i).x < 20.0 ? ofBall : ofStray);
    }
    EXPECT_GT(ofBall, 300) << pieces;
    if (pieces == std::string("pieces.keep=0"))
      EXPECT_GT(ofStray, 20);
    else
      EXPECT_EQ(ofStray, 0) << pieces;
  }
}

}  // namespace
}  // namespace isolux::test
