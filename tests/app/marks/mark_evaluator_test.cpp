// What marks say, against closed forms of balls and tori, in grids of every kind.
#include "app/marks/mark_evaluator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/marks/mark_kinds.h"
#include "scene/rules/automatic.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using scene::Mark;
using scene::MarkKind;
using testing::HasSubstr;

Mark markOf(MarkKind kind, std::vector<glm::dvec3> points) {
  return {kind, "test", std::move(points)};
}

// A volume, the isosurface 0, and marks measured on it.
struct Measuring {
  explicit Measuring(std::shared_ptr<const volume::PreparedVolume> prepared, double isovalue = 0.0)
      : volume(std::move(prepared)) {
    scene.surfaces.front().value = isovalue;
    scene = scene::resolve(scene, volume->facts);
    evaluator.emplace(volume, scene);
  }
  app::MarkReport operator()(MarkKind kind, std::vector<glm::dvec3> points) {
    return evaluator->evaluate(markOf(kind, std::move(points)), progress);
  }
  // The point of the surface in a direction from the origin.
  glm::dvec3 onSurface(glm::dvec3 world) const {
    const volume::SurfaceOf surface{volume->grid(), *scene.surfaces.front().value};
    const auto point = nearestPoint(surface, world);
    EXPECT_TRUE(point);
    return point ? point->world : world;
  }

  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;
  std::optional<app::MarkEvaluator> evaluator;
  base::Progress progress;
};

const app::MarkQuantity* find(const app::MarkReport& report, const std::string& name) {
  const auto found = std::find_if(report.quantities.begin(), report.quantities.end(),
                                  [&](const auto& quantity) { return quantity.name == name; });
  return found == report.quantities.end() ? nullptr : &*found;
}

double valueOf(const app::MarkReport& report, const std::string& name) {
  const app::MarkQuantity* quantity = find(report, name);
  EXPECT_TRUE(quantity) << name << ": " << report.problem;
  return quantity ? quantity->value : std::nan("");
}

void expectWithinStated(const app::MarkReport& report, const std::string& name, double reference) {
  const app::MarkQuantity* quantity = find(report, name);
  ASSERT_TRUE(quantity && quantity->error) << name << ": " << report.problem;
  EXPECT_LE(std::abs(quantity->value - reference), *quantity->error) << name;
}

TEST(MarkEvaluator, GreatCirclesOfABall) {
  Measuring measure(phantom("ball", 64));
  const double radius = 0.35 * 63.0;
  for (const double angle : {0.3, 1.2, 2.6}) {
    const glm::dvec3 a = measure.onSurface(radius * glm::normalize(glm::dvec3(1.0, 0.2, 0.3)));
    const glm::dvec3 axis = glm::normalize(a), side = glm::normalize(glm::cross(axis, glm::dvec3(0, 0, 1)));
    const glm::dvec3 b = measure.onSurface(radius * (std::cos(angle) * axis + std::sin(angle) * side));
    const double reference = radius * std::acos(glm::dot(glm::normalize(a), glm::normalize(b)));
    const app::MarkReport report = measure(MarkKind::path, {a, b});
    EXPECT_NEAR(valueOf(report, "along_surface"), reference, 0.005 * reference);
    EXPECT_NEAR(valueOf(report, "straight"), glm::length(a - b), 1e-9);
    EXPECT_TRUE(report.notes.empty());
    ASSERT_GT(report.line.size(), 5u);
    EXPECT_LT(glm::length(report.line.front() - a) + glm::length(report.line.back() - b), 1e-6);
  }
}

// Meridians and the inner equator of a torus are geodesics; so is the outer one as long as it is short.
TEST(MarkEvaluator, GeodesicsOfATorus) {
  Measuring measure(phantom("torus", 96));
  const double edge = 95.0, ring = 0.27 * edge, tube = 0.12 * edge;
  const auto at = [&](double around, double along) {
    const double r = ring + tube * std::cos(along);
    return measure.onSurface({r * std::cos(around), r * std::sin(around), tube * std::sin(along)});
  };
  const auto expectLength = [&](glm::dvec3 a, glm::dvec3 b, double reference) {
    EXPECT_NEAR(valueOf(measure(MarkKind::path, {a, b}), "along_surface"), reference, 0.005 * reference);
  };
  expectLength(at(0.4, 0.1), at(0.4, 2.3), 2.2 * tube);
  expectLength(at(0.1, std::numbers::pi), at(1.9, std::numbers::pi), 1.8 * (ring - tube));
  expectLength(at(0.2, 0.0), at(0.7, 0.0), 0.5 * (ring + tube));
}

