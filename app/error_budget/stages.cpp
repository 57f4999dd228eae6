#include "app/error_budget/stages.h"

#include <cmath>
#include <map>

#include "app/error_budget/candidates.h"

namespace isolux::app {

namespace {

// What more paths on a lattice would leave of its error, from the last two numbers of paths that were tried.
class ErrorOfPlace {
 public:
  // The square of noise falls with the number of paths, of few paths that find what is bright by chance more
  // slowly: taken as its power of 0.75, so that little is given up that more paths would mend.
  void add(double paths, double error) {
    const double fall = std::pow(paths, 0.75), square = error * error;
    if (fall_ > 0.0 && fall > fall_) left_ = (fall * square - fall_ * square_) / (fall - fall_);
    fall_ = fall;
    square_ = square;
  }
  bool surelyAbove(double limit) const { return left_ > kSure * kSure * limit * limit; }

 private:
  static constexpr double kSure = 1.1;
  double fall_ = 0.0, square_ = 0.0;  // of the last number of paths
  double left_ = 0.0;                 // squared
};

}  // namespace

MeasuredCandidate measuredAsNeeded(const Candidate& candidate, std::span<const Limit> limits,
                                   const MeasureCandidate& measure) {
  TargetErrors errors;
  for (const Measuring measuring : {Measuring::few, Measuring::many, Measuring::most}) {
    errors = measure(candidate, measuring);
    if (keeps(errors, limits) || !mayKeep(errors, limits)) break;
  }
  return {candidate, errors};
}

std::optional<std::size_t> chooseSurface(std::span<const Candidate> list, std::span<const Limit> limits,
                                         const MeasureCandidate& measure, const Report& report,
                                         std::vector<MeasuredCandidate>& measured) {
  if (!keeps(measured.front().errors, limits))
    measured.front() = measuredAsNeeded(list.front(), limits, measure);
  const bool exactKeeps = keeps(measured.front().errors, limits);
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (exactKeeps && list[i].cost >= list.front().cost) break;
    report(static_cast<double>(i) / static_cast<double>(list.size()));
    measured.push_back(measuredAsNeeded(list[i], limits, measure));
    if (keeps(measured.back().errors, limits)) break;
  }
  return cheapestThatKeeps(measured, limits);
}

std::optional<std::size_t> chooseLight(std::span<const Candidate> list, const scene::Scene& given,
                                       const Limit& limit, const MeasureCandidate& measure,
                                       const Report& report, std::vector<MeasuredCandidate>& measured) {
  std::map<double, ErrorOfPlace> places;  // by texels per voxel
  for (std::size_t i = 0; i < list.size(); ++i) {
    const scene::Gi gi = applied(list[i], given).gi;
    ErrorOfPlace& place = places[gi.latticeScale];
    if (place.surelyAbove(limit.most)) continue;
    report(static_cast<double>(i) / static_cast<double>(list.size()));
    measured.push_back(measuredAsNeeded(list[i], {&limit, 1}, measure));
    MeasuredCandidate& last = measured.back();
    // The few pixels that err most may all be absent from a small part: what seems to hold is confirmed.
    if (keeps(last.errors, {&limit, 1})) last.errors = measure(list[i], Measuring::most);
    if (keeps(last.errors, {&limit, 1})) return measured.size() - 1;
    place.add(static_cast<double>(gi.samples), measured.back().errors[indexOf(limit.quantity)].value);
  }
  return std::nullopt;
}

}  // namespace isolux::app
