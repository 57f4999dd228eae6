// Where the voxels of a volume lie in its textures: as one texture, or (BRICKS) as bricks in a cache.
//
// A brick holds what every lookup around its 32^3 cells needs: voxels 32 b - BRICK_APRON .. 32 b + 32 + BRICK_APRON on
// each axis, border voxels repeated. All lookups around one cell are made in the cell's own brick. CASTS_RAYS: each brick that is entered is
// marked as used, or as asked for where it is not resident. Hadwiger et al. 2005 sec. 3.1.

#ifdef BRICKS
const int brickShift = 5, brickTexels = 33 + 2 * BRICK_APRON;  // render/volume/brick_cache.h holds the same numbers
uniform usampler3D uBricks;  // of each brick: its slot in the cache; w = 1 where it is resident

#ifdef CASTS_RAYS
layout(std430, binding = 0) buffer BrickUse {
  uint waitingRays;
  uint brickUse[];  // x fastest; 1: used, 2: asked for
};
#endif

ivec3 currentBrick = ivec3(-1), currentSlot, currentShift;
bool currentResident = false;
bool brickMissed = false;  // something was looked up in a brick that is not resident

void enterBrick(ivec3 cell) {
  ivec3 brick = cell >> brickShift;
  if (brick == currentBrick) return;
  uvec4 slot = texelFetch(uBricks, brick, 0);
  currentBrick = brick;
  currentSlot = ivec3(slot.xyz) * brickTexels;
  currentShift = currentSlot + BRICK_APRON - (brick << brickShift);
  currentResident = slot.w != 0u;
  if (!currentResident) brickMissed = true;
#ifdef CASTS_RAYS
  ivec3 size = textureSize(uBricks, 0);
  brickUse[(brick.z * size.y + brick.y) * size.x + brick.x] = currentResident ? 1u : 2u;
#endif
}

// Lookups around `cell` are answered.
bool resident(ivec3 cell) {
  enterBrick(cell);
  return currentResident;
}

// Texel = voxel + this, for lookups around `cell`.
ivec3 texelShift(ivec3 cell) {
  enterBrick(cell);
  return currentShift;
}

// Texture coordinate of a voxel position near `cell`. Kept off the neighbouring slots: a filter's rounding may reach
// over the edge by some 1e-4 texels.
vec3 filterCoordinate(vec3 voxel, ivec3 cell, ivec3 textureTexels) {
  enterBrick(cell);
  const float edge = 1.0 / 1024.0;
  vec3 low = vec3(currentSlot) + 0.5 + edge;
  vec3 texel = clamp(voxel + 0.5 + vec3(currentShift), low, low + float(brickTexels - 1) - 2.0 * edge);
  return texel / vec3(textureTexels);
}

#ifdef CASTS_RAYS
// Enters the bricks of the box between two points and a little around it.
void enterBricks(vec3 a, vec3 b) {
  const float margin = 0.01;
  ivec3 low = cellOf(min(a, b) - margin), high = cellOf(max(a, b) + margin);
  for (int i = 0; i < 8; ++i) enterBrick(mix(low, high, bvec3(i & 1, i & 2, i & 4)));
}
#endif

#else
const bool brickMissed = false;
bool resident(ivec3 cell) { return true; }
ivec3 texelShift(ivec3 cell) { return ivec3(0); }
vec3 filterCoordinate(vec3 voxel, ivec3 cell, ivec3 textureTexels) { return (voxel + 0.5) / vec3(textureTexels); }
#endif
