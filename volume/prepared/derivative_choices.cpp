#include "volume/prepared/derivative_choices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.h"
#include "volume/statistics/interpolated_slices.h"
#include "volume/statistics/noise_estimate.h"
#include "volume/statistics/scale_ladder.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPoints = 600;       // at which scales are measured
constexpr std::size_t kManyPoints = 6000;  // at which terraces are looked for
constexpr std::size_t kFewest = 30;        // below, nothing is known
// What noise may do at scale 0 before a scale is looked for.
constexpr double kCleanCurvature = 0.02;                         // of the root mean square
constexpr double kCleanNormal = 0.5 * std::numbers::pi / 180.0;  // radians
// Geometric mean over the axes, voxels: noise that is alike over more cannot be told from detail.
constexpr double kLikeDetail = 0.8;
constexpr double kRough = 1.2;  // times the noise of voxels
// Of what is seen, without confidence, before 0 is refused; and what a scale may then add to the error.
constexpr double kMostUnknown = 0.2, kHardlyMore = 1.15;
// Terraces of interpolated slices: the power that shows them (by chance once in e^12), and the scale that
// leaves exp(-2 pi^2 0.6^2) = 0.001 of them, in parts of the distance.
constexpr double kShownTerraces = 12.0, kTerraces = 0.6;

// Away from the border, where samples are repeated.
std::vector<glm::dvec3> pointsWithin(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                     std::size_t wanted) {
  constexpr double margin = 2.0;
  std::vector<glm::dvec3> points;
  for (const VisiblePoint& point : visiblePoints(grid, blocks, isovalue, wanted)) {
    const glm::dvec3 far = glm::dvec3(grid.dims() - 1) - point.voxel;
    const glm::dvec3 near = glm::min(point.voxel, far);
    if (std::min({near.x, near.y, near.z}) >= margin) points.push_back(point.voxel);
  }
  return points;
}

struct ScaleChoice {
  std::size_t step = 0;
  ScaleErrors errors;
  bool settled = false;  // no larger scale can be better
};

// What roughness leaves at larger scales is not known as well as what noise leaves: of scales nearly as good
// as the best the largest.
ScaleChoice judged(std::span<const ScaleStep> steps, double noiseVariance, bool clean, bool rough) {
  constexpr double nearly = 1.35;  // of the root mean square error
  ScaleChoice verdict{.errors = scaleErrors(steps, noiseVariance)};
  const ScaleErrors& e = verdict.errors;
  const double allowed = (rough ? nearly * nearly : 1.0) * (e.noise[e.best] + e.lost[e.best]);
  verdict.step = clean ? 0 : e.best;
  for (std::size_t i = e.best; !clean && i < steps.size(); ++i)
    if (e.noise[i] + e.lost[i] <= allowed) verdict.step = i;
  verdict.settled = clean || e.lost.back() > allowed;
  return verdict;
}

struct Search {
  ScaleLadder::Measures measures;
  double noise = 0.0;  // as the surface shows it
  bool cleanCurvature = false;
  ScaleChoice curvature, normal;
};

void judge(Search& search, const DerivativeQuestion& question, double estimated) {
  const ScaleLadder::Measures& m = search.measures;
  const double variance =
      question.noise ? estimated * estimated : surfaceNoise(m.curvature, estimated * estimated);
  search.noise = std::sqrt(variance);
  const bool rough = variance > kRough * kRough * estimated * estimated;
  search.cleanCurvature =
      variance * m.curvature[0].noise <= kCleanCurvature * kCleanCurvature * m.meanSquareCurvature[0];
  const bool cleanNormal = variance * m.normal[0].noise <= kCleanNormal * kCleanNormal;
  search.curvature = judged(m.curvature, variance, search.cleanCurvature, rough);
  search.normal = judged(m.normal, variance, cleanNormal, false);
}

// Scale after scale, until larger ones only lose.
Search searchScales(ScaleLadder& ladder, const DerivativeQuestion& question, double noise,
                    base::Progress& progress) {
  constexpr std::size_t fewestSteps = 5;  // that tell how rough a surface is
  Search search;
  search.noise = noise;
  do {
    progress.throwIfStopped();
    ladder.addScale(progress);
    search.measures = ladder.measures();
    if (search.measures.points < kFewest) break;
    judge(search, question, noise);
  } while (!ladder.complete() && (search.measures.curvature.size() < fewestSteps ||
                                  !(search.curvature.settled && search.normal.settled)));
  return search;
}

std::string percentText(double part) {
  return base::shortText(100.0 * part, 2) + " %";
}

// Where noise hides much of what is seen at scale 0: the scale that is best for the half that bends evenly,
// of those that are hardly worse for the whole. RMS errors are ruled by edges, pictures by what lies between.
std::size_t stepOfEvenHalf(const ScaleLadder& ladder, const ScaleErrors& whole) {
  const ScaleErrors half = scaleErrors(ladder.evenMeasures().curvature, whole.noiseVariance);
  const auto sum = [](const ScaleErrors& e, std::size_t i) { return e.noise[i] + e.lost[i]; };
  std::size_t step = 0;
  for (std::size_t i = 1; i < whole.noise.size(); ++i)
    if (sum(whole, i) <= kHardlyMore * kHardlyMore * sum(whole, 0) && sum(half, i) < sum(half, step))
      step = i;
  return step;
}

