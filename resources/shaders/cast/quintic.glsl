// Derivatives of the field at a scale: the tri-quintic uniform B-spline of uField, whose coefficients go on beyond the
// border by point reflection (volume/field/scaled_field.h, quintic_weights.h). None is missing. Needs spline.glsl.

uniform int uSix;  // 6: a loop that drivers do not unroll

// Weights of coefficients floor(x) - 2 .. floor(x) + 3 and their first and second derivatives.
struct QuinticWeights {
  float w[6], d[6], dd[6];
};

// Of the first three at fraction a. The last three, from behind, are those at 1 - a; their slopes have the other sign.
void quinticHalf(float a, out vec3 w, out vec3 d, out vec3 dd) {
  float b = 1.0 - a, a2 = a * a, b2 = b * b;
  w = vec3(b2 * b2 * b, 26.0 + a * (-50.0 + a * (20.0 + a * (20.0 + a * (-20.0 + 5.0 * a)))),
           66.0 + a2 * (-60.0 + a2 * (30.0 - 10.0 * a))) / 120.0;
  d = vec3(-b2 * b2, -10.0 + a * (8.0 + a * (12.0 + a * (-16.0 + 5.0 * a))), 2.0 * a * (-12.0 + a2 * (12.0 - 5.0 * a))) / 24.0;
  dd = vec3(b2 * b, 2.0 + a * (6.0 + a * (-12.0 + 5.0 * a)), -6.0 + a2 * (18.0 - 10.0 * a)) / 6.0;
}

// What a tap beyond the border weighs is added to those within, c(-k) = 2 c(0) - c(k).
void foldTap(inout QuinticWeights q, int tap, int first, int voxels) {
  float w = q.w[tap], d = q.d[tap], dd = q.dd[tap], factor = 1.0;
  q.w[tap] = q.d[tap] = q.dd[tap] = 0.0;
  for (int k = first + tap;;) {
    bool within = k >= 0 && k < voxels;
    int at = (within ? k : k < 0 ? 0 : voxels - 1) - first;
    float part = within ? factor : 2.0 * factor;
    q.w[at] += part * w;
    q.d[at] += part * d;
    q.dd[at] += part * dd;
    if (within) return;
    factor = -factor;
    k = 2 * (at + first) - k;
  }
}

QuinticWeights quinticWeights(int cell, float t, int voxels) {
  vec3 w[2], d[2], dd[2];
  quinticHalf(t, w[0], d[0], dd[0]);
  quinticHalf(1.0 - t, w[1], d[1], dd[1]);
  QuinticWeights q = QuinticWeights(float[6](w[0].x, w[0].y, w[0].z, w[1].z, w[1].y, w[1].x),
                                    float[6](d[0].x, d[0].y, d[0].z, -d[1].z, -d[1].y, -d[1].x),
                                    float[6](dd[0].x, dd[0].y, dd[0].z, dd[1].z, dd[1].y, dd[1].x));
  int first = cell - 2;
  if (first < 0 || first + 5 >= voxels)
    for (int tap = 0; tap < 6; ++tap)
      if (first + tap < 0 || first + tap >= voxels) foldTap(q, tap, first, voxels);
  return q;
}

// Gradient and Hessian as splineDerivatives() gives them, from 216 fetches.
void quinticDerivatives(vec3 p, out vec3 gradient, out vec3 hessianDiagonal, out vec3 hessianMixed) {
  ivec3 cell = cellOf(p), shift = texelShift(cell), first = cell - 2, top = uDims - 1;
  vec3 t = p - vec3(cell);
  QuinticWeights X = quinticWeights(cell.x, t.x, uDims.x), Y = quinticWeights(cell.y, t.y, uDims.y),
                 Z = quinticWeights(cell.z, t.z, uDims.z);
  vec3 xw[2] = vec3[2](vec3(X.w[0], X.w[1], X.w[2]), vec3(X.w[3], X.w[4], X.w[5]));
  vec3 xd[2] = vec3[2](vec3(X.d[0], X.d[1], X.d[2]), vec3(X.d[3], X.d[4], X.d[5]));
  vec3 xdd[2] = vec3[2](vec3(X.dd[0], X.dd[1], X.dd[2]), vec3(X.dd[3], X.dd[4], X.dd[5]));
  ivec3 x[2] = ivec3[2](clamp(first.x + ivec3(0, 1, 2), 0, top.x) + shift.x, clamp(first.x + ivec3(3, 4, 5), 0, top.x) + shift.x);
  gradient = hessianDiagonal = hessianMixed = vec3(0.0);
  // A derivative's weights sum to 0: of values like 1e6 + small only the small part may be weighted.
  float reference = texelFetch(uField, cell + shift, 0).r;
  for (int k = 0; k < uSix; ++k) {
    int z = clamp(first.z + k, 0, top.z) + shift.z;
    vec3 plane = vec3(0.0);   // value, d/dx, d/dy of this plane
    vec3 second = vec3(0.0);  // d2/dx2, d2/dy2, d2/dxdy
    for (int j = 0; j < uSix; ++j) {
      int y = clamp(first.y + j, 0, top.y) + shift.y;
      float value = 0.0, slope = 0.0, bend = 0.0;
      for (int half_ = 0; half_ < 2; ++half_) {
        vec3 row = vec3(texelFetch(uField, ivec3(x[half_].x, y, z), 0).r, texelFetch(uField, ivec3(x[half_].y, y, z), 0).r,
                        texelFetch(uField, ivec3(x[half_].z, y, z), 0).r) - reference;
        value += dot(row, xw[half_]);
        slope += dot(row, xd[half_]);
        bend += dot(row, xdd[half_]);
      }
      plane += vec3(value * Y.w[j], slope * Y.w[j], value * Y.d[j]);
      second += vec3(bend * Y.w[j], value * Y.dd[j], slope * Y.d[j]);
    }
    gradient += vec3(plane.yz * Z.w[k], plane.x * Z.d[k]);
#ifdef HESSIAN
    hessianDiagonal += vec3(second.xy * Z.w[k], plane.x * Z.dd[k]);
    hessianMixed += vec3(second.z * Z.w[k], plane.yz * Z.d[k]);
#endif
  }
}
