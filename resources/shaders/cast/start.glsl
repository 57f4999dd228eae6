// Between which t the ray of a pixel can meet anything: of its tile, by projecting the blocks that can hold a surface
// (render/volume/ray_starts.h). Hadwiger et al. 2005 sec. 3.1 rasterises the blocks' faces. Needs common.glsl.
uniform sampler2D uStartDepths;  // of each tile, mm along the view direction: first and last; first > last: none
uniform int uTileShift;          // log2 of a tile's pixels

// slack: mm, for the rounding of the depths. t > tEnd where the ray can meet nothing.
void rayStart(vec2 fragment, float slack, out float t, out float tEnd) {
  vec2 depths = texelFetch(uStartDepths, ivec2(fragment) >> uTileShift, 0).rg, xy = imagePlane(fragment);
  float slant = uOrthographic != 0 ? 1.0 : sqrt(1.0 + dot(xy, xy));
  t = max(depths.x * slant - slack, 0.0);
  tEnd = depths.y * slant + slack;
}
