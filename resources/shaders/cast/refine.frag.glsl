// The surface point of each pixel from the bracket of sampled hits: the paper's regula falsi on the exact field,
// Hadwiger et al. 2005 eq. (1), uRefinements times.
// Outputs: voxel position and t (mm; -1: no surface); |f - isovalue| in texels of what is hit, and the packed
// knowledge of the bracket (cast.frag.glsl).
#include "common.glsl"
#include "hit_info.glsl"
#include "field.glsl"
#ifdef CUBIC
#include "spline.glsl"
#endif

uniform sampler2D uBrackets;
uniform int uRefinements;
uniform vec4 uIsovalues;
layout(location = 0) out vec4 oSurface;
layout(location = 1) out vec2 oInfo;

float fieldMinus(vec3 p, float isovalue) {
#ifdef CUBIC
  return splineMinus(clamp(p, vec3(0.0), vec3(uDims - 1)), isovalue);
#else
  return trilinearMinus(p, isovalue);
#endif
}

void main() {
  vec4 bracket = texelFetch(uBrackets, ivec2(gl_FragCoord.xy), 0);
  oSurface = vec4(0.0, 0.0, 0.0, -1.0);
  oInfo = vec2(0.0, bracket.w == 0.0 ? 0.0 : 128.0);  // waits for a brick
  if (bracket.x > bracket.y) return;
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  float isovalue = uIsovalues[placeOf(int(bracket.z))];

  float a = bracket.x, b = bracket.y, t = a;
  float fa = fieldMinus(origin + a * direction, isovalue), f = fa;
  if (b > a) {
    float fb = fieldMinus(origin + b * direction, isovalue);
    if (abs(fb) < abs(fa)) {
      t = b;
      f = fb;
    }
    // One side at both ends: the hardware's filter saw a crossing that is not there by a rounding; the nearer end it is.
    bool crosses = (fa >= 0.0) != (fb >= 0.0);
    for (int i = 0; crosses && i < uRefinements; ++i) {
      t = clamp(b - fb * (b - a) / (fb - fa), a, b);
      f = fieldMinus(origin + t * direction, isovalue);
      if ((f >= 0.0) == (fb >= 0.0)) {
        b = t;
        fb = f;
      } else {
        a = t;
        fa = f;
      }
    }
  }
  if (brickMissed) discard;  // refined while its bricks were resident
  oInfo = vec2(0.0);
  if (isMissing(f)) return;  // a gap in the bracket after all, by rounding: nothing is known of a crossing
  oSurface = vec4(origin + t * direction, max(t, 0.0));
  oInfo = vec2(abs(f), bracket.z);
}
