// Where the voxels of a volume lie in its textures: as one texture, or (BRICKS) as bricks in a cache.
//
// A brick holds what every lookup around its 32^3 cells needs: voxels 32 b - BRICK_APRON .. 32 b + 32 + BRICK_APRON on
// each axis, border voxels repeated. All lookups around one cell are made in the cell's own brick. CASTS_RAYS: each brick that is entered is
// marked as used, or as asked for where it is not resident. LOST_BLOCKS: some blocks of 8^3 cells may be lost, because
// nobody can read what lookups there need; rays that meet one, or a brick that is lost as a whole, end and wait for
// nothing. Hadwiger et al. 2005 sec. 3.1.

#ifdef BRICKS
const int brickShift = 5, brickTexels = 33 + 2 * BRICK_APRON;  // render/volume/brick_cache.h holds the same numbers
// Of each brick: its slot in the cache; w = 1: it is resident, 2: lost, 3: resident, and some of its blocks are lost
// (render/volume/bricks.h). LOST_BLOCKS: in the second half, which: a channel for each z, bit x + 4 y.
uniform usampler3D uBricks;

#ifdef CASTS_RAYS
layout(std430, binding = 0) buffer BrickUse {
  uint waitingRays;
  uint lostRays;
  uint brickUse[];  // x fastest; 1: used, 2: asked for
};
#endif

ivec3 currentBrick = ivec3(-1), currentSlot, currentShift;
bool currentResident = false;
#ifdef LOST_BLOCKS
uvec4 currentLost = uvec4(0u);
#endif
bool brickMissed = false;  // something was looked up in a brick that is not resident
bool brickAwaited = false;  // and that may become so

void enterBrick(ivec3 cell) {
  ivec3 brick = cell >> brickShift;
  if (brick == currentBrick) return;
  uvec4 slot = texelFetch(uBricks, brick, 0);
  currentBrick = brick;
  currentSlot = ivec3(slot.xyz) * brickTexels;
  currentShift = currentSlot + BRICK_APRON - (brick << brickShift);
  currentResident = (slot.w & 1u) != 0u;
  if (!currentResident) brickMissed = true;
  if (slot.w == 0u) brickAwaited = true;
#ifdef LOST_BLOCKS
  currentLost = uvec4(0u);
  if (slot.w == 3u) currentLost = texelFetch(uBricks, brick + ivec3(0, 0, textureSize(uBricks, 0).z / 2), 0);
#endif
#ifdef CASTS_RAYS
  ivec3 size = textureSize(uBricks, 0);
  brickUse[(brick.z * size.y + brick.y) * size.x + brick.x] = currentResident ? 1u : slot.w == 0u ? 2u : 0u;
#endif
}

// Lookups around `cell` are answered.
bool resident(ivec3 cell) {
  enterBrick(cell);
#ifdef LOST_BLOCKS
  ivec3 block = cell >> 3 & 3;
  if ((currentLost[block.z] >> (block.x + 4 * block.y) & 1u) != 0u) {
    brickMissed = true;
    return false;
  }
#endif
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
void countMissed() {
  if (brickAwaited)
    atomicAdd(waitingRays, 1u);
  else
    atomicAdd(lostRays, 1u);
}

// Enters the bricks of the box between two points and a little around it.
void enterBricks(vec3 a, vec3 b) {
  const float margin = 0.01;
  ivec3 low = cellOf(min(a, b) - margin), high = cellOf(max(a, b) + margin);
  for (int i = 0; i < 8; ++i) resident(mix(low, high, bvec3(i & 1, i & 2, i & 4)));
}
#endif

#else
const bool brickMissed = false;
bool resident(ivec3 cell) { return true; }
ivec3 texelShift(ivec3 cell) { return ivec3(0); }
vec3 filterCoordinate(vec3 voxel, ivec3 cell, ivec3 textureTexels) { return (voxel + 0.5) / vec3(textureTexels); }
#endif
