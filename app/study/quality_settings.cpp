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
  for (scene::ExtraIsosurface& extra : scene.extraIsosurfaces) extra.shown = false;
  return scene::resolve(std::move(scene), facts);
}

}  // namespace

std::vector<QualitySetting> parseQualitySettings(const std::string& list) {
  if (list.empty()) return knobs();
  std::vector<std::string> known;
  for (const QualitySetting& knob : knobs()) known.emplace_back(knob.name);
  std::vector<QualitySetting> chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto knob = std::ranges::find(knobs(), word, &QualitySetting::name);
    if (knob == knobs().end())
      throw base::Error(base::ErrorKind::usage, "", "--knobs",
                        "unknown quality setting \"" + word + '"' +
                            base::didYouMean(word, known, "; choose from " + base::joined(known, " ")));
    chosen.push_back(*knob);
  }
  return chosen;
}

scene::Scene turned(const QualitySetting& knob, const std::string& value, scene::Scene scene,
                    const scene::VolumeFacts& facts) {
  if (knob.sampled) scene.hit.method = scene::HitMethod::sampled;
  if (knob.measure == Measure::light) scene = litScene(knob, std::move(scene));
  if (knob.name == kScale) {
    scene.derivatives.scale.reset();
    if (value != kAutomatic)
      scene.derivatives.scale =
          *base::readNumber(value) * std::cbrt(facts.spacingMm.x * facts.spacingMm.y * facts.spacingMm.z);
    return resolvedFirstSurface(std::move(scene), facts);
  }
  if (knob.name != kThreshold) {
    scene::applyAssignment(scene, std::string(knob.setting) + '=' + value);
    return resolvedFirstSurface(std::move(scene), facts);
  }
  scene.hit.nearThreshold.reset();
  scene = resolvedFirstSurface(std::move(scene), facts);
  *scene.hit.nearThreshold *= *base::readNumber(value);
  return scene;
}

std::string defaultValue(const QualitySetting& knob) {
  if (knob.name == kThreshold) return "1";
  if (knob.name == kScale) return std::string(kAutomatic);
  const scene::Setting& setting = scene::setting(knob.setting);
  for (const std::string& value : knob.values) {
    scene::Scene scene;
    scene::applyAssignment(scene, std::string(knob.setting) + '=' + value);
    if (setting.get(scene) == setting.defaultValue()) return value;
  }
  return {};
}

std::string whyWithoutEffect(const QualitySetting& knob, const scene::Scene& scene) {
  if (knob.measure == Measure::shadow) return std::string(scene::whyInactive(knob.setting, scene));
  if (knob.measure == Measure::shape && !knob.field) {
    scene::Scene curved = scene;
    curved.look.mode = scene::LookMode::kappa1;
    return std::string(scene::whyInactive(knob.setting, curved));
  }
  if (knob.measure != Measure::light) return {};
  const scene::Scene lit = litScene(knob, scene);
  if (knob.transfer && scene::hasOneColor(scene.light.environment) && scene.gi.mode != scene::GiMode::off)
    return "the environment is constant: transfer needs one number only";
  return std::string(scene::whyInactive(knob.setting, lit));
}

double effortOf(const QualitySetting& knob, const scene::Scene& scene) {
  if (!whyWithoutEffect(knob, scene).empty()) return 0.01;
  const auto values = static_cast<double>(knob.values.size());
  if (knob.measure == Measure::edges) return 10.0 * values;
  if (knob.measure != Measure::light) return values;
  return knob.cost == Cost::bakeSeconds ? 6.0 * values : 2.0 * values;
}

scene::Scene litScene(const QualitySetting& knob, scene::Scene scene) {
  scene.look.mode = scene::LookMode::gi;
  scene.hit.method = scene::HitMethod::exact;
  scene.hit.field = scene::Field::trilinear;
  scene.gi.extent = scene::GiExtent::view;
  scene.isosurface.opacity = scene.isosurface.facingOpacity = 1.0;
  if (!knob.transfer || scene.gi.mode == scene::GiMode::off) return scene;
  scene.gi.mode = scene::GiMode::automatic;
  scene.light.environment.moves = true;
  return scene;
}

}  // namespace isolux::app
