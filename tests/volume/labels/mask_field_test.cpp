// The mask field is the one that its definition says, keeps every voxel's side, changes as it is made, and
// follows balls closely.
#include "volume/labels/mask_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/plain_mask.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::LabelBlocks;
using volume::MaskField;

using LabelAt = std::function<int(glm::ivec3)>;

template <class T = std::uint8_t>
std::shared_ptr<const Grid> labelGrid(glm::ivec3 dims, const LabelAt& labelAt,
                                      glm::dvec3 spacingMm = glm::dvec3(1.0)) {
  std::vector<T> voxels;
  volume::forEachIn(glm::ivec3(0), dims, [&](glm::ivec3 p) { voxels.push_back(static_cast<T>(labelAt(p))); });
  return std::make_shared<const Grid>(volume::GridGeometry::make(dims, spacingMm), std::move(voxels));
}

struct MadeMask {
  std::shared_ptr<const Grid> labels;
  MaskField mask;
};
MadeMask madeMask(const std::shared_ptr<const Grid>& labels, const std::vector<int>& set, double smoothing) {
  base::Progress progress;
  return {labels, makeMask(LabelBlocks(labels, "", progress), set, smoothing, progress)};
}

double distanceTo(glm::ivec3 p, glm::dvec3 centre) {
  return glm::length(glm::dvec3(p) - centre);
}

// ---- Label maps ----

struct LabelCase {
  std::string name;
  glm::ivec3 dims;
  LabelAt labelAt;
  std::vector<int> set;
};

int randomLabel(glm::ivec3 p, std::uint64_t seed, int labels) {
  const auto at = static_cast<std::uint64_t>(p.x + 1000 * p.y + 1000000 * p.z);
  return static_cast<int>(base::counterHash(seed, at) % static_cast<std::uint64_t>(labels));
}

const std::vector<LabelCase>& labelCases() {
  static const std::vector<LabelCase> cases{
      {"random labels", {21, 18, 27}, [](glm::ivec3 p) { return randomLabel(p, 1, 5); }, {1, 3}},
      {"few voxels", {26, 19, 17}, [](glm::ivec3 p) { return randomLabel(p, 2, 40); }, {0}},
      {"few holes", {17, 25, 19}, [](glm::ivec3 p) { return randomLabel(p, 3, 30) == 0 ? 0 : 1; }, {1}},
      {"random boxes", {30, 28, 33}, [](glm::ivec3 p) { return randomLabel(p / 4, 4, 3); }, {1}},
      {"ball",
       {30, 31, 29},
       [](glm::ivec3 p) {
         return distanceTo(p, {14.3, 15.2, 13.8}) < 9.0 ? 7 : 0;
       },
       {7}},
      {"touching balls",
       {33, 17, 18},
       [](glm::ivec3 p) {
         return distanceTo(p, {10.0, 8.0, 9.0}) <= 6.0 ? 1 : distanceTo(p, {22.0, 8.0, 9.0}) <= 6.0 ? 2 : 0;
       },
       {2}},
      {"sheets",
       {24, 24, 24},
       [](glm::ivec3 p) { return p.z == 8 || p.z == 15 || p.x - p.y == 3 ? 1 : 0; },
       {1}},
      {"lines",
       {24, 24, 24},
       [](glm::ivec3 p) {
         return (p.x == 8 && p.y == 7) || (p.x == p.y && p.z == 16) || (p.x == p.y && p.z == p.x + 4) ? 1 : 0;
       },
       {1}},
      {"a lone voxel", {17, 17, 17}, [](glm::ivec3 p) { return p == glm::ivec3(8, 7, 15) ? 1 : 0; }, {1}},
      {"checkers", {18, 18, 18}, [](glm::ivec3 p) { return (p.x + p.y + p.z) % 2; }, {1}},
      {"checkers of 3", {20, 20, 20}, [](glm::ivec3 p) { return (p.x / 3 + p.y / 3 + p.z / 3) % 2; }, {1}},
      {"eight labels in a corner",
       {16, 16, 16},
       [](glm::ivec3 p) { return (p.x >= 8 ? 1 : 0) + (p.y >= 8 ? 2 : 0) + (p.z >= 8 ? 4 : 0); },
       {0, 3, 5, 6}},
      {"half of the volume", {24, 9, 9}, [](glm::ivec3 p) { return p.x < 12 ? 1 : 0; }, {1}},
      {"a label at the border", {9, 9, 25}, [](glm::ivec3 p) { return p.z > 22 || p.x == 0 ? 1 : 0; }, {1}},
      {"nothing", {9, 9, 9}, [](glm::ivec3) { return 0; }, {1}},
      {"all", {9, 9, 9}, [](glm::ivec3) { return 1; }, {1}},
      {"wider than what is computed at a time",
       {530, 6, 4},
       [](glm::ivec3 p) { return randomLabel(p / 3, 10, 2); },
       {1}},
      {"one voxel wide", {1, 30, 12}, [](glm::ivec3 p) { return randomLabel(p, 9, 2); }, {1}},
  };
  return cases;
}

