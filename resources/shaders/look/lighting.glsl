// Light on a surface of colour `base`. Needs surface.glsl.
uniform float uAmbient, uAmbientVariation, uSpecular, uShininess, uHeadlight, uFill, uRim;
uniform vec3 uLight;       // unit, world, toward the key light
uniform vec3 uLightColor;  // times its intensity
uniform vec3 uFillLight, uRimLights[2];  // unit, world, toward them
uniform vec3 uToneCool, uToneWarm;

#if SHADING == SHADING_TONE
// Gooch et al. 1998: hue carries the form, from cool to warm, each with a part of the surface's own colour. `lit` is
// 0 in shadow.
vec3 lighted(vec3 base, Point p, float lit) {
  float facing = dot(p.normal, uLight);
  float warmth = 0.5 + 0.5 * (facing > 0.0 ? facing * lit : facing);
  // Cubed: a surface lit from near the eye would show little of the cool side.
  return mix(mix(uToneCool, base, 0.1), mix(uToneWarm, base, 0.4), warmth * warmth * warmth);
}
#elif SHADING == SHADING_GI
uniform sampler2D uIrradiance;
uniform float uExposure;  // 2^stops
#ifdef GLOSS
#include "gloss.glsl"
#endif

vec3 lighted(vec3 base, Point p, float lit) {
  const float pi = 3.14159265;
  vec3 diffuse = base * texelFetch(uIrradiance, ivec2(fragment()), 0).rgb * (uExposure / pi);
#ifdef GLOSS
  vec4 gloss = glossAt(p, surfaceOf(int(texelFetch(uInfo, ivec2(fragment()), 0).g)));
  return mix(diffuse, gloss.rgb * uExposure, gloss.a);
#else
  return diffuse;
#endif
}
#elif SHADING == SHADING_UNLIT
vec3 lighted(vec3 base, Point p, float lit) { return base; }
#else
float highlight(Point p, vec3 toward) {
  vec3 halfway = safeNormalize(toward - p.ray, p.normal);
  return dot(p.normal, toward) > 0.0 ? pow(max(dot(p.normal, halfway), 0.0), uShininess) : 0.0;
}

vec3 lighted(vec3 base, Point p, float lit) {
  vec3 key = uLightColor * lit;
  float ambient = uAmbient * (1.0 + uAmbientVariation * dot(p.normal, uUpWorld));
  vec3 diffuse = key * max(dot(p.normal, uLight), 0.0) + uHeadlight * max(-dot(p.normal, p.ray), 0.0);
  diffuse += uLightColor * (uFill * max(dot(p.normal, uFillLight), 0.0) +
                            uRim * (max(dot(p.normal, uRimLights[0]), 0.0) + max(dot(p.normal, uRimLights[1]), 0.0)));
  vec3 color = base * (ambient + (1.0 - uAmbient) * diffuse);
#if SHADING == SHADING_BLINN_PHONG
  color += uSpecular * (key * highlight(p, uLight) + uHeadlight * highlight(p, -p.ray));
#endif
  return color;
}
#endif
