// One triangle over the whole picture. TILES: instead, squares of tiles as points (render/volume/ray_starts.h).
#ifdef TILES
layout(location = 0) in ivec3 aSquare;  // tiles: lower left, side
uniform int uTileShift;                 // log2 of a tile's pixels
uniform ivec2 uTiles;                   // in the picture

void main() {
  vec2 middle = vec2(aSquare.xy) + 0.5 * float(aSquare.z);
  gl_PointSize = float(aSquare.z << uTileShift);
  gl_Position = vec4(middle / vec2(uTiles) * 2.0 - 1.0, 0.0, 1.0);
}
#else
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
#endif