std::set<int> asSet(const std::vector<int>& labels) {
  return {labels.begin(), labels.end()};
}

// Alike on all axes; slices across each axis, just thick or very; the other two axes differ.
const std::vector<glm::dvec3>& spacings() {
  static const std::vector<glm::dvec3> all{
      {0.8, 0.8, 1.19}, {1.0, 1.0, 1.5}, {4.0, 1.0, 1.2}, {0.7, 2.5, 0.7}, {0.5, 0.4, 9.0}};
  return all;
}

std::string nameOf(const LabelCase& of, const glm::dvec3& spacing, double smoothing) {
  return of.name + ", spacing " + std::to_string(spacing.x) + " " + std::to_string(spacing.y) + " " +
         std::to_string(spacing.z) + ", smoothing " + std::to_string(smoothing);
}

TEST(MaskFieldTest, IsWhatItsDefinitionSays) {
  for (const LabelCase& of : labelCases())
    for (const glm::dvec3& spacing : spacings())
      for (const double smoothing : {0.0, 1.0, 2.0}) {
        SCOPED_TRACE(nameOf(of, spacing, smoothing));
        const MadeMask made = madeMask(labelGrid(of.dims, of.labelAt, spacing), of.set, smoothing);
        const PlainMask plain = plainMask(*made.labels, asSet(of.set), smoothing);
        const volume::Extent3 extent{of.dims};
        std::size_t thin = 0, wrong = 0, undecided = 0;
        for (std::size_t i = 0; i < plain.u.size(); ++i) {
          thin += plain.thin[i] && plain.member[i] ? 1 : 0;
          undecided += plain.undecided[i] ? 1 : 0;
          if (!plain.undecided[i])
            wrong += std::abs(made.mask.grid->stored(extent.at(i)) - 127.0 * plain.u[i]) > 0.501 ? 1 : 0;
        }
        EXPECT_EQ(wrong, 0u);
        EXPECT_LE(undecided, plain.u.size() / 100);
        if (undecided == 0) {
          EXPECT_EQ(made.mask.thinVoxels(), thin);
        }
      }
}

TEST(MaskFieldTest, EveryVoxelKeepsItsSideAndTheSurfaceLiesAtFaces) {
  for (const LabelCase& of : labelCases())
    for (const glm::dvec3& spacing : spacings())
      for (const double smoothing : {0.0, 0.3, 0.7, 1.0, 1.5, 2.0}) {
        const MadeMask made = madeMask(labelGrid(of.dims, of.labelAt, spacing), of.set, smoothing);
        EXPECT_EQ(brokenPromise(*made.labels, asSet(of.set), *made.mask.grid, 1), "")
            << nameOf(of, spacing, smoothing);
      }
}

TEST(MaskFieldTest, KeepsItsPromiseInAMillionCells) {
  const glm::ivec3 dims(101);
  const MadeMask made =
      madeMask(labelGrid(dims, [](glm::ivec3 p) { return randomLabel(p, 5, 3); }), {1}, 1.0);
  EXPECT_EQ(brokenPromise(*made.labels, {1}, *made.mask.grid, 2), "");
}

