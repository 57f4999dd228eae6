// The surface point of each pixel, from its bracket.
//
// An exact bracket is the root already (t0 = t1). A sampled one gets the paper's regula falsi on the exact
// trilinear field, Hadwiger et al. 2005 eq. (1), uRefinements times.
// Outputs: voxel position and t (mm; -1: no surface), and |f - isovalue| in texels.
#include "common.glsl"
#include "field.glsl"

uniform sampler2D uBrackets;
uniform int uRefinements;
layout(location = 0) out vec4 oSurface;
layout(location = 1) out float oError;

void main() {
  vec2 bracket = texelFetch(uBrackets, ivec2(gl_FragCoord.xy), 0).rg;
  oSurface = vec4(0.0, 0.0, 0.0, -1.0);
  oError = 0.0;
  if (bracket.x > bracket.y) return;
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);

  float a = bracket.x, b = bracket.y, t = a;
  float fa = trilinearMinusIsovalue(origin + a * direction), f = fa;
  if (b > a) {
    float fb = trilinearMinusIsovalue(origin + b * direction);
    if (abs(fb) < abs(fa)) {
      t = b;
      f = fb;
    }
    // One side at both ends: the hardware's filter saw a crossing that is not there by a rounding; the nearer end it is.
    bool crosses = (fa >= 0.0) != (fb >= 0.0) && !isMissing(fa) && !isMissing(fb);
    for (int i = 0; crosses && i < uRefinements; ++i) {
      t = clamp(b - fb * (b - a) / (fb - fa), a, b);
      f = trilinearMinusIsovalue(origin + t * direction);
      if ((f >= 0.0) == (fb >= 0.0)) {
        b = t;
        fb = f;
      } else {
        a = t;
        fa = f;
      }
    }
  }
  oSurface = vec4(origin + t * direction, max(t, 0.0));
  oError = isMissing(f) ? 0.0 : abs(f);
}
