// The first crossing of a ray with the trilinear isosurfaces, exactly: traversal of the cells that can hold one; in
// each the cubic along the ray is split at its extrema, so the first change of side is found whatever its shape.
// What cannot hold one is left in one step, by masks of boxes of 2x2x2 cells, or of single cells (GpuVolume::bindMasks).
//
// HIDDEN: some pieces are hidden; what is seen is inside and not hidden (hidden.glsl).
//
// SURFACES isovalues (1 to 4) are followed at once. Needs field.glsl. Positions are voxel coordinates, t is in mm.

#ifndef SURFACES
#define SURFACES 1
#endif

uniform usampler3D uMasks;  // of 4x4x4 cells (boxes) each: a bit for each that can hold a crossing, x + 4 y + 16 z
uniform int uMaskShift;     // log2 of the cells per axis that a bit stands for
uniform bool uGaps;         // the volume has missing voxels: behind an empty box no side is known
uniform vec4 uIsovalues;    // texels of what is hit
uniform vec4 uIsovalueShifts;  // each isovalue minus the first, rounded once

const float never = 1e30;

// A crossing. `inside` has a bit for each surface: the side behind the crossing.
struct Crossing {
  bool found;
  float t;
  int surface;
  int inside;
};

// The ray in the form that traversal wants.
struct Path {
  vec3 origin, direction, inverseDirection;
  bvec3 moves;
  ivec3 forward;  // 1 where the ray rises along the axis
};

Path pathOf(vec3 origin, vec3 direction) {
  Path path;
  path.origin = origin;
  path.direction = direction;
  path.moves = notEqual(direction, vec3(0.0));
  path.inverseDirection = 1.0 / mix(vec3(1.0), direction, path.moves);
  path.forward = ivec3(greaterThan(direction, vec3(0.0)));
  return path;
}

// Cuts [t, tEnd] to the voxel domain: a clamped position would not be the ray's.
void clipToDomain(Path path, inout float t, inout float tEnd) {
  vec3 nearPlanes = mix(vec3(uDims - 1), vec3(0.0), bvec3(path.forward));
  vec3 farPlanes = vec3(uDims - 1) - nearPlanes;
  vec3 tNear = mix(vec3(-never), (nearPlanes - path.origin) * path.inverseDirection, path.moves);
  vec3 tFar = mix(vec3(never), (farPlanes - path.origin) * path.inverseDirection, path.moves);
  bvec3 outside = bvec3(uvec3(lessThan(path.origin, vec3(0.0))) | uvec3(greaterThan(path.origin, vec3(uDims - 1))));
  if (any(bvec3(uvec3(outside) & uvec3(not(path.moves))))) tEnd = -1.0;  // beside the volume, and stays there
  t = max(t, max(max(tNear.x, tNear.y), tNear.z));
  tEnd = min(tEnd, min(min(tFar.x, tFar.y), tFar.z));
}

bool outsideCells(ivec3 cell) { return any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, uDims - 2)); }

// Where a ray is: the cell, and the mask that it is in.
struct Place {
  ivec3 cell, block;
  uvec2 mask;
};
Place placeAt(vec3 p) { return Place(cellOf(p), ivec3(-1), uvec2(0u)); }

// log2 of the cells per axis of the largest empty box around the cell; -1: the cell can hold a crossing.
int emptyShift(inout Place place) {
  ivec3 block = place.cell >> (2 + uMaskShift);
  if (block != place.block) {
    place.block = block;
    place.mask = texelFetch(uMasks, block, 0).rg;
  }
  if ((place.mask.x | place.mask.y) == 0u) return 2 + uMaskShift;
  ivec3 at = place.cell >> uMaskShift & 3;
  uint word = at.z < 2 ? place.mask.x : place.mask.y;
  if ((word >> ((at.x & 2) + 4 * (at.y & 2)) & 0x330033u) == 0u) return 1 + uMaskShift;
  return (word >> (at.x + 4 * at.y + 16 * (at.z & 1)) & 1u) == 0u ? uMaskShift : -1;
}

// t at which the ray leaves the box of 1 << shift cells per axis around `cell`, and along which axis. Axes it does not
// move along it never leaves.
float exitOf(Path path, ivec3 cell, int shift, out bvec3 axis) {
  vec3 planes = vec3(((cell >> shift) + path.forward) << shift);
  vec3 t = mix(vec3(never), (planes - path.origin) * path.inverseDirection, path.moves);
  bool x = t.x <= t.y && t.x <= t.z, y = !x && t.y <= t.z;
  axis = bvec3(x, y, !x && !y);
  return x ? t.x : y ? t.y : t.z;
}

// The cell behind `cell` across `axis`.
ivec3 neighbour(Path path, ivec3 cell, bvec3 axis) { return mix(cell, cell + 2 * path.forward - 1, axis); }