TEST(MarkEvaluator, AWayOverSeveralPointsIsTheSumOfItsParts) {
  Measuring measure(phantom("ball", 48));
  const double radius = 0.35 * 47.0;
  const glm::dvec3 a = measure.onSurface({radius, 0, 0}), b = measure.onSurface({0, radius, 0}),
                   c = measure.onSurface({0, 0, radius});
  const app::MarkReport path = measure(MarkKind::path, {a, b, c});
  EXPECT_NEAR(valueOf(path, "along_surface"), std::numbers::pi * radius, 0.005 * std::numbers::pi * radius);
  EXPECT_DOUBLE_EQ(valueOf(path, "along_surface"),
                   valueOf(path, "along_surface_1_2") + valueOf(path, "along_surface_2_3"));
  const app::MarkReport straight = measure(MarkKind::distance, {a, b, c});
  EXPECT_NEAR(valueOf(straight, "straight"), glm::length(a - b) + glm::length(b - c), 1e-9);
  EXPECT_NEAR(valueOf(straight, "straight_2_3"), glm::length(b - c), 1e-9);
}

// Of 1000 pairs of points of a ball's isosurface, the ball's own points are as far apart as is stated.
TEST(MarkEvaluator, StraightDistancesOnAnisotropicObliqueGrids) {
  for (const volume::GridGeometry& geometry : {anisotropicGeometry(48), obliqueLeftHandedGeometry(48)}) {
    const glm::dvec3 lengths = glm::dvec3(geometry.dims - 1) * geometry.spacingMm();
    const double radius = 0.35 * std::min({lengths.x, lengths.y, lengths.z});
    const glm::dvec3 centre(geometry.worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(geometry.dims - 1), 1.0));
    Measuring measure(
        prepared(gridOfWorld(geometry, [&](glm::dvec3 p) { return radius - glm::length(p - centre); })));
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto direction = [&] {
      const double x = normal(random), y = normal(random), z = normal(random);
      return glm::normalize(glm::dvec3(x, y, z));
    };
    double stated = 0.0, made = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 a = measure.onSurface(centre + radius * direction()),
                       b = measure.onSurface(centre + radius * direction());
      const double reference = radius * glm::length(glm::normalize(a - centre) - glm::normalize(b - centre));
      const app::MarkReport report = measure(MarkKind::distance, {a, b});
      expectWithinStated(report, "straight", reference);
      stated += *report.quantities[0].error;
      made += std::abs(report.quantities[0].value - reference);
    }
    EXPECT_LE(stated, 10.0 * made);  // and not by saying too much
  }
}

TEST(MarkEvaluator, AnglesAndCircles) {
  Measuring measure(phantom("ball", 24));
  EXPECT_NEAR(valueOf(measure(MarkKind::angle, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}), "angle"), 90.0, 1e-9);
  // The lines 1-2 and 3-4 lean by 60 degrees, and do not meet.
  const glm::dvec3 u(1, 0, 0), v(0.5, std::sqrt(0.75), 0.0), far(3, -2, 5);
  EXPECT_NEAR(valueOf(measure(MarkKind::angle, {{0, 0, 0}, u * 4.0, far, far + v * 2.0}), "angle"), 60.0,
              1e-9);
  EXPECT_NEAR(valueOf(measure(MarkKind::angle, {u * 4.0, {0, 0, 0}, far, far + v * 2.0}), "angle"), 120.0,
              1e-9);
  const app::MarkReport circle = measure(MarkKind::circle, {{3, 0, 0}, {0, 0, 0}, {0, 4, 0}});
  EXPECT_NEAR(valueOf(circle, "radius"), 2.5, 1e-9);
  EXPECT_LT(glm::length(*circle.centre - glm::dvec3(1.5, 2.0, 0.0)), 1e-9);
  EXPECT_THAT(measure(MarkKind::circle, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}).problem, HasSubstr("on a line"));
  EXPECT_THAT(measure(MarkKind::angle, {{0, 0, 0}, {0, 0, 0}, {2, 2, 2}}).problem, HasSubstr("coincide"));
}

TEST(MarkEvaluator, ThicknessAndPieceOfABall) {
  Measuring measure(phantom("ball", 64));
  const double r = 0.35 * 63.0, pi = std::numbers::pi;
  const app::MarkReport thickness = measure(MarkKind::thickness, {{0, 0, r}});
  expectWithinStated(thickness, "ray", 2.0 * r);
  expectWithinStated(thickness, "ball", 2.0 * r);
  EXPECT_EQ(thickness.line.size(), 2u);
  const app::MarkReport piece = measure(MarkKind::piece, {measure.onSurface({r, 0, 0})});
  expectWithinStated(piece, "volume", 4.0 / 3.0 * pi * r * r * r);
  expectWithinStated(piece, "area", 4.0 * pi * r * r);
  EXPECT_EQ(valueOf(piece, "pieces"), 1.0);
  EXPECT_THAT(measure(MarkKind::piece, {{30, 30, 30}}).problem, HasSubstr("no connected component"));
}

