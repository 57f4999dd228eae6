// The first crossing of a ray with the isosurfaces of the tri-cubic B-spline of uField, with a bound that makes a miss
// impossible. Needs trace.glsl and spline.glsl.
//
// Along its stretch through a cell the field is a polynomial of degree 9. Its Bernstein coefficients follow from the
// 64 samples by convex combinations only: blossoms of the B-spline at the stretch's ends along each axis give the
// Bezier points of the box between them; their means over i + j + k = m are the coefficients (polar form). The
// polynomial lies in their hull, so coefficients on one side mean no crossing (volume/hit/exact_cubic_hit.h does the same).

// Weights of four samples for the blossom F(u, v, w) of the uniform cubic B-spline on the interval [0, 1].
vec4 splineBlossom(float u, float v, float w) {
  float a = (1.0 - w) * (1.0 - v) * 0.5, b = (1.0 - w) * (1.0 + v) * 0.5 + w * (2.0 - v) * 0.5, c = w * v * 0.5;
  return vec4(a * (1.0 - u), a * (u + 2.0) + b * (2.0 - u), b * (u + 1.0) + c * (3.0 - u), c * u) / 3.0;
}

// Columns: the blossoms at (a,a,a), (a,a,b), (a,b,b), (b,b,b).
mat4 blossoms(float a, float b) {
  return mat4(splineBlossom(a, a, a), splineBlossom(a, a, b), splineBlossom(a, b, b), splineBlossom(b, b, b));
}

// The 4 x 4 x 4 samples about a cell, minus the first isovalue: rows along x, row 4 k + j at (j, k). False where one of
// them is missing, or one of the cell's voxels: interpolating coefficients are known in gaps too.
bool cellSamples(ivec3 cell, out vec4 rows[16], out float least, out float most) {
  ivec3 first = cell - 1, top = uDims - 1, shift = texelShift(cell);
  least = never;
  most = -never;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      vec4 row = splineRow(first.x, clamp(first.y + j, 0, top.y), clamp(first.z + k, 0, top.z), shift) - uIsovalues.x;
      rows[4 * k + j] = row;
      most = max(most, largest(row));
      least = min(least, -largest(-row));
    }
  return !isMissing(most) && !(uGaps && cellMissing(cell));
}

void bernstein9(vec4 rows[16], vec3 from, vec3 to, out float b[10]) {
  mat4 X = blossoms(from.x, to.x), Y = blossoms(from.y, to.y), Z = blossoms(from.z, to.z);
  const float binomial[4] = float[4](1.0, 3.0, 3.0, 1.0);
  const float total[10] = float[10](1.0, 9.0, 36.0, 84.0, 126.0, 126.0, 84.0, 36.0, 9.0, 1.0);
  for (int m = 0; m < 10; ++m) b[m] = 0.0;
  vec4 planes[16];  // rows along x, blossomed along x and y: 4 k + jj
  for (int k = 0; k < 4; ++k) {
    vec4 r0 = rows[4 * k] * X, r1 = rows[4 * k + 1] * X, r2 = rows[4 * k + 2] * X, r3 = rows[4 * k + 3] * X;
    for (int j = 0; j < 4; ++j) planes[4 * k + j] = r0 * Y[j].x + r1 * Y[j].y + r2 * Y[j].z + r3 * Y[j].w;
  }
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      vec4 line = planes[j] * Z[k].x + planes[4 + j] * Z[k].y + planes[8 + j] * Z[k].z + planes[12 + j] * Z[k].w;
      for (int i = 0; i < 4; ++i) b[i + j + k] += binomial[i] * binomial[j] * binomial[k] * line[i];
    }
  for (int m = 0; m < 10; ++m) b[m] /= total[m];
}

// The polynomial on [s, 1], or on [0, s], as one on [0, 1]: de Casteljau.
void keepRight(inout float c[10], float s) {
  for (int r = 1; r < 10; ++r)
    for (int i = 0; i < 10 - r; ++i) c[i] = mix(c[i], c[i + 1], s);
}
// Written by way of the mirrored polynomial: Mesa 22.3 miscompiles de Casteljau with a descending inner loop.
void keepLeft(inout float c[10], float s) {
  float mirrored[10];
  for (int i = 0; i < 10; ++i) mirrored[i] = c[9 - i];
  keepRight(mirrored, 1.0 - s);
  for (int i = 0; i < 10; ++i) c[i] = mirrored[9 - i];
}

