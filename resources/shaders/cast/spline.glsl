// The tri-cubic uniform B-spline of uField: the samples, or coefficients whose spline passes through the samples.
// Samples beyond the border repeat the border sample. Needs field.glsl.

uniform sampler3D uField;
uniform float uFieldPerVolume;  // texels of uVolume per texel of uField
uniform int uFour;              // 4: a loop over planes that drivers do not unroll, which costs a third on software GL

// Weights of samples floor(x) - 1 .. floor(x) + 2 at fraction t, Hadwiger et al. 2005 eq. (6), and their first and
// second derivatives.
struct SplineWeights {
  vec4 w, d, dd;
};
SplineWeights splineWeights(float t) {
  float s = 1.0 - t;
  SplineWeights r;
  r.w = vec4(s * s * s, 4.0 + t * t * (3.0 * t - 6.0), 4.0 + s * s * (3.0 * s - 6.0), t * t * t) / 6.0;
  r.d = vec4(-0.5 * s * s, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), 0.5 * t * t);
  r.dd = vec4(s, 3.0 * t - 2.0, 1.0 - 3.0 * t, t);
  return r;
}

// The four samples along x at (y, z); x0 is the first, unclamped. shift: texelShift() of the cell.
vec4 splineRow(int x0, int y, int z, ivec3 shift) {
  ivec4 x = clamp(ivec4(x0, x0 + 1, x0 + 2, x0 + 3), 0, uDims.x - 1) + shift.x;
  y += shift.y;
  z += shift.z;
  return vec4(texelFetch(uField, ivec3(x.x, y, z), 0).r, texelFetch(uField, ivec3(x.y, y, z), 0).r,
              texelFetch(uField, ivec3(x.z, y, z), 0).r, texelFetch(uField, ivec3(x.w, y, z), 0).r);
}

float largest(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// The field minus `isovalue` (texels of uField) at p; huge where a sample is missing.
float splineMinus(vec3 p, float isovalue) {
  ivec3 cell = cellOf(p), shift = texelShift(cell), first = cell - 1, top = uDims - 1;
  vec3 base = vec3(cell);
  vec4 wx = splineWeights(p.x - base.x).w, wy = splineWeights(p.y - base.y).w, wz = splineWeights(p.z - base.z).w;
  float sum = 0.0, most = 0.0;
  for (int k = 0; k < 4; ++k) {
    int z = clamp(first.z + k, 0, top.z);
    float plane = 0.0;
    for (int j = 0; j < 4; ++j) {
      vec4 row = splineRow(first.x, clamp(first.y + j, 0, top.y), z, shift);
      most = max(most, largest(row));
      plane += dot(row - isovalue, wx) * wy[j];
    }
    sum += plane * wz[k];
  }
  return isMissing(most) ? missingTexel : sum;
}

// Value, gradient and Hessian at once from 64 fetches, texels of uField per voxel and per voxel squared; hessian as
// (xx, yy, zz) and (xy, xz, yz). False where a sample is missing.
bool splineDerivatives(vec3 p, out vec3 gradient, out vec3 hessianDiagonal, out vec3 hessianMixed) {
  ivec3 cell = cellOf(p), shift = texelShift(cell), first = cell - 1, top = uDims - 1;
  vec3 base = vec3(cell);
  SplineWeights X = splineWeights(p.x - base.x), Y = splineWeights(p.y - base.y), Z = splineWeights(p.z - base.z);
  gradient = hessianDiagonal = hessianMixed = vec3(0.0);
  float most = 0.0;
  // A derivative's weights sum to 0: of values like 1e6 + small only the small part may be weighted.
  float reference = texelFetch(uField, cell + shift, 0).r;
  for (int k = 0; k < uFour; ++k) {
    int z = clamp(first.z + k, 0, top.z);
    vec3 plane = vec3(0.0);  // value, d/dx, d/dy of this plane
#ifdef HESSIAN
    vec3 second = vec3(0.0);  // d2/dx2, d2/dy2, d2/dxdy
#endif
    for (int j = 0; j < uFour; ++j) {
      vec4 row = splineRow(first.x, clamp(first.y + j, 0, top.y), z, shift);
      most = max(most, largest(row));
      row -= reference;
      float value = dot(row, X.w), slope = dot(row, X.d);
      plane += vec3(value * Y.w[j], slope * Y.w[j], value * Y.d[j]);
#ifdef HESSIAN
      second += vec3(dot(row, X.dd) * Y.w[j], value * Y.dd[j], slope * Y.d[j]);
#endif
    }
    gradient += vec3(plane.yz * Z.w[k], plane.x * Z.d[k]);
#ifdef HESSIAN
    hessianDiagonal += vec3(second.xy * Z.w[k], plane.x * Z.dd[k]);
    hessianMixed += vec3(second.z * Z.w[k], plane.yz * Z.d[k]);
#endif
  }
  return !isMissing(most);
}

// ---- The fast scheme: pairs of samples by one filtered fetch, Hadwiger et al. 2005 eq. (7)-(9), Sigg & Hadwiger 2005.

// An axis as at most three filtered samples: weight and offset from the sample floor(x).
struct Taps {
  vec3 weight, offset;
};
// Value and first derivative: the weights of a pair have one sign, so that each is one filtered sample.
Taps pairTaps(vec4 w) {
  float a = w.x + w.y, b = w.z + w.w;
  return Taps(vec3(a, b, 0.0), vec3(w.y / a - 1.0, w.w / b + 1.0, 0.0));
}
// The second derivative's pairs have not (1-t and 3t-2); but it is the second difference of linear interpolation:
// f'' = L(x-1) - 2 L(x) + L(x+1).
Taps secondTaps(float t) { return Taps(vec3(1.0, -2.0, 1.0), vec3(t - 1.0, t, t + 1.0)); }

float filtered(vec3 base, vec3 offset) {
  return texture(uField, filterCoordinate(base + offset, ivec3(base), textureSize(uField, 0))).r;
}

// `missing` becomes huge where a sample is.
float filteredSum(vec3 base, Taps x, int nx, Taps y, int ny, Taps z, int nz, inout float missing) {
  float sum = 0.0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        float v = filtered(base, vec3(x.offset[i], y.offset[j], z.offset[k]));
        missing = max(missing, v);
        sum += x.weight[i] * y.weight[j] * z.weight[k] * v;
      }
  return sum;
}

