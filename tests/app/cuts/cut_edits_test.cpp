// Planes and boxes that a user asks for, by their definitions.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/cuts/cut_edits.h"

namespace isolux::app {
namespace {

volume::GridGeometry slantedGrid() {
  return volume::GridGeometry::make({40, 30, 20}, {0.8, 1.0, 1.6}, {-12.0, 7.0, 30.0},
                                    glm::dmat3(-0.8, 0.6, 0.0, 0.48, 0.64, 0.6, -0.36, -0.48, 0.8));
}

scene::VolumeFacts factsOf(glm::dvec3 low, glm::dvec3 high) {
  scene::VolumeFacts facts;
  facts.boundsMinMm = low;
  facts.boundsMaxMm = high;
  return facts;
}

TEST(CutEdits, NewPlanesTakeAwayWhatIsBeforeThem) {
  const glm::dvec3 point(1.0, 2.0, 3.0), back = glm::normalize(glm::dvec3(0.3, -0.9, 0.2));
  EXPECT_EQ(planeAcross(0, point, back), (scene::ClipPlane{point, {1.0, 0.0, 0.0}}));
  EXPECT_EQ(planeAcross(1, point, back), (scene::ClipPlane{point, {0.0, -1.0, 0.0}}));
  EXPECT_EQ(planeAcross(2, point, -back), (scene::ClipPlane{point, {0.0, 0.0, -1.0}}));
  EXPECT_EQ(planeFacing(back, point), (scene::ClipPlane{point, back}));
}

TEST(CutEdits, AThreePointPlaneGoesThroughThemAndFacesTheViewer) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-80.0, 80.0);
  const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  for (int i = 0; i < 100; ++i) {
    const std::array<glm::dvec3, 3> points{point(), point(), point()};
    const glm::dvec3 back = glm::normalize(point());
    const auto plane = planeThrough(points, back);
    ASSERT_TRUE(plane);
    for (const glm::dvec3& p : points) EXPECT_NEAR(glm::dot(plane->normal, p - plane->point), 0.0, 1e-9);
    EXPECT_GE(glm::dot(plane->normal, back), 0.0);
  }
  const glm::dvec3 a(1, 2, 3), way(4, -2, 7);
  EXPECT_FALSE(planeThrough(std::array{a, a + way, a + 2.5 * way}, {0, 0, 1}));
  EXPECT_FALSE(planeThrough(std::array{a, a, a + way}, {0, 0, 1}));
}

TEST(CutEdits, TheLastPointsThatWereMarked) {
  const scene::Mark pin{scene::MarkKind::point, "a", {{1, 0, 0}}},
      two{scene::MarkKind::distance, "b", {{2, 0, 0}, {3, 0, 0}}};
  EXPECT_EQ(lastMarked({pin}, 3).size(), 1u);
  EXPECT_EQ(lastMarked({pin, two}, 3), (std::vector<glm::dvec3>{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(lastMarked({pin, two, pin}, 3), (std::vector<glm::dvec3>{{2, 0, 0}, {3, 0, 0}, {1, 0, 0}}));
}

// The crosshair where the user has put it, else what the view turns about; never outside what there is to
// see.
TEST(CutEdits, PlanesGoThroughWhatIsSeen) {
  const scene::VolumeFacts facts = factsOf({-10, -20, -30}, {10, 20, 30});
  scene::Scene scene;
  scene.camera.target = {4, 5, 6};
  EXPECT_EQ(cutPoint(scene, facts), glm::dvec3(4, 5, 6));
  scene.camera.target = {400, 5, 6};
  EXPECT_EQ(cutPoint(scene, facts), glm::dvec3(10, 5, 6));
  scene.slice.position = {1, 2, 3};
  EXPECT_EQ(cutPoint(scene, facts), glm::dvec3(1, 2, 3));
}

// Corners lie on the plane and on the box's edges, in order; the area is that of the whole face for a plane
// along the axes.
TEST(CutEdits, TheOutlineIsWhatThePlaneHasOfTheBox) {
  const BoxCorners box = slantedGrid().corners();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const glm::dmat4 voxelFromWorld = slantedGrid().voxelFromWorld();
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 n(normal(random), normal(random), normal(random));
    const glm::dvec3 inside =
        0.5 * (box[0] + box[7]) + 6.0 * glm::dvec3(normal(random), normal(random), normal(random));
    const scene::ClipPlane plane{inside, n};
    const std::vector<glm::dvec3> outline = outlineOf(plane, box);
    if (outline.empty()) continue;
    ++whole;
    ASSERT_LE(outline.size(), 6u);
    double turns = 0.0;
    const glm::dvec3 middle = middleOf(plane, box);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const glm::dvec3 &p = outline[k], &q = outline[(k + 1) % outline.size()];
      EXPECT_NEAR(glm::dot(glm::normalize(n), p - inside), 0.0, 1e-9);
      int atEnds = 0;
      const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(p, 1.0));
      for (int axis = 0; axis < 3; ++axis) {
        const double last = slantedGrid().dims[axis] - 1;
        EXPECT_GT(voxel[axis], -1e-9);
        EXPECT_LT(voxel[axis], last + 1e-9);
        atEnds += std::abs(voxel[axis]) < 1e-9 || std::abs(voxel[axis] - last) < 1e-9;
      }
      EXPECT_GE(atEnds, 2);
      turns += std::atan2(glm::dot(glm::normalize(n), glm::cross(p - middle, q - middle)),
                          glm::dot(p - middle, q - middle));
    }
    EXPECT_NEAR(turns, 2.0 * std::acos(-1.0), 1e-9);  // once about its middle: convex and in order
  }
  EXPECT_GT(whole, 150);
}

