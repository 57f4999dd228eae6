#include "app/error_budget/choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace isolux::app {

namespace {

constexpr double kWithoutBound = std::numeric_limits<double>::infinity();

ErrorBound boundsOfCount(double count) {
  constexpr double sure = 4.0;  // 1.3 times the 3.09 deviations of 0.1 %
  return {.value = count,
          .least = std::max(count - sure * std::sqrt(count), 0.0),
          .bound = count + 4.8 + sure * std::sqrt(count + 1.0)};
}

ErrorBound quantileBound(const Spread& spread, Measuring measuring) {
  const double margin = marginOf(measuring);
  return {.value = spread.most99, .least = spread.most99 / margin, .bound = spread.most99 * margin};
}

bool beats(const MeasuredCandidate& one, const MeasuredCandidate& other, std::span<const Limit> units) {
  bool better = one.candidate.cost < other.candidate.cost ||
                one.candidate.supersampling > other.candidate.supersampling;
  if (one.candidate.cost > other.candidate.cost ||
      one.candidate.supersampling < other.candidate.supersampling)
    return false;
  for (const Limit& unit : units) {
    const double a = one.errors[indexOf(unit.quantity)].bound, b = other.errors[indexOf(unit.quantity)].bound;
    if (!(a <= b)) return false;
    better = better || a < b;
  }
  return better;
}

}  // namespace

TargetErrors surfaceErrors(const Errors& errors, Measuring measuring, bool complete) {
  TargetErrors found;
  found[indexOf(Quantity::depthMm)] = quantileBound(errors.depthMm, measuring);
  found[indexOf(Quantity::depthVoxels)] = quantileBound(errors.depthVoxels, measuring);
  found[indexOf(Quantity::normal)] = quantileBound(errors.normalDegrees, measuring);
  found[indexOf(Quantity::curvature)] = quantileBound(errors.curvature, measuring);
  const auto wrong = static_cast<double>(errors.missed + errors.invented);
  const auto surface = static_cast<double>(errors.surface);
  const bool known = measuring == Measuring::picture || (wrong == 0.0 && complete);
  const ErrorBound count = known ? ErrorBound{wrong, wrong, wrong} : boundsOfCount(wrong);
  found[indexOf(Quantity::missed)] = {count.value / surface, count.least / surface, count.bound / surface};
  return found;
}

// Pixels are drawn from the picture's by lot, so that the standard error holds though neighbours share texels
// and their noise; but what errs most is rare, and on few pixels it may be absent.
ErrorBound lightBound(const LightErrors& errors, Measuring measuring) {
  const double sure = (measuring < Measuring::most ? 3.0 : 1.0) * errors.rmseStandardError;
  return {.value = errors.relative(errors.rmse),
          .least = errors.relative(std::max(errors.rmse - sure, 0.0)),
          .bound = errors.relative(errors.rmse + sure)};
}

double worstRatio(const TargetErrors& errors, std::span<const Limit> limits) {
  double worst = 0.0;
  for (const Limit& limit : limits) {
    const double bound = errors[indexOf(limit.quantity)].bound;
    if (std::isnan(bound)) return kWithoutBound;
    if (bound > 0.0) worst = std::max(worst, limit.most > 0.0 ? bound / limit.most : kWithoutBound);
  }
  return worst;
}

bool keeps(const TargetErrors& errors, std::span<const Limit> limits) {
  return worstRatio(errors, limits) <= 1.0;
}

bool mayKeep(const TargetErrors& errors, std::span<const Limit> limits) {
  return std::ranges::all_of(
      limits, [&](const Limit& limit) { return errors[indexOf(limit.quantity)].least <= limit.most; });
}

std::optional<std::size_t> cheapestThatKeeps(std::span<const MeasuredCandidate> measured,
                                             std::span<const Limit> limits) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (keeps(measured[i].errors, limits) &&
        (!best || measured[i].candidate.cost < measured[*best].candidate.cost))
      best = i;
  return best;
}

std::size_t nearestTo(std::span<const MeasuredCandidate> measured, std::span<const Limit> limits) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < measured.size(); ++i)
    if (worstRatio(measured[i].errors, limits) < worstRatio(measured[best].errors, limits)) best = i;
  return best;
}

std::vector<std::size_t> byAccuracy(std::span<const MeasuredCandidate> measured,
                                    std::span<const Limit> units) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (std::ranges::none_of(
            measured, [&](const MeasuredCandidate& other) { return beats(other, measured[i], units); }))
      order.push_back(i);
  const auto rank = [&](std::size_t i) {
    const MeasuredCandidate& one = measured[i];
    const double ratio = worstRatio(one.errors, units);
    // What errs by less than half a unit is as good as exact.
    const double classOfTwo = std::ceil(std::log2(std::max(ratio, 0.5)));
    return std::tuple(classOfTwo, -one.candidate.supersampling, ratio, one.candidate.cost, i);
  };
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

}  // namespace isolux::app