// unknown: the share of what is seen that noise hides at scale 0. refused: which is why there is a scale.
std::string scaleReason(const DerivativeChoice& choice, double unknown, bool refused) {
  const double* const noise = choice.curvatureNoise;
  const auto part = [&](double of) {
    return percentText(choice.curvature > 0.0 ? of / choice.curvature : 0.0);
  };
  const std::string hidden = "hides it on " + percentText(unknown) + " of the visible surface";
  if (choice.scaleMm == 0.0)
    return "noise is " + part(noise[0]) + " of the curvature" +
           (unknown > kMostUnknown ? " and " + hidden : "") + ", any scale loses more";
  if (refused)
    return "noise is " + part(noise[0]) + " of the curvature and " + hidden +
           ", smooth parts have less error at this scale and edges hardly more";
  return "noise falls from " + part(noise[0]) + " to " + part(noise[1]) +
         " of the curvature, larger scales lose more shape";
}

// kept: why nothing may be taken away; empty: it may.
std::string normalReason(const DerivativeChoice& choice, const std::string& kept) {
  if (!kept.empty()) return kept;
  const auto degrees = [](double radians) {
    return base::shortText(radians * 180.0 / std::numbers::pi, 2) + " degrees";
  };
  const double* const noise = choice.normalNoise;
  if (choice.normalScaleMm == 0.0)
    return "noise turns normals by " + degrees(noise[0]) + ", any scale turns them more";
  return "noise turns normals by " + degrees(noise[1]) + " instead of " + degrees(noise[0]);
}

struct LeastScale {
  double mm = 0.0;
  std::string reason;
};

// Where voxels are much longer one way, slices show as terraces: at half of that length they still do, at
// this part of it they do not. 0 where voxels are alike, more or less.
LeastScale scaleOfThickSlices(const GridGeometry& geometry) {
  constexpr double alike = 1.5, part = 0.8;
  const double most = geometry.mostSpacingMm();
  if (most <= alike * geometry.leastSpacingMm()) return {};
  return {part * most, "four fifths of the distance between slices, which would show as terraces"};
}

LeastScale scaleOfInterpolatedSlices(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                     const glm::dvec3& slices, const glm::dvec3& noiseBlur,
                                     base::Progress& progress) {
  LeastScale least;
  if (slices == glm::dvec3(0.0)) return least;
  ScaleLadder ladder(grid, pointsWithin(grid, blocks, isovalue, kManyPoints), noiseBlur);
  for (int i = 0; i < 3; ++i) ladder.addScale(progress);
  for (int axis = 0; axis < 3; ++axis) {
    const double mm = slices[axis] * grid.geometry().spacingMm()[axis];
    if (kTerraces * mm <= least.mm || ladder.repetition(axis, slices[axis]) < kShownTerraces) continue;
    least = {kTerraces * mm, "six tenths of the " + base::shortText(mm, 3) +
                                 " mm between the slices that the volume was interpolated from, which would "
                                 "show as terraces"};
  }
  return least;
}

std::string noiseReason(double estimated, double believed) {
  if (believed < estimated)
    return "the surface changes too little from scale to scale for the " + base::shortText(estimated, 3) +
           " that neighbouring voxels differ by";
  if (believed > estimated)
    return "neighbouring voxels have " + base::shortText(estimated, 3) + ", but the surface is rougher";
  return "differences between neighbouring voxels";
}

// Pictures lose no detail: not a voxel's, and none that noise only may be.
std::size_t normalStep(const ScaleLadder& ladder, const Search& search, const GridGeometry& geometry,
                       bool keepsAll) {
  const double most = 1.001 * geometry.leastSpacingMm();
  std::size_t step = keepsAll ? 0 : search.normal.step;
  while (ladder.scaleMm(step) > most) --step;
  return step;
}

