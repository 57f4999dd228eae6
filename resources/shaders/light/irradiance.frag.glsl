// Irradiance at the surface points: what is stored of it, and light without anything in its way where that is not yet
// baked and on the inner side of the surface, which no texel lies on. STORED: there is a lattice (light_lattice.glsl).
#include "common.glsl"
#include "surface.glsl"
#include "local_light.glsl"
#ifdef STORED
#include "light_lattice.glsl"
uniform vec4 uStoredIsovalues;  // stored units, of each surface
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
  if (p.side > 0.0) {
    lookUp(surface.xyz, p.outward, uStoredIsovalues[int(texelFetch(uInfo, pixel, 0).g) & 3]);
    coverage = 1.0;
#if SKY != PACKED_NONE
    sky = mix(sky, skySum, covered.x);
    coverage = covered.x;
#endif
#if LAMPS != PACKED_NONE
    lamps = mix(lamps, lampsSum, covered.y);
    coverage = min(coverage, covered.y);
#endif
  }
#endif
  oIrradiance = vec4(sky + lamps, coverage);
}