// A judge that finds nothing wrong with anything would be none.
TEST(MaskFieldTest, APromiseCanBeBroken) {
  const auto labels = labelGrid(glm::ivec3(12), [](glm::ivec3 p) { return p.x < 6 ? 1 : 0; });
  const auto moved = [&](double by) {
    return gridOfVoxels(unitGeometry(glm::ivec3(12)), [by](glm::dvec3 p) { return 5.5 + by - p.x; });
  };
  EXPECT_EQ(brokenPromise(*labels, {1}, moved(0.4), 1), "");
  EXPECT_NE(brokenPromise(*labels, {1}, moved(0.6), 1), "");
  EXPECT_NE(brokenPromise(*labels, {1}, moved(-0.6), 1), "");
}

// ---- What it is made of ----

TEST(MaskFieldTest, IsAnInt8GridOfTheSameGeometry) {
  const auto geometry = volume::GridGeometry::make({12, 10, 9}, {0.5, 0.7, 1.0}, {4.0, 5.0, -6.0});
  std::vector<std::int16_t> voxels(geometry.voxelCount());
  voxels[3] = -7;
  const MadeMask made = madeMask(std::make_shared<const Grid>(geometry, std::move(voxels)), {-7}, 1.0);
  EXPECT_EQ(made.mask.grid->storedType(), volume::VoxelType::int8);
  EXPECT_TRUE(made.mask.grid->geometry().sameAs(geometry));
  EXPECT_EQ(made.mask.grid->maximum(), 1.0);
  EXPECT_EQ(made.mask.grid->minimum(), -1.0);
  EXPECT_EQ(made.mask.thinVoxels(), 1u);
}

template <class T>
std::vector<std::int8_t> voxelsOfMask(const LabelCase& of, int offset) {
  std::vector<int> set;
  for (const int label : of.set) set.push_back(label + offset);
  const auto labels = labelGrid<T>(of.dims, [&](glm::ivec3 p) { return of.labelAt(p) + offset; });
  return std::get<std::vector<std::int8_t>>(madeMask(labels, set, 1.0).mask.grid->voxels());
}

TEST(MaskFieldTest, EveryStoredTypeGivesTheSame) {
  for (const LabelCase& of : labelCases()) {
    SCOPED_TRACE(of.name);
    const std::vector<std::int8_t> expected = voxelsOfMask<std::uint8_t>(of, 0);
    EXPECT_EQ(voxelsOfMask<std::int8_t>(of, -40), expected);
    EXPECT_EQ(voxelsOfMask<std::uint16_t>(of, 40000), expected);
    EXPECT_EQ(voxelsOfMask<std::int16_t>(of, -30000), expected);
    EXPECT_EQ(voxelsOfMask<float>(of, 1000000), expected);
  }
}

TEST(MaskFieldTest, MissingVoxelsAreInNoSet) {
  std::vector<float> voxels(9 * 9 * 9, 1.0f);
  voxels[364] = std::nanf("");
  const MadeMask made =
      madeMask(std::make_shared<const Grid>(unitGeometry(glm::ivec3(9)), std::move(voxels)), {0, 1, 2}, 1.0);
  EXPECT_LT(made.mask.grid->value(4, 4, 4), 0.0);
  EXPECT_EQ(made.mask.grid->missingCount(), 0u);
}

