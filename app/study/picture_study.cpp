#include "app/study/picture_study.h"

#include <algorithm>

#include "app/image_metrics/flip.h"
#include "app/ready/ready_fields.h"
#include "render/still_picture.h"

namespace isolux::app {

ImageErrors pictureErrorsOf(const ComparedPicture& picture, const ComparedPicture& reference) {
  ImageErrors errors;
  errors.flip = meanFlip(reference, picture);
  errors.rms = rmsDifference(picture, reference);
  return errors;
}

ComparedPicture drawnPicture(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size,
                             int supersampling) {
  renderer.render(scene, {.size = size, .linear = true, .supersampling = supersampling});
  return comparedPicture(renderer.readLinearPicture());
}

struct PictureStudyRunner::Alternative {
  StudySetting setting;  // its value, and its times as they are measured
  scene::Scene scene;
  int supersampling;
  ComparedPicture picture{};
};

PictureStudyRunner::PictureStudyRunner(render::Renderer& renderer, bool software, const StudySubject& subject)
    : renderer_(renderer), software_(software), subject_(subject) {}

void PictureStudyRunner::time(Alternative& alternative) {
  const render::FrameRequest request{.size = subject_.size, .supersampling = alternative.supersampling};
  renderer_.invalidate();
  const double before = processorMilliseconds();
  const render::FrameReport& report = renderer_.render(alternative.scene, request);
  StudySetting& setting = alternative.setting;
  setting.frameTimes.push_back(report.milliseconds);
  if (software_) setting.processorTimes.push_back(processorMilliseconds() - before);
  for (const render::PassReport& pass : report.passes)
    if (pass.state == render::PassState::ran) setting.passTimes[pass.name].push_back(pass.milliseconds);
}

ComparedPicture PictureStudyRunner::manyRays(const scene::Scene& scene, base::Progress& progress) {
  const render::FrameRequest request{.size = kReferenceBlock * subject_.size,
                                     .linear = true,
                                     .supersampling = 4,
                                     .pixelRatio = kReferenceBlock};
  base::Progress inner;  // the picture's own fraction is not the study's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  return comparedPicture(render::drawStill(renderer_, scene, request, inner).linear);
}

QualityStudy PictureStudyRunner::study(const QualitySetting& quality, base::Progress& progress, double from,
                                       double to) {
  std::vector<Alternative> alternatives;
  for (const std::string& value : quality.values) {
    scene::Scene scene = turned(quality, value, subject_.scene, subject_.volume->facts);
    completeFields(scene, *subject_.volume, true, progress);
    const int rays = quality.measure == Measure::edges ? scene.picture.supersampling : 1;
    const bool isDefault = value == defaultValue(quality);
    alternatives.push_back({{.value = value, .isDefault = isDefault}, std::move(scene), rays});
  }
  const double steps = static_cast<double>(alternatives.size()) * (subject_.repeat + 1) + 1.0;
  double done = 0.0;
  for (int round = 0; round <= subject_.repeat; ++round)
    for (Alternative& alternative : alternatives) {
      progress.throwIfStopped();
      if (round > 0)
        time(alternative);
      else  // warms up, and is compared
        alternative.picture =
            drawnPicture(renderer_, alternative.scene, subject_.size, alternative.supersampling);
      progress.report(from + (to - from) * ++done / steps, "measuring");
    }

  ComparedPicture reference;
  std::vector<bool> edges;
  if (quality.measure == Measure::edges) {
    const ComparedPicture fine = manyRays(alternatives.front().scene, progress);
    reference = blockMeans(fine, kReferenceBlock);
    edges = edgePixels(fine, kReferenceBlock, kEdgeContrast);
  } else {
    for (const Alternative& alternative : alternatives)
      if (alternative.setting.value == quality.reference) reference = alternative.picture;
  }

  QualityStudy result{.quality = quality};
  for (Alternative& alternative : alternatives) {
    StudySetting& setting = alternative.setting;
    setMedians(setting);
    setting.errors.pixels = alternative.picture.linear.size();
    setting.errors.picture = pictureErrorsOf(alternative.picture, reference);
    if (!edges.empty()) {
      setting.errors.picture.edgePixels = static_cast<std::size_t>(std::ranges::count(edges, true));
      setting.errors.picture.edgeRms = rmsDifference(alternative.picture, reference, edges);
    }
    result.settings.push_back(std::move(setting));
  }
  return result;
}

}  // namespace isolux::app
