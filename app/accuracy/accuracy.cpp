#include "app/accuracy/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/ready/give_way.h"
#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"
#include "base/quantiles.h"
#include "render/graph/pass.h"
#include "render/still_picture.h"

namespace isolux::app {

namespace {

BoundSpread boundSpreadOf(const std::vector<float>& image, const std::vector<std::uint8_t>& certain) {
  std::vector<double> bounds;
  for (std::size_t i = 0; i < image.size(); ++i)  // of light that is not stored: none
    if (certain[i] && !std::isnan(image[i])) bounds.push_back(static_cast<double>(image[i]));
  if (bounds.empty())
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  return {base::quantile(bounds, 0.5), base::quantile(bounds, 0.99)};
}

}  // namespace

bool castsOnProcessor(const render::FrameReport& report) {
  return std::ranges::any_of(report.passes, [](const render::PassReport& pass) {
    return pass.name == render::pass::cast && pass.onProcessor;
  });
}

double Accuracy::uncertainShare() const {
  return pixels > 0 ? static_cast<double>(uncertain) / static_cast<double>(pixels) : 0.0;
}

Accuracy accuracyOf(const PictureErrors& errors) {
  Accuracy accuracy;
  accuracy.pixels = errors.certain.size();
  for (std::size_t i = 0; i < errors.certain.size(); ++i) {
    if (!std::isnan(errors.depthMm[i])) ++accuracy.seen;
    if (!errors.certain[i]) ++accuracy.uncertain;
  }
  const auto spread = [&](const std::vector<float>& image) { return boundSpreadOf(image, errors.certain); };
  accuracy.depthMm = spread(errors.depthMm);
  accuracy.normalDegrees = spread(errors.normalDegrees);
  accuracy.curvature = spread(errors.curvature);
  accuracy.relativeCurvature = spread(errors.relativeCurvature);
  accuracy.normalNoiseDegrees = spread(errors.normalNoiseDegrees);
  accuracy.curvatureNoise = spread(errors.curvatureNoise);
  accuracy.depthNoiseMm = spread(errors.depthNoiseMm);
  accuracy.light = spread(errors.light);
  accuracy.relativeLight = {accuracy.light.median / errors.meanIrradiance,
                            accuracy.light.most99 / errors.meanIrradiance};
  accuracy.relativeLightWithin =
      std::isnan(accuracy.light.median) ? accuracy.light.median : errors.lightWithin / errors.meanIrradiance;
  return accuracy;
}

PictureErrors measureErrors(render::Renderer& renderer, ShownPicture drawn, base::Progress& progress,
                            std::optional<bool> drawnOnProcessor) {
  completeFields(drawn.scene, *drawn.volume, true, progress);
  const render::FrameRequest hits{.size = drawn.size,
                                  .color = false,
                                  .aovs = {render::Aov::depth, render::Aov::voxel},
                                  .stop = progress.token()};
  render::StillPicture picture = render::drawStill(renderer, drawn.scene, hits, progress);
  PictureErrors errors =
      pictureErrors(*drawn.volume, drawn.scene,
                    {drawn.size, std::move(picture.aovs[0].values), std::move(picture.aovs[1].values),
                     drawnOnProcessor.value_or(castsOnProcessor(picture.report))},
                    progress);
  boundLight(renderer, drawn, errors, progress);
  return errors;
}

std::unique_ptr<AccuracyTask> accuracyTask(AccuracySubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress& progress) {
    giveWay();
    QuietRenderer quiet(subject.volume, subject.light);
    ShownPicture shown = subject;
    completeFields(shown.scene, *shown.volume, true, progress);
    shown.scene = atRest(std::move(shown.scene), *shown.volume, progress);
    PictureErrors errors = measureErrors(*quiet, std::move(shown), progress, subject.onProcessor);
    MeasuredPicture measured{accuracyOf(errors), nullptr};
    if (subject.keepImages) measured.images = std::make_shared<const PictureErrors>(std::move(errors));
    return measured;
  };
  return AccuracyTask::start({"", "bound the errors of the image"}, work);
}

}  // namespace isolux::app
