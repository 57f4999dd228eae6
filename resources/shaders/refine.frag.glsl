// The surface point of each pixel: its bracket narrowed on the exact trilinear field.
//
// EXACT brackets hold one root of a monotone cubic: Illinois steps until the field is as small as float allows.
// Sampled brackets get the paper's regula falsi, Hadwiger et al. 2005 eq. (1), uRefinements times.
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

  float a = bracket.x, b = bracket.y;
  float fa = trilinearMinusIsovalue(origin + a * direction), fb = trilinearMinusIsovalue(origin + b * direction);
  float t = abs(fa) <= abs(fb) ? a : b, ft = abs(fa) <= abs(fb) ? fa : fb;
  float fBest = ft, tBest = t;
#ifdef EXACT
  const int steps = 12;
#else
  int steps = uRefinements;
#endif
  if ((fa >= 0.0) != (fb >= 0.0) && !isMissing(fa) && !isMissing(fb)) {
    int side = 0;
    for (int i = 0; i < steps; ++i) {
      t = clamp(b - fb * (b - a) / (fb - fa), a, b);
      ft = trilinearMinusIsovalue(origin + t * direction);
#ifdef EXACT
      if (abs(ft) < abs(fBest)) {
        fBest = ft;
        tBest = t;
      }
      if (ft == 0.0 || b - a <= 1e-7 * b) break;
#else
      fBest = ft;
      tBest = t;
#endif
      if ((ft >= 0.0) == (fb >= 0.0)) {
        b = t;
        fb = ft;
#ifdef EXACT
        if (side == 1) fa *= 0.5;
        side = 1;
#endif
      } else {
        a = t;
        fa = ft;
#ifdef EXACT
        if (side == -1) fb *= 0.5;
        side = -1;
#endif
      }
    }
  }
  oSurface = vec4(origin + tBest * direction, max(tBest, 0.0));
  oError = isMissing(fBest) ? 0.0 : abs(fBest);
}
