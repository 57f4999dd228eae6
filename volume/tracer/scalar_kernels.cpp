// The isosurface tracer one ray at a time, without SIMD: the fallback, and what SIMD is compared with.
#include <algorithm>
#include <cstring>
#include <limits>

#include "volume/field/cubic_weights.h"
#include "volume/tracer/kernels.h"

namespace isolux::volume::tracing {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Of values on one side of 0 never one on the other, however far apart they are.
float mixed(float a, float b, float t) {
  return (1.0f - t) * a + t * b;
}

// The field (inside: positive) along a stretch through a cell, s in [0, 1].
struct Cubic {
  float b0, b1, b2, b3;

  float operator()(float s) const {
    const float u = 1.0f - s;
    return u * (u * (u * b0 + s * (3.0f * b1)) + s * s * (3.0f * b2)) + s * s * s * b3;
  }
};

// Which stretch of s holds the first entry: from `low`, outside, to `high`, inside.
struct Bracket {
  float low, high, atLow, atHigh;
};

// The bracket of the first entry from a stretch's beginning, or from where it has left the inside that it
// begins in; `last` is a bracket's lower end even where there is none.
bool findBracket(const Cubic& f, Bracket& bracket) {
  const float c0 = f.b1 - f.b0, c1 = f.b2 - f.b1, c2 = f.b3 - f.b2;
  const float a = (c0 - c1) + (c2 - c1), h = c1 - c0;
  const float discriminant = h * h - a * c0;
  bool hasMinimum = false, hasMaximum = false;
  float sMinimum = 0, sMaximum = 0, atMinimum = 0, atMaximum = 0;
  if (discriminant >= 0.0f) {
    const float root = std::sqrt(discriminant);
    const float q = h > 0.0f ? -(h + root) : root - h;
    const float first = q / a, second = c0 / q;
    sMaximum = h > 0.0f ? first : second;
    sMinimum = h > 0.0f ? second : first;
    if (sMinimum > 0.0f && sMinimum < 1.0f) {
      atMinimum = f(sMinimum);
      hasMinimum = atMinimum < 0.0f;
    }
    if (sMaximum > 0.0f && sMaximum < 1.0f) {
      atMaximum = f(sMaximum);
      hasMaximum = atMaximum > 0.0f;
    }
  }
  const bool minimumFirst = sMinimum < sMaximum;
  const bool toMaximum = hasMaximum && (f.b0 < 0.0f || (hasMinimum && minimumFirst));
  const bool fromMinimum = hasMinimum && (!toMaximum || minimumFirst);
  bracket.high = toMaximum ? sMaximum : 1.0f;
  bracket.atHigh = toMaximum ? atMaximum : f.b3;
  bracket.low = fromMinimum ? sMinimum : 0.0f;
  bracket.atLow = fromMinimum ? atMinimum : f.b0;
  return bracket.atLow < 0.0f && bracket.atHigh > 0.0f;
}

float rootIn(const Cubic& f, Bracket b) {
  float s = b.low;
  for (int step = 0; step < 8; ++step) {  // regula falsi, Illinois
    s = b.low - b.atLow * (b.high - b.low) / (b.atHigh - b.atLow);
    const float value = f(s);
    if ((value > 0.0f) == (b.atHigh > 0.0f)) {
      b.atLow *= 0.5f;
    } else {
      b.low = b.high;
      b.atLow = b.atHigh;
    }
    b.high = s;
    b.atHigh = value;
    if (value == 0.0f) break;
  }
  return s;
}

template <class T>
class Tracer {
 public:
  Tracer(const View& view, const T* voxels) : view_(view), voxels_(voxels) {}

  // t of the first entry, scaled as the ray, or +inf; with `any` some number that is not.
  template <bool any>
  float trace(const PreparedRay& ray) const;

 private:
  float value(std::size_t index, float isovalue) const {
    return view_.scale * (static_cast<float>(voxels_[index]) - isovalue);
  }
  // s of the first entry in the cell, or -1.
  template <bool any>
  float entryInCell(const PreparedRay& ray, const int cell[3], float tIn, float tOut, bool& outside) const;

