// How much light from all around reaches a surface point: that of the cells around it (occlusion.frag.glsl) which show
// the same piece of surface. Needs surface.glsl.
uniform sampler2D uOpen;
uniform float uOcclusion;
uniform vec2 uCellsPerRay;

float opennessAt(Point p) {
  vec2 at = inPicture(fragment()) * uCellsPerRay - 0.5;
  ivec2 low = ivec2(floor(at)), last = textureSize(uOpen, 0) - 1;
  vec2 part = at - vec2(low);
  float tolerance = 4.0 * p.footprint / max(uCellsPerRay.x, 1e-6);
  vec2 sum = vec2(0.0);
  float nearest = 3e38, alone = 1.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 cell = texelFetch(uOpen, clamp(low + corner, ivec2(0), last), 0).rg;
    float away = cell.y < 0.0 ? 3e37 : abs(cell.y - p.depth);
    if (away < nearest) {  // that alone, where none shows the same
      nearest = away;
      alone = cell.x;
    }
    vec2 weights = mix(1.0 - part, part, vec2(corner));
    if (away <= tolerance) sum += weights.x * weights.y * vec2(cell.x, 1.0);
  }
  return mix(1.0, sum.y > 1e-4 ? sum.x / sum.y : alone, uOcclusion);
}
