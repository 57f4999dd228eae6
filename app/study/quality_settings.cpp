#include "app/study/quality_settings.h"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "base/decimal_text.h"
#include "base/error.h"
#include "base/words.h"
#include "scene/rules/environment.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

constexpr std::string_view kThreshold = "near_threshold", kScale = "derivatives_scale", kAutomatic = "auto";

scene::Scene resolvedFirstSurface(scene::Scene scene, const scene::VolumeFacts& facts) {
  scene.surfaces.resize(1);
  return scene::resolve(std::move(scene), facts);
}

}  // namespace

std::vector<QualitySetting> parseQualitySettings(const std::string& list) {
  if (list.empty()) return qualitySettings();
  std::vector<std::string> known;
  for (const QualitySetting& quality : qualitySettings()) known.emplace_back(quality.name);
  std::vector<QualitySetting> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto quality = std::ranges::find(qualitySettings(), word, &QualitySetting::name);
    if (quality == qualitySettings().end())
      base::throwUsage("", "--knobs",
                       "unknown quality setting \"" + word + '"' +
                           base::didYouMean(word, known, "; choose from " + base::joined(known, " ")));
    chosen.push_back(*quality);
  }
  return chosen;
}

scene::Scene turned(const QualitySetting& quality, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts) {
  if (quality.sampled()) scene.hit.method = scene::HitMethod::sampled;
  if (quality.measure == Measure::light) scene = litScene(quality, std::move(scene));
  if (quality.name == kScale) {
    scene.derivatives.scale.reset();
    if (value != kAutomatic)
      scene.derivatives.scale =
          *base::readNumber(value) * std::cbrt(facts.spacingMm.x * facts.spacingMm.y * facts.spacingMm.z);
    return resolvedFirstSurface(std::move(scene), facts);
  }
  if (quality.name != kThreshold) {
    scene::applyAssignment(scene, std::string(quality.setting) + '=' + value);
    return resolvedFirstSurface(std::move(scene), facts);
  }
  scene.hit.nearThreshold.reset();
  scene = resolvedFirstSurface(std::move(scene), facts);
  *scene.hit.nearThreshold *= *base::readNumber(value);
  return scene;
}

std::string defaultValue(const QualitySetting& quality) {
  if (quality.name == kThreshold) return "1";
  if (quality.name == kScale) return std::string(kAutomatic);
  const scene::Setting& setting = scene::setting(quality.setting);
  for (const std::string& value : quality.values) {
    scene::Scene scene;
    scene::applyAssignment(scene, std::string(quality.setting) + '=' + value);
    if (setting.get(scene) == setting.defaultValue()) return value;
  }
  return {};
}

std::string whyWithoutEffect(const QualitySetting& quality, const scene::Scene& scene) {
  if (quality.measure == Measure::shadow) return std::string(scene::whyInactive(quality.setting, scene));
  if (quality.measure == Measure::shape && !quality.field()) {
    scene::Scene curved = scene;
    curved.look.mode = scene::LookMode::kappa1;
    return std::string(scene::whyInactive(quality.setting, curved));
  }
  if (quality.measure != Measure::light) return {};
  const scene::Scene lit = litScene(quality, scene);
  if (quality.transfer() && scene::hasOneColor(scene.light.environment) &&
      scene.gi.mode != scene::GiMode::off)
    return "the environment is constant: transfer needs one number only";
  return std::string(scene::whyInactive(quality.setting, lit));
}

double effortOf(const QualitySetting& quality, const scene::Scene& scene) {
  if (!whyWithoutEffect(quality, scene).empty()) return 0.01;
  const auto values = static_cast<double>(quality.values.size());
  if (quality.measure == Measure::edges) return 10.0 * values;
  if (quality.measure != Measure::light) return values;
  return quality.cost == Cost::bakeSeconds ? 6.0 * values : 2.0 * values;
}

scene::Scene litScene(const QualitySetting& quality, scene::Scene scene) {
  scene.look.mode = scene::LookMode::gi;
  scene.hit.method = scene::HitMethod::exact;
  scene.hit.field = scene::Field::trilinear;
  scene.gi.extent = scene::GiExtent::view;
  scene.surfaces.front().opacity = scene.surfaces.front().facingOpacity = 1.0;
  if (!quality.transfer() || scene.gi.mode == scene::GiMode::off) return scene;
  scene.gi.mode = scene::GiMode::automatic;
  scene.light.environment.moves = true;
  return scene;
}

}  // namespace isolux::app
