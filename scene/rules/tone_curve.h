// Returns which tone curve a picture is drawn with (base/tone_curve.h,
// resources/shaders/look/tone_curve.glsl).
#pragma once

#include "scene/rules/needs.h"

namespace isolux::scene {

inline bool isFilmic(const Scene& scene) {
  return scene.picture.curve == ToneCurve::filmic ||
         (scene.picture.curve == ToneCurve::automatic && usesGi(scene));
}

}  // namespace isolux::scene
