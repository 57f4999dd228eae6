#include "app/study/picture_study.h"

#include <algorithm>

#include "app/compare/flip.h"
#include "app/ready/ready_fields.h"
#include "render/still_picture.h"

namespace isolux::app {

ImageErrors pictureErrorsOf(const ComparedPicture& picture, const ComparedPicture& reference) {
  ImageErrors errors;
  errors.flip = meanFlip(reference, picture);
  errors.rms = rmsDifference(picture, reference);
  return errors;
}

struct PictureStudio::Alternative {
  StudySetting setting;  // its value, and its times as they are measured
  scene::Scene scene;
  int supersampling;
  ComparedPicture picture{};
};

PictureStudio::PictureStudio(render::Renderer& renderer, bool software,
                             std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene scene,
                             glm::ivec2 size, int repeat)
    : renderer_(renderer),
      software_(software),
      volume_(std::move(volume)),
      scene_(std::move(scene)),
      size_(size),
      repeat_(repeat) {}

void PictureStudio::draw(Alternative& alternative, bool timed) {
  render::FrameRequest request;
  request.size = size_;
  request.supersampling = alternative.supersampling;
  if (!timed) {
    request.linear = true;
    renderer_.render(alternative.scene, request);
    alternative.picture = comparedPicture(renderer_.readLinearPicture());
    return;
  }
  renderer_.invalidate();
  const double before = processorMilliseconds();
  const render::FrameReport& report = renderer_.render(alternative.scene, request);
  StudySetting& setting = alternative.setting;
  setting.frameTimes.push_back(report.milliseconds);
  if (software_) setting.processorTimes.push_back(processorMilliseconds() - before);
  for (const render::PassReport& pass : report.passes)
    if (pass.state == render::PassState::ran) setting.passTimes[pass.name].push_back(pass.milliseconds);
}

ComparedPicture PictureStudio::manyRays(const scene::Scene& scene, base::Progress& progress) {
  render::FrameRequest request;
  request.size = kReferenceBlock * size_;
  request.supersampling = 4;
  request.pixelRatio = kReferenceBlock;
  request.linear = true;
  base::Progress inner;  // the picture's own fraction is not the study's
  const std::stop_callback stop(progress.token(), [&inner] { inner.requestStop(); });
  return comparedPicture(render::drawStill(renderer_, scene, request, inner).linear);
}

KnobStudy PictureStudio::study(const Knob& knob, base::Progress& progress, double from, double to) {
  std::vector<Alternative> alternatives;
  for (const std::string& value : knob.values) {
    scene::Scene scene = turned(knob, value, scene_, volume_->facts);
    completeFields(scene, *volume_, true, progress);
    const int rays = knob.measure == Measure::edges ? scene.picture.supersampling : 1;
    const bool isDefault = value == defaultValue(knob);
    alternatives.push_back({{.value = value, .isDefault = isDefault}, std::move(scene), rays});
  }
  const double steps = static_cast<double>(alternatives.size()) * (repeat_ + 1) + 1.0;
  double done = 0.0;
  for (int round = 0; round <= repeat_; ++round)
    for (Alternative& alternative : alternatives) {
      progress.throwIfStopped();
      draw(alternative, round > 0);  // the first round warms up, and its pictures are compared
      progress.report(from + (to - from) * ++done / steps, "measuring");
    }

  ComparedPicture reference;
  std::vector<bool> edges;
  if (knob.measure == Measure::edges) {
    const ComparedPicture fine = manyRays(alternatives.front().scene, progress);
    reference = blockMeans(fine, kReferenceBlock);
    edges = edgePixels(fine, kReferenceBlock, kEdgeContrast);
  } else {
    for (const Alternative& alternative : alternatives)
      if (alternative.setting.value == knob.reference) reference = alternative.picture;
  }

  KnobStudy result{.knob = knob, .settings = {}, .plot = {}};
  for (Alternative& alternative : alternatives) {
    StudySetting& setting = alternative.setting;
    setMedians(setting);
    setting.errors.pixels = alternative.picture.linear.size();
    setting.errors.picture = pictureErrorsOf(alternative.picture, reference);
    if (!edges.empty()) {
      setting.errors.picture.edgePixels =
          static_cast<std::size_t>(std::count(edges.begin(), edges.end(), true));
      setting.errors.picture.edgeRms = rmsDifference(alternative.picture, reference, edges);
    }
    result.settings.push_back(std::move(setting));
  }
  return result;
}

}  // namespace isolux::app
