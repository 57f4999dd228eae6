// The nearest maximum of |grad f| along the normal of the surface point: volume/edge/edge_walk.h has the definitions, and
// the same walk. SCALED: of the field at a scale; else of the tri-cubic B-spline of uField, by single fetches. GAPS: some
// voxels are missing.
#define HESSIAN
#include "common.glsl"
#include "field.glsl"
#include "of_group.glsl"
#include "spline.glsl"
#ifdef SCALED
#include "quintic.glsl"
#endif

uniform sampler2D uSurface;
uniform vec3 uLow, uHigh;     // where the field is the volume's own, voxels
uniform mat3 uVoxelFromWorld;
uniform mat3 uSmoothing;      // covariance of the field's smoothing, mm^2
uniform mat3 uNoise;          // covariance of the world gradient's noise, 1/mm^2
uniform float uUnit;          // texels times this have noise of about 1
uniform float uOutward;       // times the gradient
uniform float uSearch;        // mm, each way
uniform float uContrast;      // standard deviations of the noise of |g|
uniform float uLeastStep;     // mm
layout(location = 0) out vec2 oEdge;  // offset along the outward normal, mm; |g| over its noise at the hit

const float noEdge = 1e30, leastPeak = 1e-4, mostMoved = 0.5;
const int mostSteps = 400, mostHalvings = 40;

// The gradient at a place of the line.
struct Slope {
  float s;       // mm
  float size;    // |g|, world
  float along;   // its part along the line, positive as at the hit
  float change;  // d ln|g| / ds, 1/mm
  float moved;   // by what smoothing has moved an edge there inward, mm
  bool known;
};

vec3 origin = vec3(0.0), normal = vec3(0.0), direction = vec3(0.0);  // voxels; outward, world; voxels per mm along it
bool haveNormal = false;

Slope nothingAt(float s) { return Slope(s, 0.0, 0.0, 0.0, 0.0, false); }

float lengthOf(vec3 v) {
  float most = max(max(abs(v.x), abs(v.y)), abs(v.z));
  return most > 0.0 ? most * length(v / most) : 0.0;
}

// By half the trace of the smoothing's covariance times the shape operator.
float movedInward(vec3 u, float size, mat3 hessian) {
  mat3 across = mat3(1.0) - outerProduct(u, u);
  mat3 bent = across * (uOutward / size * transpose(uVoxelFromWorld) * hessian * uVoxelFromWorld) * across;
  float trace = dot(bent[0], uSmoothing[0]) + dot(bent[1], uSmoothing[1]) + dot(bent[2], uSmoothing[2]);
  float most = mostMoved * sqrt((uSmoothing[0][0] + uSmoothing[1][1] + uSmoothing[2][2]) / 3.0);
  return clamp(0.5 * trace, -most, most);
}

// At the hit (s = 0, the first call) and along its normal.
Slope slopeAt(float s) {
  vec3 p = haveNormal ? origin + s * direction : clamp(origin, vec3(0.0), vec3(uDims - 1));
  if (haveNormal && (any(lessThan(p, uLow)) || any(greaterThan(p, uHigh)))) return nothingAt(s);
  if (!resident(cellOf(p))) return nothingAt(s);
#ifdef GAPS
  if (cellMissing(cellOf(p))) return nothingAt(s);
#endif
  vec3 g, d, m;
#ifdef SCALED
  quinticDerivatives(p, g, d, m);
#else
  if (!splineDerivatives(p, g, d, m)) return nothingAt(s);
#endif
  float unit = uUnit * uFieldPerVolume;
  mat3 hessian = unit * mat3(d.x, m.x, m.y, m.x, d.y, m.z, m.y, m.z, d.z);
  g = transpose(uVoxelFromWorld) * (g * unit);
  float size = lengthOf(g);
  if (!(size > 0.0)) return Slope(s, 0.0, 0.0, 0.0, 0.0, haveNormal);
  vec3 u = g / size;
  if (!haveNormal) {
    normal = uOutward * u;
    direction = uVoxelFromWorld * normal;
    haveNormal = true;
  }
  vec3 bend = hessian * (uVoxelFromWorld * u) / size;
  return Slope(s, size, uOutward * dot(g, normal), dot(direction, bend), movedInward(u, size, hessian), true);
}

// Root of `change` between a place where |g| rises and one where it falls: regula falsi (Illinois).
Slope peakBetween(Slope rising, Slope falling) {
  float close = 2e-5 * abs(falling.s - rising.s), toward = falling.s > rising.s ? 1.0 : -1.0;
  float weightRising = rising.change, weightFalling = falling.change;
  Slope best = falling;
  if (rising.size > falling.size) best = rising;
  int kept = 0;
  for (int i = 0; i < mostHalvings; ++i) {
    float part = weightRising / (weightRising - weightFalling);
    Slope at = slopeAt(rising.s + part * (falling.s - rising.s));
    if (!at.known) break;
    float moved = abs(at.s - best.s), up = toward * at.change;
    best = at;
    if (up == 0.0 || moved < close) break;
    if (up > 0.0) {
      rising = at;
      weightRising = at.change;
      if (kept == 1) weightFalling *= 0.5;
      kept = 1;
    } else {
      falling = at;
      weightFalling = at.change;
      if (kept == -1) weightRising *= 0.5;
      kept = -1;
    }
  }
  return best;
}

void main() {
  if (isOfOther(ivec2(gl_FragCoord.xy))) discard;
  oEdge = vec2(noEdge, 0.0);
  vec4 surface = texelFetch(uSurface, ivec2(gl_FragCoord.xy), 0);
  if (surface.w < 0.0) return;
  origin = surface.xyz;
  Slope before[2];
  float noise = 0.0, step_ = 0.0, nearest = noEdge;
  // Step 0 is the hit itself; then one step to each side in turn.
  for (int i = 0; i <= mostSteps && nearest == noEdge; ++i) {
    for (int side = 0; side < 2; ++side) {
      if (i == 0) {
        before[0] = before[1] = slopeAt(0.0);
        if (!before[0].known) break;
        noise = sqrt(max(dot(normal, uNoise * normal), 0.0));
        float voxel = 1.0 / max(max(abs(direction.x), abs(direction.y)), abs(direction.z));  // mm
        step_ = max(max(0.5 * voxel, uLeastStep), uSearch / float(mostSteps));
        oEdge.y = before[0].size / noise;
        break;
      }
      Slope from = before[side];
      if (!from.known || abs(from.s) >= uSearch) {
        before[side].known = false;
        continue;
      }
      float toward = side == 0 ? 1.0 : -1.0;
      Slope to = slopeAt(toward * min(float(i) * step_, uSearch));
      bool rises = toward * from.change > 0.0 || (i == 1 && side == 0 && from.change == 0.0);
      before[side] = to;
      if (to.along < -uContrast * noise) before[side].known = false;
      // A step may end at the peak itself.
      bool falls = toward * to.change < 0.0 || (to.change == 0.0 && from.change != 0.0);
      if (!to.known || !rises || !falls) continue;
      Slope peak = peakBetween(from, to);
      bool clear = peak.size >= uContrast * noise && peak.along > 0.0 &&
                   min(from.size, to.size) <= (1.0 - leastPeak) * peak.size;
      if (clear && abs(peak.s) < abs(nearest)) {
        nearest = peak.s;
        oEdge.x = peak.s + peak.moved;
      }
    }
    if (!before[0].known && !before[1].known) break;
  }
}
