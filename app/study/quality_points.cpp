#include "app/study/quality_points.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "scene/rules/needs.h"
#include "scene/rules/relevance.h"
#include "scene/settings/settings.h"

namespace isolux::app {

scene::Scene withQualitySettingAt(const QualitySetting& quality, const std::string& value, scene::Scene scene,
                                  const scene::VolumeFacts& facts) {
  const scene::Setting& setting = scene::setting(quality.setting);
  if (value == defaultValue(quality))
    setting.set(scene, setting.defaultValue());
  else
    setting.set(scene, setting.get(turned(quality, value, scene, facts)));
  return scene;
}

void markFront(std::vector<QualityPoint>& points) {
  for (QualityPoint& point : points)
    point.onFront = std::ranges::none_of(points, [&](const QualityPoint& other) {
      return other.cost <= point.cost && other.error <= point.error &&
             (other.cost < point.cost || other.error < point.error);
    });
}

std::vector<QualityPoint> pointsOf(const QualityStudy& study, const scene::Scene& scene,
                                   const scene::VolumeFacts& facts) {
  const Panel& panel = panelsOf(study.quality)[0];
  const scene::Setting& setting = scene::setting(study.quality.setting);
  std::vector<QualityPoint> points;
  for (const StudySetting& measured : study.settings) {
    if (measured.comparison) continue;
    QualityPoint point{measured.value, costOf(study.quality, measured, panel), panel.error(judged(measured)),
                       measured.isDefault || measured.settingDefault};
    if (!std::isfinite(point.cost) || !std::isfinite(point.error)) continue;
    point.isPresent =
        setting.get(scene) == setting.get(withQualitySettingAt(study.quality, measured.value, scene, facts));
    points.push_back(std::move(point));
  }
  markFront(points);
  return points;
}

std::vector<QualitySetting> actingQualitySettings(const scene::Scene& scene,
                                                  const scene::VolumeFacts& facts) {
  const scene::Scene resolved = scene::resolve(scene, facts);
  std::vector<QualitySetting> acting;
  for (const QualitySetting& quality : qualitySettings()) {
    if (quality.measure == Measure::light && !scene::usesGi(scene)) continue;
    if (quality.measure == Measure::shadow) continue;  // on or off: that is a look
    if (scene::whyInactive(quality.setting, resolved).empty()) acting.push_back(quality);
  }
  return acting;
}

}  // namespace isolux::app
