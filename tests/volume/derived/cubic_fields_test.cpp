#include "volume/derived/cubic_fields.h"
#include "tests/support/memory_limit.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"

#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {
namespace {

std::shared_ptr<const Grid> ball() {
  return std::make_shared<const Grid>(test::phantomGrid("ball", 20));
}

TEST(CubicFields, AreMadeOnceAndOnlyWhenASceneAsksForThem) {
  const auto grid = ball();
  CubicFields fields(grid);
  scene::Scene scene;
  scene.hit.field = scene::Field::trilinear;
  scene.derivatives.field = scene::Field::cubic;
  EXPECT_TRUE(fields.readyFor(scene));
  scene.derivatives.field = scene::Field::cubic_interpolating;
  EXPECT_FALSE(fields.readyFor(scene));
  EXPECT_FALSE(fields.find(scene::Field::cubic_interpolating));
  base::Progress progress;
  fields.makeFor(scene, progress);
  EXPECT_TRUE(fields.readyFor(scene));
  EXPECT_FALSE(fields.find(scene::Field::cubic));
  const auto made = fields.find(scene::Field::cubic_interpolating);
  ASSERT_TRUE(made && made->coefficients);
  EXPECT_EQ(made->coefficients->values, interpolatingCoefficients(*grid).values);
  EXPECT_EQ(fields.make(scene::Field::cubic_interpolating, progress), made);
  EXPECT_FALSE(fields.make(scene::Field::cubic, progress)->coefficients);
  EXPECT_EQ(fields.make(scene::Field::trilinear, progress), nullptr);
}

TEST(CubicFields, TheLastTwoScalesAreKept) {
  CubicFields fields(ball());
  base::Progress progress;
  const auto field = scene::Field::cubic;
  const auto first = fields.make(field, 0.5, progress);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->scaleMm, 0.5);
  EXPECT_EQ(fields.find(field, 0.5), first);
  EXPECT_EQ(fields.find(scene::Field::cubic_interpolating, 0.5), nullptr);
  const auto second = fields.make(field, 1.0, progress);
  EXPECT_EQ(fields.make(field, 0.5, progress), first);  // asked for last now
  fields.make(field, 2.0, progress);
  EXPECT_EQ(fields.find(field, 1.0), nullptr);
  EXPECT_EQ(fields.find(field, 0.5), first);
  EXPECT_TRUE(fields.find(field, 2.0));
  EXPECT_EQ(fields.make(field, 0.0, progress), nullptr);
  EXPECT_EQ(fields.make(scene::Field::trilinear, 1.0, progress), nullptr);
}

TEST(CubicFields, AKeptScaleGoesBeforeAnotherOneIsRefused) {
  CubicFields fields(ball());
  base::Progress progress;
  const std::size_t before = base::machineMemory().held();
  fields.make(scene::Field::cubic, 0.5, progress);
  const test::MemoryLimit limit((base::machineMemory().held() - before) / 2);
  EXPECT_TRUE(fields.make(scene::Field::cubic, 1.0, progress));
  EXPECT_EQ(fields.find(scene::Field::cubic, 0.5), nullptr);
}

TEST(CubicFields, ScalesOfASceneAreMadeWhereALookReadsThem) {
  CubicFields fields(ball());
  base::Progress progress;
  scene::Scene scene;
  scene.hit.field = scene::Field::trilinear;
  scene.derivatives.scale = 1.0;
  scene.derivatives.normalScale = 0.0;
  scene.look.mode = scene::LookMode::blinn_phong;
  EXPECT_TRUE(fields.readyFor(scene));  // no curvature is read
  scene.look.mode = scene::LookMode::mean_curvature;
  EXPECT_FALSE(fields.readyFor(scene));
  fields.makeFor(scene, progress);
  EXPECT_TRUE(fields.readyFor(scene));
  EXPECT_TRUE(fields.find(scene::Field::cubic, 1.0));
  scene.derivatives.normalScale = 0.5;
  EXPECT_FALSE(fields.readyFor(scene));
  fields.makeFor(scene, progress);
  EXPECT_TRUE(fields.find(scene::Field::cubic, 0.5));
  EXPECT_TRUE(fields.readyFor(scene));
  scene.derivatives.field = scene::Field::cubic_interpolating;  // only at scales: no other coefficients
  fields.makeFor(scene, progress);
  EXPECT_FALSE(fields.find(scene::Field::cubic_interpolating));
  EXPECT_TRUE(fields.readyFor(scene));
}

TEST(CubicFields, AStoppedOneIsNotKept) {
  CubicFields fields(ball());
  base::Progress stopped, progress;
  stopped.requestStop();
  EXPECT_THROW(fields.make(scene::Field::cubic_interpolating, stopped), base::Error);
  EXPECT_FALSE(fields.find(scene::Field::cubic_interpolating));
  EXPECT_TRUE(fields.make(scene::Field::cubic_interpolating, progress));
}

TEST(CubicFields, ThreadsThatAskAtOnceGetTheSame) {
  CubicFields fields(ball());
  std::shared_ptr<const CubicField> found[2];
  std::thread threads[2];
  for (int i = 0; i < 2; ++i)
    threads[i] = std::thread([&, i] {
      base::Progress progress;
      found[i] = fields.make(scene::Field::cubic_interpolating, progress);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(found[0]);
  EXPECT_EQ(found[0], found[1]);
}

}  // namespace
}  // namespace isolux::volume
