// Which pieces of the isosurfaces' inside are hidden. In cells whose inside corners are all hidden nothing is seen; in
// those that have both kinds, what lies inside belongs to the piece of the corner that one comes to by going, per axis
// in turn, to the end of the cell where the field lies deeper inside (volume/hit/shown_cells.h does the same).
// Part of trace.glsl.

uniform usampler3D uHidden;  // of each 4x4x2 voxels a bit for each that is hidden, x + 4 y + 16 z; a channel a surface
uniform bool uHidesStrays;   // a spline's surface without an inside voxel around is hidden
uniform bool uInsideHigh;    // inside are texels from the isovalue up

// The stretch of the ray through the cell that is looked at, in the cell's [0, 1]^3.
struct HiddenCell {
  vec4 low, high;  // the corners' texels
  vec3 from, to;
  ivec4 corners;   // of each surface: a bit for each corner that is hidden, x + 2 y + 4 z
} hiddenHere;

uint hiddenBit(ivec3 voxel, int k) {
  uint word = texelFetch(uHidden, voxel >> ivec3(2, 2, 1), 0)[k];
  return word >> ((voxel.x & 3) + 4 * (voxel.y & 3) + 16 * (voxel.z & 1)) & 1u;
}

void lookUpHidden(ivec3 cell, vec4 low, vec4 high, vec3 from, vec3 to) {
  hiddenHere = HiddenCell(low, high, from, to, ivec4(0));
  for (int i = 0; i < 8; ++i) {
    ivec3 corner = min(cell + ivec3(i & 1, i >> 1 & 1, i >> 2), uDims - 1);
    for (int k = 0; k < SURFACES; ++k) hiddenHere.corners[k] |= int(hiddenBit(corner, k)) << i;
  }
}

bool anyHidden(int k) { return hiddenHere.corners[k] != 0; }

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
bool shownSide(float f, int k, float s) {
  bool side = f >= 0.0;
  if (side != uInsideHigh || !anyHidden(k)) return side;
  int corner = ascend(hiddenHere.low, hiddenHere.high, mix(hiddenHere.from, hiddenHere.to, s));
  return (hiddenHere.corners[k] >> corner & 1) != 0 ? !side : side;
}
