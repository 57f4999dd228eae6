// Irradiance at the surface points: what is stored of it, and light without anything in its way where that is not yet
// baked. STORED: there is a lattice (light_lattice.glsl).
//
// A transparent surface shows its own shadow in part, or not at all, and passes light on to what it encloses, its own
// inner side first (scene/opacity.h).
#include "common.glsl"
#include "surface.glsl"
#include "local_light.glsl"
#ifdef STORED
#include "light_lattice.glsl"
uniform float uStoredIsovalues[ALL_SURFACES];  // stored units
uniform float uShadowShown[ALL_SURFACES];
#endif
uniform vec3 uBehindOthers[ALL_SURFACES], uBehindItself[ALL_SURFACES];  // light, in units of that before them
layout(location = 0) out vec4 oIrradiance;  // E of sky and lamps; how much of the lookup is baked

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  oIrradiance = vec4(0.0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  vec3 sky = localSky(p.normal), lamps = localLamps(p.position, p.normal);
  int which = surfaceOf(int(texelFetch(uInfo, pixel, 0).g));
  bool inner = p.side < 0.0;
  if (inner) {
    sky *= uBehindItself[which];
    lamps *= uBehindItself[which];
  }
  float coverage = 0.0;
#ifdef STORED
  if (!inner || uInnerPages >= 0) {
    if (inner) firstPage = uInnerPages;
    lookUp(surface.xyz, p.side * p.outward, uStoredIsovalues[which]);
    vec2 part = covered * uShadowShown[which];
    coverage = 1.0;
#if SKY != PACKED_NONE
    sky = mix(sky, skySum, part.x);
    coverage = covered.x;
#endif
#if LAMPS != PACKED_NONE
    lamps = mix(lamps, lampsSum, part.y);
    coverage = min(coverage, covered.y);
#endif
  }
#endif
  oIrradiance = vec4(uBehindOthers[which] * (sky + lamps), coverage);
}
