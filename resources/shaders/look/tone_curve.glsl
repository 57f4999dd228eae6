// The filmic tone curve; formula and source: scene/rules/tone_curve.h. No channel is negative.
vec3 filmic(vec3 linear) {
  const float knee = 0.5, desaturation = 0.15, d = 1.0 - knee;
  float peak = max(linear.r, max(linear.g, linear.b));
  if (!(peak > knee)) return linear;
  float newPeak = 1.0 - d * d / (peak + d - knee);
  float white = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return mix(linear * (newPeak / peak), vec3(newPeak), white);
}
