// World gradient at the surface point, in data units per mm: g_w = A^-T g_v.
//
// CUBIC: tri-cubic B-spline of uField (the samples, or interpolating coefficients), 64 exact fetches; samples beyond
// the border repeat the border sample. Otherwise, and where a sample is missing: the trilinear field's gradient.
#include "common.glsl"
#include "field.glsl"

uniform sampler2D uSurface;
uniform sampler3D uField;
uniform mat3 uWorldGradient;      // A^-T times data units per texel of uVolume
uniform float uFieldPerVolume;    // texels of uVolume per texel of uField
layout(location = 0) out vec4 oGradient;

vec3 trilinearGradient(vec3 p) {
  ivec3 cell = cellOf(p);
  vec3 f = clamp(p - vec3(cell), 0.0, 1.0);
  vec4 low, high;
  cellCorners(cell, low, high);
  if (anyMissing(low, high)) return vec3(0.0);
  vec4 c = mix(low, high, f.z);
  return vec3(mix(c.y - c.x, c.w - c.z, f.y), mix(c.z - c.x, c.w - c.y, f.x), bilinear(high - low, f.x, f.y));
}

#ifdef CUBIC
// Uniform cubic B-spline weights and first derivatives at fraction t, Hadwiger et al. 2005 eq. (6).
void cubicWeights(float t, out vec4 w, out vec4 d) {
  float s = 1.0 - t;
  w = vec4(s * s * s, 4.0 + t * t * (3.0 * t - 6.0), 4.0 + s * s * (3.0 * s - 6.0), t * t * t) / 6.0;
  d = vec4(-0.5 * s * s, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), 0.5 * t * t);
}

bool cubicGradient(vec3 p, out vec3 gradient) {
  vec3 base = floor(p);
  vec3 f = p - base;
  vec4 wx, wy, wz, dx, dy, dz;
  cubicWeights(f.x, wx, dx);
  cubicWeights(f.y, wy, dy);
  cubicWeights(f.z, wz, dz);
  ivec3 first = ivec3(base) - 1, top = uDims - 1;
  int x0 = clamp(first.x, 0, top.x), x1 = clamp(first.x + 1, 0, top.x);
  int x2 = clamp(first.x + 2, 0, top.x), x3 = clamp(first.x + 3, 0, top.x);
  gradient = vec3(0.0);
  float most = 0.0;
  for (int k = 0; k < 4; ++k) {
    int z = clamp(first.z + k, 0, top.z);
    vec3 plane = vec3(0.0);  // (d/dx, d/dy, value) of this plane
    for (int j = 0; j < 4; ++j) {
      int y = clamp(first.y + j, 0, top.y);
      vec4 row = vec4(texelFetch(uField, ivec3(x0, y, z), 0).r, texelFetch(uField, ivec3(x1, y, z), 0).r,
                      texelFetch(uField, ivec3(x2, y, z), 0).r, texelFetch(uField, ivec3(x3, y, z), 0).r);
      most = max(most, max(max(row.x, row.y), max(row.z, row.w)));
      float value = dot(row, wx);
      plane += vec3(dot(row, dx) * wy[j], value * dy[j], value * wy[j]);
    }
    gradient += vec3(plane.xy * wz[k], plane.z * dz[k]);
  }
  return !isMissing(most);
}
#endif

void main() {
  vec4 surface = texelFetch(uSurface, ivec2(gl_FragCoord.xy), 0);
  oGradient = vec4(0.0);
  if (surface.w < 0.0) return;
  vec3 p = clamp(surface.xyz, vec3(0.0), vec3(uDims - 1));
  vec3 gradient;
#ifdef CUBIC
  if (cubicGradient(p, gradient)) gradient *= uFieldPerVolume;
  else gradient = trilinearGradient(p);
#else
  gradient = trilinearGradient(p);
#endif
  oGradient = vec4(uWorldGradient * gradient, 1.0);
}