  const View& view_;
  const T* voxels_;
};

template <class T>
template <bool any>
float Tracer<T>::entryInCell(const PreparedRay& ray, const int cell[3], float tIn, float tOut,
                             bool& outside) const {
  const Extent3 extent{view_.dims};
  const std::size_t row = extent.row(), slice = extent.slice(), at = extent.index(cell[0], cell[1], cell[2]);
  const float c000 = value(at, ray.isovalue), c100 = value(at + 1, ray.isovalue);
  const float c010 = value(at + row, ray.isovalue), c110 = value(at + row + 1, ray.isovalue);
  const float c001 = value(at + slice, ray.isovalue), c101 = value(at + slice + 1, ray.isovalue);
  const float c011 = value(at + slice + row, ray.isovalue), c111 = value(at + slice + row + 1, ray.isovalue);
  if constexpr (std::is_same_v<T, float>) {
    const float sum = ((c000 + c100) + (c010 + c110)) + ((c001 + c101) + (c011 + c111));
    if (std::isnan(sum)) {
      outside = false;
      return -1.0f;
    }
  }
  float p[3], q[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float from = ray.origin[axis] - static_cast<float>(cell[axis]);
    p[axis] = std::clamp(from + tIn * ray.direction[axis], 0.0f, 1.0f);
    q[axis] = std::clamp(from + tOut * ray.direction[axis], 0.0f, 1.0f);
  }
  const glm::ivec3 place(cell[0], cell[1], cell[2]);
  if (view_.shown && view_.shown->hides(place))
    return static_cast<float>(entryIntoShown(view_, place, {p[0], p[1], p[2]}, {q[0], q[1], q[2]}, outside));
  // Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends.
  const float p00 = mixed(c000, c100, p[0]), p10 = mixed(c010, c110, p[0]);
  const float p01 = mixed(c001, c101, p[0]), p11 = mixed(c011, c111, p[0]);
  const float q00 = mixed(c000, c100, q[0]), q10 = mixed(c010, c110, q[0]);
  const float q01 = mixed(c001, c101, q[0]), q11 = mixed(c011, c111, q[0]);
  const float pp0 = mixed(p00, p10, p[1]), pp1 = mixed(p01, p11, p[1]);
  const float pq0 = mixed(p00, p10, q[1]), pq1 = mixed(p01, p11, q[1]);
  const float qp0 = mixed(q00, q10, p[1]), qp1 = mixed(q01, q11, p[1]);
  const float qq0 = mixed(q00, q10, q[1]), qq1 = mixed(q01, q11, q[1]);
  const auto mean = [](float a, float b, float c) { return a / 3.0f + b / 3.0f + c / 3.0f; };
  const Cubic f{
      mixed(pp0, pp1, p[2]), mean(mixed(qp0, qp1, p[2]), mixed(pq0, pq1, p[2]), mixed(pp0, pp1, q[2])),
      mean(mixed(qq0, qq1, p[2]), mixed(qp0, qp1, q[2]), mixed(pq0, pq1, q[2])), mixed(qq0, qq1, q[2])};

  const bool falls = f.b1 < 0.0f || (f.b1 == 0.0f && (f.b2 < 0.0f || (f.b2 == 0.0f && f.b3 < 0.0f)));
  const bool beginsInside = f.b0 > 0.0f || (f.b0 == 0.0f && !falls);
  if (outside && beginsInside) return 0.0f;
  if (beginsInside) {
    if (f.b1 >= 0.0f && f.b2 >= 0.0f && f.b3 >= 0.0f) return -1.0f;  // stays inside
  } else {
    if (f.b1 <= 0.0f && f.b2 <= 0.0f && f.b3 <= 0.0f) {  // stays outside
      outside = true;
      return -1.0f;
    }
    if (any && f.b0 < 0.0f && f.b3 > 0.0f) return 0.0f;
  }
  Bracket bracket;
  if (findBracket(f, bracket)) return any ? 0.0f : rootIn(f, bracket);
  outside = f.b3 < 0.0f || (f.b3 == 0.0f && bracket.atLow < 0.0f);
  return -1.0f;
}

template <class T>
template <bool any>
float Tracer<T>::trace(const PreparedRay& ray) const {
  int cell[3] = {ray.cell[0], ray.cell[1], ray.cell[2]};
  float t = 0.0f;
  bool outside = false;
  std::size_t lastBlock = ~std::size_t{0};
  bool blockActive = false;
  std::uint8_t word[4] = {};
  for (;;) {
    const std::size_t block = Extent3{view_.blockDims}.index(cell[0] >> 2, cell[1] >> 2, cell[2] >> 2);
    if (block != lastBlock) {
      std::memcpy(word, view_.table + 4 * block, 4);
      blockActive = word[0] <= ray.bin && ray.bin <= word[1];
      lastBlock = block;
    }
    int least = word[0], size = 4;
    bool active = false;
    if (blockActive) {
      const int local = (cell[2] & 3) * 16 + (cell[1] & 3) * 4 + (cell[0] & 3);
      const std::uint8_t* pair =
          view_.table + view_.cellBytes + 128 * block + 2 * static_cast<std::size_t>(local);
      least = pair[0];
      active = least <= ray.bin && ray.bin <= pair[1];
      size = 1;
    } else if (!(word[2] <= ray.bin && ray.bin <= word[3])) {
      size = 16;
    }
    // To the nearest plane through which the ray leaves the box of cells.
    float exit[3];
    int plane[3];
    for (int axis = 0; axis < 3; ++axis) {
      plane[axis] = (cell[axis] & -size) + (ray.direction[axis] > 0.0f ? size : 0);
      exit[axis] = (static_cast<float>(plane[axis]) - ray.origin[axis]) * ray.inverse[axis];
    }
    const float tOut = std::min(exit[0], std::min(exit[1], exit[2]));
    if (active) {
      const float s = entryInCell<any>(ray, cell, t, std::min(tOut, ray.tEnd), outside);
      if (s >= 0.0f) return t + s * (std::min(tOut, ray.tEnd) - t);
    } else {
      const bool inside = (ray.bin < least) == (view_.scale > 0.0f);
      if (outside && inside) return t;
      outside = !inside;
    }
    if (!(tOut < ray.tEnd)) return kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
      const int low = cell[axis] & -size;
      if (exit[axis] <= tOut) {
        cell[axis] = ray.direction[axis] > 0.0f ? plane[axis] : plane[axis] - 1;
        if (cell[axis] < 0 || cell[axis] > view_.dims[axis] - 2) return kInfinity;
      } else {
        const int below = static_cast<int>(ray.origin[axis] + tOut * ray.direction[axis]);
        cell[axis] = std::clamp(below, low, std::min(low + size - 1, view_.dims[axis] - 2));
      }
    }
    t = std::max(t, tOut);
  }
}

