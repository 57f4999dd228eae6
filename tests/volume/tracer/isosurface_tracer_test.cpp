// Every test runs on every target of this machine. What is compared with the double-precision reference is
// judged so: t agrees within the voxels that the test states, and hit or miss agree, unless the reference
// itself is undecided within the rounding of float: its answer changes, or spans the tracer's, when the
// isovalue moves by 2^-19 of the range of values or the origin by 2^-22 of the volume's extent.
#include "volume/tracer/isosurface_tracer.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/first_entry.h"
#include "tests/support/memory_limit.h"
#include "tests/support/rays.h"
#include "tests/support/test_data.h"
#include "volume/field/reconstruct.h"
#include "volume/read/reader.h"
#include "volume/skip/cell_ranges.h"

namespace isolux::volume {
namespace {

using scene::Inside;
using GridPointer = std::shared_ptr<const Grid>;

constexpr float kNoEntry = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

GridPointer phantom(const std::string& name, glm::ivec3 dims) {
  return std::make_shared<const Grid>(test::phantomGrid(name, dims));
}

template <class T>
GridPointer gridOf(glm::ivec3 dims, std::vector<T> values, double slope = 1.0) {
  return std::make_shared<const Grid>(GridGeometry::make(dims, glm::dvec3(1)), VoxelArray(std::move(values)),
                                      slope, 0.0);
}

// The stored values of `grid` as T: scaled to [low, high].
template <class T>
GridPointer quantised(const Grid& grid, double low, double high, double slope = 1.0) {
  std::vector<T> values;
  const double scale = (high - low) / (grid.maximum() - grid.minimum());
  for (const float v : std::get<std::vector<float>>(grid.voxels()))
    values.push_back(static_cast<T>(
        std::is_same_v<T, float> ? low + (static_cast<double>(v) - grid.minimum()) * scale
                                 : std::round(low + (static_cast<double>(v) - grid.minimum()) * scale)));
  return gridOf(grid.dims(), values, slope);
}

class IsosurfaceTracerOn : public testing::TestWithParam<TracerTarget> {
 protected:
  IsosurfaceTracer tracer(GridPointer grid, Inside inside = Inside::above) const {
    base::Progress progress;
    return {std::move(grid), inside, progress, GetParam()};
  }
  static std::vector<float> firstOf(const IsosurfaceTracer& tracer, const std::vector<TraceRay>& rays) {
    std::vector<float> t(rays.size(), -1.0f);
    tracer.firstEntries(rays, t);
    return t;
  }
};

struct Tally {
  long rays = 0, hits = 0, wrong = 0, undecided = 0;
  double worstVoxels = 0.0;  // of the hits that agree
};

double voxelsBetween(const TraceRay& ray, double a, double b) {
  if (a == b) return 0.0;  // infinite both
  return std::abs(a - b) * glm::length(glm::dvec3(ray.direction));
}

// The least and greatest answer of the reference within the rounding of float; none is +inf.
std::pair<double, double> undecidedRange(const Grid& grid, Inside inside, const TraceRay& ray) {
  const glm::ivec3 dims = grid.dims();
  const double range = (grid.maximum() - grid.minimum()) / std::abs(grid.slope());
  const double extent = std::max({dims.x, dims.y, dims.z});
  double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
  for (int i = 0; i < 15; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    Ray moved{ray.origin, ray.direction, 0.0, static_cast<double>(ray.tMaximum)};
    double iso = static_cast<double>(ray.isovalue);
    if (i < 4)
      iso += sign * (i < 2 ? 1.0 : 0.125) * range * std::ldexp(1.0, -19);
    else if (i < 10)
      moved.origin[(i - 4) / 2] += sign * extent * std::ldexp(1.0, -22);
    else if (i < 14)
      moved.origin +=
          (test::randomVector(static_cast<std::uint64_t>(i), 9) - 0.5) * extent * std::ldexp(1.0, -21);
    const double t = firstEntry(grid, inside, iso, moved).value_or(std::numeric_limits<double>::infinity());
    least = std::min(least, t);
    greatest = std::max(greatest, t);
  }
  return {least, greatest};
}

Tally compare(const IsosurfaceTracer& tracer, Inside inside, const std::vector<TraceRay>& rays,
              double toleranceVoxels) {
  Tally tally;
  std::vector<float> t(rays.size(), -1.0f);
  std::vector<std::uint8_t> any(rays.size(), 7);
  tracer.firstEntries(rays, t);
  tracer.anyEntries(rays, any);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const TraceRay& ray = rays[i];
    const double expected = firstEntry(tracer.grid(), inside, static_cast<double>(ray.isovalue),
                                       {ray.origin, ray.direction, 0.0, static_cast<double>(ray.tMaximum)})
                                .value_or(std::numeric_limits<double>::infinity());
    ++tally.rays;
    tally.hits += std::isfinite(expected) ? 1 : 0;
    const double found = static_cast<double>(t[i]);
    const bool anyAgrees = any[i] == (std::isfinite(expected) ? 1 : 0);
    const double apart = voxelsBetween(ray, found, expected);
    if (apart <= toleranceVoxels && anyAgrees) {
      tally.worstVoxels = std::max(tally.worstVoxels, apart);
      continue;
    }
    const auto [least, greatest] = undecidedRange(tracer.grid(), inside, ray);
    const double slack = toleranceVoxels / glm::length(glm::dvec3(ray.direction));
    const bool explained = found >= least - slack && found <= greatest + slack &&
                           (anyAgrees || std::isfinite(least) != std::isfinite(greatest));
    if (explained) {
      ++tally.undecided;
    } else {
      ++tally.wrong;
      ADD_FAILURE() << "ray " << i << " from " << ray.origin.x << ", " << ray.origin.y << ", " << ray.origin.z
                    << " along " << ray.direction.x << ", " << ray.direction.y << ", " << ray.direction.z
                    << " isovalue " << ray.isovalue << ": " << found << " (any " << int{any[i]}
                    << ") instead of " << expected << ", undecided from " << least << " to " << greatest;
      if (tally.wrong > 5) break;
    }
  }
  return tally;
}

// From points in the volume with the isovalue found there, `offset` voxels along the cubic gradient outward,
// cosine distributed, as the bake does.
std::vector<TraceRay> bakeRays(const Grid& grid, Inside inside, int count, double offset,
                               std::uint64_t seed) {
  std::vector<TraceRay> rays;
  const double outward = inside == Inside::above ? -1.0 : 1.0;
  for (std::uint64_t i = 0;
       static_cast<int>(rays.size()) < count && i < 20 * static_cast<std::uint64_t>(count); ++i) {
    glm::dvec3 p = test::randomVector(i, seed) * glm::dvec3(grid.dims() - 1);
    if (i % 2 == 0) p = glm::round(p);  // a texel of the full lattice lies on a voxel
    const glm::dvec3 g = sampleCubic(grid, p).gradient;
    const double value = sampleTrilinear(grid, p).value;
    if (!(glm::length(g) > 1e-30) || !std::isfinite(value)) continue;
    const glm::dvec3 normal = outward * glm::normalize(g);
    const glm::dvec3 sphere = test::randomVector(i, seed + 1);
    const double z = 2.0 * sphere.x - 1.0, angle = 6.28318530717958647692 * sphere.y;
    const glm::dvec3 round(std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle),
                           z);
    TraceRay ray;
    ray.origin = p + offset * normal;
    ray.direction = (normal + 0.9999 * round) * (i % 3 == 0 ? 0.02 : 1.0);
    ray.isovalue = grid.storedIsovalue(value);
    if (i % 5 == 0) ray.tMaximum = static_cast<float>(10.0 * sphere.z);
    rays.push_back(ray);
  }
  return rays;
}