// A field that is changed label by label is the field of the last set.
void changesToTheFieldOfTheOtherSet(const glm::dvec3& spacing) {
  const auto labelAt = [](glm::ivec3 p) {
    int nearest = 0;
    double least = 12.0;
    for (int i = 0; i < 40; ++i) {
      const glm::dvec3 seed(base::uniformNoise(3, static_cast<std::uint64_t>(i)) * 70.0,
                            base::uniformNoise(4, static_cast<std::uint64_t>(i)) * 45.0,
                            base::uniformNoise(5, static_cast<std::uint64_t>(i)) * 52.0);
      if (const double d = distanceTo(p, seed); d < least) {
        least = d;
        nearest = i + 1;
      }
    }
    return nearest;
  };
  const auto labels = labelGrid({70, 45, 52}, labelAt, spacing);
  base::Progress progress;
  const LabelBlocks blocks(labels, "", progress);
  for (const double smoothing : {0.0, 1.0, 2.0}) {
    std::vector<int> set;
    MaskField mask = makeMask(blocks, set, smoothing, progress);
    for (std::uint64_t step = 0; step < 12; ++step) {
      const int label = static_cast<int>(base::counterHash(8, step) % 42);
      if (const auto found = std::find(set.begin(), set.end(), label); found != set.end())
        set.erase(found);
      else
        set.insert(set.begin(), label);
      mask = changedMask(mask, blocks, set, progress);
      const MaskField whole = makeMask(blocks, set, smoothing, progress);
      ASSERT_EQ(mask.grid->hash(), whole.grid->hash()) << "step " << step << ", smoothing " << smoothing;
      ASSERT_EQ(mask.thin, whole.thin);
      ASSERT_EQ(mask.labels, whole.labels);
    }
  }
}

TEST(MaskFieldTest, ChangesToTheFieldOfTheOtherSet) {
  changesToTheFieldOfTheOtherSet({1.0, 1.0, 1.0});
}

TEST(MaskFieldTest, ChangesToTheFieldOfTheOtherSetInThickSlices) {
  changesToTheFieldOfTheOtherSet({0.7, 0.7, 2.0});
  changesToTheFieldOfTheOtherSet({5.0, 1.0, 1.0});
}

TEST(MaskFieldTest, FourThousandLabels) {
  const auto labels = labelGrid<std::uint16_t>(
      {80, 80, 80}, [](glm::ivec3 p) { return 1 + p.x / 5 + 16 * (p.y / 5) + 256 * (p.z / 5); });
  std::vector<int> odd;
  for (int label = 1; label <= 4096; label += 2) odd.push_back(label);
  const MadeMask made = madeMask(labels, odd, 1.0);
  EXPECT_EQ(brokenPromise(*labels, asSet(odd), *made.mask.grid, 3), "");
}

TEST(MaskFieldTest, CanBeStopped) {
  base::Progress progress;
  const LabelBlocks blocks(labelGrid(glm::ivec3(20), [](glm::ivec3 p) { return p.x / 5; }), "", progress);
  progress.requestStop();
  EXPECT_THROW(makeMask(blocks, std::vector<int>{1}, 1.0, progress), base::Error);
}

// ---- How closely it follows a ball ----

struct BallErrors {
  double mean = 0.0, rms = 0.0;  // of the radius, mm
  double normals = 0.0;          // rms, degrees; of the B-spline
};

// Points of the surface on lines 1/8 voxel apart along the axis that its normal is nearest to. The centre:
// voxels.
BallErrors ballErrors(const Grid& mask, glm::dvec3 centre, double radius,
                      const glm::dvec3& spacing = glm::dvec3(1.0)) {
  constexpr int perVoxel = 8;
  double count = 0.0, sum = 0.0, squares = 0.0, angles = 0.0;
  volume::forEachIn(glm::ivec3(0), mask.dims() - 1, [&](glm::ivec3 cell) {
    std::array<double, 8> corner{};
    for (std::size_t i = 0; i < 8; ++i) corner[i] = mask.value(cell + volume::cornerStep(i));
    const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
    if (*least >= 0.0 || *most < 0.0) return;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < perVoxel * perVoxel; ++i) {
        glm::dvec3 at(cell);
        at[(axis + 1) % 3] += (i % perVoxel + 0.5) / perVoxel;
        at[(axis + 2) % 3] += (i / perVoxel + 0.5) / perVoxel;
        glm::dvec3 next = at;
        next[axis] += 1.0 - 1e-12;  // of the same cell
        const double from = sampleTrilinear(mask, at).value, to = sampleTrilinear(mask, next).value;
        if ((from < 0.0) == (to < 0.0)) continue;
        at[axis] += from / (from - to);
        const glm::dvec3 arm = spacing * (at - centre);
        if (std::abs(arm[axis]) < std::max(std::abs(arm[(axis + 1) % 3]), std::abs(arm[(axis + 2) % 3])))
          continue;
        const double error = glm::length(arm) - radius;
        const glm::dvec3 normal = -glm::normalize(sampleCubic(mask, at).gradient / spacing);
        const double angle = std::acos(std::clamp(glm::dot(normal, glm::normalize(arm)), -1.0, 1.0)) * 180.0 /
                             3.14159265358979;
        count += 1.0;
        sum += error;
        squares += error * error;
        angles += angle * angle;
      }
  });
  return {sum / count, std::sqrt(squares / count), std::sqrt(angles / count)};
}

