// Area and volume of solids of known size: within the stated error, and that not much larger than the true
// one.
#include "volume/measure/surface_measure.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/line_area.h"
#include "tests/support/volumes.h"
#include "tests/volume/measure/shapes.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

using volume::Measured;
using volume::SurfaceMeasure;
using volume::SurfaceQuestion;

SurfaceMeasure measured(const volume::Grid& grid, const SurfaceQuestion& question = {}) {
  base::Progress progress;
  return measureSurface(grid, volume::MinMaxBlocks(grid, 8, progress), question, progress);
}

// The stated error covers the true one, and is at most ten times as large.
void expectHonest(const Measured& measure, double reference, const std::string& what) {
  const double error = std::abs(measure.value - reference);
  EXPECT_LE(error, measure.error) << what << ": " << measure.value << " for " << reference;
  EXPECT_LE(measure.error, 10.0 * error) << what << ": " << measure.value << " for " << reference;
}

void expectHonestSolids(const volume::GridGeometry& geometry, const std::string& where) {
  for (const KnownSolid& solid : knownSolids(geometry)) {
    const SurfaceMeasure surface = measured(gridOfWorld(geometry, solid.field));
    const std::string what = solid.name + " " + where + " " + std::to_string(geometry.dims.x);
    EXPECT_FALSE(surface.open()) << what;
    expectHonest(surface.volumeMm3, solid.volume, what + " volume");
    expectHonest(surface.areaMm2, solid.area, what + " area");
  }
}

TEST(SurfaceMeasureTest, SolidsAreWithinWhatIsStated) {
  for (const int size : {64, 128, 256}) expectHonestSolids(isotropicGeometry(size), "isotropic");
}

TEST(SurfaceMeasureTest, SolidsInLeaningGridsAreWithinWhatIsStated) {
  for (const int size : {64, 128, 256}) {
    expectHonestSolids(obliqueLeftHandedGeometry(size), "oblique");
    expectHonestSolids(thickObliqueSlices(size), "thick slices");
  }
}

// A cubic cell of the level set sin x cos y + ... = 0 has nearly the area of the minimal surface that it is
// near to, 3.0915 times that of its face (Jung, Chu & Torquato 2007), and half the volume.
TEST(SurfaceMeasureTest, AGyroidCellHasItsKnownArea) {
  constexpr double period = 10.0;
  for (const int size : {65, 129}) {
    const auto geometry = volume::GridGeometry::make(glm::ivec3(size), glm::dvec3(2.0 * period / (size - 1)));
    const volume::Grid grid = gridOfWorld(geometry, [](glm::dvec3 p) {
      const glm::dvec3 q = p * (2.0 * std::numbers::pi / period);
      return std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) + std::sin(q.z) * std::cos(q.x);
    });
    const SurfaceMeasure surface = measured(grid);
    EXPECT_TRUE(surface.open());
    EXPECT_NEAR(surface.volumeMm3.value, 4.0 * period * period * period, surface.volumeMm3.error);
    EXPECT_NEAR(surface.areaMm2.value, 8.0 * 3.0915 * period * period, 0.005 * surface.areaMm2.value);
    const SurfaceMeasure cell =
        measured(grid, {.box = volume::WorldBox{glm::dvec3(0.5 * period), glm::dvec3(1.5 * period)}});
    EXPECT_NEAR(8.0 * cell.areaMm2.value, surface.areaMm2.value, 8.0 * cell.areaMm2.error);
    EXPECT_NEAR(8.0 * cell.volumeMm3.value, surface.volumeMm3.value, 8.0 * cell.volumeMm3.error);
  }
}

// Cauchy and Crofton: lines at random meet the surface in proportion to its area. Counts exact hits.
TEST(SurfaceMeasureTest, AreaAgreesWithLinesAtRandom) {
  for (const char* name : {"gyroid", "head", "noise"}) {
    const bool head = std::string(name) == "head";
    const volume::Grid grid = phantomGrid(name, head ? 64 : 40);
    const double isovalue = head ? 300.0 : 0.1;
    const SurfaceMeasure surface = measured(grid, {.isovalue = isovalue});
    const LineArea lines = areaByLines(grid, isovalue, 40000);
    EXPECT_NEAR(surface.areaMm2.value, lines.areaMm2, 4.0 * lines.deviationMm2) << name;
    EXPECT_LT(lines.deviationMm2, 0.02 * lines.areaMm2) << name;
  }
}