std::vector<TraceRay> allKindsOfRays(const Grid& grid, int count, const std::vector<float>& isovalues) {
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i) {
    const Ray ray = test::randomRay(i, grid.dims());
    rays.push_back({ray.origin, ray.direction, isovalues[(i / 8) % isovalues.size()]});
  }
  return rays;
}

TEST_P(IsosurfaceTracerOn, EntersABallWhereTheFormulaSays) {
  // f = -|p - c|^2 is not trilinear: the surface is off by at most 1/8 of the second derivatives, three axes.
  const int n = 48;
  const glm::dvec3 middle(23.4, 23.1, 22.8);
  std::vector<float> values;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const glm::dvec3 q = glm::dvec3(x, y, z) - middle;
        values.push_back(static_cast<float>(-glm::dot(q, q)));
      }
  const IsosurfaceTracer above = tracer(gridOf({n, n, n}, values));
  const IsosurfaceTracer below = tracer(gridOf({n, n, n}, values), Inside::below);
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const double radius = 4.0 + 15.0 * test::randomVector(i, 1).x;
    const glm::dvec3 from = test::randomVector(i, 2) * 47.0,
                     to = middle + (test::randomVector(i, 3) - 0.5) * 8.0;
    rays.push_back({from, to - from, static_cast<float>(-radius * radius)});
  }
  const auto t = firstOf(above, rays), tBelow = firstOf(below, rays);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const TraceRay& ray = rays[i];
    const glm::dvec3 o = glm::dvec3(ray.origin) - middle, d(ray.direction);
    const double radius = std::sqrt(-static_cast<double>(ray.isovalue));
    // Off by at most 3/4 in f, 2 radius per voxel along the normal; grazing rays are left out.
    const double slack = 0.75 / (2.0 * radius) / 0.3;
    const double a = glm::dot(d, d), b = glm::dot(o, d),
                 disc = b * b - a * (glm::dot(o, o) - radius * radius);
    if (disc < 0.1 * radius * radius * a || std::abs(glm::length(o) - radius) < 0.2) continue;
    const double in = (-b - std::sqrt(disc)) / a, out = (-b + std::sqrt(disc)) / a;
    if (in > 0.0) {
      ++hits;
      EXPECT_NEAR(static_cast<double>(t[i]) * std::sqrt(a), in * std::sqrt(a), slack);
    } else {
      EXPECT_EQ(t[i], kNoEntry);
    }
    const glm::dvec3 leaves = glm::dvec3(ray.origin) + (out + 0.5 / std::sqrt(a)) * d;
    const bool within = glm::all(glm::greaterThan(leaves, glm::dvec3(0))) &&
                        glm::all(glm::lessThan(leaves, glm::dvec3(n - 1)));
    if (out > 0.0 && within) {
      EXPECT_NEAR(static_cast<double>(tBelow[i]) * std::sqrt(a), out * std::sqrt(a), slack);
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST_P(IsosurfaceTracerOn, ARampIsEnteredExactly) {
  // f = 2 x - y + z / 2: along a ray f is linear, from any distance.
  const glm::ivec3 dims(70, 35, 21);
  std::vector<float> values;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        values.push_back(2.0f * static_cast<float>(x) - static_cast<float>(y) + 0.5f * static_cast<float>(z));
  const IsosurfaceTracer ramp = tracer(gridOf(dims, values));
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < 6000; ++i) {
    const glm::dvec3 from = test::randomVector(i, 2) * glm::dvec3(dims - 1);
    rays.push_back(
        {from, test::randomVector(i, 3) - 0.5, static_cast<float>(120.0 * test::randomVector(i, 4).x)});
  }
  const auto t = firstOf(ramp, rays);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const glm::dvec3 g(2.0, -1.0, 0.5), o(rays[i].origin), d(rays[i].direction);
    const double speed = glm::dot(g, d),
                 expected = (static_cast<double>(rays[i].isovalue) - glm::dot(g, o)) / speed;
    if (std::abs(speed) < 0.05 || std::abs(expected) < 0.01) continue;
    const glm::dvec3 at = o + expected * d;
    const glm::dvec3 border = glm::min(at, glm::dvec3(dims - 1) - at);
    const double inside = std::min({border.x, border.y, border.z});
    if (std::abs(inside) < 1e-3) continue;
    if (speed > 0.0 && expected > 0.0 && inside > 0.0) {
      ++hits;
      EXPECT_NEAR(static_cast<double>(t[i]), expected, 2e-4);
    } else {
      EXPECT_EQ(t[i], kNoEntry);
    }
  }
  EXPECT_GT(hits, 300);
}

