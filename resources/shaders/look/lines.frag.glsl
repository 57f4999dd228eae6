// What is drawn of the lines of line_field.frag.glsl, as coverage: x ridges, y valleys, z suggestive contours, w contours.
//
// Each line is followed both ways along its tangent. Lines that are too short, or too weak on the average over what was
// followed, are left out; weak stretches of strong lines stay (hysteresis), and short gaps in them are closed.
#include "common.glsl"
#include "surface.glsl"

uniform float uMostRays;       // followed each way
uniform float uDetail, uGap;   // mm: see neighbours.glsl; a gap that is closed
uniform float uPixel;          // rays
uniform vec4 uDrawn;           // what is drawn, from its lower left to its upper right, rays from the images' corner
#ifdef RIDGES
uniform sampler2D uRidgeField, uValleyField;
uniform vec2 uRidgeLengths;   // of ridges and valleys, mm
uniform float uRidgeRays, uRidgeMm;  // width: the one that is not 0
#endif
#ifdef SUGGESTIVE
uniform sampler2D uSuggestiveField;
#endif
#ifdef CONTOURS
uniform sampler2D uContourField;
#endif
uniform float uContourWidth;  // rays
layout(location = 0) out vec4 oLines;

const float shortest = 0.03;  // of the picture's width: what is shorter and joins no other line reads as a crack

// Of 1 ray's width it is a ray that fades; narrower lines are fainter.
float coverage(float distance_, float width) {
  float half_ = 0.5 * max(width, 1.0);
  return min(width, 1.0) * (1.0 - smoothstep(half_ - 0.5, half_ + 0.5, abs(distance_)));
}

struct Wanted {
  float width;     // rays
  float length;    // mm
  float strength;  // on the average
  float weakest;   // that is still followed
  float gap;       // mm
};

struct Followed {
  float length, gained;  // mm, less what turned; strengths times rays
  float rays;
  vec2 met;  // where the line begins, rays from the corner; x < 0: nowhere
  vec2 along;  // its tangent there, in the sense of the walk
};

vec2 acrossOf(vec4 line) { return vec2(line.y, -line.x); }
// From `at` to what the pixel there says of a line.
float distanceFrom(vec4 line, vec2 at) { return dot(fract(at) - 0.5, acrossOf(line)) + line.z; }

// One way from `at`, of which `along` is the tangent; `onLine`: a line runs there.
Followed follow(sampler2D field, Point p, vec2 at, vec2 along, bool onLine, Wanted wanted) {
  Followed f = Followed(0.0, 0.0, 0.0, onLine ? at : vec2(-1.0), along);
  vec2 size = vec2(textureSize(field, 0));
  // At least what a few voxels are.
  float rays = clamp(max(1.2 * wanted.length, 6.0 * uDetail) / p.footprint, 8.0, max(uMostRays, 8.0));
  float step_ = max(max(0.125 * uDetail / p.footprint, 1.0), rays / 64.0), gap = 0.0, steady = 1.0;
  float widest = wanted.gap / p.footprint, detail = uDetail / p.footprint;
  vec2 corner = at, before = along;
  vec3 position = p.position;
  for (float walked = step_; walked <= rays; walked += step_) {
    at += step_ * along;
    if (any(lessThan(at, uDrawn.xy)) || any(greaterThanEqual(at, uDrawn.zw))) {  // it may go on beyond the picture
      if (f.met.x >= 0.0) f.length += steady * (rays - walked) * p.footprint;
      return f;
    }
    bool within = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, size));
    vec4 line = within ? texelFetch(field, ivec2(at), 0) : vec4(0.0);
    float turn = dot(line.xy, along);
    bool here = line.w >= wanted.weakest && abs(line.z) < max(step_ + 1.0, 0.5 * detail) && abs(turn) > 0.7;
    if (here) {
      vec4 surface = texelFetch(uSurface, ivec2(at), 0);
      vec3 next = uWorldFromVoxel * surface.xyz;
      float moved = distance(next, position);
      if (moved > 8.0 * (step_ + gap) * p.footprint) return f;  // an edge in depth
      at -= distanceFrom(line, at) * acrossOf(line);
      along = turn > 0.0 ? line.xy : -line.xy;
      if (f.met.x < 0.0) {
        f.met = corner = at;
        f.along = before = along;
      }
      position = next;
      vec2 chord = at - corner;
      if (length(chord) >= detail) {  // curves lose little; what noise makes turns soon
        chord = normalize(chord);
        steady *= max(dot(chord, before), 0.0) * dot(chord, before);
        before = chord;
        corner = at;
      }
      f.length += steady * moved;
      f.gained += (step_ + gap) * line.w;
      f.rays += step_ + gap;
      gap = 0.0;
    } else {
      gap += step_;
      if (gap > widest) return f;
    }
  }
  return f;
}

