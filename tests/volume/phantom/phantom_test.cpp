#include "volume/phantom/phantom.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <tbb/task_arena.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"

namespace isolux::volume {
namespace {

using test::phantomGrid;

const char* const kClosedForms[] = {"ball",   "torus",  "cylinder",      "plane",
                                    "saddle", "gyroid", "marschner_lobb"};

TEST(Phantom, ClosedFormsAreSampledInTheWorldWhateverTheGeometry) {
  for (const char* name : kClosedForms) {
    for (const GridGeometry& geometry :
         {test::isotropicGeometry(21), test::anisotropicGeometry(20), test::obliqueLeftHandedGeometry(17)}) {
      const Grid grid = phantomGrid(name, geometry);
      const auto field = test::analyticField(name, geometry);
      for (int z = 0; z < grid.dims().z; z += 3)
        for (int y = 0; y < grid.dims().y; y += 2)
          for (int x = 0; x < grid.dims().x; ++x) {
            const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(x, y, z, 1));
            const double expected = field->at(world).value;
            if (std::isnan(expected)) continue;
            ASSERT_NEAR(grid.value(x, y, z), expected, 1e-6 * (1.0 + std::abs(expected))) << name;
          }
    }
  }
}

TEST(Phantom, ClosedFormDerivativesAgreeWithDifferences) {
  for (const char* name : kClosedForms) {
    const auto field = test::analyticField(name, test::isotropicGeometry(128));
    for (std::uint64_t i = 0; i < 50; ++i) {
      const glm::dvec3 p = glm::dvec3(5, -7, 11) + 90.0 * glm::dvec3(base::uniformNoise(1, i) - 0.5,
                                                                     base::uniformNoise(2, i) - 0.5,
                                                                     base::uniformNoise(3, i) - 0.5);
      const test::Derivatives exact = field->at(p);
      const auto value = [&](glm::dvec3 q) { return field->at(q).value; };
      const test::Derivatives numeric = test::differences(value, p, 1e-3);
      EXPECT_LT(glm::length(exact.gradient - numeric.gradient), 1e-4) << name;
      for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(exact.hessian[c] - numeric.hessian[c]), 1e-4) << name;
      const test::Curvature direct = field->curvature(p), general = test::curvatureOf(exact);
      EXPECT_NEAR(direct.kappa1, general.kappa1, 1e-7) << name;
      EXPECT_NEAR(direct.kappa2, general.kappa2, 1e-7) << name;
      EXPECT_GE(direct.kappa1, direct.kappa2);
    }
  }
}

TEST(Phantom, ClosedFormHitsLieOnTheSurface) {
  for (const char* name : kClosedForms) {
    const GridGeometry geometry = test::isotropicGeometry(64);
    const auto field = test::analyticField(name, geometry);
    const double iso = std::string(name) == "marschner_lobb" ? 0.5 : 0.0;
    int hits = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      const glm::dvec3 origin(5 + 200 * (base::uniformNoise(1, i) - 0.5),
                              -7 + 200 * (base::uniformNoise(2, i) - 0.5), 111);
      const glm::dvec3 target =
          glm::dvec3(5, -7, 11) +
          30.0 * glm::dvec3(base::uniformNoise(3, i) - 0.5, base::uniformNoise(4, i) - 0.5, 0.0);
      const glm::dvec3 direction = glm::normalize(target - origin);
      const auto t = field->firstHit(origin, direction, iso);
      if (!t) continue;
      ++hits;
      const test::Derivatives at = field->at(origin + *t * direction);
      EXPECT_NEAR(at.value, iso, 1e-8 * (1.0 + glm::length(at.gradient))) << name;
      // Nothing before it.
      const bool side = field->at(origin).value >= iso;
      for (double s = 0.01; s < 0.999; s += 0.01)
        EXPECT_EQ(field->at(origin + s * *t * direction).value >= iso, side) << name << " at " << s;
    }
    EXPECT_GT(hits, 50) << name;
  }
}

TEST(Phantom, BallHasItsRadiusInMillimetresUnderAnyAffine) {
  for (const GridGeometry& geometry : {test::anisotropicGeometry(64), test::obliqueLeftHandedGeometry(64)}) {
    const glm::dvec3 spacing = geometry.spacingMm();
    const double edge = 63.0 * std::min({spacing.x, spacing.y, spacing.z});
    EXPECT_NEAR(phantomGrid("ball", geometry).maximum(), 0.35 * edge, 0.6 * glm::length(spacing));
  }
}

