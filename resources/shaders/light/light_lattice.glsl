// Stored light: texels of the light lattice around a point, interpolated. Only baked texels have weight.
//
// render/light/light_texel.h says what is in a texel's words, render/light/light_atlas.h where texels are. SKY, LAMPS: how each is
// packed (PACKED_*); WORDS: of a texel; CODE_WORDS, CODE_COUNT, CODE_FIELDS: of transfer; ISOVALUE: texels hold theirs.
// PARTS_OF_OPEN_SKY: the sky's irradiance is in parts of what an open sky gives each normal (gi/harmonics/open_sky.h).
// INTERPOLATION: scene::GiInterpolation. Wyman et al. 2006 sec. 4.2 and fig. 6.
#define PACKED_NONE 0
#define PACKED_R11G11B10 1
#define PACKED_HALF 2
#define PACKED_SINGLE 3
#define PACKED_CODES 4
#define CLOSEST_ISOVALUE 0
#define NEAREST 1
#define TRILINEAR 2
#define TRICUBIC 3
#define WEIGHTED 4

uniform usamplerBuffer uLightPages;   // of each block, x fastest: its slot plus 1, 0 where nothing is stored
uniform int uInnerPages;              // where those of the inner side begin; -1: there are none
uniform usamplerBuffer uLightTexels;  // words: 512 texels a slot, x fastest
#if WORDS % 2 == 0
uint lightWord(int at) { return texelFetch(uLightTexels, at >> 1)[at & 1]; }
uvec2 firstWords(int at) { return texelFetch(uLightTexels, at >> 1).rg; }
#else
uint lightWord(int at) { return texelFetch(uLightTexels, at).r; }
uvec2 firstWords(int at) { return uvec2(lightWord(at), lightWord(at + 1)); }
#endif
uniform ivec3 uLatticeDims, uLatticeBlocks;
uniform vec3 uTexelsPerVoxel;  // 0 on an axis of one texel
uniform vec3 uSkyScale;        // E = this times what is stored; transfer has its own scale
uniform float uLampsUnit;      // the same of lamps
uniform vec3 uPerMeanSky;      // 1 / mean of localSky() over all normals
const float leastOpenSky = 0.2;
#if SKY == PACKED_CODES
layout(std430, binding = 3) readonly buffer TransferFactors {
  vec4 transferFactors[];  // E = offset + sum of codes times the second of these and all that follow
};
uniform vec3 uTransferOffset;
float codeSums[CODE_COUNT + 1];
#endif

// Sums over texels: light times weight, weight, and how much of the lookup is known.
vec3 skySum = vec3(0.0), lampsSum = vec3(0.0);
vec2 weights = vec2(0.0), covered = vec2(0.0);  // sky, lamps

int firstPage = 0;  // of the side that is looked up

// Where a texel's words begin; -1 where its block is not there.
int lightTexelAt(ivec3 texel) {
  ivec3 block = texel >> 3, inner = texel & 7;
  int index = firstPage + (block.z * uLatticeBlocks.y + block.y) * uLatticeBlocks.x + block.x;
  uint page = texelFetch(uLightPages, index).r;
  return page == 0u ? -1 : (((int(page) - 1) * 8 + inner.z) * 64 + inner.y * 8 + inner.x) * WORDS;
}

vec3 unpackR11g11b10(uint word) {
  vec2 redGreen = unpackHalf2x16((word & 0x7FFu) << 4 | (word & 0x3FF800u) << 9);
  return vec3(redGreen, unpackHalf2x16(word >> 22 << 5).x);
}

// `first` is the word at `at`.
vec3 unpackLight(int packing, int at, uint first) {
  if (packing == PACKED_R11G11B10) return unpackR11g11b10(first);
  if (packing == PACKED_SINGLE) return vec3(uintBitsToFloat(first));
  return vec3(unpackHalf2x16(first), unpackHalf2x16(lightWord(at + 1)).x);
}

const int skyWords = SKY == PACKED_NONE ? 0 : SKY == PACKED_HALF ? 2 : SKY == PACKED_CODES ? CODE_WORDS : 1;
const int lampsWords = LAMPS == PACKED_NONE ? 0 : LAMPS == PACKED_HALF ? 2 : 1;

// How far it is baked: sky, lamps. 0 where there is no texel.
uvec2 texelHead(int at) { return at < 0 ? uvec2(0u) : firstWords(at); }  // state, and the first word of its light
vec2 bakedParts(uint state) { return vec2(uvec2(state >> 24, state >> 28) & 15u) / 15.0; }
bool isLit(uint state) { return (state & 0xFFFFFFu) != 0u; }
vec3 texelNormal(uint state) { return unpackSnorm4x8(state).xyz; }  // not quite unit