template <class T, class Write>
void traceAll(const View& view, const T* voxels, const TraceRay* rays, std::size_t count,
              const Write& write) {
  const Tracer<T> tracer(view, voxels);
  for (std::size_t i = 0; i < count; ++i) {
    PreparedRay ray;
    if (prepare(view, rays[i], ray))
      write(i, &tracer, ray);
    else
      write(i, static_cast<const Tracer<T>*>(nullptr), ray);
  }
}

template <class Write>
void withVoxels(const View& view, const TraceRay* rays, std::size_t count, const Write& write) {
  if (view.signed16)
    traceAll(view, view.signed16, rays, count, write);
  else if (view.unsigned16)
    traceAll(view, view.unsigned16, rays, count, write);
  else
    traceAll(view, view.float32, rays, count, write);
}

void firstEntries(const View& view, const TraceRay* rays, std::size_t count, float* t) {
  withVoxels(view, rays, count, [&](std::size_t i, const auto* tracer, const PreparedRay& ray) {
    const float found = tracer ? tracer->template trace<false>(ray) : kInfinity;
    t[i] = found < kInfinity ? ray.callerT(found) : kInfinity;
  });
}

void anyEntries(const View& view, const TraceRay* rays, std::size_t count, std::uint8_t* hit) {
  withVoxels(view, rays, count, [&](std::size_t i, const auto* tracer, const PreparedRay& ray) {
    hit[i] = tracer && tracer->template trace<true>(ray) < kInfinity ? 1 : 0;
  });
}