// The cell behind that box.
ivec3 nextCell(Path path, ivec3 cell, int shift, float tOut, bvec3 axis) {
  ivec3 low = cell >> shift << shift, high = low + (1 << shift);
  ivec3 inBox = clamp(ivec3(floor(path.origin + tOut * path.direction)), low, min(high, uDims - 1) - 1);
  return mix(inBox, mix(low - 1, high, bvec3(path.forward)), axis);
}

// The cubic in Bernstein form on [0, 1] by de Casteljau: no cancellation, and inside the hull of its coefficients.
float cubic(vec4 b, float s) {
  vec3 q = mix(b.xyz, b.yzw, s);
  vec2 r = mix(q.xy, q.yz, s);
  return mix(r.x, r.y, s);
}

// Ascending, in [0, 1]; 1 where there is none.
vec2 extremaOf(vec4 b) {
  // The derivative's Bernstein coefficients, as c2 s^2 + 2 c1 s + c0.
  float d0 = b.y - b.x, d1 = b.z - b.y, d2 = b.w - b.z;
  float c2 = d0 - 2.0 * d1 + d2, c1 = d1 - d0, c0 = d0;
  float discriminant = c1 * c1 - c2 * c0;
  vec2 extrema = vec2(1.0);
  if (discriminant > 0.0) {
    // Citardauq's form: the stable one of the two for each root.
    float q = -(c1 + (c1 >= 0.0 ? 1.0 : -1.0) * sqrt(discriminant));
    vec2 roots = vec2(c2 != 0.0 ? q / c2 : 1.0, c0 / q);  // q is not 0
    roots = vec2(min(roots.x, roots.y), max(roots.x, roots.y));
    extrema = clamp(roots, 0.0, 1.0);
  }
  return extrema;
}

#ifdef HIDDEN
#include "hidden.glsl"
#else
bool anyHidden(int k) { return false; }
bool shownSide(float f, int k, float s) { return f >= 0.0; }
#endif

// First sub-interval of [0, 1] between extrema over which the side that is seen of surface k is no longer `inside`:
// every stretch on one side holds an end or an extremum.
bool firstChange(vec4 b, int k, bool inside, out vec2 bracket) {
  bvec4 sides = greaterThanEqual(b, vec4(0.0));
  bracket = vec2(0.0);
  if (!anyHidden(k) && all(equal(sides, bvec4(inside)))) return false;  // convex hull: no crossing in this cell
  vec2 extrema = extremaOf(b);
  float stops[4] = float[4](0.0, extrema.x, extrema.y, 1.0);
  float before = 0.0;
  for (int i = 0; i < 4; ++i) {
    float at = stops[i];
    float f = i == 0 ? b.x : i == 3 ? b.w : cubic(b, at);
    if (shownSide(f, k, at) != inside) {
      bracket = vec2(before, at);
      return true;
    }
    before = at;
  }
  return false;
}

// The root of the cubic in [bracket.x, bracket.y], over which it is monotone: regula falsi, Illinois variant.
float rootIn(vec4 b, vec2 bracket) {
  float s0 = bracket.x, s1 = bracket.y, f0 = cubic(b, s0), f1 = cubic(b, s1);
  if ((f0 >= 0.0) == (f1 >= 0.0)) return abs(f0) <= abs(f1) ? s0 : s1;  // a crossing at the cell's very entry
  float s = s0;
  int side = 0;
  for (int i = 0; i < 12; ++i) {
    s = clamp(s1 - f1 * (s1 - s0) / (f1 - f0), s0, s1);
    float f = cubic(b, s);
    if (f == 0.0 || s1 - s0 < 1e-6) break;
    if ((f >= 0.0) == (f1 >= 0.0)) {
      s1 = s;
      f1 = f;
      if (side == 1) f0 *= 0.5;
      side = 1;
    } else {
      s0 = s;
      f0 = f;
      if (side == -1) f1 *= 0.5;
      side = -1;
    }
  }
  return s;
}

// Bernstein coefficients of the trilinear field along the segment from..to of a cell: the polar form, which for a
// multi-affine field is the mean over which axes have already moved. Within the corners' values, which rounding beside
// what stands for no value (-1e30) would leave: no surface where no corner is on its other side.
vec4 bernstein(vec4 low, vec4 high, vec3 from, vec3 to) {
  vec4 atFrom = mix(low, high, from.z), atTo = mix(low, high, to.z);
  float f000 = bilinear(atFrom, from.x, from.y), f100 = bilinear(atFrom, to.x, from.y);
  float f010 = bilinear(atFrom, from.x, to.y), f110 = bilinear(atFrom, to.x, to.y);
  float f001 = bilinear(atTo, from.x, from.y), f101 = bilinear(atTo, to.x, from.y);
  float f011 = bilinear(atTo, from.x, to.y), f111 = bilinear(atTo, to.x, to.y);
  vec4 least = min(low, high), most = max(low, high);
  return clamp(vec4(f000, (f100 + f010 + f001) / 3.0, (f110 + f101 + f011) / 3.0, f111),
               min(min(least.x, least.y), min(least.z, least.w)), max(max(most.x, most.y), max(most.z, most.w)));
}