// One texel with `weight`, of which `place` is what the lookup's place gives it.
void gather(int at, uvec2 head, float weight, float place) {
  uint state = head.x;
  vec2 baked = bakedParts(state), w = isLit(state) ? weight * baked : vec2(0.0);
  covered += place * baked;
  weights += w;
  int words = max(at, 0) + 1;
#if SKY == PACKED_CODES
  uint codes[CODE_WORDS];
  for (int i = 0; i < CODE_WORDS; ++i) codes[i] = lightWord(words + i);
#define FIELD(component, word, shift, mask) codeSums[component] += w.x * float(codes[word] >> shift & mask);
  CODE_FIELDS
#undef FIELD
#elif SKY != PACKED_NONE
  skySum += w.x * unpackLight(SKY, words, head.y);
#endif
#if LAMPS != PACKED_NONE
#if SKY == PACKED_NONE
  lampsSum += w.y * unpackLight(LAMPS, words, head.y);
#else
  lampsSum += w.y * unpackLight(LAMPS, words + skyWords, lightWord(words + skyWords));
#endif
#endif
}

float texelIsovalue(int at) { return uintBitsToFloat(lightWord(max(at, 0) + 1 + skyWords + lampsWords)); }

// Stored light at a point (voxel coordinates) on the isosurface of `isovalue` (stored units), with its normal on the
// side of firstPage;
// w: how much of the lookup is baked, 0 where nothing is.
void lookUp(vec3 voxel, vec3 normal, float isovalue) {
  vec3 texel = clamp(voxel * uTexelsPerVoxel, vec3(0.0), vec3(uLatticeDims - 1));
#if SKY == PACKED_CODES
  for (int i = 0; i < CODE_COUNT; ++i) codeSums[i] = 0.0;
#endif
#if INTERPOLATION == NEAREST
  int at = lightTexelAt(ivec3(texel + 0.5));
  gather(at, texelHead(at), 1.0, 1.0);
#elif INTERPOLATION == TRICUBIC
  ivec3 base = ivec3(floor(texel));
  vec3 f = texel - vec3(base), g = 1.0 - f;
  vec3 w[4] = vec3[4](g * g * g / 6.0, (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0,
                      (4.0 - 6.0 * g * g + 3.0 * g * g * g) / 6.0, f * f * f / 6.0);
  for (int i = 0; i < 64; ++i) {
    ivec3 step = ivec3(i & 3, i >> 2 & 3, i >> 4);
    float weight = w[step.x].x * w[step.y].y * w[step.z].z;
    int at = lightTexelAt(clamp(base + step - 1, ivec3(0), uLatticeDims - 1));
    gather(at, texelHead(at), weight, weight);
  }
#else
  ivec3 base = min(ivec3(texel), max(uLatticeDims - 2, ivec3(0)));
  vec3 f = texel - vec3(base);
#if INTERPOLATION == CLOSEST_ISOVALUE
  int closest = -1;
  float least = 1e30;
  for (int i = 0; i < 8; ++i) {
    ivec3 step = ivec3(i & 1, i >> 1 & 1, i >> 2);
    int at = lightTexelAt(min(base + step, uLatticeDims - 1));
    if (!isLit(texelHead(at).x)) continue;
    float off = abs(texelIsovalue(at) - isovalue);
    if (off >= least) continue;
    least = off;
    closest = at;
  }
  gather(closest, texelHead(closest), 1.0, 1.0);
#else
  for (int i = 0; i < 8; ++i) {
    ivec3 step = ivec3(i & 1, i >> 1 & 1, i >> 2);
    vec3 part = mix(1.0 - f, f, vec3(step));
    float place = part.x * part.y * part.z, weight = place;
    int at = lightTexelAt(min(base + step, uLatticeDims - 1));
    uvec2 head = texelHead(at);
#if INTERPOLATION == WEIGHTED
    float agreement = max(dot(texelNormal(head.x), normal), 0.0);
    agreement *= agreement;
    weight *= agreement * agreement + 1e-4;
#endif
    gather(at, head, weight, place);
  }
#endif
#endif
  covered = clamp(covered, 0.0, 1.0) * vec2(greaterThan(weights, vec2(0.0)));
  vec2 scale = 1.0 / max(weights, vec2(1e-30));
#if SKY == PACKED_CODES
  skySum = uTransferOffset;
  for (int i = 0; i < CODE_COUNT; ++i) skySum += scale.x * codeSums[i] * transferFactors[i + 1].rgb;
  skySum = max(skySum, vec3(0.0));  // a few bands of spherical harmonics ring
#else
  skySum *= scale.x * uSkyScale;
#ifdef PARTS_OF_OPEN_SKY
  skySum *= max(uPerMeanSky * localSky(normal), leastOpenSky);
#endif
#endif
  lampsSum *= scale.y * uLampsUnit;
}
