#include "scene/framing.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::scene {
namespace {

Camera obliqueCamera(Projection projection) {
  Camera camera;
  camera.eye = glm::dvec3(30, -400, 155);
  camera.target = glm::dvec3(10, 20, -5);
  camera.up = glm::dvec3(0.1, 0, 2);
  camera.fov = 35;
  camera.projection = projection;
  return camera;
}

std::vector<glm::dvec3> cloud(unsigned seed, glm::dvec3 centre, glm::dvec3 size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 300; ++i)
    points.push_back(centre + size * glm::dvec3(part(random), part(random), part(random)));
  return points;
}

Rooms roomOf(glm::dvec2 half) {
  return {{-half, half}};
}

// Where points appear: the largest and smallest of each axis, 1 at the picture's border.
struct Extent {
  glm::dvec2 low{1e9}, high{-1e9};
};
Extent extentIn(const Camera& camera, double aspect, const std::vector<glm::dvec3>& points) {
  const CameraFrame f = frameOf(camera);
  Extent extent;
  for (const glm::dvec3& p : points) {
    const glm::dvec3 d = p - f.eye;
    const double depth = -glm::dot(d, f.back);
    EXPECT_GT(depth, 0.0);
    const double scale = f.projection == Projection::perspective ? depth * f.halfHeight : f.halfHeight;
    const glm::dvec2 at(glm::dot(d, f.right) / scale / aspect, glm::dot(d, f.up) / scale);
    extent.low = glm::dvec2(std::min(extent.low.x, at.x), std::min(extent.low.y, at.y));
    extent.high = glm::dvec2(std::max(extent.high.x, at.x), std::max(extent.high.y, at.y));
  }
  return extent;
}

TEST(Framing, AllPointsLieInThePictureAndTouchTheMarginOfTheTighterAxis) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double aspect : {0.6, 1.0, 2.0})
      for (const glm::dvec3& size : {glm::dvec3(100), glm::dvec3(300, 5, 5), glm::dvec3(5, 5, 200)}) {
        const Camera before = obliqueCamera(projection);
        const auto points = cloud(7, {-50, 300, 20}, size);
        const Camera after = framing(before, wholePicture(aspect), points);
        const Extent e = extentIn(after, aspect, points);
        const double border = 1.0 / 1.04;
        EXPECT_GE(e.low.x, -border - 1e-9);
        EXPECT_GE(e.low.y, -border - 1e-9);
        EXPECT_LE(e.high.x, border + 1e-9);
        EXPECT_LE(e.high.y, border + 1e-9);
        // Both ends of one axis lie on the margin: nothing nearer would do.
        const bool acrossTight = std::abs(e.low.x + border) < 1e-9 && std::abs(e.high.x - border) < 1e-9;
        const bool upTight = std::abs(e.low.y + border) < 1e-9 && std::abs(e.high.y - border) < 1e-9;
        EXPECT_TRUE(acrossTight || upTight)
            << e.low.x << ' ' << e.high.x << ' ' << e.low.y << ' ' << e.high.y;
        const CameraFrame f = frameOf(before), g = frameOf(after);
        EXPECT_NEAR(glm::dot(f.back, g.back), 1.0, 1e-12) << "the same direction";
        EXPECT_NEAR(glm::dot(f.up, g.up), 1.0, 1e-12);
      }
}

TEST(Framing, TheTargetIsInTheMiddleOfTheDepth) {
  const Camera before = obliqueCamera(Projection::perspective);
  const auto points = cloud(3, {10, 20, 30}, {40, 90, 10});
  const Camera after = framing(before, wholePicture(1.5), points);
  const glm::dvec3 back = frameOf(after).back;
  double nearest = -1e9, farthest = 1e9;
  for (const glm::dvec3& p : points) {
    nearest = std::max(nearest, glm::dot(p, back));
    farthest = std::min(farthest, glm::dot(p, back));
  }
  EXPECT_NEAR(glm::dot(*after.target, back), (nearest + farthest) / 2.0, 1e-9);
}

TEST(Framing, ABallFitsFromEverySide) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double aspect : {0.5, 1.5}) {
      const glm::dvec3 centre(5, 6, 7);
      std::vector<glm::dvec3> ball;
      for (const glm::dvec3& p : cloud(1, {0, 0, 0}, {2, 2, 2}))
        ball.push_back(centre + 25.0 * glm::normalize(p));
      const Camera camera = framingBall(obliqueCamera(projection), wholePicture(aspect), centre, 25.0);
      const Extent e = extentIn(camera, aspect, ball);
      const double most = std::max({-e.low.x, -e.low.y, e.high.x, e.high.y});
      EXPECT_LE(most, 1.0 / 1.04 + 1e-9);
      EXPECT_GE(most, 0.85);
    }
}