int sidesOf(float valueMinusFirst) {
  int bits = 0;
  for (int k = 0; k < SURFACES; ++k) bits |= int(valueMinusFirst - uIsovalueShifts[k] >= 0.0) << k;
  return bits;
}

// Of what is seen at the begin of a stretch.
int shownSidesOf(float valueMinusFirst) {
  int bits = 0;
  for (int k = 0; k < SURFACES; ++k) bits |= int(shownSide(valueMinusFirst - uIsovalueShifts[k], k, 0.0)) << k;
  return bits;
}

// The cubic of a surface in its cell. The crossing the ray comes from (first) lies at this cell's entry, on one side or
// the other by rounding.
vec4 ofSurface(vec4 b, int k, int inside, bool first) {
  vec4 own = b - uIsovalueShifts[k];
  if (first) own.x = (inside >> k & 1) != 0 ? max(own.x, 0.0) : min(own.x, -1e-30);
  return own;
}

// The nearest crossing of the surfaces in `changed` (a bit each) in the cell between t.x and t.y.
void solve(vec4 b, int changed, int inside, bool first, vec2 t, inout Crossing crossing) {
  float least = 2.0;
  for (int k = 0; k < SURFACES; ++k) {
    if ((changed >> k & 1) == 0) continue;
    vec4 own = ofSurface(b, k, inside, first);
    vec2 bracket;
    firstChange(own, k, (inside >> k & 1) != 0, bracket);
    float s = rootIn(own, bracket);
    if (s >= least) continue;
    least = s;
    crossing.surface = k;
  }
  crossing.found = true;
  crossing.t = mix(t.x, t.y, least);
  crossing.inside = inside ^ (1 << crossing.surface);
}

// The first crossing in [t, tEnd]. carried: the ray has just crossed surfaces at t, and `inside` is the side it is on
// behind them; otherwise the sides are those of the field at t. Behind missing voxels nothing is known: no surface
// there. Ends where a brick is not resident (brickMissed says so).
Crossing trace(vec3 origin, vec3 direction, float t, float tEnd, bool carried, int inside) {
  Crossing crossing = Crossing(false, 0.0, 0, inside);
  Path path = pathOf(origin, direction);
  clipToDomain(path, t, tEnd);
  if (t > tEnd) return crossing;
  Place place = placeAt(origin + t * direction);
  bool known = carried, first = carried;
  int steps = 2 * (uDims.x + uDims.y + uDims.z) + 16, changed = 0;
  vec4 b;
  float tOut;
  bool alive = true;
  while (alive) {
    bvec3 axis;
    int shift = emptyShift(place);
    // Stepping over what is empty does not pay for cells: where lanes share a counter, only loops jump.
    while (shift >= 0) {
      float tNext = max(t, exitOf(path, place.cell, shift, axis));
      ivec3 next = nextCell(path, place.cell, shift, tNext, axis);
      alive = tNext < tEnd && !outsideCells(next) && --steps > 0;
      if (!alive) break;
      t = tNext;
      place.cell = next;
      if (uGaps) known = false;
      first = false;
      shift = emptyShift(place);
    }
    alive = alive && resident(place.cell);
    if (!alive) break;
    tOut = max(t, exitOf(path, place.cell, 0, axis));
    vec4 low, high;
    cellCorners(place.cell, low, high);
    bool whole = !anyMissing(low, high);
    vec3 from = clamp(origin + t * direction - vec3(place.cell), 0.0, 1.0);
    vec3 to = clamp(origin + tOut * direction - vec3(place.cell), 0.0, 1.0);
    b = bernstein(low - uIsovalues.x, high - uIsovalues.x, from, to);
#ifdef HIDDEN
    lookUpHidden(place.cell, low, high, from, to);
#endif
    if (whole && !known) inside = shownSidesOf(b.x);
    known = whole;
    for (int k = 0; k < SURFACES; ++k) {
      vec2 bracket;
      changed |= int(whole && firstChange(ofSurface(b, k, inside, first), k, (inside >> k & 1) != 0, bracket)) << k;
    }
    if (changed != 0) break;
    first = false;
    place.cell = neighbour(path, place.cell, axis);
    alive = tOut < tEnd && !outsideCells(place.cell) && --steps > 0;
    t = tOut;
  }
  if (changed != 0) solve(b, changed, inside, first, vec2(t, tOut), crossing);
  return crossing;
}