float valueAt(float c[10], float s) {
  keepRight(c, s);
  return c[0];
}

// The only root of a polynomial whose coefficients change sign once: regula falsi, Illinois variant; from the seventh
// step on with bisections between, because it creeps where the polynomial is nearly 0 at an end of the stretch, too.
float onlyRoot(float c[10], float zero) {
  float s0 = 0.0, s1 = 1.0, f0 = c[0], f1 = c[9], s = 0.0;
  int side = 0;
  for (int i = 0; i < 46; ++i) {
    s = i > 5 && i % 2 == 1 ? 0.5 * (s0 + s1) : clamp(s1 - f1 * (s1 - s0) / (f1 - f0), s0, s1);
    float f = valueAt(c, s);
    if (s1 - s0 < 1e-6) break;
    if (f >= zero) {
      s0 = s;
      f0 = f;
      if (side == -1) f1 *= 0.5;
      side = -1;
    } else {
      s1 = s;
      f1 = f;
      if (side == 1) f0 *= 0.5;
      side = 1;
    }
  }
  return s;
}

// The first s at which the polynomial leaves the side `inside`. Coefficients that change sign once have one root, those
// that do not have none (variation diminishing); otherwise the interval is halved, front half first. `certain` becomes
// false where a touch was not decided even in the smallest interval; the search goes on behind it.
bool firstRoot9(float b[10], bool inside, bool first, out float s, inout bool certain) {
  const int finest = 12;
  float zero = inside ? 0.0 : 1e-30;  // f = 0 is inside: below this the side is left
  int level = 0, index = 0;           // the interval [index, index + 1] * width
  float width = 1.0;                  // 2^-level
  s = 0.0;
  for (int step = 0; step < 128; ++step) {
    float at = float(index) * width;
    float c[10];  // positive on the ray's side
    for (int i = 0; i < 10; ++i) c[i] = inside ? b[i] : -b[i];
    if (first) c[0] = max(c[0], zero);
    keepRight(c, at);
    keepLeft(c, width / (1.0 - at));
    if (c[0] < zero) {
      s = at;
      return true;
    }
    int signs = 0;
    for (int i = 0; i < 10; ++i) signs |= int(c[i] < zero) << i;
    int changes = bitCount((signs ^ signs >> 1) & 511);
    if (changes == 1) {
      s = at + width * onlyRoot(c, zero);
      return true;
    }
    if (changes > 1 && level < finest) {  // the front half
      ++level;
      index *= 2;
      width *= 0.5;
    } else {  // what follows, as wide as it may be
      if (changes > 1) certain = false;
      ++index;
      while (level > 0 && (index & 1) == 0) {
        --level;
        index >>= 1;
        width *= 2.0;
      }
      if (level == 0) return false;
    }
  }
  certain = false;
  return false;
}

#ifdef HIDDEN
uniform vec4 uSampleIsovalues;  // texels of uVolume

bool sampleInside(float texel, int k) { return (texel >= uSampleIsovalues[k]) == uInsideHigh; }

// Of the spline at p, in the cell's [0, 1]^3, which lies inside: whether the piece is hidden of the sample that the
// ascent in the cell leads to, or where that one lies outside, of the nearest inside one among the 4 x 4 x 4 around. Of samples
// as near as rounding leaves open the first counts (volume/hit/surface_voxel.cpp does the same).
bool splineHidden(ivec3 cell, vec3 p, int k) {
  vec4 low, high;
  cellCorners(cell, low, high);
  int corner = ascend(low, high, p);
  ivec3 at = ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
  if (sampleInside(at.z == 0 ? low[corner] : high[corner - 4], k)) return hiddenBit(min(cell + at, uDims - 1), k) != 0u;
  ivec3 shift = texelShift(cell);
  float least = 1e30;
  bool hidden = uHidesStrays;
  for (int i = 0; i < 64; ++i) {
    ivec3 voxel = clamp(cell + ivec3(i & 3, i >> 2 & 3, i >> 4) - 1, ivec3(0), uDims - 1);
    vec3 apart = vec3(voxel - cell) - p;
    if (dot(apart, apart) >= least - 1e-4 || !sampleInside(texelFetch(uVolume, voxel + shift, 0).r, k)) continue;
    least = dot(apart, apart);
    hidden = hiddenBit(voxel, k) != 0u;
  }
  return hidden;
}

