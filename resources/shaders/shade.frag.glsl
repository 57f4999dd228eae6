// The look, in linear colour. LOOK: the number of scene::LookMode.
#include "common.glsl"

uniform sampler2D uSurface, uGradient;
uniform vec3 uRightWorld, uUpWorld, uForwardWorld;  // the camera's unit axes
uniform float uOutward;        // -1: inside is above the isovalue, +1: below
uniform vec3 uAlbedo;
uniform float uAmbient, uSpecular, uShininess, uIntensity;
uniform vec3 uLight;           // unit, world, toward the light
uniform vec2 uDepthRange;      // mm along the view direction: nearest and farthest corner of the volume
uniform vec3 uBackgroundTop, uBackgroundBottom;
layout(location = 0) out vec4 oColor;

// A length that neither under- nor overflows.
vec3 safeNormalize(vec3 v, vec3 otherwise) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 0.0)) return otherwise;
  return normalize(v / largest);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) {
    oColor = vec4(mix(uBackgroundBottom, uBackgroundTop, gl_FragCoord.y / float(uPictureSize.y)), 1.0);
    return;
  }
  vec2 xy = imagePlane(gl_FragCoord.xy);
  vec3 ray = uOrthographic != 0 ? uForwardWorld : normalize(uForwardWorld + xy.x * uRightWorld + xy.y * uUpWorld);
#if LOOK == 13
  float depth = surface.w * dot(ray, uForwardWorld);
  float nearness = 1.0 - clamp((depth - uDepthRange.x) / max(uDepthRange.y - uDepthRange.x, 1e-30), 0.0, 1.0);
  // Even steps of depth are even steps of lightness.
  oColor = vec4(vec3(pow(0.08 + 0.92 * nearness, 2.2)), 1.0);
#else
  // Where the gradient vanishes there is no normal; the point is shaded as if it faced the viewer.
  vec3 normal = safeNormalize(uOutward * texelFetch(uGradient, pixel, 0).xyz, -ray);
#if LOOK == 12
  oColor = vec4(pow(normal * 0.5 + 0.5, vec3(2.2)), 1.0);
#else
  if (dot(normal, ray) > 0.0) normal = -normal;  // the inner side, seen through an opening
  float diffuse = max(dot(normal, uLight), 0.0);
  vec3 color = uAlbedo * (uAmbient + (1.0 - uAmbient) * uIntensity * diffuse);
#if LOOK == 0
  vec3 halfway = normalize(uLight - ray);
  float highlight = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), uShininess) : 0.0;
  color += uSpecular * uIntensity * highlight;
#endif
  oColor = vec4(color, 1.0);
#endif
#endif
}