TEST_P(IsosurfaceTracerOn, AgreesWithTheReferenceOnRaysOfTheBake) {
  struct Case {
    const char* name;
    glm::ivec3 dims;
    double toleranceVoxels;
  };
  const Case cases[] = {
      {"noise", {40, 37, 30}, 3e-3}, {"gyroid", {64, 50, 47}, 3e-4}, {"sheet", {30, 31, 32}, 3e-4}};
  for (const Case& c : cases) {
    const GridPointer grid = phantom(c.name, c.dims);
    for (const Inside inside : {Inside::above, Inside::below}) {
      const IsosurfaceTracer subject = tracer(grid, inside);
      // At offset 0 a ray begins on the surface, where rounding decides the side: the side is tested, with
      // others, by RaysThatBeginOnTheSurface.
      for (const double offset : {1e-3, 0.1}) {
        const Tally tally =
            compare(subject, inside, bakeRays(*grid, inside, 6000, offset, 11), c.toleranceVoxels);
        EXPECT_EQ(tally.wrong, 0) << c.name << " offset " << offset;
        EXPECT_LE(tally.undecided, tally.rays / 1000) << c.name << " offset " << offset;
        // From the faces of a sheet rays go away from it.
        if (c.name != std::string("sheet") || inside == Inside::below) {
          EXPECT_GT(tally.hits, tally.rays / 50) << c.name;
        }
      }
      const Tally close = compare(subject, inside, bakeRays(*grid, inside, 3000, 1e-4, 12), 3e-3);
      EXPECT_EQ(close.wrong, 0) << c.name;
      EXPECT_LE(close.undecided, close.rays / 1000) << c.name;
    }
  }
}

TEST_P(IsosurfaceTracerOn, AgreesWithTheReferenceOnRaysOfEveryKind) {
  const GridPointer noise = phantom("noise", {27, 18, 33}), gyroid = phantom("gyroid", {41, 60, 35});
  for (const Inside inside : {Inside::above, Inside::below}) {
    for (const GridPointer& grid : {noise, gyroid}) {
      const IsosurfaceTracer subject = tracer(grid, inside);
      const Tally tally =
          compare(subject, inside, allKindsOfRays(*grid, 8000, {0.05f, 0.7f, -0.4f, 0.31f}), 3e-3);
      EXPECT_EQ(tally.wrong, 0);
      EXPECT_LE(tally.undecided, tally.rays / 1000);
      EXPECT_GT(tally.hits, tally.rays / 10);
    }
  }
}

TEST_P(IsosurfaceTracerOn, AgreesForEveryStoredTypeAndSlope) {
  const GridPointer noise = phantom("noise", {29, 30, 31});
  struct Case {
    const char* name;
    GridPointer grid;
    double low, high;
  };
  const Case cases[] = {
      {"int8", quantised<std::int8_t>(*noise, -128, 127), -128, 127},
      {"uint8", quantised<std::uint8_t>(*noise, 0, 255, -2.0), 0, 255},
      {"int16, full range", quantised<std::int16_t>(*noise, -32768, 32767), -32768, 32767},
      {"int16, falling", quantised<std::int16_t>(*noise, -1024, 3071, -0.5), -1024, 3071},
      {"uint16, full range", quantised<std::uint16_t>(*noise, 0, 65535), 0, 65535},
      {"float, small", quantised<float>(*noise, -1e-20, 1e-20), -1e-20, 1e-20},
      {"float, far from 0", quantised<float>(*noise, 1e6, 1e6 + 512.0), 1e6, 1e6 + 512.0},
      {"float, large", quantised<float>(*noise, -1e30, 1e30), -1e30, 1e30},
  };
  for (const Case& c : cases) {
    std::vector<float> isovalues;
    for (int k = 1; k < 12; ++k) isovalues.push_back(static_cast<float>(c.low + (c.high - c.low) * k / 12.0));
    isovalues.push_back(static_cast<float>(c.low));
    isovalues.push_back(static_cast<float>(c.high));
    for (const Inside inside : {Inside::above, Inside::below}) {
      const IsosurfaceTracer subject = tracer(c.grid, inside);
      const Tally all = compare(subject, inside, allKindsOfRays(*c.grid, 4000, isovalues), 3e-3);
      const Tally bake = compare(subject, inside, bakeRays(*c.grid, inside, 2000, 0.1, 21), 3e-3);
      EXPECT_EQ(all.wrong + bake.wrong, 0) << c.name;
      EXPECT_GT(all.hits, 300) << c.name;
      EXPECT_GT(bake.hits, 300) << c.name;
    }
  }
}

