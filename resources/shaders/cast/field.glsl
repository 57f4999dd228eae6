// The volume and its exact trilinear field. Fetches, not hardware filtering: many GPUs round filter
// weights to 8 bits. Values are texels (render/volume/volume_texture.h).

uniform sampler3D uVolume;
uniform ivec3 uDims;

const float missingTexel = 1e30;  // stands for a missing voxel; render/gl/constants.h holds the same number
bool isMissing(float v) { return v > 1e20; }

ivec3 cellOf(vec3 p) { return clamp(ivec3(floor(p)), ivec3(0), max(uDims - 2, ivec3(0))); }

#include "bricks.glsl"

// Corner values of the cell whose lowest corner is `cell`: low.xyzw = (0,0,0) (1,0,0) (0,1,0) (1,1,0), high: z + 1.
void cellCorners(ivec3 cell, out vec4 low, out vec4 high) {
  ivec3 shift = texelShift(cell), near = cell + shift, far = min(cell + 1, uDims - 1) + shift;
  low = vec4(texelFetch(uVolume, near, 0).r, texelFetch(uVolume, ivec3(far.x, near.y, near.z), 0).r,
             texelFetch(uVolume, ivec3(near.x, far.y, near.z), 0).r, texelFetch(uVolume, ivec3(far.xy, near.z), 0).r);
  high = vec4(texelFetch(uVolume, ivec3(near.xy, far.z), 0).r, texelFetch(uVolume, ivec3(far.x, near.y, far.z), 0).r,
              texelFetch(uVolume, ivec3(near.x, far.yz), 0).r, texelFetch(uVolume, far, 0).r);
}

bool anyMissing(vec4 low, vec4 high) {
  vec4 most = max(low, high);
  return isMissing(max(max(most.x, most.y), max(most.z, most.w)));
}

bool cellMissing(ivec3 cell) {
  vec4 low, high;
  cellCorners(cell, low, high);
  return anyMissing(low, high);
}

float bilinear(vec4 corners, float x, float y) {
  return mix(mix(corners.x, corners.y, x), mix(corners.z, corners.w, x), y);
}

// f - isovalue at p (voxel coordinates, clamped to the domain); huge where a corner is missing.
float trilinearMinus(vec3 p, float isovalue) {
  ivec3 cell = cellOf(p);
  vec3 f = clamp(p - vec3(cell), 0.0, 1.0);
  vec4 low, high;
  cellCorners(cell, low, high);
  if (anyMissing(low, high)) return missingTexel;
  return bilinear(mix(low - isovalue, high - isovalue, f.z), f.x, f.y);
}

// Corner values less one of them: derivatives of values like 1e6 + small come from the small part alone.
void toDifferences(inout vec4 low, inout vec4 high) {
  float reference = low.x;
  low -= reference;
  high -= reference;
}

// The trilinear field's gradient in its cell, texels per voxel; 0 where a corner is missing.
vec3 trilinearGradient(vec3 p) {
  ivec3 cell = cellOf(p);
  vec3 f = clamp(p - vec3(cell), 0.0, 1.0);
  vec4 low, high;
  cellCorners(cell, low, high);
  if (anyMissing(low, high)) return vec3(0.0);
  toDifferences(low, high);
  vec4 c = mix(low, high, f.z);
  return vec3(mix(c.y - c.x, c.w - c.z, f.y), mix(c.z - c.x, c.w - c.y, f.x), bilinear(high - low, f.x, f.y));
}

// Its mixed second derivatives (xy, xz, yz); the others are 0. False where a corner is missing.
bool trilinearMixed(vec3 p, out vec3 mixed) {
  ivec3 cell = cellOf(p);
  vec3 f = clamp(p - vec3(cell), 0.0, 1.0);
  vec4 low, high;
  cellCorners(cell, low, high);
  mixed = vec3(0.0);
  if (anyMissing(low, high)) return false;
  toDifferences(low, high);
  vec4 c = mix(low, high, f.z), rise = high - low;
  mixed = vec3(c.w - c.z - c.y + c.x, mix(rise.y - rise.x, rise.w - rise.z, f.y), mix(rise.z - rise.x, rise.w - rise.y, f.x));
  return true;
}