template <class T>
glm::vec3 trilinearGradient(const T* voxels, const std::size_t offset[3][4], const float t[3]) {
  float c[8];
  for (std::size_t i = 0; i < 8; ++i)
    c[i] = static_cast<float>(
        voxels[offset[0][1 + (i & 1)] + offset[1][1 + (i >> 1 & 1)] + offset[2][1 + (i >> 2)]]);
  const auto face = [&](float a, float b, float e, float f, float u, float v) {
    return mixed(mixed(a, b, u), mixed(e, f, u), v);
  };
  const glm::vec3 g(face(c[1] - c[0], c[3] - c[2], c[5] - c[4], c[7] - c[6], t[1], t[2]),
                    face(c[2] - c[0], c[3] - c[1], c[6] - c[4], c[7] - c[5], t[0], t[2]),
                    face(c[4] - c[0], c[5] - c[1], c[6] - c[2], c[7] - c[3], t[0], t[1]));
  return std::isnan(g.x + g.y + g.z) ? glm::vec3(0.0f) : g;
}

template <class T>
glm::vec3 gradientAt(const View& view, const T* voxels, glm::vec3 position) {
  std::size_t offset[3][4];
  float t[3];
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = view.dims[axis];
    // In this order NaN becomes 0.
    const float x = std::min(std::max(0.0f, position[axis]), static_cast<float>(n - 1));
    const int cell = std::min(static_cast<int>(x), std::max(n - 2, 0));
    t[axis] = x - static_cast<float>(cell);
    for (int k = 0; k < 4; ++k)
      offset[axis][k] = stride * static_cast<std::size_t>(std::clamp(cell - 1 + k, 0, n - 1));
    stride *= static_cast<std::size_t>(n);
  }
  const CubicWeights wx = cubicWeights(t[0]), wy = cubicWeights(t[1]), wz = cubicWeights(t[2]);
  // Of values like 1e6 + small only the small part may be weighted.
  const auto reference = static_cast<float>(voxels[offset[2][1] + offset[1][1] + offset[0][1]]);
  float gx = 0, gy = 0, gz = 0;
  for (int k = 0; k < 4; ++k) {
    float f = 0, fx = 0, fy = 0;
    for (int j = 0; j < 4; ++j) {
      const T* row = voxels + offset[2][k] + offset[1][j];
      const auto less = [&](int i) { return static_cast<float>(row[offset[0][i]]) - reference; };
      const float a = less(0), b = less(1), c = less(2), e = less(3);
      const float v = (wx.w[0] * a + wx.w[1] * b) + (wx.w[2] * c + wx.w[3] * e);
      f += wy.w[j] * v;
      fy += wy.d1[j] * v;
      fx += wy.w[j] * ((wx.d1[0] * a + wx.d1[1] * b) + (wx.d1[2] * c + wx.d1[3] * e));
    }
    gx += wz.w[k] * fx;
    gy += wz.w[k] * fy;
    gz += wz.d1[k] * f;
  }
  if (std::is_same_v<T, float> && std::isnan(gx + gy + gz)) return trilinearGradient(voxels, offset, t);
  return {gx, gy, gz};
}

void gradients(const View& view, const glm::vec3* voxels, std::size_t count, glm::vec3* result) {
  for (std::size_t i = 0; i < count; ++i)
    result[i] = view.signed16     ? gradientAt(view, view.signed16, voxels[i])
                : view.unsigned16 ? gradientAt(view, view.unsigned16, voxels[i])
                                  : gradientAt(view, view.float32, voxels[i]);
}

}  // namespace

const Kernels& scalarKernels() {
  static constexpr Kernels kernels{{TracerTarget::scalar, "scalar", 0}, firstEntries, anyEntries, gradients};
  return kernels;
}

}  // namespace isolux::volume::tracing