// Every fifth slice of a grid.
volume::Grid everyFifthSlice(const volume::Grid& grid) {
  volume::GridGeometry geometry = grid.geometry();
  geometry.dims.z = (geometry.dims.z + 4) / 5;
  geometry.worldFromVoxel[2] *= 5.0;
  return gridOfVoxels(geometry, [&](glm::dvec3 p) {
    const glm::ivec3 voxel(p);
    return grid.value(voxel.x, voxel.y, 5 * voxel.z);
  });
}

// Resampled to slices of 5 mm, measures differ by no more than both state.
TEST(SurfaceMeasureTest, ThickSlicesKeepWhatTheyState) {
  const auto geometry = volume::GridGeometry::make({161, 161, 161}, glm::dvec3(1.25), glm::dvec3(-100.0));
  for (const auto& [name, isovalue] : {std::pair("ball", 0.0), std::pair("torus", 0.0),
                                       std::pair("head", 300.0), std::pair("head", -300.0)}) {
    const volume::Grid grid = phantomGrid(name, geometry);
    const SurfaceMeasure fine = measured(grid, {.isovalue = isovalue}),
                         thick = measured(everyFifthSlice(grid), {.isovalue = isovalue});
    EXPECT_NEAR(fine.volumeMm3.value, thick.volumeMm3.value, fine.volumeMm3.error + thick.volumeMm3.error)
        << name << isovalue;
    EXPECT_NEAR(fine.areaMm2.value, thick.areaMm2.value, fine.areaMm2.error + thick.areaMm2.error)
        << name << isovalue;
    EXPECT_GT(thick.volumeMm3.error, fine.volumeMm3.error) << name << isovalue;
  }
}

TEST(SurfaceMeasureTest, BoxesAddUp) {
  const volume::GridGeometry geometry = thickObliqueSlices(64);
  for (const volume::GridGeometry& grid : {isotropicGeometry(48), geometry}) {
    const KnownSolid ball = knownSolids(grid)[0];
    const volume::Grid voxels = gridOfWorld(grid, ball.field);
    const SurfaceMeasure whole = measured(voxels);
    const glm::dvec3 c = SolidPlace(grid).centre, far(1000.0);
    double volume = 0.0, area = 0.0, volumeCut = 0.0, areaCut = 0.0;
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 low = c - far, high = c + far;
      (side < 0.0 ? high : low).x = c.x + 0.37;
      const SurfaceMeasure half = measured(voxels, {.box = volume::WorldBox{low, high}});
      volume += half.volumeMm3.value;
      area += half.areaMm2.value;
      volumeCut += half.volumeParts.cut + half.volumeParts.quadrature;
      areaCut += half.areaParts.cut + half.areaParts.quadrature;
    }
    EXPECT_NEAR(volume, whole.volumeMm3.value, volumeCut + 1e-9 * volume);
    EXPECT_NEAR(area, whole.areaMm2.value, areaCut + whole.areaParts.quadrature + 1e-9 * area);
  }
}

// Counting samples inside, 512 in each cell.
TEST(SurfaceMeasureTest, VolumeAgreesWithDenseSamples) {
  for (const char* name : {"noise", "head"}) {
    const volume::Grid grid = phantomGrid(name, 24);
    const double isovalue = std::string(name) == "head" ? 300.0 : 0.1;
    const SurfaceMeasure surface = measured(grid, {.isovalue = isovalue});
    constexpr int samples = 8;
    std::size_t inside = 0;
    const glm::ivec3 counts = (grid.dims() - 1) * samples;
    for (int z = 0; z < counts.z; ++z)
      for (int y = 0; y < counts.y; ++y)
        for (int x = 0; x < counts.x; ++x) {
          const glm::dvec3 at = (glm::dvec3(x, y, z) + 0.5) / static_cast<double>(samples);
          inside += volume::sampleTrilinear(grid, at).value >= isovalue;
        }
    const glm::dvec3 spacing = grid.geometry().spacingMm();
    const double cell = spacing.x * spacing.y * spacing.z;
    const double counted = static_cast<double>(inside) * cell / std::pow(samples, 3);
    // Walls along the axes, the worst, leave a cell's count off by 1/8 / sqrt(12) of it, by chance.
    const double chance = std::sqrt(static_cast<double>(surface.cells) / 12.0) / samples * cell;
    EXPECT_NEAR(surface.volumeMm3.value, counted, 3.0 * chance) << name;
    EXPECT_LT(chance, 2e-3 * counted) << name;
  }
}

