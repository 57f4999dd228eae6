// The surface point of a pixel as looks want it: world space, millimetres. Needs common.glsl.
#include "hit_info.glsl"
uniform sampler2D uSurface, uInfo;
#ifndef NO_GRADIENT
uniform sampler2D uGradient;
uniform int uGradientRow;      // of the other images, that its first row is
#endif
uniform vec3 uRightWorld, uUpWorld, uForwardWorld;  // the camera's unit axes
uniform float uOutward;        // -1: inside is above the isovalue, +1: below
uniform mat3 uWorldFromVoxel;  // positions are taken from voxel 0: floats keep more digits near their origin

struct Point {
  vec3 position;    // mm from voxel 0
  vec3 ray;         // unit, from the eye to the point
  float depth;      // mm along the view direction
  float footprint;  // mm per ray across the view direction at this depth
  vec3 outward;     // unit normal, out of the inside
  float side;       // +1: the outer side is seen, -1: the inner one
  vec3 normal;      // unit, on the side that is seen
};

// A length that neither under- nor overflows.
vec3 safeNormalize(vec3 v, vec3 otherwise) {
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 0.0)) return otherwise;
  return normalize(v / largest);
}

vec3 worldRay(vec2 fragment) {
  vec2 xy = imagePlane(fragment);
  return uOrthographic != 0 ? uForwardWorld : normalize(uForwardWorld + xy.x * uRightWorld + xy.y * uUpWorld);
}

Point pointAt(ivec2 pixel, vec4 surface) {
  Point p;
  p.position = uWorldFromVoxel * surface.xyz;
  p.ray = worldRay(vec2(pixel) + 0.5);
  p.depth = surface.w * dot(p.ray, uForwardWorld) + uStartDepth;
  p.footprint = max(footprintAt(p.depth), 1e-30);
#ifdef NO_GRADIENT
  p.outward = -p.ray;
#else
  // Where the gradient vanishes there is no normal; the point is taken as if it faced the viewer.
  p.outward = safeNormalize(uOutward * texelFetch(uGradient, pixel - ivec2(0, uGradientRow), 0).xyz, -p.ray);
#endif
  // Which side is seen is known from the values before and behind the hit. Near an outline the normal, smoother than
  // the surface hit, may already turn away from the viewer: then the surface is seen edge on.
  int info = int(texelFetch(uInfo, pixel, 0).g);
  p.side = risesBehind(info) == (uOutward < 0.0) ? 1.0 : -1.0;
  p.normal = p.side * p.outward;
  float away = dot(p.normal, p.ray);
  if (away > 0.0) p.normal = safeNormalize(p.normal - away * p.ray, -p.ray);
  return p;
}
