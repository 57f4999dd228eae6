// Which of the measured combinations of settings is taken: pure functions of numbers.
//
// A choice goes by bounds, not by what was measured: an error is measured on a part of the view's pixels, and
// the picture itself errs a little differently.
//   depth, normals, curvature: a margin (Measuring) times the 99 % quantile that was measured;
//   missed: between limits of the number of such pixels that one picture in a thousand exceeds, were they
//     spread by chance (Poisson), widened because they come in clusters: k + 4.8 + 4 sqrt(k + 1), k - 4
//     sqrt(k); 0 where none was found and the search for hits is complete;
//   light: three standard errors to both sides of the root mean square; on most pixels one.
// Measured on all of the picture's pixels, what was measured is the bound.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/accuracy/error_limits.h"
#include "app/study/study_errors.h"

namespace isolux::app {

// On which pixels errors were measured: a part of the view's, more and more of them, or the picture's own.
enum class Measuring { few, many, most, picture };
constexpr double marginOf(Measuring measuring) {
  constexpr double margins[] = {1.25, 1.1, 1.05, 1.0};
  return margins[static_cast<int>(measuring)];
}
// The part of the time that was asked for which a picture may take: the rest is for clocks.
inline constexpr double kTimeMargin = 0.85;

// A combination of settings, as changes of the scene that was given.
struct Candidate {
  std::vector<std::string> assignments;  // PATH=VALUE; none: the scene as it was given
  double cost = 0.0;                     // work, app/error_budget/work.h
  bool complete = false;                 // every cell that a ray crosses is searched: nothing can be missed
  int supersampling = 1;
};
struct MeasuredCandidate {
  Candidate candidate;
  TargetErrors errors;
  double milliseconds = std::numeric_limits<double>::quiet_NaN();  // NaN: was not timed
};

// `complete`: as of the candidate.
TargetErrors surfaceErrors(const Errors& errors, Measuring measuring, bool complete);
ErrorBound lightBound(const LightErrors& errors, Measuring measuring);

bool keeps(const TargetErrors& errors, std::span<const Limit> limits);
// Measured on more pixels they may be kept.
bool mayKeep(const TargetErrors& errors, std::span<const Limit> limits);
// The largest of bound over limit; infinite where something was not measured, or a limit of 0 is not kept.
double worstRatio(const TargetErrors& errors, std::span<const Limit> limits);
// The first of least cost among those that keep the limits; none: nothing does.
std::optional<std::size_t> cheapestThatKeeps(std::span<const MeasuredCandidate> measured,
                                             std::span<const Limit> limits);
// The one that comes nearest to the limits. `measured` is not empty.
std::size_t nearestTo(std::span<const MeasuredCandidate> measured, std::span<const Limit> limits);

// From the most accurate on, by worstRatio() of `units`. Errors within a factor of two count as equal: then
// more rays per pixel come first, then smaller errors, then less work. What another one beats in every error,
// with at least as many rays per pixel, for no more work, is left out.
std::vector<std::size_t> byAccuracy(std::span<const MeasuredCandidate> measured,
                                    std::span<const Limit> units);

}  // namespace isolux::app