TEST_P(IsosurfaceTracerOn, AgreesOnACtScan) {
  ISOLUX_NEEDS_DATA();
  base::Progress progress;
  const std::string path = (test::dataFolder() / "volumes/ct_head_skin_bone.nii.gz").string();
  const GridPointer grid = readVolume(path, {}, progress).grid;
  const IsosurfaceTracer subject = tracer(grid);
  for (const double offset : {1e-3, 0.1}) {
    const Tally tally =
        compare(subject, Inside::above, bakeRays(*grid, Inside::above, 6000, offset, 31), 3e-3);
    EXPECT_EQ(tally.wrong, 0) << offset;
    EXPECT_LE(tally.undecided, tally.rays / 50) << offset;
    EXPECT_GT(tally.hits, tally.rays / 10) << offset;
  }
}

TEST_P(IsosurfaceTracerOn, GrazingRaysAgreeWhereTheyAreDecided) {
  const GridPointer grid = phantom("gyroid", {50, 50, 50});
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const glm::dvec3 p = 5.0 + test::randomVector(i, 1) * 39.0;
    const FieldSample at = sampleTrilinear(*grid, p);
    const Ray ray = test::grazingRay(i, p, glm::normalize(at.gradient));
    rays.push_back({ray.origin, ray.direction, static_cast<float>(at.value)});
  }
  const Tally tally = compare(tracer(grid), Inside::above, rays, 5e-3);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.hits, 1000);
}

// The cells beside what stands for no value hold no surface, however far away that is.
TEST_P(IsosurfaceTracerOn, AFillHoldsNoSurface) {
  constexpr int n = 48;
  const auto ball = [](float sign, float fill) {
    std::vector<float> values;
    for (int i = 0; i < n * n * n; ++i) {
      const glm::dvec3 p(i % n, i / n % n, i / (n * n));
      const double r = glm::distance(p, glm::dvec3(23.3, 23.9, 23.1));
      values.push_back(sign * (fill < 0.0f && r > 18.0 ? fill : static_cast<float>(15.0 - r)));
    }
    return gridOf(glm::ivec3(n), values);
  };
  for (const float sign : {1.0f, -1.0f}) {
    const Inside inside = sign > 0.0f ? Inside::above : Inside::below;
    const IsosurfaceTracer plain = tracer(ball(sign, 0.0f), inside);
    const std::vector<TraceRay> rays = allKindsOfRays(plain.grid(), 20000, {0.0f});
    const std::vector<float> expected = firstOf(plain, rays);
    for (const float fill : {-1e9f, -1e20f, -1e30f, std::numeric_limits<float>::lowest()}) {
      const IsosurfaceTracer filled = tracer(ball(sign, fill), inside);
      const std::vector<float> found = firstOf(filled, rays);
      std::vector<std::uint8_t> any(rays.size());
      filled.anyEntries(rays, any);
      int hits = 0, wrong = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        hits += expected[i] < kNoEntry;
        wrong +=
            (expected[i] < kNoEntry) != (found[i] < kNoEntry) || any[i] != (expected[i] < kNoEntry) ||
            voxelsBetween(rays[i], static_cast<double>(found[i]), static_cast<double>(expected[i])) > 1e-3;
      }
      EXPECT_GT(hits, 1000);
      EXPECT_LE(wrong, hits / 1000) << sign * fill;  // rays that graze
    }
  }
}

TEST_P(IsosurfaceTracerOn, MissingVoxelsAreGaps) {
  const GridPointer whole = phantom("noise", {37, 38, 40});
  std::vector<float> values = std::get<std::vector<float>>(whole->voxels());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (base::uniformNoise(9, i) < 0.01) values[i] = kNaN;
  const GridPointer grid = gridOf(whole->dims(), values);
  std::vector<TraceRay> rays;
  for (const TraceRay& ray : allKindsOfRays(*grid, 16000, {0.0f, 0.3f})) {
    // On a plane between a cell with a missing corner and one without, either answer is right.
    if (rays.size() % 8 < 4 && glm::all(glm::notEqual(ray.direction, glm::vec3(0))) &&
        glm::fract(ray.origin) != glm::vec3(0))
      rays.push_back(ray);
  }
  for (TraceRay ray : bakeRays(*grid, Inside::above, 4000, 0.1, 41)) rays.push_back(ray);
  const Tally tally = compare(tracer(grid), Inside::above, rays, 3e-3);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.hits, 1000);
}

