// Curvature of noisy volumes at a ladder of scales and at the automatic one, against closed forms; how far
// its confidence can be believed; and how much of real scans has none.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <numeric>

#include <glm/geometric.hpp>

#include "bench/bench.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/field/scaled_field.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/statistics/visible_points.h"

namespace isolux::bench {
namespace {

constexpr int kSize = 96, kHeadSize = 128, kSeeds = 5;
constexpr std::size_t kPoints = 2000;
constexpr double kTrimmed =
    0.02;  // of the points, the worst: next to vanishing gradients errors have no bound

struct Shape {
  std::string name;
  volume::Grid clean;
  double isovalue = 0.0, contrast = 0.0;
  std::function<test::Curvature(glm::dvec3 world)> reference;
};

// A distance seen through a point spread of one voxel: contrast 100 from one side to the other.
double edgeOf(double voxels) {
  return 50.0 * (1.0 + std::erf(voxels / std::sqrt(2.0)));
}

Shape closedForm(const std::string& name) {
  const volume::GridGeometry geometry = test::unitGeometry(glm::ivec3(kSize));
  const std::shared_ptr<const test::AnalyticField> field = test::analyticField(name, geometry);
  const auto reference = [field](glm::dvec3 world) { return field->curvature(world); };
  if (name == "gyroid") return {name, test::phantomGrid(name, geometry), 0.0, 3.0, reference};
  const auto edge = [&](glm::dvec3 world) {
    const test::Derivatives d = field->at(world);
    return edgeOf(d.value / glm::length(d.gradient));
  };
  return {name, test::gridOfWorld(geometry, edge), 50.0, 100.0, reference};
}

// What the noise-free head has at scale 0: the formulas of its organs have no curvature of their own.
Shape headShape(const char* name, double isovalue) {
  const auto head = std::make_shared<const volume::Grid>(test::phantomGrid("head", kHeadSize));
  const auto reference = [head](glm::dvec3 world) {
    const volume::GridGeometry& geometry = head->geometry();
    const volume::FieldSample s =
        volume::sampleCubic(*head, glm::dvec3(geometry.voxelFromWorld() * glm::dvec4(world, 1.0)));
    const volume::PrincipalCurvature k = volume::principalCurvature(
        volume::worldGradient(geometry, s.gradient), volume::worldHessian(geometry, s.hessian));
    return test::Curvature{k.kappa1, k.kappa2};
  };
  return {name, *head, isovalue, 1000.0, reference};
}

struct Noise {
  const char* name;
  glm::dvec3 blur;
};
constexpr int kNoises = 3;
const std::array<Noise, kNoises>& noises() {
  static const std::array<Noise, kNoises> list = {Noise{"white", glm::dvec3(0.0)},
                                                  Noise{"over 2 voxels", glm::dvec3(1.0)},
                                                  Noise{"between slices", glm::dvec3(0.0, 0.0, 1.0)}};
  return list;
}

using Volume = std::shared_ptr<const volume::PreparedVolume>;

std::vector<glm::dvec3> surfacePoints(const volume::PreparedVolume& volume, double isovalue) {
  std::vector<glm::dvec3> points;
  for (const volume::VisiblePoint& p :
       volume::visiblePoints(volume.grid(), *volume.blocks, isovalue, kPoints)) {
    const glm::dvec3 inside = glm::min(p.voxel, glm::dvec3(volume.grid().dims() - 1) - p.voxel);
    if (std::min({inside.x, inside.y, inside.z}) >= 3.0) points.push_back(p.voxel);
  }
  return points;
}

struct AtPoint {
  volume::PrincipalCurvature curvature;
  glm::dvec3 gradient;
};

std::vector<AtPoint> curvaturesAt(const volume::PreparedVolume& volume, const std::vector<glm::dvec3>& points,
                                  double scaleMm) {
  base::Progress progress;
  const volume::Grid& grid = volume.grid();
  const auto scaled = volume.cubicFields->make(scene::Field::cubic, scaleMm, progress);
  std::vector<AtPoint> list;
  for (const glm::dvec3& point : points) {
    const volume::FieldSample s =
        scaled ? volume::sampleScaled(*scaled, grid, point) : volume::sampleCubic(grid, point);
    const glm::dvec3 gradient = volume::worldGradient(grid.geometry(), s.gradient);
    list.push_back(
        {volume::principalCurvature(gradient, volume::worldHessian(grid.geometry(), s.hessian)), gradient});
  }
  return list;
}

double trimmedMean(std::vector<double> squares) {
  std::erase_if(squares, [](double s) { return !std::isfinite(s); });
  std::sort(squares.begin(), squares.end());
  squares.resize(squares.size() - static_cast<std::size_t>(kTrimmed * static_cast<double>(squares.size())));
  return std::accumulate(squares.begin(), squares.end(), 0.0) / static_cast<double>(squares.size());
}

double meanSquareError(const std::vector<AtPoint>& found, const std::vector<test::Curvature>& reference) {
  std::vector<double> squares;
  for (std::size_t i = 0; i < found.size(); ++i)
    squares.push_back(0.5 * (std::pow(found[i].curvature.kappa1 - reference[i].kappa1, 2) +
                             std::pow(found[i].curvature.kappa2 - reference[i].kappa2, 2)));
  return trimmedMean(std::move(squares));
}

// Of points with much confidence: those whose curvatures are right within a fifth, or 0.1 / diagonal.
struct Belief {
  long points = 0, confident = 0, right = 0;
  void add(const AtPoint& at, const test::Curvature& reference, const volume::CurvatureScale& scale) {
    ++points;
    if (volume::curvatureConfidence(at.curvature, at.gradient, scale) < 0.9) return;
    ++confident;
    const double size = std::max(std::abs(reference.kappa1), std::abs(reference.kappa2));
    const double allowed = std::max(0.2 * size, scale.flatCurvature);
    right += std::abs(at.curvature.kappa1 - reference.kappa1) <= allowed &&
                     std::abs(at.curvature.kappa2 - reference.kappa2) <= allowed
                 ? 1
                 : 0;
  }
};

volume::CurvatureScale confidenceScale(const volume::PreparedVolume& volume,
                                       const volume::DerivativeChoice& choice) {
  base::Progress progress;
  return volume::curvatureScale(volume.grid().geometry(), scene::Field::cubic, choice.noise,
                                volume.derivativeChoices->noise(progress).correlation, choice.scaleMm);
}

// Scales of the table, voxels. Below 1 / sqrt 3 all are as 0: the spline smooths as much by itself.
const std::array<double, 7>& ladder() {
  static const std::array<double, 7> scales = {0.0, 0.7071, 1.0, 1.4142, 2.0, 2.8284, 4.0};
  return scales;
}

struct Row {
  std::array<double, 7> fixed{};  // mean squares over seeds
  double automatic = 0.0, milliseconds = 0.0, scale = 0.0;
  Belief belief;
};

void addVolume(const Shape& shape, const volume::Grid& grid, Row& row) {
  const Volume volume = test::prepared(volume::Grid(grid));
  const double spacing = grid.geometry().spacingMm().x;
  const std::vector<glm::dvec3> points = surfacePoints(*volume, shape.isovalue);
  std::vector<test::Curvature> reference;
  for (const glm::dvec3& point : points)
    reference.push_back(shape.reference(glm::dvec3(grid.geometry().worldFromVoxel * glm::dvec4(point, 1.0))));
  for (std::size_t i = 0; i < ladder().size(); ++i)
    row.fixed[i] += meanSquareError(curvaturesAt(*volume, points, spacing * ladder()[i]), reference) / kSeeds;
  base::Progress progress;
  volume->derivativeChoices->noise(progress);
  const auto begin = std::chrono::steady_clock::now();
  const volume::DerivativeChoice choice = volume->derivativeChoices->choose({shape.isovalue}, progress);
  row.milliseconds +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() / kSeeds;
  row.scale += choice.scaleMm / spacing / kSeeds;
  const std::vector<AtPoint> found = curvaturesAt(*volume, points, choice.scaleMm);
  row.automatic += meanSquareError(found, reference) / kSeeds;
  const volume::CurvatureScale scale = confidenceScale(*volume, choice);
  for (std::size_t i = 0; i < found.size(); ++i) row.belief.add(found[i], reference[i], scale);
}

volume::Grid withNoiseOf(const Shape& shape, double deviation, const std::vector<float>& noise) {
  const glm::ivec3 dims = shape.clean.dims();
  std::vector<float> values;
  values.reserve(noise.size());
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        values.push_back(static_cast<float>(shape.clean.value(x, y, z) + deviation * noise[values.size()]));
  return volume::Grid(shape.clean.geometry(), std::move(values));
}

void printRow(const Shape& shape, const Noise& noise, double part, const Row& row) {
  const double spacing = shape.clean.geometry().spacingMm().x;
  const auto best = std::min_element(row.fixed.begin(), row.fixed.end());
  std::printf("%-7s %-15s %3.0f %% |", shape.name.c_str(), noise.name, 100.0 * part);
  for (const double square : row.fixed) std::printf(" %.4f", std::sqrt(square) * spacing);
  std::printf(" | %.4f, ratio %.3f, scale %.2f (best %.2f), %3.0f ms | confident %4.1f %%, right %5.1f %%\n",
              std::sqrt(row.automatic) * spacing, std::sqrt(row.automatic / *best), row.scale,
              ladder()[static_cast<std::size_t>(best - row.fixed.begin())], row.milliseconds,
              100.0 * static_cast<double>(row.belief.confident) / static_cast<double>(row.belief.points),
              100.0 * static_cast<double>(row.belief.right) /
                  static_cast<double>(std::max(1L, row.belief.confident)));
  std::fflush(stdout);
}

std::vector<Shape> shapes() {
  std::vector<Shape> list;
  for (const char* name : {"torus", "saddle", "gyroid"}) list.push_back(closedForm(name));
  list.push_back(headShape("skin", -300.0));
  list.push_back(headShape("bone", 300.0));
  return list;
}

void runPhantoms() {
  std::printf(
      " RMS error of kappa1 and kappa2, 1/voxel, at scales of 0 to 4 voxels, and at the automatic one\n");
  const std::vector<Shape> list = shapes();
  std::map<std::pair<int, int>, std::vector<float>> fields;  // by size and seed, of one kind of noise
  for (const Noise& noise : noises()) {
    fields.clear();
    for (const Shape& shape : list)
      for (const double part : {0.01, 0.02, 0.05, 0.1}) {
        Row row;
        for (int seed = 1; seed <= kSeeds; ++seed) {
          std::vector<float>& field = fields[{shape.clean.dims().x, seed}];
          if (field.empty())
            field = test::blurredNoise(shape.clean.dims(), noise.blur, static_cast<std::uint64_t>(seed));
          addVolume(shape, withNoiseOf(shape, part * shape.contrast, field), row);
        }
        printRow(shape, noise, part, row);
      }
  }
}

struct Scan {
  const char* file;
  double isovalue;
};

void runScans() {
  const std::filesystem::path data = test::dataFolder();
  if (data.empty()) return;
  std::printf(
      " scans: share of visible points without confidence (< 0.5) at scale 0 and at the automatic one\n");
  for (const Scan& scan :
       {Scan{"mri_colin27.nii.gz", 40.0}, Scan{"ct_head_pitch.nii.gz", 100.0},
        Scan{"ct_head_skin_bone.nii.gz", 0.196}, Scan{"ct_head_skin_bone.nii.gz", 0.51},
        Scan{"ct_avm.nii.gz", 130.0}, Scan{"tooth.mhd", 600.0}, Scan{"engine.nii.gz", 80.0}}) {
    scene::Source source;
    source.path = (data / "volumes" / scan.file).string();
    base::Progress progress;
    const Volume volume = volume::loadVolume(source, progress);
    const volume::DerivativeChoice choice = volume->derivativeChoices->choose({scan.isovalue}, progress);
    const std::vector<glm::dvec3> points = surfacePoints(*volume, scan.isovalue);
    const auto unknown = [&](const volume::DerivativeChoice& at) {
      const volume::CurvatureScale scale = confidenceScale(*volume, at);
      long count = 0;
      for (const AtPoint& p : curvaturesAt(*volume, points, at.scaleMm))
        count += volume::curvatureConfidence(p.curvature, p.gradient, scale) < 0.5 ? 1 : 0;
      return 100.0 * static_cast<double>(count) /
             static_cast<double>(std::max<std::size_t>(points.size(), 1));
    };
    volume::DerivativeChoice none = choice;
    none.scaleMm = 0.0;
    std::printf(
        "  %-26s %6.3g: %4.1f %% -> %4.1f %%; noise %.3g (%s); scale %.3g mm (%s); normals %.3g mm (%s)\n",
        scan.file, scan.isovalue, unknown(none), unknown(choice), choice.noise, choice.noiseReason.c_str(),
        choice.scaleMm, choice.scaleReason.c_str(), choice.normalScaleMm, choice.normalReason.c_str());
    std::fflush(stdout);
  }
}

const Registration phantoms("derivative_scale",
                            "error of curvature at automatic and fixed scales, closed forms", runPhantoms);
const Registration scans("derivative_scale_scans", "how much of scans has no confidence, at automatic scales",
                         runScans);

}  // namespace
}  // namespace isolux::bench
