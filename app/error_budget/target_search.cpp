#include "app/error_budget/target_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "app/error_budget/drawn_images.h"
#include "app/error_budget/stages.h"
#include "app/error_budget/work.h"
#include "app/light/light_picture.h"
#include "app/ready/give_way.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"
#include "base/error.h"
#include "render/gl/gl_context.h"
#include "render/passes/pass_declarations.h"
#include "render/passes/processor.h"
#include "scene/rules/automatic.h"
#include "scene/rules/gi_choice.h"

namespace isolux::app {

namespace {

// What nobody asked for is kept as well where its quality settings are turned, or cheap hits would miss what
// they like.
constexpr Limit kUnasked[] = {{Quantity::depthVoxels, 0.1},
                              {Quantity::missed, 0.001},
                              {Quantity::normal, 2.0},
                              {Quantity::curvature, 0.2}};

bool isOfLight(const Limit& limit) {
  return limit.quantity == Quantity::light;
}
bool isOfShape(const Limit& limit) {
  return limit.quantity == Quantity::normal || limit.quantity == Quantity::curvature;
}

bool hasName(std::span<const Limit> limits, Quantity quantity) {
  return std::ranges::any_of(limits, [&](const Limit& limit) {
    return std::string_view(nameOf(limit.quantity)) == nameOf(quantity);
  });
}

// The first isosurface, opaque and whole: what truths are known of.
scene::Scene wholeSurface(scene::Scene scene) {
  scene.surfaces.resize(1);
  scene.surfaces.front().opacity = scene.surfaces.front().facingOpacity = 1.0;
  scene.surfaces.front().ghost = 0.0;
  scene.pieces = {};
  return scene;
}

std::atomic<int> searching{0};

std::optional<TargetAnswer> answerTo(const TargetSubject& subject, base::Progress& progress) {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  renderer.setHostSettings(subject.host);
  renderer.setVolume(subject.volume);
  renderer.setLight(subject.light);
  TargetQuestion question = subject;
  question.processor = render::takesProcessor(subject.host.executor, *context->gl());
  question.picture.stop = progress.token();
  TargetSearch search(renderer, std::move(question));
  return subject.limits.empty() ? search.keepTime(subject.milliseconds, progress)
                                : search.keepErrors(subject.limits, progress);
}

}  // namespace

glm::ivec2 measuredSize(glm::ivec2 picture, int mostPixels) {
  const double pixels = static_cast<double>(picture.x) * picture.y;
  if (pixels <= mostPixels) return picture;
  const double scale = std::sqrt(mostPixels / pixels);
  return glm::max(glm::ivec2(std::floor(scale * picture.x), std::floor(scale * picture.y)), glm::ivec2(1));
}

TargetSearch::TargetSearch(render::Renderer& renderer, TargetQuestion question)
    : renderer_(renderer),
      question_(std::move(question)),
      size_(measuredSize(question_.picture.size, kFewPixels)) {}

scene::Scene TargetSearch::sceneOf(const Candidate& candidate, base::Progress& progress) const {
  scene::Scene scene = scene::resolve(applied(candidate, question_.given), question_.volume->facts);
  completeFields(scene, *question_.volume, true, progress);
  if (question_.picture.aovs.empty()) scene = atRest(std::move(scene), *question_.volume, progress);
  return scene;
}

bool TargetSearch::prepare(base::Progress& progress) {
  progress.report(0.0, "choosing settings");
  if (!reference_) reference_ = wholeSurface(sceneOf({}, progress));
  return std::ranges::any_of(referenceAt(size_).hitsOf(reference_->hit.field, progress), &TrueHit::hit);
}

SurfaceReference& TargetSearch::referenceAt(glm::ivec2 size) {
  return references_.try_emplace({size.x, size.y}, question_.volume, *reference_, size).first->second;
}

Turning TargetSearch::turning(bool derivatives) const {
  return {.given = question_.given,
          .drawnField = reference_->hit.field,
          .processor = question_.processor,
          .derivatives = render::readsDerivatives(*reference_, question_.picture),
          .second = render::readsHessian(*reference_, question_.picture),
          .turnDerivatives = derivatives,
          .fixed = question_.fixed};
}

bool TargetSearch::acts(Quantity quantity) const {
  if (quantity == Quantity::normal) return render::readsDerivatives(*reference_, question_.picture);
  if (quantity == Quantity::curvature) return render::readsHessian(*reference_, question_.picture);
  if (quantity == Quantity::light) return scene::giChoiceOf(litScene(*reference_, question_.picture)).wanted;
  return true;
}

std::vector<Candidate> TargetSearch::candidates(bool turnDerivatives, base::Progress& progress) {
  prepare(progress);
  return surfaceCandidates(turning(turnDerivatives));
}

TargetErrors TargetSearch::measure(const Candidate& candidate, Measuring measuring,
                                   base::Progress& progress) {
  progress.throwIfStopped();
  const glm::ivec2 picture = question_.picture.size;
  const int most = measuring == Measuring::few    ? kFewPixels
                   : measuring == Measuring::many ? kManyPixels
                                                  : kMostPixels;
  const glm::ivec2 size = measuring == Measuring::picture ? picture : measuredSize(picture, most);
  if (size == picture) measuring = Measuring::picture;
  const scene::Scene scene = wholeSurface(sceneOf(candidate, progress));
  constexpr render::Aov aovs[] = {render::Aov::hit, render::Aov::depth, render::Aov::normal,
                                  render::Aov::kappa};
  std::vector<std::vector<float>> drawn = drawnImages(renderer_, scene, size, aovs, progress);
  const DrawnImages images{std::move(drawn[0]), std::move(drawn[1]), std::move(drawn[2]),
                           std::move(drawn[3])};
  const scene::Field field = reference_->hit.field;
  SurfaceReference& surface = referenceAt(size);
  const TrueSurface reference = surface.of(field, reference_->derivatives, progress);
  const Errors errors = errorsOf(images, reference, [&](std::size_t pixel) {
    progress.throwIfStopped();
    return surface.undecided(field, pixel);
  });
  return surfaceErrors(errors, measuring, candidate.complete && scene.hit.field == field);
}

TargetErrors TargetSearch::measureLight(const Candidate& candidate, Measuring measuring,
                                        base::Progress& progress) {
  if (!light_) {
    const glm::ivec2 size = measuredSize(question_.picture.size, kMostPixels);
    light_.emplace(renderer_, referenceAt(size), question_, size, lightNoise_);
  }
  TargetErrors errors;
  errors[indexOf(Quantity::light)] =
      lightBound(light_->judge(wholeSurface(sceneOf(candidate, progress)), measuring, progress), measuring);
  return errors;
}

std::vector<Limit> TargetSearch::actingLimits(const std::vector<Limit>& asked, TargetAnswer& answer,
                                              base::Progress& progress) const {
  progress.throwIfStopped();
  std::vector<Limit> limits;
  for (const Limit& limit : asked) {
    if (acts(limit.quantity)) {
      limits.push_back(limit);
      continue;
    }
    const char* const why = isOfLight(limit)                        ? "this image reads no baked light"
                            : limit.quantity == Quantity::curvature ? "this image reads no curvature"
                                                                    : "this image reads no normals";
    answer.notes.push_back(std::string(nameOf(limit.quantity)) + " is ignored: " + why);
  }
  return limits;
}

// What is kept though nobody asked for it: limits of ours, or what the most exact settings reach.
void TargetSearch::addUnasked(TargetAnswer& answer) const {
  const bool shapes = std::ranges::any_of(answer.limits, isOfShape);
  const TargetErrors& exact = answer.measured.front().errors;
  for (const Limit& limit : kUnasked) {
    if (hasName(answer.limits, limit.quantity) || !acts(limit.quantity) || (isOfShape(limit) && !shapes))
      continue;
    const double bound = exact[indexOf(limit.quantity)].bound;
    if (!std::isnan(bound)) answer.limits.push_back({limit.quantity, std::max(limit.most, bound)});
  }
}

void TargetSearch::addSurface(TargetAnswer& answer, base::Progress& progress) {
  const bool shapes = std::ranges::any_of(answer.limits, isOfShape);
  const std::vector<Candidate> list = surfaceCandidates(turning(shapes));
  answer.measured.push_back({list.front(), measure(list.front(), Measuring::few, progress)});
  std::erase_if(answer.limits, [&](const Limit& limit) {
    const bool unknown =
        !isOfLight(limit) && std::isnan(answer.measured.front().errors[indexOf(limit.quantity)].bound);
    if (unknown)
      answer.notes.push_back(
          std::string(nameOf(limit.quantity)) +
          " is ignored: it is not significant against the volume's noise at any visible pixel");
    return unknown;
  });
  answer.asked = answer.limits.size();
  addUnasked(answer);
  std::vector<Limit> limits;
  std::ranges::copy_if(answer.limits, std::back_inserter(limits),
                       [](const Limit& limit) { return !isOfLight(limit); });
  const std::optional<std::size_t> chosen = chooseSurface(
      list, limits,
      [&](const Candidate& candidate, Measuring measuring) {
        return measure(candidate, measuring, progress);
      },
      [&](double part) { progress.report(part, "choosing settings"); }, answer.measured);
  if (chosen) {
    answer.chosen = *chosen;
    return;
  }
  const TargetErrors& nearest = answer.measured[nearestTo(answer.measured, limits)].errors;
  std::string found;
  for (const Limit& limit : limits) {
    const ErrorBound& error = nearest[indexOf(limit.quantity)];
    if (!keeps(nearest, std::span(&limit, 1)))
      found += (found.empty() ? "" : ", ") + std::string(nameOf(limit.quantity)) + ' ' +
               errorText(limit.quantity, error.bound);
  }
  base::throwUsage("", "--error",
                   "no settings keep " + limitsText(limits) + "; the smallest guaranteed error is " + found);
}

void TargetSearch::addLight(TargetAnswer& answer, const MeasuredCandidate& surface,
                            base::Progress& progress) {
  const auto limit = std::ranges::find_if(answer.limits, isOfLight);
  if (limit == answer.limits.end()) return;
  // Noise is taken out of an error, but what it leaves uncertain is not small against a smaller error.
  if (!light_) lightNoise_ = std::min(lightNoise_, 0.5 * limit->most);
  const auto withLight = [&](const Candidate& candidate, Measuring measuring) {
    TargetErrors errors = surface.errors;
    errors[indexOf(Quantity::light)] = measureLight(candidate, measuring, progress)[indexOf(Quantity::light)];
    return errors;
  };
  std::vector<MeasuredCandidate> lit;
  const std::optional<std::size_t> chosen = chooseLight(
      lightCandidates(turning(false), surface.candidate), question_.given, *limit, withLight,
      [&](double part) { progress.report(part, "measuring light"); }, lit);
  if (!chosen) {
    const double least = lit[nearestTo(lit, {&*limit, 1})].errors[indexOf(Quantity::light)].bound;
    base::throwUsage("", "--error",
                     "no settings keep " + limitsText({&*limit, 1}) + "; the smallest guaranteed error is " +
                         errorText(Quantity::light, least) +
                         "; a larger image, gi.samples above 1024 or gi.lattice_scale above 2 may keep it");
  }
  answer.chosen = answer.measured.size() + *chosen;
  answer.measured.insert(answer.measured.end(), lit.begin(), lit.end());
}

Candidate TargetSearch::asGiven() const {
  const Turning as = turning(false);
  double work = hitWork(reference_->hit, as.processor);
  if (as.derivatives) work += derivativeWork(reference_->derivatives, as.second, as.processor);
  return {{}, work, false, question_.given.picture.supersampling};
}

std::optional<TargetAnswer> TargetSearch::keepErrors(const std::vector<Limit>& asked,
                                                     base::Progress& progress) {
  if (!prepare(progress)) return std::nullopt;
  TargetAnswer answer;
  answer.limits = actingLimits(asked, answer, progress);
  answer.asked = answer.limits.size();
  if (answer.limits.empty()) return answer;
  MeasuredCandidate surface{asGiven(), {}};
  if (!std::ranges::all_of(answer.limits, isOfLight)) {
    addSurface(answer, progress);
    surface = answer.measured[answer.chosen];
  }
  addLight(answer, surface, progress);
  const MeasuredCandidate& chosen = answer.measured[answer.chosen];
  answer.reason =
      "it is the least work that keeps " + limitsText(std::span(answer.limits).first(answer.asked));
  answer.expectedMilliseconds = scaledMilliseconds(chosen.candidate, progress);
  return answer;
}

std::unique_ptr<TargetTask> targetTask(TargetSubject asked) {
  ++searching;
  const std::shared_ptr<const void> counted(&searching, [](const void*) { --searching; });
  const auto work = [subject = std::move(asked), counted](base::Progress& progress) {
    giveWay();
    return answerTo(subject, progress);
  };
  return TargetTask::start({"", "choose settings"}, work);
}

int runningSearches() {
  return searching;
}

}  // namespace isolux::app