TEST_P(IsosurfaceTracerOn, BehindAGapTheSideIsFoundAnew) {
  const auto along = [](const std::vector<float>& samples) {
    std::vector<float> values;
    for (int i = 0; i < 9; ++i) values.insert(values.end(), samples.begin(), samples.end());
    return gridOf({static_cast<int>(samples.size()), 3, 3}, values);
  };
  const std::vector<TraceRay> ray{{{0.5f, 1.3f, 0.6f}, {1, 0, 0}, 1.0f}};
  EXPECT_EQ(firstOf(tracer(along({0, 0, kNaN, 2, 2, 2})), ray)[0], kNoEntry);
  EXPECT_FLOAT_EQ(firstOf(tracer(along({0, 0, kNaN, 2, 0, 2})), ray)[0], 4.0f);
  EXPECT_FLOAT_EQ(firstOf(tracer(along({2, 2, kNaN, 0, 2})), ray)[0], 3.0f);
  // A gap that fills blocks.
  std::vector<float> wide(60, kNaN);
  std::fill(wide.begin(), wide.begin() + 9, 0.0f);
  std::fill(wide.begin() + 45, wide.end(), 2.0f);
  EXPECT_EQ(firstOf(tracer(along(wide)), ray)[0], kNoEntry);
  wide[50] = wide[51] = 0.0f;
  EXPECT_FLOAT_EQ(firstOf(tracer(along(wide)), ray)[0], 51.0f);
}

TEST_P(IsosurfaceTracerOn, ExitAndReentryInOneCell) {
  std::vector<float> values(8, 0.0f);
  values[0] = values[7] = 1.0f;
  const GridPointer grid = gridOf({2, 2, 2}, values);
  // Along the diagonal f = (1-s)^3 + s^3.
  const double s = 0.5 + std::sqrt((0.5 - 0.25) / 3.0);
  const std::vector<TraceRay> rays{{{0, 0, 0}, {1, 1, 1}, 0.5f}, {{1, 1, 1}, {-2, -2, -2}, 0.5f}};
  const auto above = firstOf(tracer(grid), rays), below = firstOf(tracer(grid, Inside::below), rays);
  EXPECT_NEAR(static_cast<double>(above[0]), s, 1e-5);
  EXPECT_NEAR(static_cast<double>(above[1]), s / 2.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(below[0]), 1.0 - s, 1e-5);
  EXPECT_NEAR(static_cast<double>(below[1]), (1.0 - s) / 2.0, 1e-5);
}

TEST_P(IsosurfaceTracerOn, RaysThatBeginOnTheSurface) {
  std::vector<float> values;
  for (int i = 0; i < 25; ++i)
    for (const float v : {0.0f, 1.0f, 2.0f, 1.0f, 0.0f, 1.0f, 2.0f, 3.0f}) values.push_back(v);
  const IsosurfaceTracer subject = tracer(gridOf({8, 5, 5}, values));
  const std::vector<TraceRay> rays{{{1, 2, 2}, {1, 0, 0}, 1.0f},  // rises: inside, leaves at 3, enters at 5
                                   {{1, 2.5f, 2}, {-1, 0, 0}, 1.0f},  // falls: outside, to the border
                                   {{3, 2, 2}, {2, 0, 0}, 1.0f},      // falls, enters at 5
                                   {{3, 2, 2}, {0, 1, 0}, 1.0f},      // along the surface: inside
                                   {{3, 2, 2}, {-1, 0, 0}, 1.0f}};    // rises backward, leaves at 1
  const auto t = firstOf(subject, rays);
  EXPECT_FLOAT_EQ(t[0], 4.0f);
  EXPECT_EQ(t[1], kNoEntry);
  EXPECT_FLOAT_EQ(t[2], 1.0f);
  EXPECT_EQ(t[3], kNoEntry);
  EXPECT_EQ(t[4], kNoEntry);
}

TEST_P(IsosurfaceTracerOn, AxesWithoutCellsAndWhatIsNotARayHitNothing) {
  const std::vector<TraceRay> ray{{{0.5f, 0.5f, 0.5f}, {1, 0, 0}, 0.5f}, {{0, 0, 0}, {1, 0, 0}, 0.5f}};
  for (const glm::ivec3& dims :
       {glm::ivec3(1, 9, 9), glm::ivec3(9, 1, 9), glm::ivec3(9, 9, 1), glm::ivec3(1, 1, 1)}) {
    std::vector<float> values(static_cast<std::size_t>(dims.x * dims.y * dims.z));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 2);
    const IsosurfaceTracer subject = tracer(gridOf(dims, values));
    std::vector<std::uint8_t> any(2, 7);
    subject.anyEntries(ray, any);
    EXPECT_EQ(any, std::vector<std::uint8_t>(2, 0));
    EXPECT_EQ(firstOf(subject, ray), std::vector<float>(2, kNoEntry));
    std::vector<glm::vec3> g(1, glm::vec3(kNaN));
    subject.gradients(std::vector<glm::vec3>{{4, 4, 4}}, g);
    EXPECT_FALSE(std::isnan(g[0].x + g[0].y + g[0].z));
  }
  const IsosurfaceTracer two = tracer(gridOf<float>({2, 2, 2}, {0, 1, 0, 1, 0, 1, 0, 1}));
  std::vector<TraceRay> rays{{{0, 0.5f, 0.5f}, {1, 0, 0}, 0.25f}};
  EXPECT_FLOAT_EQ(firstOf(two, rays)[0], 0.25f);
  for (int axis = 0; axis < 3; ++axis)
    for (const float bad : {kNaN, kNoEntry, -kNoEntry}) {
      rays.assign(2, rays[0]);
      rays[0].origin[axis] = bad;
      rays[1].direction[axis] = bad;
      EXPECT_EQ(firstOf(two, rays), std::vector<float>(2, kNoEntry));
    }
  rays.assign(5, {{0, 0.5f, 0.5f}, {1, 0, 0}, 0.25f});
  rays[0].isovalue = kNaN;
  rays[1].isovalue = kNoEntry;
  rays[2].direction = {0, 0, 0};
  rays[3].tMaximum = kNaN;
  rays[4].tMaximum = -1.0f;
  EXPECT_EQ(firstOf(two, rays), std::vector<float>(5, kNoEntry));
}