// The line next to `here`, z its distance from there, found by looking to both sides as far as half a line's width: on a
// sharp ridge curvature stops falling soon, and what a pixel knows of the line by itself ends there.
vec4 nearestLine(sampler2D field, vec2 here, vec4 own, float width) {
  vec4 nearest = own.w > 0.0 ? own : vec4(own.xy, 1000.0, 0.0);
  vec2 size = vec2(textureSize(field, 0));
  float reach = 0.5 * width + 1.5, step_ = max(1.0, reach / 16.0);
  for (float i = -reach; i <= reach; i += step_) {
    vec2 at = here + i * acrossOf(own);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, size))) continue;
    vec4 line = texelFetch(field, ivec2(at), 0);
    if (line.w <= 0.0 || abs(line.z) > 0.75 * step_ || abs(dot(line.xy, own.xy)) < 0.6) continue;
    float distance_ = dot(here - floor(at) - 0.5, acrossOf(line)) + line.z;
    if (abs(distance_) < abs(nearest.z) || abs(nearest.z) > abs(i)) nearest = vec4(line.xy, distance_, line.w);
  }
  return nearest;
}

float distanceToSegment(vec2 at, vec2 from, vec2 to) {
  vec2 all_ = to - from;
  return distance(at, from + clamp(dot(at - from, all_) / max(dot(all_, all_), 1e-12), 0.0, 1.0) * all_);
}

// Of the straight line that closes a gap: both ends must point at each other.
float gapCoverage(vec2 here, Followed there, Followed back, float width) {
  vec2 across = safeNormalize(vec3(there.met - back.met, 0.0), vec3(0.0)).xy;
  if (min(dot(across, there.along), -dot(across, back.along)) < 0.9) return 0.0;
  return coverage(distanceToSegment(here, there.met, back.met), width);
}

float drawn(sampler2D field, ivec2 pixel, Point p, Wanted wanted) {
  vec4 line = texelFetch(field, pixel, 0);
  if (line.xy == vec2(0.0)) return 0.0;
  vec2 here = vec2(pixel) + 0.5, at = here;
  bool beside = line.w >= wanted.weakest && abs(line.z) < wanted.width + 4.0;
  line = nearestLine(field, here, line, wanted.width);
  float covered = coverage(line.z, wanted.width);
  bool onLine = line.w >= wanted.weakest && covered > 0.0;
  if (!onLine && (beside || wanted.gap <= 0.0)) return 0.0;
  if (onLine) at -= line.z * acrossOf(line);
  Followed there = follow(field, p, at, line.xy, onLine, wanted);
  if (there.met.x < 0.0) return 0.0;
  Followed back = follow(field, p, at, -line.xy, onLine, wanted);
  if (back.met.x < 0.0) return 0.0;
  if (!onLine) covered = gapCoverage(here, there, back, wanted.width);
  if (covered <= 0.0) return 0.0;
  float rays = there.rays + back.rays, strength = (there.gained + back.gained) / max(rays, 1e-6);
  float long_ = smoothstep(0.7, 1.1, (there.length + back.length) / max(wanted.length, 1e-30));
  return covered * long_ * smoothstep(0.8 * wanted.strength, 1.2 * wanted.strength, strength);
}

#ifdef CONTOURS
// Outlines keep their distance from the edge: it and the strength are averaged along the line.
float outline(sampler2D field, ivec2 pixel, Point p) {
  vec4 own = texelFetch(field, pixel, 0);
  if (own.xy == vec2(0.0) || abs(own.z) > 4.0 * uContourWidth + 8.0) return 0.0;
  float distance_ = own.z * own.w, strength = own.w, weights = 1.0;
  const int steps = 6;
  vec2 size = vec2(textureSize(field, 0));
  for (int way = -1; way <= 1; way += 2) {
    vec2 at = vec2(pixel) + 0.5, along = float(way) * own.xy;
    float depth = texelFetch(uSurface, pixel, 0).w;
    for (int i = 1; i <= steps; ++i) {
      at += uPixel * along;
      if (any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, size))) break;
      vec4 line = texelFetch(field, ivec2(at), 0);
      float next = texelFetch(uSurface, ivec2(at), 0).w, turn = dot(line.xy, along);
      if (next < 0.0 || abs(next - depth) > 12.0 * uPixel * p.footprint || abs(turn) < 0.6) break;
      along = turn > 0.0 ? line.xy : -line.xy;
      depth = next;
      float weight = 1.0 - float(i) / float(steps + 1);
      distance_ += weight * line.w * clamp(line.z, -uContourWidth, 4.0 * uContourWidth + 8.0);
      strength += weight * line.w;
      weights += weight;
    }
  }
  if (!(strength > 0.0)) return 0.0;
  return coverage(max(distance_ / strength, 0.0), uContourWidth) * smoothstep(0.25, 0.6, strength / weights);
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  oLines = vec4(0.0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  float most = 1.6 * uMostRays * p.footprint;  // a line as long as is looked at is long enough
  float seen = shortest * float(uPictureSize.x) * p.footprint;
#ifdef RIDGES
  float width = uRidgeMm > 0.0 ? uRidgeMm / p.footprint : uRidgeRays;
  Wanted wanted = Wanted(width, min(max(uRidgeLengths.x, seen), most), 1.0, 0.4, uGap);
  oLines.x = drawn(uRidgeField, pixel, p, wanted);
  wanted.length = min(max(uRidgeLengths.y, seen), most);
  oLines.y = drawn(uValleyField, pixel, p, wanted);
#endif
#ifdef SUGGESTIVE
  oLines.z = drawn(uSuggestiveField, pixel, p, Wanted(uContourWidth, min(seen, most), 0.25, 0.05, 0.0));
#endif
#ifdef CONTOURS
  oLines.w = outline(uContourField, pixel, p);
#endif
}
