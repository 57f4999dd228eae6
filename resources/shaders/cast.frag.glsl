// The first crossing of the isovalue on each ray, as a bracket [t0, t1] in mm; (1, 0) where there is none.
//
// EXACT: voxel traversal; in each cell of an active block the cubic along the ray is split at its extrema, so the
// first sign change is found whatever its shape; its root is solved there, t0 = t1. Otherwise: samples at a fixed
// rate (Hadwiger et al. 2005 sec. 3.2).
#include "common.glsl"
#include "field.glsl"

uniform sampler2D uSegments;
uniform sampler3D uActiveBlocks;
uniform int uBlockShift;   // log2 of the cells per block and axis
uniform float uStep;       // voxels between samples (sampled)
uniform int uMaxSteps;
layout(location = 0) out vec2 oBracket;

const float never = 1e30;

// t at which the ray leaves through the far planes; axis of the first of them. Zero directions never leave.
float exitOf(vec3 farPlanes, vec3 origin, vec3 inverseDirection, bvec3 moves, out int axis) {
  vec3 t = mix(vec3(never), (farPlanes - origin) * inverseDirection, moves);
  axis = t.x <= t.y ? (t.x <= t.z ? 0 : 2) : (t.y <= t.z ? 1 : 2);
  return t[axis];
}

#ifdef EXACT
// The cubic in Bernstein form on [0, 1] by de Casteljau: no cancellation, and inside the hull of its coefficients.
float cubic(vec4 b, float s) {
  vec3 q = mix(b.xyz, b.yzw, s);
  vec2 r = mix(q.xy, q.yz, s);
  return mix(r.x, r.y, s);
}

