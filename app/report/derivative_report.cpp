#include "app/report/derivative_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "app/files/json_text.h"
#include "app/ready/rest_scene.h"
#include "app/study/study_errors.h"
#include "base/number_text.h"
#include "render/passes/pass_declarations.h"
#include "scene/looks.h"
#include "scene/rules/needs.h"
#include "scene/settings/settings.h"
#include "volume/statistics/spline_residual.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

// A picture of its rays that is no larger than the renderer draws at once.
double unknownShareOf(render::Renderer& renderer, const scene::Scene& scene, render::FrameRequest request) {
  constexpr int most = 4096;
  request.color = request.linear = false;
  request.supersampling = 1;
  request.aovs = {render::Aov::hit, render::Aov::curvature_confidence};
  while (std::max(request.size.x, request.size.y) > most)
    request.size = glm::max(request.size / 2, glm::ivec2(1));
  renderer.render(scene, request);
  DrawnImages drawn;
  drawn.hit = renderer.readAov(render::Aov::hit).values;
  drawn.confidence = renderer.readAov(render::Aov::curvature_confidence).values;
  const double share = unknownShare(drawn);
  return std::isnan(share) ? 0.0 : share;  // nothing is seen
}

// "0.8 mm, chosen: curvature stands clear of the noise there" of an automatic number.
std::string numberText(const std::optional<double>& asked, const std::optional<double>& drawn,
                       const std::string& unit, const std::string& reason) {
  if (!drawn) return "not read";
  std::string text = base::shortText(*drawn, 3) + unit;
  if (asked) return text + ", as set";
  return reason.empty() ? text + ", automatic" : text + ", automatic: " + reason;
}

// The ends of the colours that stand for numbers, and from where on lines are drawn.
void printTaken(const scene::Look& look, const render::CurvatureReport& curvature) {
  const scene::LookInfo& info = scene::lookInfo(look.mode);
  if (info.kind == scene::LookKind::measure || info.kind == scene::LookKind::square)
    std::printf("colours: %s to %s %s%s\n", base::shortText(curvature.range.x, 4).c_str(),
                base::shortText(curvature.range.y, 4).c_str(), std::string(scene::unitOf(info)).c_str(),
                look.rangeLow && look.rangeHigh ? ", as set" : ", automatic: of the whole surface");
  if (look.ridges > 0.0)
    std::printf("lines: ridges from %s, valleys from %s 1/mm%s\n",
                base::shortText(curvature.ridgeThresholds.x, 4).c_str(),
                base::shortText(curvature.ridgeThresholds.y, 4).c_str(),
                look.ridgeThreshold ? ", as set" : ", automatic: of the whole surface");
}

}  // namespace

DerivativeFacts derivativeFacts(render::Renderer& renderer, const scene::Derivatives& asked,
                                const FinishedPicture& picture) {
  const scene::Scene& drawn = picture.inputs.scene;
  DerivativeFacts facts{asked, drawn, {}, picture.still.report.curvature, {}};
  const volume::DerivativeChoices& choices = *picture.inputs.volume->derivativeChoices;
  const volume::DerivativeQuestion whole{drawn.surfaces.front().value.value(), drawn.derivatives.field,
                                         asked.noise},
      ofNoise{whole.isovalue, whole.field, drawn.derivatives.noise};  // which was known before
  facts.choice = choices.find(whole);
  if (!facts.choice) facts.choice = choices.find(ofNoise);
  if (render::readsHessian(drawn, picture.inputs.request))
    facts.unknownShare = unknownShareOf(renderer, drawn, picture.inputs.request);
  return facts;
}

ordered_json choiceJson(const volume::DerivativeChoice& choice) {
  return {{"noise", choice.noise},
          {"scale_mm", choice.scaleMm},
          {"normal_scale_mm", choice.normalScaleMm},
          {"reasons",
           {{"noise", choice.noiseReason},
            {"scale", choice.scaleReason},
            {"normal_scale", choice.normalReason}}}};
}

ordered_json derivativesJson(const DerivativeFacts& facts) {
  const scene::Derivatives &asked = facts.asked, &drawn = facts.drawn.derivatives;
  ordered_json automatic = ordered_json::array();
  if (!asked.noise) automatic.push_back("noise");
  if (!asked.scale) automatic.push_back("scale");
  if (!asked.normalScale) automatic.push_back("normal_scale");
  ordered_json json{{"noise", drawn.noise},
                    {"scale_mm", drawn.scale},
                    {"normal_scale_mm", drawn.normalScale},
                    {"automatic", automatic}};
  json["chosen"] = facts.choice ? choiceJson(*facts.choice) : ordered_json(nullptr);
  json["range"] = facts.curvature ? ordered_json(facts.curvature->range) : ordered_json();
  json["ridge_thresholds"] =
      facts.curvature ? ordered_json(facts.curvature->ridgeThresholds) : ordered_json();
  json["unknown_share"] = facts.unknownShare;
  return json;
}

void printDerivatives(const DerivativeFacts& facts) {
  if (!scene::needsGradient(facts.drawn) && !facts.unknownShare) return;
  const scene::Derivatives &asked = facts.asked, &drawn = facts.drawn.derivatives;
  const volume::DerivativeChoice reasons = facts.choice.value_or(volume::DerivativeChoice{});
  const auto line = [](const char* what, const std::string& text) {
    std::printf("%s: %s\n", what, text.c_str());
  };
  line("noise of a voxel", numberText(asked.noise, drawn.noise, "", reasons.noiseReason));
  line("scale of curvature", numberText(asked.scale, drawn.scale, " mm", reasons.scaleReason));
  line("scale of normals", numberText(asked.normalScale, drawn.normalScale, " mm", reasons.normalReason));
  if (facts.curvature) printTaken(facts.drawn.look, *facts.curvature);
  if (facts.unknownShare)
    std::printf("curvature is not significant (confidence below 0.5) on %.1f %% of the visible surface\n",
                100.0 * *facts.unknownShare);
  std::fflush(stdout);
}

ordered_json restJson(const scene::Scene& drawn, const volume::PreparedVolume& volume) {
  const std::optional<double> share = volume.stillHits->find(drawn.surfaces.front().value.value());
  return {{"field", scene::setting("hit.field").get(atRestIfReady(drawn, volume))},
          {"share_beside_spline", share}};
}

void printRest(const scene::Scene& drawn, const volume::PreparedVolume& volume) {
  const ordered_json json = restJson(drawn, volume);
  std::printf("field of hits: %s", json["field"].get<std::string>().c_str());
  if (!json["share_beside_spline"].is_null())
    std::printf(
        " (%.0f %% of the visible surface is over %.1f voxel off the spline's surface; final images take the "
        "spline's hits from %.0f %%)",
        100.0 * json["share_beside_spline"].get<double>(), volume::kVisibleResidualVoxels,
        100.0 * volume::kManyBesideSpline);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace isolux::app