TEST(Phantom, DefaultGeometryIsMillimetresRoundTheOrigin) {
  const Grid grid = phantomGrid("ball", 33);
  EXPECT_EQ(grid.dims(), glm::ivec3(33));
  EXPECT_EQ(grid.geometry().spacingMm(), glm::dvec3(1));
  EXPECT_EQ(grid.geometry().originMm(), glm::dvec3(-16));
  EXPECT_FLOAT_EQ(static_cast<float>(grid.value(16, 16, 16)), 0.35f * 32.0f);
}

TEST(Phantom, TwoBallsTouchWhereTheGradientVanishes) {
  const Grid grid = phantomGrid("two_balls", 101);  // e = 100, R = 20, contact in the middle voxel
  EXPECT_EQ(grid.value(50, 50, 50), 0.0);
  EXPECT_NEAR(grid.value(51, 50, 50), grid.value(49, 50, 50), 1e-6);
  EXPECT_GT(grid.value(60, 50, 50), 0.0);
  EXPECT_GT(grid.value(40, 50, 50), 0.0);
  EXPECT_LT(grid.value(50, 55, 50), 0.0);
  EXPECT_NEAR(grid.value(90, 50, 50), 0.0, 1e-6);  // the far pole of one ball
}

TEST(Phantom, SheetsAreAsThickAsTheirGapsAndEndAtHalfABall) {
  // e = 127, R = 50.8, a sheet every 4 voxels across (2, 14, -5) / 15; the middle lies between voxels.
  const Grid grid = phantomGrid("sheets", 128);
  const auto across = [](int x, int y, int z) {
    return (2 * (x - 63.5) + 14 * (y - 63.5) - 5 * (z - 63.5)) / 15.0;
  };
  EXPECT_NEAR(across(64, 81, 64), 16.0 + 7.0 / 30.0, 1e-9);  // near the middle of the fourth sheet
  EXPECT_NEAR(grid.value(64, 81, 64), 23.0 / 30.0, 1e-5);
  EXPECT_NEAR(grid.value(64 + 10, 81, 64 + 4), 23.0 / 30.0, 1e-5);  // along it
  EXPECT_NEAR(grid.value(64, 81 + 30, 64), 23.0 / 30.0, 1e-5);      // seven sheets on
  EXPECT_NEAR(grid.value(64, 83, 64), -0.9, 1e-5);                  // in the gap
  EXPECT_NEAR(grid.value(64, 60, 64), -3.5, 1e-6);                  // before the cut
  EXPECT_LT(grid.value(64, 120, 64), -5.0);                         // outside the ball
  int inside = 0, all = 0;
  for (int z = 50; z < 80; ++z)
    for (int y = 66; y < 90; ++y)
      for (int x = 50; x < 80; ++x, ++all) inside += grid.value(x, y, z) >= 0.0;
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.5, 0.03);
}

TEST(Phantom, WiresFallOffFromRings) {
  // e = 127; the axes of two rings lean by 40 degrees toward x and away from it, so that y lies in their
  // planes.
  const Grid grid = phantomGrid("wires", 128);
  const double width = 0.6, radius = 38.1, lean = 40.0 / 180.0 * std::numbers::pi;
  for (const int y : {100, 101, 102, 103}) {
    // The middle lies between voxels: x and z are half a voxel off it.
    double expected = 0.0;
    for (const double side : {-1.0, 1.0}) {
      const double along = 0.5 * side * std::sin(lean) + 0.5 * std::cos(lean), q = y - 63.5;
      const double distance = std::hypot(along, std::sqrt(0.5 + q * q - along * along) - radius);
      expected = std::max(expected, 1000.0 * std::exp(-0.5 * distance * distance / (width * width)));
    }
    EXPECT_NEAR(grid.value(64, y, 64), expected, 1e-3) << y;
  }
  EXPECT_LT(grid.value(64, 64, 64), 1e-6);
}

TEST(Phantom, SheetIsThinnerThanAVoxelOnItsLayer) {
  for (const GridGeometry& geometry : {test::isotropicGeometry(16), test::obliqueLeftHandedGeometry(15)}) {
    const Grid grid = phantomGrid("sheet", geometry);
    const double spacing = geometry.spacingMm().z;
    EXPECT_NEAR(grid.value(3, 9, 7), 0.15 * spacing, 1e-6);
    EXPECT_NEAR(grid.value(3, 9, 8), -0.85 * spacing, 1e-6);
    EXPECT_NEAR(grid.value(12, 1, 6), -0.85 * spacing, 1e-6);
  }
}

TEST(Phantom, NoiseHasTheRequestedSpreadAndNoBias) {
  const Grid clean = phantomGrid("plane", 48);
  const Grid noisy = phantomGrid("plane", 48, 3.0);
  double sum = 0.0, squares = 0.0;
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const double d = noisy.value(x, y, z) - clean.value(x, y, z);
        sum += d;
        squares += d * d;
      }
  const double n = 48.0 * 48.0 * 48.0;
  EXPECT_NEAR(sum / n, 0.0, 5.0 * 3.0 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 3.0, 0.05);
}

