// Irradiance at the surface points: what is stored of it, and light without anything in its way where that is not yet
// baked. STORED: there is a lattice (light_lattice.glsl).
//
// What a transparent surface hides from its own inner side it hides by its opacity only, for light from everywhere
// (meanOpacity() of scene/opacity.h): the rest of the light comes through.
#include "common.glsl"
#include "surface.glsl"
#include "local_light.glsl"
#ifdef STORED
#include "light_lattice.glsl"
uniform vec4 uStoredIsovalues;  // stored units, of each surface
uniform vec4 uOpacities;
#endif
layout(location = 0) out vec4 oIrradiance;  // E of sky and lamps; how much of the lookup is baked

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  oIrradiance = vec4(0.0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  vec3 sky = localSky(p.normal), lamps = localLamps(p.position, p.normal);
  float coverage = 0.0;
#ifdef STORED
  bool inner = p.side < 0.0;
  if (!inner || uInnerPages >= 0) {
    int which = int(texelFetch(uInfo, pixel, 0).g) & 3;
    if (inner) firstPage = uInnerPages;
    lookUp(surface.xyz, p.side * p.outward, uStoredIsovalues[which]);
    vec2 part = covered * (inner ? uOpacities[which] : 1.0);
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
  oIrradiance = vec4(sky + lamps, coverage);
}