TEST_P(IsosurfaceTracerOn, LengthOfTheDirectionAndDistanceOfTheOriginDoNotMatter) {
  const IsosurfaceTracer subject = tracer(gridOf<float>({2, 2, 2}, {0, 1, 0, 1, 0, 1, 0, 1}));
  for (const float length : {1e-30f, 1e-12f, 0.3f, 1.0f, 1e6f, 1e20f}) {
    const std::vector<TraceRay> rays{{{0, 0.5f, 0.5f}, {length, 0, 0}, 0.25f},
                                     {{-3, 0.5f, 0.5f}, {length, 0, 0}, 0.25f},
                                     {{0.5f, 0.5f, 0.5f}, {0, length, 0}, 0.25f}};
    const auto t = firstOf(subject, rays);
    EXPECT_FLOAT_EQ(t[0] * length, 0.25f);
    EXPECT_FLOAT_EQ(t[1] * length, 3.25f);
    EXPECT_EQ(t[2], kNoEntry);
  }
}

TEST_P(IsosurfaceTracerOn, TheResultOfARayDoesNotDependOnItsNeighbours) {
  const GridPointer grid = phantom("noise", {30, 30, 30});
  const IsosurfaceTracer subject = tracer(grid);
  const std::vector<TraceRay> rays = bakeRays(*grid, Inside::above, 1000, 0.1, 51);
  const auto together = firstOf(subject, rays);
  for (std::size_t i = 0; i < rays.size(); ++i)
    EXPECT_EQ(firstOf(subject, std::vector<TraceRay>{rays[i]})[0], together[i]);
  EXPECT_TRUE(firstOf(subject, {}).empty());
}

TEST_P(IsosurfaceTracerOn, GradientsAreThoseOfTheSpline) {
  const GridPointer noise = phantom("noise", {19, 18, 17});
  const GridPointer grids[] = {noise, quantised<std::int16_t>(*noise, -1024, 3071, -0.5),
                               quantised<std::uint16_t>(*noise, 0, 65535),
                               quantised<std::uint8_t>(*noise, 0, 255)};
  for (const GridPointer& grid : grids) {
    const IsosurfaceTracer subject = tracer(grid);
    std::vector<glm::vec3> at;
    for (std::uint64_t i = 0; i < 2003; ++i) {
      const glm::dvec3 p =
          test::randomVector(i, 1) * glm::dvec3(grid->dims() + 1) - 1.0;  // some beyond the border
      at.emplace_back(i % 4 == 0 ? glm::round(p) : p);
    }
    std::vector<glm::vec3> g(at.size());
    subject.gradients(at, g);
    const double range = (grid->maximum() - grid->minimum()) / std::abs(grid->slope());
    for (std::size_t i = 0; i < at.size(); ++i) {
      const glm::dvec3 expected = sampleCubic(*grid, at[i]).gradient / grid->slope();
      EXPECT_LT(glm::distance(glm::dvec3(g[i]), expected), 2e-6 * range);
    }
  }
}

TEST_P(IsosurfaceTracerOn, GradientsNearMissingVoxelsAreThoseOfTheCell) {
  const GridPointer noise = phantom("noise", {12, 12, 12});
  std::vector<float> values = std::get<std::vector<float>>(noise->voxels());
  values[noise->index(6, 6, 6)] = kNaN;
  const GridPointer grid = gridOf(noise->dims(), values);
  const std::vector<glm::vec3> at{{4.3f, 5.2f, 5.7f}, {5.3f, 5.2f, 5.7f}, {2.3f, 5.2f, 5.7f}};
  std::vector<glm::vec3> g(3);
  tracer(grid).gradients(at, g);
  EXPECT_LT(glm::distance(glm::dvec3(g[0]), sampleTrilinear(*noise, at[0]).gradient), 1e-6);
  EXPECT_EQ(g[1], glm::vec3(0));
  EXPECT_LT(glm::distance(glm::dvec3(g[2]), sampleCubic(*noise, at[2]).gradient), 1e-6);
}

std::string nameOfTarget(const testing::TestParamInfo<TracerTarget>& info) {
  constexpr const char* names[] = {"automatic", "scalar", "sse4", "avx2", "avx512", "neon"};
  return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Targets, IsosurfaceTracerOn, testing::ValuesIn(IsosurfaceTracer::availableTargets()),
                         nameOfTarget);

