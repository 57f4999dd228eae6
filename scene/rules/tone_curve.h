// Provides the filmic tone curve, from linear colours of any brightness to those that a screen shows, and
// which curve a picture is drawn with.
//
// The curve of the Khronos PBR Neutral Tone Mapper (Khronos Group 2024) without its toe, and with a longer
// shoulder. With p the largest channel, k = 0.5 and d = 1 - k:
//   p <= k: the colour is unchanged; exposure and albedo keep their meaning.
//   p > k:  p' = 1 - d^2 / (p + d - k), continuous with its first derivative at k, and below 1. All channels
//   are
//           multiplied by p' / p, which keeps the hue; then mixed with the grey p' by
//           1 - 1 / (0.15 (p - p') + 1), so that what is far too bright turns white.
// resources/shaders/look/tone_curve.glsl is the same in GLSL. Safe from any thread; reports no errors.
#pragma once

#include <algorithm>

#include "scene/rules/needs.h"

namespace isolux::scene {

constexpr double kToneKnee = 0.5, kToneDesaturation = 0.15;

// `linear`: any vector of double with members x, y and z and arithmetic; no channel is negative.
template <class Rgb>
Rgb filmic(const Rgb& linear) {
  const double peak = std::max({linear.x, linear.y, linear.z});
  if (!(peak > kToneKnee)) return linear;
  constexpr double d = 1.0 - kToneKnee;
  const double newPeak = 1.0 - d * d / (peak + d - kToneKnee);
  const double white = 1.0 - 1.0 / (kToneDesaturation * (peak - newPeak) + 1.0);
  return linear * ((1.0 - white) * newPeak / peak) + Rgb(white * newPeak);
}

inline bool isFilmic(const Scene& scene) {
  return scene.picture.curve == ToneCurve::filmic ||
         (scene.picture.curve == ToneCurve::automatic && usesGi(scene));
}

}  // namespace isolux::scene