TEST(MaskFieldTest, FollowsABallOfTenVoxels) {
  const glm::dvec3 centre(14.37, 15.21, 14.83);
  constexpr double radius = 10.0;
  const auto labels =
      labelGrid({30, 31, 30}, [&](glm::ivec3 p) { return distanceTo(p, centre) <= radius ? 1 : 0; });
  struct Expected {
    double smoothing, mean, rms, normals;
  };
  for (const Expected& most : {Expected{0.0, 0.02, 0.19, 13.0}, Expected{1.0, 0.05, 0.12, 5.5},
                               Expected{1.5, 0.09, 0.11, 3.5}, Expected{2.0, 0.14, 0.15, 3.2}}) {
    const BallErrors errors = ballErrors(*madeMask(labels, {1}, most.smoothing).mask.grid, centre, radius);
    const std::string name = "smoothing_" + std::to_string(static_cast<int>(10 * most.smoothing));
    RecordProperty(name, std::to_string(errors.mean) + " " + std::to_string(errors.rms) + " mm, " +
                             std::to_string(errors.normals) + " degrees");
    EXPECT_LE(std::abs(errors.mean), most.mean) << name;
    EXPECT_LE(errors.rms, most.rms) << name;
    EXPECT_LE(errors.normals, most.normals) << name;
  }
}

// Across slices voxels are long, and a Gaussian in voxels leaves each slice's step.
TEST(MaskFieldTest, FollowsBallsThroughThickSlices) {
  struct Case {
    glm::dvec3 spacing;
    double radius, mean, rms, normals;  // mm, degrees: at most
  };
  for (const Case& of :
       {Case{{1.0, 1.0, 2.0}, 15.0, 0.04, 0.17, 6.5}, Case{{1.0, 1.0, 3.0}, 6.0, 0.27, 0.4, 9.3},
        Case{{1.0, 1.0, 3.0}, 15.0, 0.12, 0.27, 7.0}, Case{{0.8, 0.8, 5.0}, 20.0, 0.11, 0.36, 6.7},
        Case{{5.0, 0.8, 0.8}, 20.0, 0.11, 0.36, 6.7}}) {
    const glm::ivec3 dims(glm::ceil(2.0 * (of.radius + 4.0) / of.spacing) + 5.0);
    const glm::dvec3 centre = 0.5 * glm::dvec3(dims) + glm::dvec3(0.13, -0.21, 0.17);
    const auto labelAt = [&](glm::ivec3 p) {
      return glm::length(of.spacing * (glm::dvec3(p) - centre)) <= of.radius ? 1 : 0;
    };
    const auto errors = [&](const glm::dvec3& spacing) {
      const MadeMask made = madeMask(labelGrid(dims, labelAt, spacing), {1}, 1.0);
      return ballErrors(*made.mask.grid, centre, of.radius, of.spacing);
    };
    const BallErrors now = errors(of.spacing), smoothedAlone = errors(glm::dvec3(1.0));
    EXPECT_LE(std::abs(now.mean), of.mean);
    EXPECT_LE(now.rms, of.rms);
    EXPECT_LE(now.normals, of.normals);
    EXPECT_LT(now.rms, smoothedAlone.rms);
    EXPECT_LT(now.normals, 0.75 * smoothedAlone.normals);
  }
}

}  // namespace
}  // namespace isolux::test
