// The first crossing of each ray with the isosurfaces, and what is known of it, packed (volume/cast/hit_info.h).
//
// EXACT: every cell's first root (trace.glsl, trace_cubic.glsl), which is the surface point itself: voxel position and
// t (mm; -1: none); with VALUE_ERROR also |f - isovalue| in texels of what is hit. Otherwise a bracket [t0, t1] in mm,
// t0 > t1 where there is none, by samples at two rates, Hadwiger et al. 2005 sec. 3.2; refine.frag.glsl makes the point
// of it. BEHIND: the next crossing behind the one in uSurface; GROUPS: the same, where that was not the nearest. CUBIC: of the B-spline of uField. Pixels that are not
// drawn (TILES of fullscreen.vert.glsl) have no crossing.
//
// CLIP, REMOVED: surfaces are cut (clip.glsl). CUT_FACES: rays end at the faces that are shown.
//
// BRICKS: a ray that comes to a brick that is not resident ends there and waits, in vain if it is lost: 128 in what is
// known, 1 in the last channel of a bracket. AGAIN: only the rays that waited.
#define CASTS_RAYS
#include "common.glsl"
#include "hit_info.glsl"
#include "field.glsl"
#include "start.glsl"
#include "trace.glsl"
#ifdef CUBIC
#include "spline.glsl"
#include "trace_cubic.glsl"
#endif
#include "clip.glsl"

#ifdef CUT_FACES
uniform sampler2D uCutFaces;  // t of the cut face that the ray ends at, mm; -1: none
#endif
#ifdef AGAIN
uniform sampler2D uBefore;  // what this pass wrote before: what is known, or the bracket
#endif
#ifdef BEHIND
uniform sampler2D uSurface, uInfo, uColor;
#ifdef GROUPS
uniform sampler2D uNearest;  // what is known of the nearest crossing of all groups
uniform int uFirst;          // surface of the group that is cast
#endif
#endif
#ifndef EXACT
uniform float uStep;           // voxels between samples: 1 / r0
uniform float uNearFactor;     // r1 / r0
uniform float uNearThreshold;  // delta, texels of what is hit
uniform int uMaxSteps;
#endif
#ifdef EXACT
layout(location = 0) out vec4 oSurface;
layout(location = 1) out vec2 oInfo;
#else
layout(location = 0) out vec4 oBracket;
const vec4 nothing = vec4(1.0, 0.0, 0.0, 0.0);
#endif

#ifndef EXACT
// By the texture unit: a sample only has to be near enough to be bracketed.
float sampled(vec3 p) {
#ifdef CUBIC
  // Interpolating coefficients are known in gaps too.
  return uGaps && cellMissing(cellOf(p)) ? missingTexel : splineFast(p);
#else
  return texture(uVolume, filterCoordinate(p, cellOf(p), textureSize(uVolume, 0))).r;
#endif
}

// Whether the cells between two samples are whole: a crossing is only known where the field is.
bool whole(Path path, float from, float to) {
  ivec3 cell = cellOf(path.origin + from * path.direction);
  for (int i = 0; i < uMaxSteps; ++i) {
    if (!resident(cell)) return true;  // the ray waits for it
    if (cellMissing(cell)) return false;
#ifdef CUBIC
    if (isMissing(splineMinus(vec3(cell) + 0.5, 0.0))) return false;
#endif
    bvec3 axis;
    float t = exitOf(path, cell, 0, axis);
    if (t >= to) return true;
    cell = nextCell(path, cell, 0, t, axis);
    if (outsideCells(cell)) return true;
  }
  return true;
}

// What is seen of surface k at p, where the field less its isovalue is f.
#ifdef HIDDEN
float seen(float f, int k, vec3 p) {
  if ((f >= 0.0) != uInsideHigh) return f;
  ivec3 cell = cellOf(p);
  vec4 low, high;
  cellCorners(cell, low, high);
  lookUpHidden(cell, low, high, clamp(p - vec3(cell), 0.0, 1.0), vec3(0.0));
  return shownSide(f, k, 0.0) == uInsideHigh ? f : uInsideHigh ? -abs(f) - 1e-30 : abs(f);
}
#else
float seen(float f, int k, vec3 p) { return f; }
#endif

// Of `surfaces`, a bit each.
vec4 march(vec3 origin, vec3 direction, float t, float tEnd, int surfaces) {
  Path path = pathOf(origin, direction);
  clipToDomain(path, t, tEnd);
  if (t > tEnd) return nothing;
  Place place = placeAt(origin + t * direction);
  float step = uStep / length(direction), tBefore = t;
  vec4 before = vec4(0.0);
  bool known = false;
  for (int i = 0; i < uMaxSteps; ++i) {
    int shift = emptyShift(place);
    if (shift >= 0) {
      bvec3 axis;
      t = max(t, exitOf(path, place.cell, shift, axis));
      known = known && !uGaps;
      if (t >= tEnd) return nothing;
      place.cell = nextCell(path, place.cell, shift, t, axis);
      if (outsideCells(place.cell)) return nothing;
      continue;
    }
    if (!resident(place.cell)) return nothing;
    float value = sampled(origin + t * direction) - uIsovalues.x;
    float distance = never;
    if (isMissing(value)) {
      known = false;
    } else {
      float least = never;
      int surface = 0;
      vec4 at = vec4(0.0);
      for (int k = 0; k < SURFACES; ++k) {
        float now = seen(value - uIsovalueShifts[k], k, origin + t * direction), then = before[k];
        at[k] = now;
        distance = min(distance, abs(now));
        if (!known || (now >= 0.0) == (then >= 0.0) || (surfaces >> k & 1) == 0) continue;
        float s = then / (then - now);
        if (s < least) {
          least = s;
          surface = k;
        }
      }
      bool refused = least < never && uGaps && !whole(path, tBefore, t);
      if (least < never && !refused) return vec4(tBefore, t, float(surface + (at[surface] >= 0.0 ? 4 << surface : 0)), 0.0);
      known = true;
      before = at;
    }
    tBefore = t;
    if (t >= tEnd) return nothing;
    t = min(t + (distance < uNearThreshold ? step / uNearFactor : step), tEnd);
    place.cell = cellOf(origin + t * direction);
  }
  return nothing;
}
#endif

