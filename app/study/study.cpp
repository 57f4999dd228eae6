#include "app/study/study.h"

#include <algorithm>
#include <cmath>

#include "app/jobs/field_job.h"
#include "app/study/light_study.h"
#include "app/study/light_truth.h"
#include "app/study/scale_study.h"
#include "base/error.h"
#include "base/quantiles.h"

namespace isolux::app {

double milliseconds(const StudySetting& setting, const Panel& panel) {
  double sum = 0.0;
  for (const char* const pass : panel.passes)
    if (const auto found = setting.passMilliseconds.find(pass); found != setting.passMilliseconds.end())
      sum += found->second;
  return sum;
}

double costOf(const Knob& knob, const StudySetting& setting, const Panel& panel) {
  switch (knob.cost) {
    case Cost::passes:
      break;
    case Cost::bakeSeconds:
      return setting.light.value().bakeSeconds;
    case Cost::lookupMilliseconds:
      return setting.light.value().lookupMilliseconds;
    case Cost::gpuMegabytes:
      return static_cast<double>(setting.light.value().gpuBytes) / (1024.0 * 1024.0);
  }
  return milliseconds(setting, panel);
}

const Errors& judged(const StudySetting& setting) {
  return setting.fieldErrors ? *setting.fieldErrors : setting.errors;
}

const StudySetting* cheapest(const KnobStudy& study, double error) {
  const Panel& panel = panelsOf(study.knob)[0];
  const StudySetting* best = nullptr;
  for (const StudySetting& setting : study.settings) {
    if (setting.comparison || !(panel.error(judged(setting)) <= error)) continue;
    if (!best || costOf(study.knob, setting, panel) < costOf(study.knob, *best, panel)) best = &setting;
  }
  return best;
}

const std::array<double, 3>& errorsToReach(Measure measure) {
  static constexpr std::array<double, 3> voxels{0.1, 0.01, 0.001}, degrees{1.0, 0.1, 0.01},
      partsOfMean{0.05, 0.02, 0.01};
  if (measure == Measure::light) return partsOfMean;
  static constexpr std::array<double, 3> partsOfCurvature{0.5, 0.2, 0.1};
  if (measure == Measure::scale) return partsOfCurvature;
  return measure == Measure::hits ? voxels : degrees;
}

struct Studio::Alternative {
  std::string value;
  bool comparison;
  scene::Scene scene;
  std::vector<double> frames{};
  std::map<std::string, std::vector<double>> passes{};
  DrawnImages images{};
};

Studio::Studio(const std::shared_ptr<const render::Gl>& gl,
               std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene scene,
               const scene::Machine& machine, glm::ivec2 size, int repeat)
    : volume_(std::move(volume)),
      scene_(std::move(scene)),
      size_(size),
      machine_(machine),
      repeat_(repeat),
      renderer_(gl),
      truth_(volume_, scene::resolve(scene_, volume_->facts), size) {
  renderer_.setMachine(machine_);
  renderer_.setVolume(volume_);
}

Studio::~Studio() = default;

// The look's picture with every pass; then a frame with second derivatives, after the same passes: those that
// run alone find the volume in the caches.
void Studio::drawOnce(Alternative& alternative, bool timed) {
  const scene::Scene& scene = alternative.scene;
  render::FrameRequest picture, shapes;
  picture.size = shapes.size = size_;
  picture.aovs = {render::Aov::normal};
  shapes.color = false;
  shapes.aovs = {render::Aov::kappa};

  // Another field of hits makes other blocks, which is no cost of a frame.
  if (drawnField_ != scene.hit.field) renderer_.render(scene, picture);
  drawnField_ = scene.hit.field;
  std::map<std::string, double> passes;
  const auto collect = [&](const render::FrameReport& report) {
    for (const render::PassReport& pass : report.passes)
      if (pass.state == render::PassState::ran) passes[pass.name] = pass.milliseconds;
    return report.milliseconds;
  };
  renderer_.invalidate();
  collect(renderer_.render(scene, shapes));
  renderer_.invalidate();
  const double frame = collect(renderer_.render(scene, picture));
  if (!timed) return;
  alternative.frames.push_back(frame);
  for (const auto& [name, time] : passes) alternative.passes[name].push_back(time);
}

DrawnImages Studio::imagesOf(const scene::Scene& scene) {
  render::FrameRequest request;
  request.size = size_;
  request.color = false;
  request.aovs = {render::Aov::hit, render::Aov::depth, render::Aov::normal, render::Aov::kappa,
                  render::Aov::curvature_confidence};
  renderer_.render(scene, request);
  return {renderer_.readAov(render::Aov::hit).values, renderer_.readAov(render::Aov::depth).values,
          renderer_.readAov(render::Aov::normal).values, renderer_.readAov(render::Aov::kappa).values,
          renderer_.readAov(render::Aov::curvature_confidence).values};
}

void Studio::measure(std::vector<Alternative>& alternatives, base::Progress& progress, double from,
                     double to) {
  const double frames = static_cast<double>(alternatives.size()) * (repeat_ + 1);
  double done = 0.0;
  for (int round = 0; round <= repeat_; ++round)
    for (Alternative& alternative : alternatives) {
      progress.throwIfStopped();
      completeFields(alternative.scene, *volume_, true, progress);
      drawOnce(alternative, round > 0);  // the first round warms up, and its pictures are compared
      if (round == 0) alternative.images = imagesOf(alternative.scene);
      progress.report(from + (to - from) * ++done / frames, "measuring");
    }
}

void Studio::requireSurface(const scene::Scene& scene, base::Progress& progress) {
  const TrueSurface truth = truth_.of(scene.hit.field, scene.derivatives, progress);
  if (std::none_of(truth.hits.begin(), truth.hits.end(), [](const TrueHit& h) { return h.hit; }))
    throw base::Error(base::ErrorKind::usage, "", "isosurface.value",
                      "no pixel of this view shows the surface");
}

void Studio::judgeScale(const Alternative& alternative, StudySetting& setting, base::Progress& progress) {
  const scene::Scene& scene = alternative.scene;
  if (!scale_) {
    const TrueSurface truth = truth_.of(scene.hit.field, scene.derivatives.field, progress);
    std::vector<bool> isHit;
    for (const TrueHit& hit : truth.hits) isHit.push_back(hit.hit);
    std::vector<glm::dvec3> points;
    for (const std::size_t pixel : chosenPixels(isHit, kScalePoints))
      points.push_back(truth.hits[pixel].voxel);
    scale_ = std::make_unique<ScaleStudio>(volume_, scene, std::move(points),
                                           volume_->derivativeChoices->noise(progress));
  }
  const double scaleMm = scene.derivatives.scale.value_or(0.0);
  const ScaleFindings findings = scale_->at(scaleMm, progress);
  setting.errors.noise = findings.errors;
  setting.scale = {scaleMm, findings.buildSeconds, unknownShare(alternative.images)};
}

StudySetting Studio::judge(const Knob& knob, const Alternative& alternative, base::Progress& progress) {
  const scene::Scene& scene = alternative.scene;
  const auto errors = [&](scene::Field hitField, const auto& shape) {
    const TrueSurface truth = truth_.of(hitField, shape, progress);
    return errorsOf(alternative.images, truth,
                    [&](std::size_t pixel) { return truth_.undecided(hitField, pixel); });
  };
  StudySetting setting;
  setting.value = alternative.value;
  setting.isDefault = !alternative.comparison && alternative.value == defaultValue(knob);
  setting.comparison = alternative.comparison;
  setting.frameMilliseconds = base::median(alternative.frames);
  for (const auto& [name, times] : alternative.passes) setting.passMilliseconds[name] = base::median(times);
  if (knob.measure == Measure::scale) {
    judgeScale(alternative, setting, progress);
    return setting;
  }
  setting.errors = errors(scene.hit.field, scene.derivatives);
  constexpr scene::Field best = scene::Field::cubic_interpolating;
  if (knob.field)
    setting.fieldErrors =
        knob.measure == Measure::hits ? errors(best, scene.derivatives) : errors(scene.hit.field, best);
  return setting;
}

KnobStudy Studio::study(const Knob& knob, base::Progress& progress, double from, double to) {
  if (knob.measure == Measure::light) {
    KnobStudy skipped{.knob = knob, .settings = {}, .plot = {}, .skipped = whyWithoutEffect(knob, scene_)};
    if (!skipped.skipped.empty()) return skipped;
    requireSurface(turned(knob, knob.values.front(), scene_, volume_->facts), progress);
    if (!light_)
      light_ = std::make_unique<LightStudio>(renderer_, truth_, volume_, scene_, machine_, size_, repeat_);
    drawnField_.reset();
    return light_->study(knob, progress, from, to);
  }
  std::vector<Alternative> alternatives;
  for (const char* const value : knob.values)
    alternatives.push_back({value, false, turned(knob, value, scene_, volume_->facts)});
  if (knob.sampled) {
    scene::Scene exact = alternatives.front().scene;
    exact.hit.method = scene::HitMethod::exact;
    alternatives.push_back({"exact hits", true, std::move(exact)});
  }
  requireSurface(alternatives.front().scene, progress);
  const double measured = from + 0.6 * (to - from);
  measure(alternatives, progress, from, measured);
  KnobStudy result{.knob = knob, .settings = {}, .plot = {}};
  for (const Alternative& alternative : alternatives) {
    result.settings.push_back(judge(knob, alternative, progress));
    const double part =
        static_cast<double>(result.settings.size()) / static_cast<double>(alternatives.size());
    progress.report(measured + (to - measured) * part, "comparing");
  }
  if (scale_) {
    result.addedNoise = scale_->deviation();
    result.knowsTruth = scale_->isPhantom();
  }
  return result;
}

}  // namespace isolux::app