// What stored light of one kind of arithmetic rests on (docs/explanation/global-illumination.md, "Path
// tracing").
TEST(IsosurfaceTracer, FusedTargetsGiveTheSameBits) {
  std::vector<TracerTarget> fused = IsosurfaceTracer::availableTargets();
  std::erase_if(fused, [](TracerTarget t) { return t != TracerTarget::avx2 && t != TracerTarget::avx512; });
  if (fused.size() < 2) {
    std::cout << "this machine has no two of them\n";
    return;
  }
  constexpr int kFusedRays = 500'000;  // of each grid
  const GridPointer noise = phantom("noise", glm::ivec3(40));
  const GridPointer grids[] = {noise, quantised<std::int16_t>(*noise, -1024, 3071, 0.5)};
  for (const GridPointer& grid : grids) {
    const std::vector<TraceRay> rays = bakeRays(*grid, Inside::above, kFusedRays, 0.1, 7);
    ASSERT_EQ(rays.size(), std::size_t{kFusedRays});
    std::vector<glm::vec3> at;
    for (const TraceRay& ray : rays) at.push_back(ray.origin);
    base::Progress progress;
    std::vector<float> first[2];
    std::vector<glm::vec3> gradients[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const IsosurfaceTracer subject(grid, Inside::above, progress, fused[i]);
      first[i].resize(rays.size());
      subject.firstEntries(rays, first[i]);
      gradients[i].resize(at.size());
      subject.gradients(at, gradients[i]);
    }
    EXPECT_EQ(std::memcmp(first[0].data(), first[1].data(), first[0].size() * sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(gradients[0].data(), gradients[1].data(), at.size() * sizeof(glm::vec3)), 0);
    EXPECT_GT(std::count_if(first[0].begin(), first[0].end(), [](float t) { return std::isfinite(t); }),
              100'000);
  }
}

TEST(IsosurfaceTracer, ChoosesTheWidestTarget) {
  const GridPointer grid = phantom("ball", {8, 8, 8});
  base::Progress progress;
  const IsosurfaceTracer automatic(grid, Inside::above, progress);
  const IsosurfaceTracer widest(grid, Inside::above, progress, IsosurfaceTracer::availableTargets().back());
  EXPECT_STREQ(automatic.target(), widest.target());
  EXPECT_GT(automatic.bytes(), 2 * 7 * 7 * 7u);
}

TEST(IsosurfaceTracer, BuildingStopsWhenAsked) {
  base::Progress progress;
  const GridPointer grid = phantom("ball", {32, 32, 32});
  progress.requestStop();
  EXPECT_THROW(IsosurfaceTracer(grid, Inside::above, progress), base::Error);
}

// Whatever the map, a range of bins must hold every isovalue that its voxels cross.
TEST(CellRanges, BinsAreMonotoneAndRangesHoldTheirCells) {
  const GridPointer noise = phantom("noise", {23, 10, 18});
  for (const GridPointer& grid :
       {noise, quantised<float>(*noise, 1e6, 1e6 + 2.0), quantised<std::int16_t>(*noise, -9, 300)}) {
    base::Progress progress;
    const CellRanges ranges(*grid, progress);
    const glm::ivec3 cells = grid->dims() - 1;
    ASSERT_EQ(ranges.blockDims(), (cells + 3) / 4);
    for (int z = 0; z < cells.z; ++z)
      for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x) {
          int least = 255, most = 0;
          for (int corner = 0; corner < 8; ++corner) {
            const int bin = ranges.bins()(
                static_cast<float>(grid->stored(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2))));
            least = std::min(least, bin);
            most = std::max(most, bin);
          }
          const int block = ((z / 4) * ranges.blockDims().y + y / 4) * ranges.blockDims().x + x / 4;
          const std::uint8_t* word = ranges.table() + 4 * block;
          const std::uint8_t* pair =
              ranges.table() + ranges.cellBytes() + 128 * block + 2 * ((z % 4) * 16 + (y % 4) * 4 + x % 4);
          EXPECT_EQ(int{pair[0]}, least);
          EXPECT_EQ(int{pair[1]}, most);
          EXPECT_LE(word[0], least);
          EXPECT_GE(word[1], most);
          EXPECT_LE(word[2], word[0]);
          EXPECT_GE(word[3], word[1]);
        }
    std::uint8_t before = 0;
    for (int i = 0; i < 20000; ++i) {
      const double at = grid->minimum() + (grid->maximum() - grid->minimum()) * (1.2 * i / 20000.0 - 0.1);
      const std::uint8_t bin = ranges.bins()(static_cast<float>(at));
      EXPECT_GE(bin, before);
      before = bin;
    }
    EXPECT_GT(before, 200);
    EXPECT_LT(before, 255);
  }
}

