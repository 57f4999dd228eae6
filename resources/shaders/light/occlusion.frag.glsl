// How much light from all around reaches the surface point of a cell: the mean over the planes of openness.frag.glsl,
// which the cells of a square of 4 x 4 share, of those that show the same piece of surface; and its depth, mm.
#include "common.glsl"

uniform sampler2D uOpenness;
uniform vec2 uDepthRange;
uniform int uCell;
layout(location = 0) out vec2 oOpen;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 own = texelFetch(uOpenness, cell, 0);
  oOpen = vec2(1.0, -1.0);
  if (own.y <= 0.0) return;
  float range = max(uDepthRange.y - uDepthRange.x, 1e-30), depth = own.z + own.w;
  float mm = depth * range + uDepthRange.x;
  float tolerance = 8.0 * footprintAt(mm) * float(uCell) / range;
  vec2 sum = vec2(0.0);
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      vec4 other = texelFetch(uOpenness, clamp(cell + ivec2(x, y), ivec2(0), textureSize(uOpenness, 0) - 1), 0);
      if (abs(other.z + other.w - depth) <= tolerance) sum += other.xy;
    }
  oOpen = vec2(min(sum.x / sum.y, 1.0), mm);
}
