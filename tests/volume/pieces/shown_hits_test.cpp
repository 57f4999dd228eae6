#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/hidden_balls.h"
#include "tests/support/rays.h"
#include "volume/derived/cubic_fields.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/hit/exact_hit.h"
#include "volume/hit/shown_cells.h"

namespace isolux::volume {
namespace {

constexpr std::uint64_t kRays = 40000;

// A field of a grid with all it needs to be hit.
class Hits {
 public:
  Hits(const Grid& grid, scene::Field field) : field_(field), grid_(std::make_shared<Grid>(grid)) {
    base::Progress progress;
    cubic_ = CubicFields(grid_).make(field, progress);
    blocks_ = std::make_unique<MinMaxBlocks>(*grid_, 8, progress);
  }
  std::optional<RayHit> operator()(const Ray& ray, const HiddenPieces& hidden = {}) const {
    return firstHitOfField(*grid_, field_, cubic_ ? cubic_->coefficients.get() : nullptr,
                           cubic_ ? cubic_->blocks : *blocks_, 0.0, ray, hidden)
        .hit;
  }

 private:
  scene::Field field_;
  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const CubicField> cubic_;
  std::unique_ptr<const MinMaxBlocks> blocks_;
};

// The same bits.
bool same(const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->t == b->t && a->voxel == b->voxel && a->entering == b->entering));
}

TEST(ShownHits, AreThoseOfAVolumeWithoutTheHiddenBalls) {
  for (const scene::Field field : {scene::Field::trilinear, scene::Field::cubic})
    for (const double sign : {1.0, -1.0}) {
      const Hits all(test::gridOfBalls(test::pieceBalls(), true, sign), field),
          shown(test::gridOfBalls(test::pieceBalls(), false, sign), field);
      const VoxelMask voxels = test::hiddenOfBalls(test::pieceBalls());
      const HiddenPieces hidden{&voxels, sign > 0.0 ? scene::Inside::above : scene::Inside::below};
      int passed = 0;
      for (std::uint64_t i = 0; i < kRays; ++i) {
        const Ray ray = test::randomRay(i, voxels.dims());
        const auto expected = shown(ray);
        ASSERT_TRUE(same(all(ray, hidden), expected)) << i;
        passed += !same(all(ray), expected);
      }
      EXPECT_GT(passed, 4000);  // hidden balls were in the way
    }
}

// An interpolating spline of the balls' kinks rings through the volume: only where it falls off.
TEST(ShownHits, OfTheInterpolatingSplineLieWhereTheyWouldWithoutTheHiddenBalls) {
  const Hits all(test::gridOfBalls(test::pieceBalls(), true), scene::Field::cubic_interpolating),
      shown(test::gridOfBalls(test::pieceBalls(), false), scene::Field::cubic_interpolating);
  const VoxelMask voxels = test::hiddenOfBalls(test::pieceBalls());
  int different = 0;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const Ray ray = test::randomRay(i, voxels.dims());
    const auto hit = all(ray, {&voxels}), expected = shown(ray);
    different +=
        hit.has_value() != expected.has_value() || (hit && glm::distance(hit->voxel, expected->voxel) > 0.01);
  }
  EXPECT_LT(different, static_cast<int>(kRays) / 2000);  // rays that graze
}

// Cells with corners of both pieces: the first crossing of the whole surface that is of the shown piece.
TEST(ShownHits, InCellsOfTwoPiecesAreOfTheShownOne) {
  for (const double sign : {1.0, -1.0}) {
    const Grid grid = test::SplitCells::grid(sign);
    const Hits hits(grid, scene::Field::trilinear);
    const VoxelMask voxels = test::SplitCells::hidden();
    const HiddenPieces hidden{&voxels, sign > 0.0 ? scene::Inside::above : scene::Inside::below};
    int mixed = 0, compared = 0;
    for (std::uint64_t i = 0; i < kRays; ++i) {
      Ray ray = test::randomRay(i, grid.dims());
      if (i % 8 >= 3) continue;  // those within planes of voxels have crossings that rounding decides
      const auto hit = hits(ray, hidden);
      std::optional<RayHit> expected = hits(ray);
      bool passed = false;
      while (expected && !test::SplitCells::shows(expected->voxel)) {
        passed = true;
        ray.tMinimum = expected->t + 1e-9 / glm::length(ray.direction);
        expected = hits(ray);
      }
      ++compared;
      ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
      if (!hit) continue;
      ASSERT_LT(glm::distance(hit->voxel, expected->voxel), 1e-9) << i;
      EXPECT_EQ(hit->entering, expected->entering) << i;
      mixed += passed;
    }
    EXPECT_GT(compared, 10000);
    EXPECT_GT(mixed, 1000);
  }
}

// Two pieces in one block, a plane of missing voxels between them: the side before the gap says nothing of
// that behind it.
TEST(ShownHits, BehindAGapWithinABlockTheSideIsThatOfTheOtherPiece) {
  const glm::ivec3 dims(20, 9, 9);
  VoxelMask voxels(dims);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y) voxels.hide(0, 3, y, z);
  const Ray ray{{-5.0, 4.25, 4.5}, {1.0, 0.0, 0.0}};
  for (const double sign : {1.0, -1.0}) {
    const Grid grid = test::gridOfVoxels(test::unitGeometry(dims), [&](glm::dvec3 p) {
      return p.x == 3.0 ? std::nan("") : p.x < 12.0 ? sign : -sign;
    });
    for (const scene::Field field : {scene::Field::trilinear, scene::Field::cubic}) {
      const auto hit =
          Hits(grid, field)(ray, {&voxels, sign > 0.0 ? scene::Inside::above : scene::Inside::below});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->voxel.x, 11.5, 1e-12);
    }
  }
}

TEST(ShownCells, AscendToTheCornerOfThePiece) {
  const Grid grid = test::SplitCells::grid();
  const VoxelMask voxels = test::SplitCells::hidden();
  const ShownCells cells(grid, &voxels, 0.0, scene::Inside::above);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const glm::dvec3 point = test::randomPoint(i, {12.0, 12.0, 0.0}, {19.0, 19.0, 23.0});
    const glm::dvec3 cell = glm::floor(point);
    if (cell.x + cell.y + 1 != test::SplitCells::k) continue;
    const glm::dvec3 part = point - cell;
    // Bilinear with 0.4 at two corners across, -0.6 at the others.
    const double value = 0.4 - part.x - part.y + 2.0 * part.x * part.y;
    if (value <= 0.0) continue;
    EXPECT_EQ(cells.hiddenAt(point), !test::SplitCells::shows(point)) << i;
  }
}

}  // namespace
}  // namespace isolux::volume
