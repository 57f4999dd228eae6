#include "app/study/knob_points.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "scene/rules/needs.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"

namespace isolux::app {

scene::Scene withKnobAt(const Knob& knob, const std::string& value, scene::Scene scene,
                        const scene::VolumeFacts& facts) {
  const scene::Setting& setting = scene::setting(knob.setting);
  if (value == defaultValue(knob))
    setting.set(scene, setting.defaultValue());
  else
    setting.set(scene, setting.get(turned(knob, value, scene, facts)));
  return scene;
}

void markFront(std::vector<KnobPoint>& points) {
  for (KnobPoint& point : points)
    point.onFront = std::none_of(points.begin(), points.end(), [&](const KnobPoint& other) {
      return other.cost <= point.cost && other.error <= point.error &&
             (other.cost < point.cost || other.error < point.error);
    });
}

std::vector<KnobPoint> pointsOf(const KnobStudy& study, const scene::Scene& scene,
                                const scene::VolumeFacts& facts) {
  const Panel& panel = panelsOf(study.knob)[0];
  const scene::Setting& setting = scene::setting(study.knob.setting);
  std::vector<KnobPoint> points;
  for (const StudySetting& measured : study.settings) {
    if (measured.comparison) continue;
    KnobPoint point{measured.value, costOf(study.knob, measured, panel), panel.error(judged(measured)),
                    measured.isDefault || measured.settingDefault};
    if (!std::isfinite(point.cost) || !std::isfinite(point.error)) continue;
    point.isPresent = setting.get(scene) == setting.get(withKnobAt(study.knob, measured.value, scene, facts));
    points.push_back(std::move(point));
  }
  markFront(points);
  return points;
}

std::vector<Knob> actingKnobs(const scene::Scene& scene, const scene::VolumeFacts& facts) {
  const scene::Scene resolved = scene::resolve(scene, facts);
  std::vector<Knob> acting;
  for (const Knob& knob : knobs()) {
    if (knob.measure == Measure::light && !scene::usesGi(scene)) continue;
    if (knob.measure == Measure::shadow) continue;  // on or off: that is a look
    if (scene::whyInactive(knob.setting, resolved).empty()) acting.push_back(knob);
  }
  return acting;
}

}  // namespace isolux::app