TEST(CutEdits, TheMiddleOfAPlaneIsThatOfItsFaceOrTheFootOfTheBox) {
  BoxCorners box;
  for (int i = 0; i < 8; ++i)
    box[static_cast<std::size_t>(i)] = {i & 1 ? 10.0 : 0.0, i & 2 ? 6.0 : 0.0, i & 4 ? 8.0 : 0.0};
  EXPECT_LT(glm::distance(middleOf({{90, 90, 3}, {0, 0, 2}}, box), {5, 3, 3}), 1e-12);
  EXPECT_LT(glm::distance(middleOf({{0, 0, 80}, {0, 0, -1}}, box), {5, 3, 80}), 1e-12);
  // A corner's triangle: its centroid.
  EXPECT_LT(glm::distance(middleOf({{3, 0, 0}, {1, 1, 1}}, box), {1, 1, 1}), 1e-12);
}

// Two planes across one another through the middle: each has half of its face, and its middle lies there.
TEST(CutEdits, AFaceIsWhatTheOtherCutsLeave) {
  BoxCorners box;
  for (int i = 0; i < 8; ++i)
    box[static_cast<std::size_t>(i)] = {i & 1 ? 8.0 : -8.0, i & 2 ? 6.0 : -6.0, i & 4 ? 4.0 : -4.0};
  scene::Clip clip;
  clip.planes = {{{0, 0, 0}, {0, 0, 1}}, {{2, 0, 0}, {1, 0, 0}}};
  EXPECT_LT(glm::distance(middleOfFace(clip, 0, box), {-3, 0, 0}), 1e-12);
  EXPECT_LT(glm::distance(middleOfFace(clip, 1, box), {2, 0, -2}), 1e-12);
  clip.box = {{-4, -6, -4}, {8, 6, 4}};
  EXPECT_LT(glm::distance(middleOfFace(clip, 0, box), {-1, 0, 0}), 1e-12);
  clip.planes[1] = {{0, 0, -1}, {0, 0, 1}};  // leaves nothing of the first: it is shown whole
  EXPECT_EQ(faceOf(clip, 0, box), outlineOf(clip.planes[0], box));
  EXPECT_LT(glm::distance(middleOfFace(clip, 0, box), {0, 0, 0}), 1e-12);
}

TEST(CutEdits, FlippingTwiceAndAligning) {
  const BoxCorners box = slantedGrid().corners();
  const scene::ClipPlane plane{0.5 * (box[0] + box[7]), {0.2, -0.9, 0.3}};
  EXPECT_EQ(flipped(plane).normal, -plane.normal);
  EXPECT_EQ(flipped(flipped(plane)), plane);
  EXPECT_FALSE(std::signbit(flipped({{}, {0, 0, 1}}).normal.x));  // no "-0" in texts
  const scene::ClipPlane aligned = alignedToAxis(plane, box);
  EXPECT_EQ(aligned.normal, glm::dvec3(0, -1, 0));
  EXPECT_LT(std::abs(glm::dot(plane.normal, aligned.point - plane.point)), 1e-9);  // turned about itself
  EXPECT_EQ(alignedToViewer(plane, box, {0, 0, 1}).normal, glm::dvec3(0, 0, 1));
}

// From the point to beyond the volume, on the viewer's side of it on each axis.
TEST(CutEdits, ACornerIsTheOctantTowardTheViewer) {
  const BoxCorners volume = slantedGrid().corners();
  const glm::dvec3 point(1, 12, 40);
  scene::Clip clip;
  for (const glm::dvec3& back : {glm::dvec3(0.2, -0.7, 0.4), glm::dvec3(-1, 0.1, -0.2)}) {
    addCorner(clip, point, back, volume);
    const glm::dvec3 end = clip.removed.back();
    for (int axis = 0; axis < 3; ++axis)
      for (const glm::dvec3& corner : volume) EXPECT_GT((end[axis] - corner[axis]) * back[axis], 0.0) << axis;
  }
  ASSERT_EQ(clip.removed.size(), 4u);
  EXPECT_EQ(clip.removed[2], point);
  removeCorner(clip, 0);
  ASSERT_EQ(clip.removed.size(), 2u);
  EXPECT_LT(clip.removed[1].x, point.x);
  removeCorner(clip, 1);
  EXPECT_EQ(clip.removed.size(), 2u);
}

TEST(CutEdits, ANewBoxLiesAboutTheMiddle) {
  scene::Clip clip;
  clip.boxRotation = {0.5, 0.5, 0.5, 0.5};
  addBox(clip, factsOf({-10, 0, 20}, {10, 40, 60}));
  EXPECT_EQ(clip.box, (std::vector<glm::dvec3>{{-7.5, 5, 25}, {7.5, 35, 55}}));
  const TurnedBox box = turnedBox(clip);
  EXPECT_EQ(box.middle, glm::dvec3(0, 20, 40));
  EXPECT_EQ(box.corner(5), glm::dvec3(7.5, 5, 55));
}

}  // namespace
}  // namespace isolux::app