// First sub-interval of [0, 1] between extrema over which the side (f >= 0) changes from `inside`.
bool firstChange(vec4 b, inout bool inside, out vec2 bracket) {
  bvec4 sides = greaterThanEqual(b, vec4(0.0));
  if (all(equal(sides, bvec4(inside)))) return false;  // convex hull: no crossing in this cell
  // The derivative's Bernstein coefficients, as c2 s^2 + 2 c1 s + c0.
  float d0 = b.y - b.x, d1 = b.z - b.y, d2 = b.w - b.z;
  float c2 = d0 - 2.0 * d1 + d2, c1 = d1 - d0, c0 = d0;
  float discriminant = c1 * c1 - c2 * c0;
  vec2 extrema = vec2(1.0);
  if (discriminant > 0.0) {
    // Citardauq's form: the stable one of the two for each root.
    float q = -(c1 + (c1 >= 0.0 ? 1.0 : -1.0) * sqrt(discriminant));
    vec2 roots = vec2(c2 != 0.0 ? q / c2 : 1.0, q != 0.0 ? c0 / q : 1.0);
    roots = vec2(min(roots.x, roots.y), max(roots.x, roots.y));
    extrema = clamp(roots, 0.0, 1.0);
  }
  float stops[4] = float[4](0.0, extrema.x, extrema.y, 1.0);
  float before = 0.0;
  for (int i = 0; i < 4; ++i) {
    float at = stops[i];
    float f = i == 0 ? b.x : i == 3 ? b.w : cubic(b, at);
    if ((f >= 0.0) != inside) {
      bracket = vec2(before, at);
      inside = !inside;
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
// multi-affine field is the mean over which axes have already moved.
vec4 bernstein(vec4 low, vec4 high, vec3 from, vec3 to) {
  vec4 atFrom = mix(low, high, from.z), atTo = mix(low, high, to.z);
  float f000 = bilinear(atFrom, from.x, from.y), f100 = bilinear(atFrom, to.x, from.y);
  float f010 = bilinear(atFrom, from.x, to.y), f110 = bilinear(atFrom, to.x, to.y);
  float f001 = bilinear(atTo, from.x, from.y), f101 = bilinear(atTo, to.x, from.y);
  float f011 = bilinear(atTo, from.x, to.y), f111 = bilinear(atTo, to.x, to.y);
  return vec4(f000, (f100 + f010 + f001) / 3.0, (f110 + f101 + f011) / 3.0, f111);
}
#endif

void main() {
  oBracket = vec2(1.0, 0.0);
  vec2 segment = texelFetch(uSegments, ivec2(gl_FragCoord.xy), 0).rg;
  if (segment.x >= never || segment.y >= never) return;
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  float slack = 0.05 / length(direction);  // rounding of the faces' own depths, in voxels
  float t = max(segment.x - slack, 0.0), tEnd = -segment.y + slack;

  bvec3 moves = notEqual(direction, vec3(0.0));
  vec3 inverseDirection = 1.0 / mix(vec3(1.0), direction, moves);
  ivec3 forward = ivec3(greaterThan(direction, vec3(0.0)));  // 1 where the ray rises along the axis
  // The slack must not leave the domain: a clamped position would not be the ray's.
  vec3 nearPlanes = mix(vec3(uDims - 1), vec3(0.0), bvec3(forward)), farPlanes = vec3(uDims - 1) - nearPlanes;
  vec3 tNear = mix(vec3(-never), (nearPlanes - origin) * inverseDirection, moves);
  vec3 tFar = mix(vec3(never), (farPlanes - origin) * inverseDirection, moves);
  t = max(t, max(max(tNear.x, tNear.y), tNear.z));
  tEnd = min(tEnd, min(min(tFar.x, tFar.y), tFar.z));
  if (t > tEnd) return;
  ivec3 lastCell = uDims - 2;
  ivec3 cell = cellOf(origin + t * direction);
  bool known = false, inside = false;  // the side of the field where the ray last looked
#ifdef EXACT
  bool found = false;
  vec4 b;
  vec2 bracket;
  float tOut;
#else
  float step = uStep / length(direction);
  float tBefore = t;
#endif

  for (int i = 0; i < uMaxSteps; ++i) {
    int axis;
    ivec3 block = cell >> uBlockShift;
    if (texelFetch(uActiveBlocks, block, 0).r == 0.0) {
      ivec3 low = block << uBlockShift, high = ((block + 1) << uBlockShift);
      float tLeave = exitOf(vec3(mix(low, high, bvec3(forward))), origin, inverseDirection, moves, axis);
      if (tLeave >= tEnd) return;
      t = max(t, tLeave);
      cell = clamp(ivec3(floor(origin + t * direction)), low, min(high - 1, lastCell));
      cell[axis] = forward[axis] != 0 ? high[axis] : low[axis] - 1;
      if (any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, lastCell))) return;
      continue;
    }
#ifdef EXACT
    tOut = max(t, exitOf(vec3(cell + forward), origin, inverseDirection, moves, axis));
    vec4 low, high;
    cellCorners(cell, low, high);
    if (anyMissing(low, high)) {
      known = false;  // no surface at the edge of what is missing
    } else {
      vec3 from = clamp(origin + t * direction - vec3(cell), 0.0, 1.0);
      vec3 to = clamp(origin + tOut * direction - vec3(cell), 0.0, 1.0);
      b = bernstein(low - uIsovalue, high - uIsovalue, from, to);
      if (!known) inside = b.x >= 0.0;
      known = true;
      found = firstChange(b, inside, bracket);
      if (found) break;  // solved below, where the lanes of a group meet again
    }
    if (tOut >= tEnd) return;
    t = tOut;
    cell[axis] += forward[axis] != 0 ? 1 : -1;
    if (any(lessThan(cell, ivec3(0))) || any(greaterThan(cell, lastCell))) return;
#else
    float value = texture(uVolume, (origin + t * direction + 0.5) / vec3(uDims)).r;
    if (isMissing(value)) {
      known = false;
    } else {
      bool now = value >= uIsovalue;
      if (known && now != inside) {
        oBracket = vec2(tBefore, t);
        return;
      }
      inside = now;
      known = true;
    }
    tBefore = t;
    if (t >= tEnd) return;
    t = min(t + step, tEnd);
    cell = cellOf(origin + t * direction);
#endif
  }
#ifdef EXACT
  if (found) oBracket = vec2(mix(t, tOut, rootIn(b, bracket)));
#endif
}