TEST(Phantom, SameVoxelsForAnyNumberOfThreads) {
  for (const PhantomInfo& info : phantoms()) {
    tbb::task_arena single(1);
    std::uint64_t one = 0;
    single.execute([&] { one = phantomGrid(std::string(info.name), 24, 0.1).hash(); });
    EXPECT_EQ(one, phantomGrid(std::string(info.name), 24, 0.1).hash()) << info.name;
  }
}

TEST(Phantom, EveryOneHasASurfaceAtItsIsovalueAndSmallSizesWork) {
  for (const PhantomInfo& info : phantoms()) {
    const Grid grid = phantomGrid(std::string(info.name), 40);
    EXPECT_LT(grid.minimum(), info.isovalue) << info.name;
    EXPECT_GT(grid.maximum(), info.isovalue) << info.name;
    EXPECT_EQ(grid.missingCount(), 0u);
    for (const int size : {2, 3})
      EXPECT_EQ(phantomGrid(std::string(info.name), size).dims(), glm::ivec3(size));
    phantomGrid(std::string(info.name), GridGeometry::make({7, 1, 3}, {0.4, 0.4, 5.0}));
  }
}

// Symmetric but for the bead, which marks the patient's left (+x).
TEST(Phantom, HeadIsSymmetricButForTheBeadOnTheLeftEar) {
  const Grid head = phantomGrid("head", 96);
  EXPECT_EQ(head.storedType(), VoxelType::int16);
  const glm::dmat4 world = head.geometry().worldFromVoxel;
  int different = 0;
  glm::dvec3 where(0.0);
  for (int z = 0; z < 96; ++z)
    for (int y = 0; y < 96; ++y)
      for (int x = 48; x < 96; ++x) {
        const double left = head.value(x, y, z), right = head.value(95 - x, y, z);
        if (std::abs(left - right) <= 1.0) continue;
        EXPECT_GT(left, right);
        where += glm::dvec3(world * glm::dvec4(x, y, z, 1));
        ++different;
      }
  ASSERT_GT(different, 0);
  EXPECT_LT(different, 200);
  where /= different;
  EXPECT_GT(where.x, 70.0);
}

TEST(Phantom, HeadHoldsItsTissuesWhereTheyBelong) {
  const Grid head = phantomGrid("head", 192);
  const glm::dmat4 inverse = head.geometry().voxelFromWorld();
  const auto at = [&](double x, double y, double z) {
    const glm::ivec3 v(glm::round(glm::dvec3(inverse * glm::dvec4(x, y, z, 1))));
    return head.value(v.x, v.y, v.z);
  };
  EXPECT_NEAR(at(0, 20, 75), 36.0, 4.0);    // brain
  EXPECT_NEAR(at(32, -76, 13), 18.0, 4.0);  // eye
  EXPECT_GT(at(0, 12, 109.5), 500.0);       // vault
  EXPECT_GT(at(4.3, -95, -49), 1800.0);     // incisor
  EXPECT_GT(at(0, 13, -87), 500.0);         // vertebra
  EXPECT_LT(at(0, -28, -55), -900.0);       // pharynx
  EXPECT_EQ(at(0, 0, 123), -1000.0);        // above
  EXPECT_EQ(at(110, -100, 60), -1000.0);    // beside
  EXPECT_EQ(at(0, 20, -124), -1000.0);      // below the cut
  // Nothing of it touches the border: every surface is closed.
  for (int a = 0; a < 192; ++a)
    for (int b = 0; b < 192; ++b)
      for (const int side : {0, 191}) {
        ASSERT_EQ(head.value(side, a, b), -1000.0);
        ASSERT_EQ(head.value(a, side, b), -1000.0);
        ASSERT_EQ(head.value(a, b, side), -1000.0);
      }
}

TEST(Phantom, TextNamesOneAndItsSize) {
  EXPECT_EQ(parsePhantom("ball").size, 0);
  EXPECT_EQ(parsePhantom("gyroid:64").size, 64);
  EXPECT_EQ(parsePhantom("gyroid:64").name, "gyroid");
  for (const char* bad :
       {"", "balloon", "ball:", "ball:1", "ball:1025", "ball:x", "ball:64x", "ball:-5", "ball:99999999999"}) {
    try {
      parsePhantom(bad);
      ADD_FAILURE() << bad;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    }
  }
}

TEST(Phantom, StopsWhenAsked) {
  for (const char* name : {"head", "noise"}) {
    base::Progress progress;
    progress.requestStop();
    try {
      makePhantom(parsePhantom(name), progress);
      ADD_FAILURE();
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
    }
  }
}

}  // namespace
}  // namespace isolux::volume
