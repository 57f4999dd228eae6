// World gradient (data units per mm) and, with HESSIAN, world Hessian (per mm^2) at the surface point:
// g_w = A^-T g_v, H_w = A^-T H_v A^-1.
//
// SCALED: of the field at a scale, known everywhere. CUBIC: tri-cubic B-spline of uField, by single fetches or (FAST) filtered ones. Otherwise the trilinear field's own,
// whose Hessian has mixed terms only. Where a sample of the B-spline is missing: the trilinear gradient, no Hessian.
#include "common.glsl"
#include "field.glsl"
#include "of_group.glsl"
#include "spline.glsl"
#ifdef SCALED
#include "quintic.glsl"
#endif

uniform sampler2D uSurface;
uniform mat3 uInverseTransposed;  // A^-T
uniform float uDataUnits;         // data units per texel of uVolume
layout(location = 0) out vec4 oGradient;  // w = 1 where there is a surface
#ifdef HESSIAN
layout(location = 1) out vec4 oHessianDiagonal;  // xx, yy, zz; w = 1 where the Hessian is known
layout(location = 2) out vec4 oHessianMixed;     // xy, xz, yz; w = 1 where all samples are the volume's own
#endif

void main() {
  if (isOfOther(ivec2(gl_FragCoord.xy))) discard;
  vec4 surface = texelFetch(uSurface, ivec2(gl_FragCoord.xy), 0);
  oGradient = vec4(0.0);
#ifdef HESSIAN
  oHessianDiagonal = oHessianMixed = vec4(0.0);
#endif
  if (surface.w < 0.0) return;
  vec3 p = clamp(surface.xyz, vec3(0.0), vec3(uDims - 1));
  if (!resident(cellOf(p))) discard;  // written while its brick was
  vec3 gradient, diagonal = vec3(0.0), mixed = vec3(0.0);
  bool known = true;
#ifdef SCALED
  quinticDerivatives(p, gradient, diagonal, mixed);
  gradient *= uFieldPerVolume;
  diagonal *= uFieldPerVolume;
  mixed *= uFieldPerVolume;
#elif defined(CUBIC)
#ifdef FAST
  known = splineDerivativesFast(p, gradient, diagonal, mixed);
#else
  known = splineDerivatives(p, gradient, diagonal, mixed);
#endif
  gradient = known ? gradient * uFieldPerVolume : trilinearGradient(p);
  diagonal *= uFieldPerVolume;
  mixed *= uFieldPerVolume;
#else
  gradient = trilinearGradient(p);
#ifdef HESSIAN
  known = trilinearMixed(p, mixed);
#endif
#endif
  oGradient = vec4(uInverseTransposed * gradient * uDataUnits, 1.0);
#ifdef HESSIAN
  if (!known) return;
  mat3 hessian = mat3(vec3(diagonal.x, mixed.x, mixed.y), vec3(mixed.x, diagonal.y, mixed.z), vec3(mixed.yz, diagonal.z));
  hessian = uInverseTransposed * hessian * transpose(uInverseTransposed) * uDataUnits;
  oHessianDiagonal = vec4(hessian[0][0], hessian[1][1], hessian[2][2], 1.0);
  float within = 1.0;  // the coefficients of a scaled field go on beyond the border
#ifdef CUBIC
  ivec3 first = cellOf(p) - 1;  // of the spline's 4x4x4 samples: those beyond the border only repeat it
  if (any(lessThan(first, ivec3(0))) || any(greaterThan(first + 3, uDims - 1))) within = 0.0;
#endif
  oHessianMixed = vec4(hessian[0][1], hessian[0][2], hessian[1][2], within);
#endif
}