TEST(MarkEvaluator, APinSaysWhatTheVolumeHolds) {
  Measuring measure(phantom("ball", 64));
  const double r = 0.35 * 63.0;
  const glm::dvec3 at = measure.onSurface({0, r, 0});
  const app::MarkReport pin = measure(MarkKind::point, {at});
  EXPECT_EQ(pin.problem, "");
  EXPECT_EQ(pin.quantities[0].name, "value");
  EXPECT_NEAR(valueOf(pin, "value"), 0.0, 1e-6);
  EXPECT_NEAR(valueOf(pin, "y"), at.y, 0.0);
  EXPECT_NEAR(valueOf(pin, "voxel_j"), at.y + 31.5, 1e-9);
  EXPECT_NEAR(valueOf(pin, "kappa1"), 1.0 / r, 0.02 / r);
  EXPECT_NEAR(valueOf(pin, "kappa2"), 1.0 / r, 0.02 / r);
  EXPECT_NEAR(valueOf(pin, "normal_y"), 1.0, 1e-3);
  EXPECT_EQ(valueOf(pin, "surface"), 1.0);
  EXPECT_LT(valueOf(pin, "surface_distance"), 1e-6);
  EXPECT_THAT(pin.place, HasSubstr("X "));
  EXPECT_THAT(measure(MarkKind::point, {{500, 0, 0}}).problem, HasSubstr("outside the volume"));
}

// Positions of patients have letters, and a voxel is where the file says.
TEST(MarkEvaluator, PositionsOfPatientsHaveLetters) {
  Measuring measure(phantom("head", 48), 300.0);
  volume::Volume anatomical = measure.volume->volume;
  anatomical.axes = scene::WorldAxes::anatomical;
  base::Progress progress;
  app::MarkEvaluator evaluator(volume::prepareVolume(anatomical, progress), measure.scene);
  const app::MarkReport pin = evaluator.evaluate(markOf(MarkKind::point, {{-12.5, 3.25, 4.0}}), progress);
  EXPECT_EQ(pin.place, "R 12.50, P 3.25, S 4.00 mm");
}

TEST(MarkEvaluator, AMarkStaysAndSaysThatItsSurfaceHasLeft) {
  const auto ball = phantom("ball", 64);
  const double r = 0.35 * 63.0;
  Measuring before(ball), little(ball, 2.0), far(ball, 12.0);
  const std::vector<glm::dvec3> points{before.onSurface({r, 0, 0}), before.onSurface({0, r, 0})};
  EXPECT_TRUE(before(MarkKind::distance, points).notes.empty());
  for (Measuring* moved : {&little, &far}) {
    const app::MarkReport report = (*moved)(MarkKind::distance, points);
    EXPECT_DOUBLE_EQ(valueOf(report, "straight"), valueOf(before(MarkKind::distance, points), "straight"));
    ASSERT_EQ(report.notes.size(), 2u);
    EXPECT_THAT(report.notes[0], HasSubstr("point 1 "));
  }
  EXPECT_THAT(little(MarkKind::distance, points).notes[0], HasSubstr("point 1 lies 2 mm off the surface"));
  EXPECT_THAT(far(MarkKind::distance, points).notes[1], HasSubstr("point 2 is not on the surface"));
  EXPECT_THAT(far(MarkKind::path, points).problem, HasSubstr("within three voxels of point 1"));
  EXPECT_THAT(far(MarkKind::thickness, {points[0]}).problem, HasSubstr("within three voxels of the point"));
}

TEST(MarkEvaluator, TakesTheSurfaceThatIsNearest) {
  const auto ball = phantom("ball", 64);
  scene::Scene scene;
  scene.surfaces.front().value = 8.0;
  test::surfaceAt(scene, 2).shown = true;
  test::surfaceAt(scene, 2).value = 0.0;
  scene = scene::resolve(scene, ball->facts);
  app::MarkEvaluator evaluator(ball, scene);
  base::Progress progress;
  const double r = 0.35 * 63.0;
  const app::MarkReport outer = evaluator.evaluate(markOf(MarkKind::point, {{r, 0, 0}}), progress);
  EXPECT_EQ(valueOf(outer, "surface"), 3.0);
  const app::MarkReport inner = evaluator.evaluate(markOf(MarkKind::point, {{r - 8.0, 0, 0}}), progress);
  EXPECT_EQ(valueOf(inner, "surface"), 1.0);
  EXPECT_NEAR(valueOf(evaluator.evaluate(markOf(MarkKind::thickness, {{r, 0, 0}}), progress), "ray"), 2.0 * r,
              0.2);
}