DerivativeChoice choiceOf(const ScaleLadder& ladder, const Search& search, const Grid& grid, double noise,
                          LeastScale least, const std::string& kept) {
  DerivativeChoice choice;
  choice.noise = search.noise;
  choice.noiseReason = noiseReason(noise, search.noise);
  if (search.measures.points < kFewest) {
    const bool seen = ladder.points() >= kFewest;
    choice.scaleReason = choice.normalReason =
        seen && grid.missingCount() > 0 ? "too little of the surface is clear of missing voxels to measure it"
                                        : "too little of the surface is visible to measure it";
    return choice;
  }
  const double unknown = search.cleanCurvature ? 0.0 : ladder.unknownShare(search.noise);
  const bool refused = search.curvature.step == 0 && unknown > kMostUnknown;
  const std::size_t chosen =
      refused ? stepOfEvenHalf(ladder, search.curvature.errors) : search.curvature.step;
  if (LeastScale thick = scaleOfThickSlices(grid.geometry()); !search.cleanCurvature && thick.mm > least.mm)
    least = std::move(thick);
  choice.scaleMm = std::max(least.mm, ladder.scaleMm(chosen));
  const std::size_t normal = normalStep(ladder, search, grid.geometry(), !kept.empty());
  choice.normalScaleMm = ladder.scaleMm(normal);
  const auto rms = [&](const ScaleStep& step) { return choice.noise * std::sqrt(step.noise); };
  choice.curvatureNoise[0] = rms(search.measures.curvature[0]);
  choice.curvatureNoise[1] = rms(search.measures.curvature[chosen]);
  choice.normalNoise[0] = rms(search.measures.normal[0]);
  choice.normalNoise[1] = rms(search.measures.normal[normal]);
  choice.curvature = std::sqrt(search.measures.meanSquareCurvature[chosen]);
  choice.scaleReason =
      least.mm > ladder.scaleMm(chosen) ? least.reason : scaleReason(choice, unknown, refused);
  choice.normalReason = normalReason(choice, search.normal.step > 0 ? kept : "");
  return choice;
}

// Where voxels stay in their file no noise is measured, and derivatives are those of the samples.
DerivativeChoice choiceWithoutVoxels(const DerivativeQuestion& question) {
  DerivativeChoice choice;
  choice.noise = question.noise.value_or(0.0);
  choice.noiseReason = choice.scaleReason = choice.normalReason =
      "its voxels stay in the file (memory.voxels), and are not measured";
  return choice;
}

DerivativeQuestion questionOf(const scene::Scene& scene) {
  return {scene.surfaces.front().value.value(), scene.derivatives.field, scene.derivatives.noise};
}

void fillIn(scene::Derivatives& derivatives, const DerivativeChoice& choice) {
  if (!derivatives.noise) derivatives.noise = choice.noise;
  if (!derivatives.scale) derivatives.scale = choice.scaleMm;
  if (!derivatives.normalScale) derivatives.normalScale = choice.normalScaleMm;
}

bool isComplete(const scene::Derivatives& derivatives) {
  return derivatives.noise && derivatives.scale && derivatives.normalScale;
}

}  // namespace

scene::NoiseModel DerivativeChoices::noise(base::Progress& progress) const {
  if (knownNoise_ || !grid_->isWhole()) return {{0.0}, {knownNoise_.value_or(0.0)}, glm::dvec3(0.0)};
  return noise_.get({}, [&] { return estimateNoise(*grid_, progress); });
}

std::optional<DerivativeChoice> DerivativeChoices::find(const DerivativeQuestion& question) const {
  if (knownNoise_ == 0.0 && !question.noise) {
    DerivativeChoice choice;
    choice.noiseReason = choice.scaleReason = choice.normalReason = "the source has no noise";
    return choice;
  }
  return choices_.find(question);
}

DerivativeChoice DerivativeChoices::choose(const DerivativeQuestion& question,
                                           base::Progress& progress) const {
  if (const auto found = find(question)) return *found;
  if (!grid_->isWhole()) return choiceWithoutVoxels(question);
  return choices_.get(question, [&] { return measured(question, progress); });
}

DerivativeChoice DerivativeChoices::measured(const DerivativeQuestion& question,
                                             base::Progress& progress) const {
  const scene::NoiseModel model = noise(progress);
  const double noise = question.noise.value_or(model.at(question.isovalue));
  DerivativeChoice choice;
  if (question.field == scene::Field::trilinear) {
    choice.noise = noise;
    choice.noiseReason = "differences between neighbouring voxels";
    choice.scaleReason = choice.normalReason = "the trilinear field has no scale";
  } else {
    std::string kept;
    if (scene::meanBlur(model.correlation) >= kLikeDetail)
      kept = "smoothing would remove correlated noise and detail alike";
    if (isMesh_) kept = "the roughness of a mesh is not noise";
    ScaleLadder ladder(*grid_, pointsWithin(*grid_, *blocks_, question.isovalue, kPoints), model.correlation);
    const Search search = searchScales(ladder, question, noise, progress);
    LeastScale least;
    if (question.noise != 0.0 && !isMesh_ && search.measures.points >= kFewest) {
      const glm::dvec3 slices = slices_.get({}, [&] { return interpolatedSlices(*grid_, progress); });
      least =
          scaleOfInterpolatedSlices(*grid_, *blocks_, question.isovalue, slices, model.correlation, progress);
    }
    choice = choiceOf(ladder, search, *grid_, noise, std::move(least), kept);
  }
  return choice;
}

bool DerivativeChoices::completeIfChosen(scene::Scene& scene) const {
  if (isComplete(scene.derivatives)) return true;
  const auto choice = find(questionOf(scene));
  if (choice) fillIn(scene.derivatives, *choice);
  return choice.has_value();
}

void DerivativeChoices::complete(scene::Scene& scene, base::Progress& progress) const {
  if (isComplete(scene.derivatives)) return;
  fillIn(scene.derivatives, choose(questionOf(scene), progress));
}

}  // namespace isolux::volume
