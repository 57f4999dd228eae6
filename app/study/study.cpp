#include "app/study/study.h"

#include <algorithm>

#include "app/ready/give_way.h"
#include "app/ready/ready_fields.h"
#include "app/study/light_reference.h"
#include "base/error.h"
#include "render/gl/gl.h"
#include "render/gl/gl_context.h"
#include "scene/rules/needs.h"

namespace isolux::app {

struct StudyRunner::Alternative {
  StudySetting setting;  // its value, and its times as they are measured
  scene::Scene scene;
  DrawnImages images{};
  ComparedPicture picture{};
};

StudyRunner::StudyRunner(const std::shared_ptr<const render::Gl>& gl, StudySubject subject)
    : subject_(std::move(subject)),
      software_(gl->software),
      renderer_(gl),
      reference_(subject_.volume, scene::resolve(subject_.scene, subject_.volume->facts), subject_.size) {
  renderer_.setHostSettings(subject_.host);
  renderer_.setVolume(subject_.volume);
}

// The look's picture with every pass; then a frame with second derivatives, after the same passes: those that
// run alone find the volume in the caches.
void StudyRunner::drawOnce(Alternative& alternative, bool timed) {
  const scene::Scene& scene = alternative.scene;
  const render::FrameRequest picture{.size = subject_.size, .aovs = {render::Aov::normal}},
      shapes{.size = subject_.size, .color = false, .aovs = {render::Aov::kappa}};

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
  const double before = processorMilliseconds();
  const double frame = collect(renderer_.render(scene, picture));
  const double worked = processorMilliseconds() - before;
  if (!timed) return;
  alternative.setting.frameTimes.push_back(frame);
  if (software_) alternative.setting.processorTimes.push_back(worked);
  for (const auto& [name, time] : passes) alternative.setting.passTimes[name].push_back(time);
}

DrawnImages StudyRunner::imagesOf(const scene::Scene& scene) {
  renderer_.render(scene, {.size = subject_.size,
                           .color = false,
                           .aovs = {render::Aov::hit, render::Aov::depth, render::Aov::normal,
                                    render::Aov::kappa, render::Aov::curvature_confidence}});
  return {renderer_.readAov(render::Aov::hit).values, renderer_.readAov(render::Aov::depth).values,
          renderer_.readAov(render::Aov::normal).values, renderer_.readAov(render::Aov::kappa).values,
          renderer_.readAov(render::Aov::curvature_confidence).values};
}

void StudyRunner::measure(std::vector<Alternative>& alternatives, base::Progress& progress, double from,
                          double to) {
  const double frames = static_cast<double>(alternatives.size()) * (subject_.repeat + 1);
  double done = 0.0;
  for (int round = 0; round <= subject_.repeat; ++round)
    for (Alternative& alternative : alternatives) {
      progress.throwIfStopped();
      completeFields(alternative.scene, *subject_.volume, true, progress);
      drawOnce(alternative, round > 0);  // the first round warms up, and its pictures are compared
      if (round == 0) {
        alternative.images = imagesOf(alternative.scene);
        alternative.picture = drawnPicture(renderer_, alternative.scene, subject_.size, 1);
      }
      progress.report(from + (to - from) * ++done / frames, "measuring");
    }
}

void StudyRunner::requireSurface(const scene::Scene& scene, base::Progress& progress) {
  if (std::ranges::none_of(reference_.hitsOf(scene.hit.field, progress), &TrueHit::hit))
    base::throwUsage("", "isosurface.value", "no pixel of this view shows the surface");
}

void StudyRunner::judgeScale(const Alternative& alternative, StudySetting& setting,
                             base::Progress& progress) {
  const scene::Scene& scene = alternative.scene;
  if (!scale_) {
    const std::vector<TrueHit>& hits = reference_.hitsOf(scene.hit.field, progress);
    std::vector<bool> isHit;
    for (const TrueHit& hit : hits) isHit.push_back(hit.hit);
    std::vector<glm::dvec3> points;
    for (const std::size_t pixel : chosenPixels(isHit, kScalePoints)) points.push_back(hits[pixel].voxel);
    scale_.emplace(subject_.volume, scene, std::move(points),
                   subject_.volume->derivativeChoices->noise(progress));
  }
  const double scaleMm = scene.derivatives.scale.value_or(0.0);
  const ScaleFindings findings = scale_->at(scaleMm, progress);
  setting.errors.noise = findings.errors;
  setting.scale = {scaleMm, findings.buildSeconds, unknownShare(alternative.images)};
}

StudySetting StudyRunner::judge(const QualitySetting& quality, const Alternative& alternative,
                                base::Progress& progress) {
  const scene::Scene& scene = alternative.scene;
  const auto errors = [&](scene::Field hitField, const scene::Derivatives& shape) {
    const TrueSurface truth = reference_.of(hitField, shape, progress);
    return errorsOf(alternative.images, truth,
                    [&](std::size_t pixel) { return reference_.undecided(hitField, pixel); });
  };
  StudySetting setting = alternative.setting;
  setMedians(setting);
  // A quality setting of sampled hits has no effect in what the program does by default, where hits are
  // exact.
  const bool chosen = !setting.comparison && setting.value == defaultValue(quality);
  const bool sampled = quality.sampled() && scene::Scene{}.hit.method == scene::HitMethod::exact;
  setting.isDefault = sampled ? setting.comparison : chosen;
  setting.settingDefault = sampled && chosen;
  if (quality.measure == Measure::scale) {
    judgeScale(alternative, setting, progress);
    return setting;
  }
  setting.errors = errors(scene.hit.field, scene.derivatives);
  constexpr scene::Field best = scene::Field::cubic_interpolating;
  if (!quality.field()) return setting;
  scene::Derivatives through = scene.derivatives;  // at the same scales
  through.field = best;
  setting.fieldErrors =
      quality.measure == Measure::hits ? errors(best, scene.derivatives) : errors(scene.hit.field, through);
  return setting;
}

void StudyRunner::study(const std::vector<QualitySetting>& qualities, base::Progress& progress,
                        const std::function<void(QualityStudy)>& each) {
  double all = 0.0, done = 0.0;
  for (const QualitySetting& quality : qualities) all += effortOf(quality, subject_.scene);
  for (const QualitySetting& quality : qualities) {
    const double from = done / all;
    done += effortOf(quality, subject_.scene);
    each(study(quality, progress, from, done / all));
  }
}

QualityStudy StudyRunner::study(const QualitySetting& quality, base::Progress& progress, double from,
                                double to) {
  scene::Scene first = turned(quality, quality.values.front(), subject_.scene, subject_.volume->facts);
  completeFields(first, *subject_.volume, true, progress);
  const bool shape = quality.measure == Measure::shape;
  QualityStudy skipped{.quality = quality,
                       .skipped = whyWithoutEffect(quality, shape ? first : subject_.scene)};
  if (!skipped.skipped.empty()) return skipped;
  requireSurface(first, progress);
  const bool light = quality.measure == Measure::light;
  if (!light && quality.measure != Measure::edges && quality.measure != Measure::shadow)
    return studySurface(quality, progress, from, to);
  drawnField_.reset();
  if (!light_ && light) light_.emplace(renderer_, reference_, subject_);
  if (!picture_ && !light) picture_.emplace(renderer_, software_, subject_);
  return light ? light_->study(quality, progress, from, to) : picture_->study(quality, progress, from, to);
}

QualityStudy StudyRunner::studySurface(const QualitySetting& quality, base::Progress& progress, double from,
                                       double to) {
  std::vector<Alternative> alternatives;
  for (const std::string& value : quality.values)
    alternatives.push_back(
        {{.value = value}, turned(quality, value, subject_.scene, subject_.volume->facts)});
  if (quality.sampled()) {
    scene::Scene exact = alternatives.front().scene;
    exact.hit.method = scene::HitMethod::exact;
    alternatives.push_back({{.value = kExactHits, .comparison = true}, std::move(exact)});
  }
  const double measured = from + 0.6 * (to - from);
  measure(alternatives, progress, from, measured);
  QualityStudy result{.quality = quality};
  result.eightBitVoxels = volume::bytesOf(subject_.volume->grid().storedType()) == 1;
  const auto reference = std::ranges::find_if(
      alternatives, [&](const Alternative& a) { return a.setting.value == quality.reference; });
  for (const Alternative& alternative : alternatives) {
    result.settings.push_back(judge(quality, alternative, progress));
    if (quality.measure == Measure::shape && result.settings.back().isDefault) {
      result.normalScaleMm = scene::normalScale(alternative.scene);
      result.curvatureScaleMm = scene::derivativesScale(alternative.scene);
    }
    if (reference != alternatives.end())
      result.settings.back().errors.picture = pictureErrorsOf(alternative.picture, reference->picture);
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

std::unique_ptr<StudyTask> studyTask(StudySubject subject, std::vector<QualitySetting> qualities) {
  const auto work = [subject = std::move(subject), qualities = std::move(qualities)](base::Progress& progress,
                                                                                     const auto& tell) {
    giveWay();
    const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
    context->makeCurrent();
    StudyRunner studio(context->gl(), subject);
    const double part = 1.0 / static_cast<double>(qualities.size());
    for (std::size_t i = 0; i < qualities.size(); ++i) {
      const double from = part * static_cast<double>(i);
      QualityStudy study = studio.study(qualities[i], progress, from, from + part);
      tell([&](std::vector<QualityStudy>& found) { found.push_back(std::move(study)); });
    }
  };
  return StudyTask::start({"", "measure accuracy"}, work);
}

}  // namespace isolux::app