TEST(MarkEvaluator, CameraAndLookChangeNothing) {
  const auto ball = phantom("ball", 24);
  Measuring measure(ball);
  scene::Scene other = measure.scene;
  other.camera.eye = glm::dvec3(1.0, 2.0, 300.0);
  other.look.mode = scene::LookMode::normal;
  other.surfaces.front().albedo = {0.1, 0.2, 0.3};
  EXPECT_TRUE(measure.evaluator->isFor(ball, other));
  other.surfaces.front().value = 1.0;
  EXPECT_FALSE(measure.evaluator->isFor(ball, other));
  EXPECT_FALSE(measure.evaluator->isFor(phantom("ball", 24), measure.scene));
}

TEST(MarkEvaluator, RefusesWrongNumbersOfPointsAndDoubtfulLengths) {
  Measuring measure(phantom("ball", 24));
  EXPECT_EQ(measure(MarkKind::angle, {{1, 0, 0}, {0, 0, 0}}).problem,
            "a mark of kind angle has three or four points, not 2");
  EXPECT_THAT(measure(MarkKind::distance, {{1, 0, 0}}).problem, HasSubstr("two points or more"));
  EXPECT_THAT(measure(MarkKind::thickness, {{1, 0, 0}, {2, 0, 0}}).problem, HasSubstr("one point"));
  volume::Volume assumed = measure.volume->volume;
  assumed.warnings = {"ElementSpacing is missing: 1 mm assumed"};
  base::Progress progress;
  const auto doubtful = volume::prepareVolume(assumed, progress);
  const Mark mark = markOf(MarkKind::distance, {{1, 0, 0}, {0, 0, 0}});
  app::MarkEvaluator strict(doubtful, measure.scene), anyway(doubtful, measure.scene, true);
  EXPECT_THAT(strict.evaluate(mark, progress).problem, HasSubstr("lengths are doubtful"));
  EXPECT_TRUE(strict.evaluate(mark, progress).quantities.empty());
  EXPECT_EQ(valueOf(anyway.evaluate(mark, progress), "straight"), 1.0);
  EXPECT_THAT(anyway.evaluate(mark, progress).notes[0], HasSubstr("lengths are doubtful"));
}

// Where slices lie is stated, what lies between them is not known: a number with the error that has.
TEST(MarkEvaluator, UnevenSlicesHaveALargerErrorAndNoRefusal) {
  Measuring even(phantom("ball", 24));
  volume::Volume resampled = even.volume->volume;
  resampled.warnings = {
      "slice distances are uneven (1.081 to 7 mm): resampled linearly from 28 onto 37 slices"};
  base::Progress progress;
  Measuring uneven(volume::prepareVolume(resampled, progress));
  const double radius = 0.35 * 23.0;
  const auto errorOf = [&](Measuring& measure, glm::dvec3 a, glm::dvec3 b) {
    const app::MarkReport report = measure(MarkKind::distance, {a, b});
    EXPECT_EQ(report.problem, "");
    EXPECT_FALSE(report.quantities.empty());
    return report.quantities.empty() ? 0.0 : report.quantities[0].error.value_or(0.0);
  };
  const auto onSurface = [&](glm::dvec3 along) { return even.onSurface(radius * along); };
  const glm::dvec3 top = onSurface({0, 0, 1}), bottom = onSurface({0, 0, -1}), left = onSurface({-1, 0, 0}),
                   right = onSurface({1, 0, 0});
  EXPECT_NEAR(errorOf(uneven, top, bottom) - errorOf(even, top, bottom), 7.0, 0.2) << "across the slices";
  EXPECT_NEAR(errorOf(uneven, left, right), errorOf(even, left, right), 0.2) << "within one";
  EXPECT_THAT(uneven(MarkKind::distance, {top, bottom}).notes[0], HasSubstr("slices are up to 7 mm apart"));
}

TEST(MarkEvaluator, AStopIsHeeded) {
  Measuring measure(phantom("ball", 48));
  measure.progress.requestStop();
  EXPECT_THROW(measure(MarkKind::path, {{16, 0, 0}, {0, 16, 0}}), base::Error);
}

}  // namespace
}  // namespace isolux::test
