// Makes the points of a plot from what a quality setting was found to cost and to err by, and tells which of
// them are worth their time.
#pragma once

#include <string>
#include <vector>

#include "app/study/study.h"

namespace isolux::app {

struct QualityPoint {
  std::string value;  // as in QualitySetting::values
  double cost = 0.0;  // of costOf()
  double error = 0.0;
  bool isDefault = false;
  bool isPresent = false;  // the scene has it
  bool onFront = false;    // no other point is as cheap and as accurate, and better in one of them
};

// Returns the points of the values, by the study's first panel, without those whose error is NaN. `scene` as
// the user gave it.
std::vector<QualityPoint> pointsOf(const QualityStudy& study, const scene::Scene& scene,
                                   const scene::VolumeFacts& facts);
// Sets onFront. Equal points are all on the front.
void markFront(std::vector<QualityPoint>& points);

// The scene with one of its values and nothing else changed: what is the default stays automatic.
scene::Scene withQualitySettingAt(const QualitySetting& quality, const std::string& value, scene::Scene scene,
                                  const scene::VolumeFacts& facts);

// Those that change pictures of this scene, in the order of qualitySettings(): nothing of sampling where hits
// are exact, none of light where no stored light is read. `scene` as the user gave it.
std::vector<QualitySetting> actingQualitySettings(const scene::Scene& scene, const scene::VolumeFacts& facts);

}  // namespace isolux::app