#ifndef EXACT
// As far as cuts leave the surfaces: outside the kept region and within it, by turns. Samples at the ends of its
// stretches are common.
vec4 marchKept(vec3 origin, vec3 direction, float t, float tEnd) {
#ifdef CLIP
  Kept kept = keptOf(origin, direction);
  vec2 stretch = stretchBehind(kept, t);
  const int most = 64;  // more than there are parts
  for (int part = 0; part < most && t < tEnd; ++part) {
    bool none = stretch.x >= stretch.y, within = !none && stretch.x <= t;
    float end = min(tEnd, within ? stretch.y : none ? never : stretch.x);
    int surfaces = within ? allSurfaces : allSurfaces & ~uClipped;
    if (surfaces != 0 && t < end) {
      vec4 bracket = march(origin, direction, t, end, surfaces);
      if (bracket.x <= bracket.y) return bracket;
    }
    t = end;
    if (within) stretch = end < kept.between.y ? stretchBehind(kept, end) : vec2(never);
  }
  return nothing;
#else
  return march(origin, direction, t, tEnd, (1 << SURFACES) - 1);
#endif
}
#endif

#ifdef BEHIND
const bool writesNothing = false;
#else
const bool writesNothing = true;  // that there is no crossing
#endif

// False: the pixel is to keep what it holds.
bool castRay() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef EXACT
  oSurface = vec4(0.0, 0.0, 0.0, -1.0);
  oInfo = vec2(0.0);
#else
  oBracket = nothing;
#endif
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  float voxel = 1.0 / length(direction);  // mm along the ray
  float t, tEnd;
  rayStart(gl_FragCoord.xy, 0.05 * voxel, t, tEnd);
  if (t > tEnd) return writesNothing;
  bool carried = false;
  int inside = 0;
#ifdef BEHIND
  float tFront = texelFetch(uSurface, pixel, 0).w;
  if (tFront < 0.0 || texelFetch(uColor, pixel, 0).a > 0.996) return false;
#ifdef GROUPS
  int nearest = surfaceOf(int(texelFetch(uNearest, pixel, 0).g)) - uFirst;
  if (nearest < 0 || nearest >= SURFACES) {
    vec2 info = texelFetch(uInfo, pixel, 0).rg;
#ifdef EXACT
    oSurface = texelFetch(uSurface, pixel, 0);
    oInfo = info;
#else
    oBracket = vec4(tFront, tFront, info.g, 0.0);
#endif
    return true;
  }
#endif
#ifdef EXACT
  carried = true;
  inside = sidesBehind(int(texelFetch(uInfo, pixel, 0).g));
  t = tFront + 1e-4 * voxel;
#else
  t = tFront + 0.02 * voxel;
#endif
  if (t > tEnd) return false;
#endif
#ifdef CUT_FACES
  float face = texelFetch(uCutFaces, pixel, 0).r;
#ifdef REMOVED
  bool first = false;
#else
  bool first = uClipped == allSurfaces;  // surfaces that are all cut lie behind it
#endif
  if (face >= 0.0 && (first || t >= face)) return writesNothing;
  if (face >= 0.0) tEnd = min(tEnd, face);
#endif

#ifdef EXACT
  Crossing crossing = traceKept(origin, direction, t, tEnd, carried, inside);
#ifdef CUT_FACES
  crossing.found = crossing.found && (face < 0.0 || crossing.t < face);
#endif
  if (crossing.found) {
    vec3 p = origin + crossing.t * direction;
    float error = 0.0;
#ifdef VALUE_ERROR
    float isovalue = uIsovalues[crossing.surface];
#ifdef CUBIC
    error = splineMinus(clamp(p, vec3(0.0), vec3(uDims - 1)), isovalue);
#else
    error = trilinearMinus(p, isovalue);
#endif
#endif
    oSurface = vec4(p, max(crossing.t, 0.0));
    oInfo = vec2(isMissing(error) ? 0.0 : abs(error), float(crossing.surface + 4 * crossing.inside));
  }
#ifdef BRICKS
  if (brickMissed) {
    crossing.found = false;
    oSurface = vec4(0.0, 0.0, 0.0, -1.0);
    oInfo = vec2(0.0, 128.0);
    countMissed();
  }
#endif
  return crossing.found || writesNothing;
#else
  oBracket = marchKept(origin, direction, t, tEnd);
#ifdef BRICKS
  if (oBracket.x <= oBracket.y) enterBricks(origin + oBracket.x * direction, origin + oBracket.y * direction);
  if (brickMissed) {
    oBracket = vec4(nothing.xyz, 1.0);
    countMissed();
  }
#endif
  return oBracket.x <= oBracket.y || writesNothing;
#endif
}

#ifdef AGAIN
bool waited() {
  vec4 before = texelFetch(uBefore, ivec2(gl_FragCoord.xy), 0);
#ifdef EXACT
  return waits(int(before.g));
#else
  return before.w != 0.0;
#endif
}
#else
bool waited() { return true; }
#endif

void main() {
  bool writes = false;
  if (waited()) writes = castRay();
  if (!writes) discard;  // not before the rays: llvmpipe of Mesa 22.3 then loses writes to arrays
}