// Off the middle of the picture: all of it lies in the room, and touches its margin along one axis.
TEST(Framing, PointsLieInARoomOffTheMiddle) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const Room& room : {Room{{-1.5, -1.0}, {0.7, 1.0}}, Room{{-0.2, -0.9}, {1.4, 0.1}}})
      for (const glm::dvec3& size : {glm::dvec3(100), glm::dvec3(300, 5, 5), glm::dvec3(5, 5, 200)}) {
        const auto points = cloud(7, {-50, 300, 20}, size);
        const Extent e = extentIn(framing(obliqueCamera(projection), {room}, points), 1.0, points);
        const glm::dvec2 air = 0.5 * (room.high - room.low) * (1.0 - 1.0 / 1.04);
        const glm::dvec2 below = e.low - (room.low + air), above = room.high - air - e.high;
        for (const double within : {below.x, below.y, above.x, above.y}) EXPECT_GE(within, -1e-9);
        EXPECT_LE(std::min(std::max(below.x, above.x), std::max(below.y, above.y)), 1e-9);
        EXPECT_NEAR(below.x, above.x, projection == Projection::perspective ? 0.2 : 1e-9) << "centred";
      }
}

TEST(Framing, TakesTheRoomThatShowsMostAndOfAlikeOnesTheFirst) {
  const Camera before = obliqueCamera(Projection::perspective);
  const Room middle{{-1.0, -1.0}, {1.0, 1.0}}, aside{{-1.6, -1.0}, {1.0, 1.0}},
      small{{-0.5, -0.5}, {0.5, 0.5}};
  for (const glm::dvec3& size : {glm::dvec3(5, 5, 200), glm::dvec3(300, 5, 5)}) {
    const auto points = cloud(7, {-50, 300, 20}, size);
    const Room& best =
        size.z > size.x ? middle : aside;  // the width of a column is no matter to what is high
    EXPECT_EQ(framing(before, {small, middle, aside}, points), framing(before, {best}, points));
  }
}

// From voxels of 1e-9 mm to voxels of 1e9 mm: the same picture.
TEST(Framing, ScalesWithWhatIsFramed) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double scale : {1e-9, 1e-6, 1e7, 1e9}) {
      const Camera camera = obliqueCamera(projection);
      auto points = cloud(7, {-5, 30, 20}, {100, 90, 80});
      const Camera one = framing(camera, wholePicture(1.5), points);
      for (glm::dvec3& p : points) p *= scale;
      const Camera scaled = framing(camera, wholePicture(1.5), points);
      EXPECT_NEAR(glm::distance(*scaled.eye / scale, *one.eye), 0.0, 1e-9) << scale;
      EXPECT_NEAR(glm::distance(*scaled.target / scale, *one.target), 0.0, 1e-9) << scale;
      const Camera ball = framingBall(camera, wholePicture(1.5), {0, 0, 0}, 25.0);
      const Camera scaledBall = framingBall(camera, wholePicture(1.5), {0, 0, 0}, 25.0 * scale);
      EXPECT_NEAR(glm::distance(*scaledBall.eye / scale, *ball.eye), 0.0, 1e-9) << scale;
    }
}

TEST(Framing, NumbersThatAreNoneLeaveTheCamera) {
  const Camera camera = obliqueCamera(Projection::perspective);
  std::array<double, framingDirectionCount> farthest{};
  farthest[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(framing(camera, wholePicture(1.0), farthest), camera);
  EXPECT_EQ(framingBall(camera, wholePicture(1.0), {0, 0, 0}, std::numeric_limits<double>::quiet_NaN()),
            camera);
}

// A view that nobody has chosen is cut off in no picture.
TEST(Framing, AFittedCameraIsFittedToNarrowPicturesToo) {
  const glm::dvec3 low(-60, -100, -20), high(80, 40, 50);
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera fit = fitted(obliqueCamera(projection), low, high);
    for (const double across : {1.0, 1.7, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
      EXPECT_EQ(fittedTo(fit, low, high, [&] { return Rooms{wholePicture(across)}; }), fit) << across;
    const Extent between = extentIn(fittedTo(fit, low, high,
                                             [&] {
                                               return Rooms{roomOf({2.0, 0.8})};
                                             }),
                                    1.0, corners);
    EXPECT_LE(std::max(-between.low.y, between.high.y), 0.8 + 1e-9);
    for (const double aspect : {0.9, 0.5, 0.2}) {
      const Camera narrow = fittedTo(fit, low, high, [&] { return Rooms{wholePicture(aspect)}; });
      const Extent e = extentIn(narrow, aspect, corners);
      EXPECT_GE(e.low.x, -1.0 - 1e-9);
      EXPECT_LE(e.high.x, 1.0 + 1e-9);
      EXPECT_GE(e.low.y, -1.0);
      EXPECT_LE(e.high.y, 1.0);
      const double reaches = std::max(-e.low.x, e.high.x);
      EXPECT_NEAR(aspect < 0.5 ? reaches : 1.0, 1.0, 1e-9) << "no farther than needed";
    }
    for (const Camera& chosen : {orbited(fit, 0.1, 0.0), zoomed(fit, 1.1), panned(fit, {0.1, 0.0})})
      EXPECT_EQ(fittedTo(chosen, low, high, [&] { return Rooms{roomOf({0.5, 0.5})}; }), chosen);
  }
}

}  // namespace
}  // namespace isolux::scene
