// Whether the key light reaches the surface point: 1 lit, 0 in shadow. An exact second ray to a light infinitely far
// away; any surface that is opaque stops it.
//
// The ray starts at the hit, on the viewer's side of the surface (that side is known and carried, so rounding cannot
// make the surface shadow itself). It first follows the normal for a part of a voxel: the shading normal is
// smoother than the cells' own faces, and where light grazes these would cast shadows on one another. That first way
// is traced too; it ends halfway to what it meets, so that no light leaks through a narrow gap. CUBIC, SURFACES,
// EXACT, CLIP: as in cast.frag.glsl.
#define CASTS_RAYS
#include "common.glsl"
#include "field.glsl"
#include "trace.glsl"
#ifdef CUBIC
#include "spline.glsl"
#include "trace_cubic.glsl"
#endif
#include "clip.glsl"
#include "surface.glsl"

uniform mat3 uVoxelFromWorld;
uniform vec3 uLight;     // unit, world, toward the light
uniform int uOpaqueBits;  // surfaces that stop light
uniform int uFirst;       // of them among all
layout(location = 0) out float oLit;

// The first opaque surface; `inside` becomes the sides at the end of the way where there is none.
bool meets(vec3 origin, vec3 direction, float tEnd, bool carried, inout int inside, out float t) {
  t = 0.0;
  const int most = 32;  // transparent surfaces passed through
  for (int i = 0; i < most; ++i) {
    Crossing crossing = traceKept(origin, direction, t, tEnd, carried, inside);
    if (!crossing.found) return false;
    t = crossing.t;
    if ((uOpaqueBits >> crossing.surface & 1) != 0) return true;
    inside = crossing.inside;
    carried = true;
  }
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oLit = 0.0;
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  float facing = dot(p.normal, uLight);
  if (facing <= 0.0) return;

  vec2 info = texelFetch(uInfo, pixel, 0).rg;
  vec3 origin = surface.xyz, normal = uVoxelFromWorld * p.normal;
  float voxel = 1.0 / max(length(normal), 1e-30);  // mm
  // Back to where the viewer's ray came from: a hit on a face between cells is then in the cell before the surface, and
  // a sampled hit that lies behind the surface by its error is before it.
#ifdef EXACT
  int place = surfaceOf(int(info.g)) - uFirst;
  bool known = place >= 0 && place < SURFACES, carried = known;
  int inside = (sidesBehind(int(info.g)) ^ 1 << placeOf(int(info.g))) >> (uFirst & 3);  // before the crossing
  float back = 1e-3;  // voxels
#else
  const bool known = false;
  bool carried = known;
  int inside = 0;
  float slope = length(trilinearGradient(clamp(origin, vec3(0.0), vec3(uDims - 1))));
  float back = 0.01 + 2.0 * min(info.r / max(slope, 1e-30), 0.5);
#endif
  origin -= back * safeNormalize(uVoxelFromWorld * p.ray, vec3(0.0));
  float offset = (0.02 + 0.4 * (1.0 - facing) * (1.0 - facing)) * voxel, met;
  if (meets(origin, normal, offset, carried, inside, met)) offset = 0.5 * met;
  bool blocked = meets(origin + offset * normal, uVoxelFromWorld * uLight, never, carried, inside, met);
  oLit = blocked ? 0.0 : 1.0;
#ifdef BRICKS
  if (brickMissed) {  // hatched until it is known
    vec2 at = inPicture(gl_FragCoord.xy);
    oLit = mod(at.x + at.y, 12.0) < 6.0 ? 0.0 : 1.0;
    countMissed();
  }
#endif
}