TEST(SurfaceMeasureTest, TheChangeOfVolumeIsThatOfAnotherIsovalue) {
  const volume::Grid grid = phantomGrid("head", 64);
  const double change = measured(grid, {.isovalue = 290.0}).volumeMm3.value -
                        measured(grid, {.isovalue = 310.0}).volumeMm3.value;
  EXPECT_NEAR(20.0 * measured(grid, {.isovalue = 300.0}).volumePerValue, change, 0.02 * change);
}

TEST(SurfaceMeasureTest, InsideAndOutsideFillTheVolume) {
  const volume::Grid grid = phantomGrid("gyroid", 33);
  const SurfaceMeasure above = measured(grid, {.isovalue = 0.3}),
                       below = measured(grid, {.isovalue = 0.3, .inside = scene::Inside::below});
  const glm::dvec3 size = glm::dvec3(grid.dims() - 1) * grid.geometry().spacingMm();
  EXPECT_NEAR(above.volumeMm3.value + below.volumeMm3.value, size.x * size.y * size.z,
              above.volumeParts.quadrature + below.volumeParts.quadrature);
  EXPECT_NEAR(above.areaMm2.value, below.areaMm2.value,
              above.areaParts.quadrature + below.areaParts.quadrature);
}

// Noisy copies: the spread of their volumes is what is stated.
TEST(SurfaceMeasureTest, NoiseOfTheVolumeIsItsSpread) {
  const volume::Grid ball = phantomGrid("ball", 24);
  scene::NoiseModel noise{{0.0}, {0.3}, glm::dvec3(0.0)};
  double sum = 0.0, squares = 0.0, stated = 0.0;
  constexpr int copies = 60;
  for (int i = 0; i < copies; ++i) {
    const volume::Grid noisy = withNoise(ball, 0.3, glm::dvec3(0.0), static_cast<std::uint64_t>(i + 1));
    const SurfaceMeasure surface = measured(noisy, {.noise = noise});
    sum += surface.volumeMm3.value;
    squares += surface.volumeMm3.value * surface.volumeMm3.value;
    stated += surface.volumeParts.noise / copies;
  }
  const double deviation = std::sqrt(squares / copies - sum * sum / (copies * copies));
  EXPECT_GT(stated, 1.3 * deviation);  // two deviations
  EXPECT_LT(stated, 3.5 * deviation);
}

TEST(SurfaceMeasureTest, SaysWhetherTheSurfaceIsOpen) {
  const volume::Grid closed = phantomGrid("ball", 24), open = phantomGrid("cylinder", 24);
  EXPECT_FALSE(measured(closed).open());
  EXPECT_TRUE(measured(open).meetsBorder);
  EXPECT_FALSE(measured(open).meetsMissing);
  const double missing = std::numeric_limits<double>::quiet_NaN();
  const volume::Grid gap = gridOfVoxels(unitGeometry(glm::ivec3(24)), [&](glm::dvec3 p) {
    return p == glm::dvec3(12.0) ? missing : 8.0 - glm::length(p - 11.5);
  });
  EXPECT_TRUE(measured(gap).meetsMissing);
  EXPECT_FALSE(measured(gap).meetsBorder);
}