float splineFast(vec3 p) {
  vec3 base = vec3(cellOf(p)), t = p - base;
  float missing = 0.0;
  float value = filteredSum(base, pairTaps(splineWeights(t.x).w), 2, pairTaps(splineWeights(t.y).w), 2,
                            pairTaps(splineWeights(t.z).w), 2, missing);
  return isMissing(missing) ? missingTexel : value;
}

bool splineDerivativesFast(vec3 p, out vec3 gradient, out vec3 hessianDiagonal, out vec3 hessianMixed) {
  vec3 base = vec3(cellOf(p)), t = p - base;
  SplineWeights X = splineWeights(t.x), Y = splineWeights(t.y), Z = splineWeights(t.z);
  Taps x0 = pairTaps(X.w), y0 = pairTaps(Y.w), z0 = pairTaps(Z.w);
  Taps x1 = pairTaps(X.d), y1 = pairTaps(Y.d), z1 = pairTaps(Z.d);
  float missing = 0.0;
  gradient = vec3(filteredSum(base, x1, 2, y0, 2, z0, 2, missing), filteredSum(base, x0, 2, y1, 2, z0, 2, missing),
                  filteredSum(base, x0, 2, y0, 2, z1, 2, missing));
  hessianDiagonal = hessianMixed = vec3(0.0);
#ifdef HESSIAN
  Taps x2 = secondTaps(t.x), y2 = secondTaps(t.y), z2 = secondTaps(t.z);
  hessianDiagonal =
      vec3(filteredSum(base, x2, 3, y0, 2, z0, 2, missing), filteredSum(base, x0, 2, y2, 3, z0, 2, missing),
           filteredSum(base, x0, 2, y0, 2, z2, 3, missing));
  hessianMixed = vec3(filteredSum(base, x1, 2, y1, 2, z0, 2, missing), filteredSum(base, x1, 2, y0, 2, z1, 2, missing),
                      filteredSum(base, x0, 2, y1, 2, z1, 2, missing));
#endif
  return !isMissing(missing);
}