// The first s at which what is seen of surface k changes its side: the polynomial's sides with what is hidden taken as
// outside. Between two of its roots a stretch is of one piece, which its middle tells. seen: the side before, where
// `known`; set to that of the stretch's begin where not.
bool firstShownRoot9(float b[10], int k, bool known, inout bool seen, bool first, ivec3 cell, vec3 from, vec3 to,
                     out float s, inout bool certain) {
  bool side = known && (seen == uInsideHigh || first) ? seen : b[0] >= 0.0;
  float begin = 0.0;
  for (int part = 0; part < 10; ++part) {
    float root;
    bool changes = firstRoot9(b, side, first, root, certain);
    float end = changes ? mix(begin, 1.0, root) : 1.0;
    bool now = side == uInsideHigh && splineHidden(cell, mix(from, to, 0.5 * (begin + end)), k) ? !side : side;
    if (!known) seen = now;
    known = true;
    s = begin;
    if (now != seen) return true;
    if (!changes) return false;
    keepRight(b, root);
    begin = end;
    side = !side;
    first = true;  // the root that it begins at is on either side of it by rounding
  }
  return false;
}
#endif

Crossing traceCubic(vec3 origin, vec3 direction, float t, float tEnd, bool carried, int inside) {
  Crossing crossing = Crossing(false, 0.0, 0, inside);
  Path path = pathOf(origin, direction);
  clipToDomain(path, t, tEnd);
  if (t > tEnd) return crossing;
  Place place = placeAt(origin + t * direction);
  bool known = carried, first = carried;
  bool certain = true;
  int maxSteps = 2 * (uDims.x + uDims.y + uDims.z) + 16;
  for (int i = 0; i < maxSteps; ++i) {
    int shift = emptyShift(place);
    if (shift < 0 && !resident(place.cell)) return crossing;
    bvec3 axis;
    float tOut = max(t, exitOf(path, place.cell, max(shift, 0), axis));
    vec4 rows[16];
    float least, most;
    if (shift >= 0) {
      known = known && !uGaps;
    } else if (!cellSamples(place.cell, rows, least, most)) {
      known = false;
    } else {
      int below = sidesOf(least), above = sidesOf(most);
      if (!known || below != inside || above != inside) {  // not all samples on the ray's sides
        float b[10];
        vec3 from = clamp(origin + t * direction - vec3(place.cell), 0.0, 1.0),
             to = clamp(origin + tOut * direction - vec3(place.cell), 0.0, 1.0);
        bernstein9(rows, from, to, b);
        if (!known) inside = sidesOf(b[0]);
        float nearest = 2.0;
        for (int k = 0; k < SURFACES; ++k) {
          float own[10];
          for (int m = 0; m < 10; ++m) own[m] = b[m] - uIsovalueShifts[k];
          float s;
          bool seen = (inside >> k & 1) != 0;
#ifdef HIDDEN
          bool changes = firstShownRoot9(own, k, known, seen, first, place.cell, from, to, s, certain);
          inside = seen ? inside | 1 << k : inside & ~(1 << k);
#else
          bool changes = firstRoot9(own, seen, first, s, certain);
#endif
          if (!changes || s >= nearest) continue;
          nearest = s;
          crossing.surface = k;
        }
        known = true;
        if (nearest <= 1.0) {
          crossing.found = true;
          crossing.t = mix(t, tOut, nearest);
          crossing.inside = (inside ^ (1 << crossing.surface)) | (certain ? 0 : 16);
          return crossing;
        }
      }
    }
    first = false;
    if (tOut >= tEnd) return crossing;
    t = tOut;
    place.cell = nextCell(path, place.cell, max(shift, 0), tOut, axis);
    if (outsideCells(place.cell)) return crossing;
  }
  return crossing;
}
