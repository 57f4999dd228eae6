#include "app/error_budget/candidates.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/error_budget/work.h"
#include "base/number_text.h"
#include "scene/settings/choice_names.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using scene::Field;
using scene::HitMethod;
using Values = std::vector<double>;

constexpr double kLargestLight = 1100.0;  // paths per texel times texels: beyond it nobody waits

bool isFixed(const Turning& turning, const char* path) {
  return std::ranges::find(turning.fixed, path) != turning.fixed.end();
}

// The values of a quality setting, or the scene's own where it is fixed.
Values valuesOf(const Turning& turning, const char* path, Values values) {
  if (!isFixed(turning, path)) return values;
  return {scene::setting(path).get(turning.given).get<double>()};
}

// Changes of the scene; what it has already is left out.
class Changes {
 public:
  explicit Changes(const scene::Scene& given) : scene_(given) {}

  void set(const char* path, const std::string& value) {
    scene::Scene changed = scene_;
    scene::applyAssignment(changed, std::string(path) + '=' + value);
    if (changed == scene_) return;
    scene_ = std::move(changed);
    assignments_.push_back(std::string(path) + '=' + value);
  }
  void set(const char* path, double value) { set(path, base::shortText(value)); }

  const scene::Scene& scene() const { return scene_; }
  const std::vector<std::string>& assignments() const { return assignments_; }

 private:
  scene::Scene scene_;
  std::vector<std::string> assignments_;
};

// Hits of this field and method, also at rest.
Changes hitsOf(const Turning& turning, HitMethod method, Field field) {
  Changes changes(turning.given);
  changes.set("hit.method", method == HitMethod::exact ? "exact" : "sampled");
  const bool asAtRest = method == HitMethod::exact && turning.given.hit.method == HitMethod::exact &&
                        field == turning.drawnField;
  if (asAtRest) return changes;
  changes.set("hit.field", std::string(scene::choiceName(field)));
  if (method == HitMethod::exact && field == Field::trilinear) changes.set("picture.rest_hits", "same");
  return changes;
}

std::vector<Changes> exactHits(const Turning& turning) {
  std::vector<Changes> list;
  if (isFixed(turning, "hit.method") && turning.given.hit.method != HitMethod::exact) return list;
  list.push_back(hitsOf(turning, HitMethod::exact, turning.drawnField));
  const bool fieldStays = isFixed(turning, "hit.field") || isFixed(turning, "picture.rest_hits");
  if (turning.drawnField != Field::trilinear && !fieldStays)
    list.push_back(hitsOf(turning, HitMethod::exact, Field::trilinear));
  return list;
}

std::vector<Changes> sampledHits(const Turning& turning) {
  std::vector<Changes> list;
  if (isFixed(turning, "hit.method") && turning.given.hit.method != HitMethod::sampled) return list;
  const Changes base = hitsOf(turning, HitMethod::sampled, turning.drawnField);
  for (const double rate : valuesOf(turning, "hit.rate", {8, 4, 2, 1, 0.5}))
    for (const double factor : valuesOf(turning, "hit.near_factor", {8, 1}))
      for (const double refinements : valuesOf(turning, "hit.refinements", {4, 2, 1, 0})) {
        Changes changes = base;
        changes.set("hit.rate", rate);
        changes.set("hit.near_factor", factor);
        changes.set("hit.refinements", refinements);
        list.push_back(std::move(changes));
      }
  return list;
}

std::vector<Changes> withDerivatives(const Turning& turning, const Changes& hits) {
  Changes exact = hits;
  if (turning.derivatives && !isFixed(turning, "derivatives.fetch")) exact.set("derivatives.fetch", "exact");
  std::vector<Changes> list{exact};
  if (!turning.turnDerivatives || isFixed(turning, "derivatives.field") ||
      turning.given.derivatives.field == Field::trilinear)
    return list;
  exact.set("derivatives.field", "trilinear");
  list.push_back(std::move(exact));
  return list;
}

}  // namespace

std::vector<Candidate> surfaceCandidates(const Turning& turning) {
  std::vector<Changes> hits = exactHits(turning);
  const bool canBeExact = !hits.empty();
  std::vector<Changes> sampled = sampledHits(turning);
  hits.insert(hits.end(), sampled.begin(), sampled.end());
  std::vector<Candidate> list;
  for (std::size_t i = 0; i < hits.size(); ++i)
    for (const Changes& changes : withDerivatives(turning, hits[i])) {
      scene::Hit drawn = changes.scene().hit;
      if (i == 0 && canBeExact) drawn.field = turning.drawnField;  // at rest
      double work = hitWork(drawn, turning.processor);
      if (turning.derivatives)
        work += derivativeWork(changes.scene().derivatives, turning.second, turning.processor);
      list.push_back({changes.assignments(), work, drawn.method == HitMethod::exact,
                      turning.given.picture.supersampling});
    }
  std::stable_sort(list.begin() + 1, list.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return list;
}

std::vector<Candidate> lightCandidates(const Turning& turning, const Candidate& surface) {
  std::vector<Candidate> list;
  for (const double scale : valuesOf(turning, "gi.lattice_scale", {0.5, 1, 2}))
    for (const double samples : valuesOf(turning, "gi.samples", {4, 16, 36, 100, 256, 1024})) {
      Changes changes(applied(surface, turning.given));
      changes.set("gi.samples", samples);
      changes.set("gi.lattice_scale", scale);
      if (samples * scale * scale > kLargestLight && !isFixed(turning, "gi.samples") &&
          !isFixed(turning, "gi.lattice_scale"))
        continue;
      Candidate candidate = surface;
      candidate.assignments.insert(candidate.assignments.end(), changes.assignments().begin(),
                                   changes.assignments().end());
      candidate.cost += lightWork(changes.scene().gi);
      list.push_back(std::move(candidate));
    }
  std::ranges::stable_sort(list, [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return list;
}

scene::Scene applied(const Candidate& candidate, scene::Scene given) {
  for (const std::string& assignment : candidate.assignments) scene::applyAssignment(given, assignment);
  return given;
}

}  // namespace isolux::app
