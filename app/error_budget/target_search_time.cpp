// The search for what keeps a time.
#include <algorithm>
#include <cmath>

#include "app/error_budget/target_search.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/quantiles.h"
#include "render/still_picture.h"

namespace isolux::app {

namespace {

// Errors that count as one another's equals.
constexpr Limit kErrorsOfOneUnit[] = {{Quantity::depthVoxels, 0.01},
                                      {Quantity::missed, 0.001},
                                      {Quantity::normal, 0.2},
                                      {Quantity::curvature, 0.05}};
constexpr int kTimedFrames = 3;

}  // namespace

double TargetSearch::scaledMilliseconds(const Candidate& candidate, base::Progress& progress) {
  render::FrameRequest request = question_.picture;
  const int rays = request.aovs.empty() ? candidate.supersampling * candidate.supersampling : 1;
  request.size = size_;
  request.supersampling = 1;
  request.tile.reset();
  const scene::Scene scene = sceneOf(candidate, progress);
  std::vector<double> times;
  for (int i = 0; i <= kTimedFrames; ++i) {
    progress.throwIfStopped();
    renderer_.invalidate();
    const double milliseconds = renderer_.render(scene, request).milliseconds;
    if (i > 0) times.push_back(milliseconds);  // the first compiles
  }
  const auto pixels = [](glm::ivec2 size) { return static_cast<double>(size.x) * size.y; };
  return base::median(times) * rays * pixels(question_.picture.size) / pixels(size_);
}

// Median of a few frames of the picture itself; of one where that is far above `most`.
double TargetSearch::frameMilliseconds(const Candidate& candidate, double most, base::Progress& progress) {
  render::FrameRequest request = question_.picture;
  request.supersampling = request.aovs.empty() ? candidate.supersampling : 1;
  const scene::Scene scene = sceneOf(candidate, progress);
  std::vector<double> times;
  for (int i = 0; i <= kTimedFrames; ++i) {
    progress.throwIfStopped();
    renderer_.invalidate();
    const double milliseconds = render::drawStill(renderer_, scene, request, progress).report.milliseconds;
    if (i > 0) times.push_back(milliseconds);
    if (i == 1 && milliseconds > 2.0 * most) break;
  }
  return base::median(times);
}

std::optional<TargetAnswer> TargetSearch::keepTime(double milliseconds, base::Progress& progress) {
  if (!prepare(progress)) return std::nullopt;
  TargetAnswer answer;
  for (const Limit& unit : kErrorsOfOneUnit)
    if (acts(unit.quantity)) answer.limits.push_back(unit);
  const std::vector<Candidate> list = surfaceCandidates(turning(acts(Quantity::normal)));
  const auto stays = [&](const char* path) {
    return std::ranges::find(question_.fixed, path) != question_.fixed.end();
  };
  const int most = question_.given.picture.supersampling;
  const int least = !question_.picture.aovs.empty() || stays("picture.supersampling") ? most : 1;
  std::vector<MeasuredCandidate> measured;
  for (const Candidate& candidate : list) {
    // What costs more than the most exact one is of no use.
    if (&candidate != &list.front() && candidate.cost >= list.front().cost) continue;
    progress.report(static_cast<double>(&candidate - list.data()) / static_cast<double>(list.size()),
                    "choosing settings");
    const TargetErrors errors = measure(candidate, Measuring::few, progress);
    for (int rays = most; rays >= least; --rays) {
      Candidate sampled = candidate;
      sampled.supersampling = rays;
      sampled.cost *= rays * rays;
      if (rays != most) sampled.assignments.push_back("picture.supersampling=" + std::to_string(rays));
      measured.push_back({sampled, errors});
    }
  }
  std::erase_if(answer.limits, [&](const Limit& limit) {
    return std::isnan(measured.front().errors[indexOf(limit.quantity)].bound);
  });
  double tooMuch = std::numeric_limits<double>::infinity(), quickest = tooMuch;
  for (const std::size_t i : byAccuracy(measured, answer.limits)) {
    MeasuredCandidate& one = measured[i];
    if (one.candidate.cost >= tooMuch) continue;
    progress.report(1.0, "measuring frames");
    one.milliseconds = frameMilliseconds(one.candidate, milliseconds, progress);
    answer.measured.push_back(one);
    if (one.milliseconds <= kTimeMargin * milliseconds) {
      answer.chosen = answer.measured.size() - 1;
      answer.expectedMilliseconds = one.milliseconds;
      answer.reason = "it is the most accurate one drawn within " + base::shortText(100.0 * kTimeMargin, 3) +
                      " % of " + base::shortText(milliseconds, 4) + " ms";
      return answer;
    }
    tooMuch = one.candidate.cost;
    quickest = std::min(quickest, one.milliseconds);
  }
  base::throwUsage("", "--time",
                   "no settings keep " + base::shortText(milliseconds, 4) + " ms; the fastest take about " +
                       base::shortText(std::ceil(quickest / kTimeMargin), 9) + " ms; choose a smaller image");
}

}  // namespace isolux::app