// Rays are made ready in vectors, and one by one where one of a vector begins outside or is none: whatever is
// beside a ray, its answer is the same bit for bit.
TEST_P(IsosurfaceTracerOn, ARaysAnswerDoesNotHangOnItsNeighbours) {
  const IsosurfaceTracer traced = tracer(phantom("gyroid", glm::ivec3(24)));
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<TraceRay> rays;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const auto u = [i](std::uint64_t n) { return static_cast<float>(base::uniformNoise(2, 9 * i + n)); };
    TraceRay ray{glm::vec3(u(0), u(1), u(2)) * 23.0f, glm::vec3(u(3), u(4), u(5)) - 0.5f, u(6) - 0.5f};
    // Long segments without and with those that want care.
    const std::uint64_t kind = i / 400 % 2 == 0 ? 0 : base::hash64(i) % 16;
    if (kind == 1) ray.origin.x -= 30.0f;
    if (kind == 2) ray.origin = glm::vec3(23.0f);
    if (kind == 3) ray.direction = glm::vec3(0.0f, 0.0f, 1.0f);
    if (kind == 4) ray.direction = glm::vec3(0.0f);
    if (kind == 5) ray.isovalue = nan;
    if (kind == 6) ray.tMaximum = 0.0f;
    if (kind == 7) ray.tMaximum = 3.0f;
    if (kind == 8) ray.direction *= 1e-30f;
    if (kind == 9) ray.direction *= 1e30f;
    if (kind == 10) ray.origin.z = 0.0f;
    if (kind == 11) ray.direction.y = std::numeric_limits<float>::infinity();
    rays.push_back(ray);
  }
  const std::vector<float> together = firstOf(traced, rays);
  std::vector<std::uint8_t> hit(rays.size());
  traced.anyEntries(rays, hit);
  int hits = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    float alone = -1.0f;
    traced.firstEntries(std::span(&rays[i], 1), std::span(&alone, 1));
    ASSERT_EQ(std::bit_cast<std::uint32_t>(together[i]), std::bit_cast<std::uint32_t>(alone)) << i;
    ASSERT_EQ(hit[i] != 0, alone < std::numeric_limits<float>::infinity()) << i;
    hits += hit[i];
  }
  EXPECT_GT(hits, 800);
}

TEST(IsosurfaceTracerMemory, TracersOfAGridShareTheirTables) {
  const GridPointer grid = quantised<std::uint8_t>(*phantom("ball", glm::ivec3(40)), 0.0, 255.0);
  base::Progress progress;
  const std::size_t before = base::machineMemory().held();
  auto above = std::make_unique<IsosurfaceTracer>(grid, Inside::above, progress);
  const std::size_t one = base::machineMemory().held();
  {
    const IsosurfaceTracer below(grid, Inside::below, progress);
    EXPECT_EQ(base::machineMemory().held(), one);
    above.reset();
    EXPECT_EQ(base::machineMemory().held(), one);
    // Another grid of the same values has its own, and the same answers.
    const GridPointer other = quantised<std::uint8_t>(*phantom("ball", glm::ivec3(40)), 0.0, 255.0);
    const IsosurfaceTracer ofOther(other, Inside::below, progress);
    std::vector<TraceRay> rays;
    for (int i = 0; i < 200; ++i)
      rays.push_back({glm::vec3(20.0f), glm::vec3(1.0f, 0.1f, 0.0f), static_cast<float>(i)});
    for (int i = 0; i < 200; ++i)
      rays.push_back({glm::vec3(1.0f), glm::vec3(1.0f, 1.1f, 0.9f), static_cast<float>(i)});
    std::vector<float> t(rays.size()), tOfOther(rays.size());
    below.firstEntries(rays, t);
    ofOther.firstEntries(rays, tOfOther);
    EXPECT_EQ(t, tOfOther);
    EXPECT_TRUE(std::any_of(t.begin(), t.end(), [](float at) { return at > 1.0f && at < 40.0f; }));
    EXPECT_GT(base::machineMemory().held(), one);
  }
  EXPECT_EQ(base::machineMemory().held(), before);
}

// The 64-bit indices of volumes of more than 2^32 voxels give the same, bit by bit.
TEST_P(IsosurfaceTracerOn, WideIndicesGiveTheSameEntries) {
  const GridPointer gyroid = phantom("gyroid", glm::ivec3(24, 31, 17));
  for (const GridPointer& grid :
       {gyroid, quantised<std::uint8_t>(*gyroid, 0, 255), quantised<std::uint16_t>(*gyroid, 0, 65535)}) {
    base::Progress progress;
    const IsosurfaceTracer narrow(grid, Inside::above, progress, GetParam());
    const IsosurfaceTracer wide(grid, Inside::above, progress, GetParam(), true);
    const auto isovalue = static_cast<float>(grid->storedOfValue(0.5 * (grid->minimum() + grid->maximum())));
    const std::vector<TraceRay> rays = allKindsOfRays(*grid, 2000, {isovalue, 0.9f * isovalue});
    const std::vector<float> t = firstOf(narrow, rays);
    EXPECT_EQ(t, firstOf(wide, rays));
    EXPECT_GT(std::count_if(t.begin(), t.end(), [](float at) { return at < kNoEntry; }), 200);
    std::vector<std::uint8_t> hit(rays.size()), hitWide(rays.size());
    narrow.anyEntries(rays, hit);
    wide.anyEntries(rays, hitWide);
    EXPECT_EQ(hit, hitWide);
  }
}

TEST(IsosurfaceTracerMemory, AsksBeforeItMakesItsTables) {
  const GridPointer grid = quantised<std::uint8_t>(*phantom("ball", glm::ivec3(48)), 0.0, 255.0);
  base::Progress progress;
  const std::size_t before = base::machineMemory().held();
  {
    const IsosurfaceTracer tracer(grid, Inside::above, progress);
    EXPECT_EQ(base::machineMemory().held(), before + tracer.bytes());
  }
  EXPECT_EQ(base::machineMemory().held(), before);
  const test::MemoryLimit limit(100000);
  try {
    const IsosurfaceTracer tracer(grid, Inside::above, progress);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_NE(error.reason().find("gi.mode=off"), std::string::npos) << error.reason();
  }
  EXPECT_EQ(base::machineMemory().held(), before);
}

}  // namespace
}  // namespace isolux::volume