TEST(SurfaceMeasureTest, EmptyFullAndOddVolumes) {
  const volume::Grid grid = phantomGrid("ball", 16);
  EXPECT_EQ(measured(grid, {.isovalue = 1000.0}).volumeMm3.value, 0.0);
  EXPECT_EQ(measured(grid, {.isovalue = 1000.0}).cells, 0u);
  const SurfaceMeasure full = measured(grid, {.isovalue = -1000.0});
  const glm::dvec3 size = glm::dvec3(grid.dims() - 1) * grid.geometry().spacingMm();
  EXPECT_NEAR(full.volumeMm3.value, size.x * size.y * size.z, 1e-9);
  EXPECT_EQ(full.areaMm2.value, 0.0);
  EXPECT_EQ(measured(phantomGrid("plane", glm::ivec3(8, 8, 1))).areaMm2.value, 0.0);
  EXPECT_EQ(measured(grid, {.isovalue = std::numeric_limits<double>::quiet_NaN()}).areaMm2.value, 0.0);
  const SurfaceMeasure thin = measured(phantomGrid("plane", glm::ivec3(8, 8, 2)));
  EXPECT_TRUE(std::isfinite(thin.areaMm2.value) && std::isfinite(thin.areaMm2.error));
}

TEST(SurfaceMeasureTest, OnlyCellsThatAreKept) {
  const volume::Grid grid = phantomGrid("gyroid", 24);
  const SurfaceMeasure whole = measured(grid);
  double volume = 0.0;
  for (const int parity : {0, 1}) {
    SurfaceQuestion question;
    question.keeps = [&](glm::ivec3 cell) { return (cell.x + cell.y + cell.z) % 2 == parity; };
    volume += measured(grid, question).volumeMm3.value;
  }
  EXPECT_NEAR(volume, whole.volumeMm3.value, 1e-9 * volume);
}

// A cube of 4^3 ones in zeros. As the isovalue goes to 0 the surface comes to hug the faces of the cube that
// is above 0: area 150, and 604 of 729 mm^3 are at most 0. Areas on the way by marching cubes on a grid
// graded to 1e-9 toward the faces.
TEST(SurfaceMeasureTest, AMaskIsMeasuredAtAndNextToItsValues) {
  const auto mask = [](double within, double around) {
    return gridOfVoxels(unitGeometry(glm::ivec3(10)), [=](glm::dvec3 p) {
      return glm::all(glm::greaterThan(p, glm::dvec3(2.5))) && glm::all(glm::lessThan(p, glm::dvec3(6.5)))
                 ? within
                 : around;
    });
  };
  struct Case {
    double isovalue, area;
  };
  for (const Case& c : {Case{1e-3, 146.08}, {1e-4, 148.70}, {1e-5, 149.58}, {1e-6, 149.86}, {0.0, 150.0}}) {
    for (const bool inverse : {false, true}) {
      const SurfaceMeasure surface =
          inverse ? measured(mask(0.0, 1.0), {.isovalue = 1.0 - c.isovalue})
                  : measured(mask(1.0, 0.0), {.isovalue = c.isovalue, .inside = scene::Inside::below});
      EXPECT_NEAR(surface.areaMm2.value, c.area, 0.02 + 3.0 * surface.areaParts.quadrature) << c.isovalue;
      EXPECT_LT(surface.areaParts.quadrature, 1.0) << c.isovalue;
      EXPECT_NEAR(surface.volumeMm3.value, 604.0, 0.01 + 125.0 * 20.0 * c.isovalue) << c.isovalue;
    }
  }
}

TEST(SurfaceMeasureTest, SaysWhyThereIsNoSurface) {
  EXPECT_EQ(volume::whyNoSurface(phantomGrid("plane", glm::ivec3(8, 8, 1))),
            "no surface: the volume has only one voxel along an axis");
  EXPECT_EQ(volume::whyNoSurface(
                gridOfVoxels(unitGeometry(glm::ivec3(4)), [](glm::dvec3) { return std::nan(""); })),
            "no surface: all voxels are missing");
  EXPECT_EQ(volume::whyNoSurface(gridOfVoxels(unitGeometry(glm::ivec3(4)), [](glm::dvec3 p) { return p.x; })),
            "no surface; the data range is 0 to 3");
}

}  // namespace
}  // namespace isolux::test
