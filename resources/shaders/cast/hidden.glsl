// Which pieces of the isosurfaces' inside are hidden. In cells whose inside corners are all hidden nothing is seen; in
// those that have both kinds, what lies inside belongs to the piece of the corner that one comes to by going, per axis
// in turn, to the end of the cell where the field lies deeper inside (volume/hit/shown_cells.h does the same).
// Part of trace.glsl.

uniform usampler3D uHidden;  // of each 4x4x2 voxels a bit for each that is hidden, x + 4 y + 16 z; a channel a surface
uniform bool uHidesStrays;   // a spline's surface without an inside voxel around is hidden
uniform bool uInsideHigh;    // inside are texels from the isovalue up

// A stretch of a ray through a cell in which something is hidden, in the cell's [0, 1]^3.
struct HiddenCell {
  vec4 low, high;  // the corners' texels
  vec3 from, to;
  ivec4 corners;   // of each surface: a bit for each corner that is hidden, x + 2 y + 4 z
};

uint hiddenBit(ivec3 voxel, int k) {
  uint word = texelFetch(uHidden, voxel >> ivec3(2, 2, 1), 0)[k];
  return word >> ((voxel.x & 3) + 4 * (voxel.y & 3) + 16 * (voxel.z & 1)) & 1u;
}

HiddenCell hiddenCell(ivec3 cell, vec4 low, vec4 high, vec3 from, vec3 to) {
  HiddenCell hidden = HiddenCell(low, high, from, to, ivec4(0));
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = min(cell + ivec3(i & 1, i >> 1 & 1, i >> 2), uDims - 1);
    for (int k = 0; k < SURFACES; ++k) hidden.corners[k] |= int(hiddenBit(corner, k)) << i;
  }
  return hidden;
}

int ascend(vec4 low, vec4 high, vec3 p) {
  float deeper = uInsideHigh ? 1.0 : -1.0;
  vec4 at = mix(low, high, p.z);
  vec2 alongX = mix(at.xy, at.zw, p.y);
  int x = int(deeper * (alongX.y - alongX.x) > 0.0);
  vec2 alongY = x == 1 ? at.yw : at.xz;
  int y = int(deeper * (alongY.y - alongY.x) > 0.0);
  int corner = x + 2 * y;
  return corner + 4 * int(deeper * (high[corner] - low[corner]) > 0.0);
}

// The side (f >= 0) that is seen of surface k where the field less its isovalue is f, at s of the stretch.
bool shownSide(float f, int k, float s, HiddenCell hidden) {
  bool side = f >= 0.0;
  if (side != uInsideHigh || hidden.corners[k] == 0) return side;
  int corner = ascend(hidden.low, hidden.high, mix(hidden.from, hidden.to, s));
  return (hidden.corners[k] >> corner & 1) != 0 ? !side : side;
}

int shownSides(float valueMinusFirst, HiddenCell hidden) {
  int bits = 0;
  for (int k = 0; k < SURFACES; ++k) bits |= int(shownSide(valueMinusFirst - uIsovalueShifts[k], k, 0.0, hidden)) << k;
  return bits;
}

// firstChange() of what is seen. Every stretch on one side holds an end or an extremum.
bool firstShownChange(vec4 b, int k, bool inside, HiddenCell hidden, out vec2 bracket) {
  if (hidden.corners[k] == 0) return firstChange(b, inside, bracket);
  bracket = vec2(0.0);
  vec2 extrema = extremaOf(b);
  float stops[4] = float[4](0.0, extrema.x, extrema.y, 1.0);
  float before = 0.0;
  for (int i = 0; i < 4; ++i) {
    float at = stops[i];
    float f = i == 0 ? b.x : i == 3 ? b.w : cubic(b, at);
    if (shownSide(f, k, at, hidden) != inside) {
      bracket = vec2(before, at);
      return true;
    }
    before = at;
  }
  return false;
}
