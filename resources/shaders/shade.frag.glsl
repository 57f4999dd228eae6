// The look, in linear colour. LOOK: the number of scene::LookMode.
#include "common.glsl"

uniform sampler2D uSurface, uInfo, uGradient;
uniform vec3 uRightWorld, uUpWorld, uForwardWorld;  // the camera's unit axes
uniform float uOutward;        // -1: inside is above the isovalue, +1: below
uniform float uAmbient, uSpecular, uShininess, uIntensity;
uniform vec3 uLight;           // unit, world, toward the light
uniform vec2 uDepthRange;      // mm along the view direction: nearest and farthest corner of the volume
uniform vec3 uAlbedos[4];      // of each surface
uniform vec4 uOpacities;
layout(location = 0) out vec4 oColor;  // premultiplied by the surface's opacity; 0 where there is no surface

// A length that neither under- nor overflows.
vec3 safeNormalize(vec3 v, vec3 otherwise) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 0.0)) return otherwise;
  return normalize(v / largest);
}

vec3 shaded(ivec2 pixel, vec4 surface, vec3 albedo) {
  vec2 xy = imagePlane(gl_FragCoord.xy);
  vec3 ray = uOrthographic != 0 ? uForwardWorld : normalize(uForwardWorld + xy.x * uRightWorld + xy.y * uUpWorld);
#if LOOK == 13
  float depth = surface.w * dot(ray, uForwardWorld);
  float nearness = 1.0 - clamp((depth - uDepthRange.x) / max(uDepthRange.y - uDepthRange.x, 1e-30), 0.0, 1.0);
  // Even steps of depth are even steps of lightness.
  return vec3(pow(0.08 + 0.92 * nearness, 2.2));
#else
  // Where the gradient vanishes there is no normal; the point is shaded as if it faced the viewer.
  vec3 normal = safeNormalize(uOutward * texelFetch(uGradient, pixel, 0).xyz, -ray);
#if LOOK == 12
  return pow(normal * 0.5 + 0.5, vec3(2.2));
#else
  if (dot(normal, ray) > 0.0) normal = -normal;  // the inner side, seen through an opening
  float diffuse = max(dot(normal, uLight), 0.0);
  vec3 color = albedo * (uAmbient + (1.0 - uAmbient) * uIntensity * diffuse);
#if LOOK == 0
  vec3 halfway = normalize(uLight - ray);
  float highlight = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), uShininess) : 0.0;
  color += uSpecular * uIntensity * highlight;
#endif
  return color;
#endif
#endif
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  oColor = vec4(0.0);
  if (surface.w < 0.0) return;
  int which = int(texelFetch(uInfo, pixel, 0).g) & 3;
  oColor = vec4(shaded(pixel, surface, uAlbedos[which]), 1.0) * uOpacities[which];
}
