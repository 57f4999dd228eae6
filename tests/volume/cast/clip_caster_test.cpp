// Hits of surfaces that are cut: the first of the reference's that the kept region contains, on every target.
#include <gtest/gtest.h>

#include "tests/support/volumes.h"
#include "tests/volume/cast/caster_checks.h"

namespace isolux::volume {
namespace {

using namespace test::casting;

// About the middle of a volume of `size` voxels of 1 mm: a slanted plane, and a turned box.
ClipRegion planeOf(double size) {
  scene::Clip clip;
  clip.planes = {{glm::dvec3(0.5 * size), {0.3, -0.2, 1.0}}};
  return ClipRegion(clip);
}
ClipRegion boxOf(double size) {
  scene::Clip clip;
  clip.box = {glm::dvec3(0.2 * size, 0.25 * size, 0.3 * size),
              glm::dvec3(0.8 * size, 0.7 * size, 0.75 * size)};
  clip.boxRotation = {0.9, 0.2, -0.3, 0.1};
  clip.planes = {{glm::dvec3(0.5 * size), {-1.0, 0.2, 0.1}}};
  return ClipRegion(clip);
}

// A corner is gone.
ClipRegion cornerOf(double size) {
  scene::Clip clip;
  clip.removed = {glm::dvec3(0.5 * size, 0.55 * size, 0.45 * size), glm::dvec3(1e6)};
  return ClipRegion(clip);
}
// Boxes that touch, overlap, have no thickness and lie alone; a plane and a box beside them.
ClipRegion withoutBoxes(double size) {
  scene::Clip clip;
  const double corners[][6] = {{0.1, 0.1, 0.2, 0.4, 0.6, 0.5},    {0.4, 0.1, 0.2, 0.6, 0.6, 0.5},
                               {0.5, 0.2, 0.4, 0.8, 0.5, 0.9},    {0.2, 0.7, 0.6, 0.7, 0.7, 0.9},
                               {0.65, 0.75, 0.1, 0.9, 0.95, 0.3}, {-9.0, -9.0, 0.3, 0.15, 0.4, 0.35},
                               {0.3, 0.8, 0.55, 0.45, 9.0, 9.0},  {0.45, 0.8, 0.55, 0.6, 0.9, 0.8}};
  for (const double(&c)[6] : corners) {
    clip.removed.push_back(size * glm::dvec3(c[0], c[1], c[2]));
    clip.removed.push_back(size * glm::dvec3(c[3], c[4], c[5]));
  }
  clip.planes = {{glm::dvec3(0.9 * size), {1.0, 0.4, 0.3}}};
  clip.box = {glm::dvec3(0.02 * size), glm::dvec3(0.97 * size)};
  return ClipRegion(clip);
}

TEST(ClipCaster, HitsAreTheReferencesBesideRemovedBoxes) {
  for (const scene::Field field :
       {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating}) {
    Prepared volume(test::phantomGrid("gyroid", 32), {0.1}, field);
    const int views = field == scene::Field::trilinear ? 8 : 4;  // in the fourth the eye is in the volume
    volume.cut(cornerOf(31.0), 1);
    expectFirstHits(volume, "corner", views);
    volume.cut(withoutBoxes(31.0), 1);
    expectFirstHits(volume, "boxes", views);
  }
  Prepared several(test::phantomGrid("gyroid", 32), {0.1, -0.4, 0.6});
  for (const int clipped : {1, 5, 6, 7}) {
    several.cut(withoutBoxes(31.0), clipped);
    expectFirstHits(several, "some are cut", 4);
  }
  Prepared noise(test::phantomGrid("noise", 28), {0.0, 0.3});
  for (const int clipped : {2, 3}) {
    noise.cut(withoutBoxes(27.0), clipped);
    expectFirstHits(noise, "noise", 4);
  }
}

TEST(ClipCaster, HitsAreTheReferencesWithinTheKeptRegion) {
  for (const scene::Field field :
       {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating}) {
    Prepared volume(test::phantomGrid("gyroid", 32), {0.1}, field);
    volume.cut(planeOf(31.0), 1);
    expectFirstHits(volume, "plane", field == scene::Field::trilinear ? 5 : 2);
    volume.cut(boxOf(31.0), 1);
    expectFirstHits(volume, "box", field == scene::Field::trilinear ? 5 : 2);
  }
}

TEST(ClipCaster, SurfacesThatAreNotCutAreSeenOutside) {
  Prepared volume(test::phantomGrid("gyroid", 32), {0.1, -0.4, 0.6});
  for (const int clipped : {1, 2, 5, 6}) {
    volume.cut(boxOf(31.0), clipped);
    expectFirstHits(volume, "some are cut", 2);
  }
  Prepared noise(test::phantomGrid("noise", 28), {0.0, 0.3});
  noise.cut(planeOf(27.0), 1);
  expectFirstHits(noise, "noise", 4);
}

TEST(ClipCaster, GapsAndHolesStayWhatTheyAre) {
  Prepared volume(withHoles(test::phantomGrid("gyroid", 32)), {0.05, 0.4});
  volume.cut(boxOf(31.0), 3);
  expectFirstHits(volume, "holes", 4);
  volume.cut(boxOf(31.0), 2);
  expectFirstHits(volume, "holes, one is cut", 4);
  volume.cut(withoutBoxes(31.0), 3);
  expectFirstHits(volume, "holes, boxes", 4);
}

// Where rays end sooner, nothing is found behind; where they do not, all is as before.
TEST(ClipCaster, RaysEndWhereTheyAreToldTo) {
  const Prepared volume(test::phantomGrid("gyroid", 32), {0.1});
  const PictureRays rays = view(0, volume.grid().dims());
  const CrossingImage whole = cast(volume.caster(TracerTarget::automatic), rays);
  std::vector<float> ends(whole.points.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (whole.points[i].w >= 0.0f && i % 3 != 0) ends[i] = whole.points[i].w + (i % 3 == 1 ? 0.01f : -0.01f);
  for (const TracerTarget target : targets()) {
    const CrossingImage seen = cast(volume.caster(target, ends), rays);
    int hits = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (i % 3 == 2) {
        EXPECT_LT(seen.points[i].w, 0.0f);
      } else {
        EXPECT_NEAR(seen.points[i].w, whole.points[i].w, 1e-3f);
        hits += seen.points[i].w >= 0.0f;
      }
    }
    EXPECT_GT(hits, 500);
  }
}

}  // namespace
}  // namespace isolux::volume
