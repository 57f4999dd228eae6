// How each principal curvature changes along its own direction: 0 on ridges and valleys (Ohtake et al. 2004). Directions
// have no sign, so neither have these derivatives one: who compares two of them turns them by the directions.
//
// oExtrema: d kappa1 along its direction, d kappa2 along its own (1/mm^2); `unknown` where the surface ends within reach.
#include "common.glsl"
#include "surface.glsl"
#include "neighbours.glsl"

layout(location = 0) out vec2 oExtrema;
const float unknown = 3e38;

// Positions and curvatures differ by this from one side of the pixel to the other.
struct Difference {
  vec3 position;
  vec2 kappa;
};

bool differenceAlong(ivec2 pixel, ivec2 step_, Point p, out Difference d) {
  float reach = float(max(step_.x, step_.y));
  Point before, behind;
  if (!neighbourAt(pixel - step_, p, reach, before) || !neighbourAt(pixel + step_, p, reach, behind)) return false;
  d.position = behind.position - before.position;
  d.kappa = texelFetch(uKappa, pixel + step_, 0).xy - texelFetch(uKappa, pixel - step_, 0).xy;
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oExtrema = vec2(unknown);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0 || texelFetch(uKappa, pixel, 0).w <= 0.0) return;
  Point p = pointAt(pixel, surface);
  int reach = differenceReach(p, 1.0);
  Difference x, y;
  // Next to an edge in depth half of it must do.
  if (!differenceAlong(pixel, ivec2(reach, 0), p, x) || !differenceAlong(pixel, ivec2(0, reach), p, y)) {
    reach = (reach + 1) / 2;
    if (!differenceAlong(pixel, ivec2(reach, 0), p, x) || !differenceAlong(pixel, ivec2(0, reach), p, y)) return;
  }
  // A direction as parts of the two differences, by least squares.
  float xx = dot(x.position, x.position), xy = dot(x.position, y.position), yy = dot(y.position, y.position);
  float determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-6 * xx * yy)) return;
  vec3 first = texelFetch(uDirection, pixel, 0).xyz, second = cross(p.outward, first);
  mat2 solve = mat2(yy, -xy, -xy, xx);
  vec2 alongFirst = solve * vec2(dot(x.position, first), dot(y.position, first)) / determinant;
  vec2 alongSecond = solve * vec2(dot(x.position, second), dot(y.position, second)) / determinant;
  vec2 extrema = vec2(dot(alongFirst, vec2(x.kappa.x, y.kappa.x)), dot(alongSecond, vec2(x.kappa.y, y.kappa.y)));
  if (all(lessThan(abs(extrema), vec2(1e30)))) oExtrema = extrema;
}
