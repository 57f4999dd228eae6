// Where lines run, for each pixel near one: RIDGES, SUGGESTIVE, CONTOURS, each in an image of its own (their places are
// AT_RIDGES, AT_VALLEYS ...): xy the line's unit tangent on screen, 0 where there is none; z the distance to its middle in
// rays, toward (tangent.y, -tangent.x); w its strength, 0 where the pixel belongs to no line.
#include "common.glsl"
#include "surface.glsl"
#include "neighbours.glsl"

const float far = 1000.0;  // rays: no line is near

vec4 lineAlong(vec2 gradient, float value, float strength) {
  float steepness = length(gradient);
  if (!(steepness > 0.0)) return vec4(0.0, 0.0, far, 0.0);
  vec2 across = gradient / steepness;
  return vec4(-across.y, across.x, clamp(value / steepness, -far, far), strength);
}

#ifdef RIDGES
uniform sampler2D uExtrema;
uniform vec2 uRidgeThresholds;  // of ridges and of valleys, 1/mm
uniform float uMostRays;        // looked at to the sides
layout(location = AT_RIDGES) out vec4 oRidges;
layout(location = AT_VALLEYS) out vec4 oValleys;

// Of a valley everything is that of a ridge with the surface turned inside out: kappa2 for kappa1, and minus.
float curvatureOf(ivec2 pixel, bool valley) {
  vec2 kappa = texelFetch(uKappa, pixel, 0).xy;
  return valley ? -kappa.y : kappa.x;
}

vec3 directionOf(ivec2 pixel, Point p, bool valley) {
  vec3 first = texelFetch(uDirection, pixel, 0).xyz;
  return valley ? cross(p.outward, first) : first;
}

// The derivative of the curvature along its direction, in the sense of `direction`.
bool extremumAt(ivec2 pixel, Point p, float reach, vec3 direction, bool valley, out float derivative) {
  derivative = 0.0;
  Point q;
  if (!neighbourAt(pixel, p, reach, q)) return false;
  vec2 both = texelFetch(uExtrema, pixel, 0).xy;
  derivative = valley ? -both.y : both.x;
  if (abs(derivative) >= 1e30) return false;
  if (dot(directionOf(pixel, q, valley), direction) < 0.0) derivative = -derivative;
  return true;
}

// Along one axis of the picture; next to an edge in depth from one side alone.
bool slopeAlong(ivec2 pixel, ivec2 step_, Point p, vec3 direction, bool valley, float here, out float slope) {
  float reach = float(max(step_.x, step_.y)), before, behind;
  bool hasBefore = extremumAt(pixel - step_, p, reach, direction, valley, before);
  bool hasBehind = extremumAt(pixel + step_, p, reach, direction, valley, behind);
  slope = ((hasBehind ? behind : here) - (hasBefore ? before : here)) / (hasBefore && hasBehind ? 2.0 * reach : reach);
  return hasBefore || hasBehind;
}

// By how much less curved the surface is at both sides, over what it turns in about a radian: an edge of one curvature all
// along, or noise on it, is no ridge. Sides that are not seen say nothing.
float prominence(ivec2 pixel, Point p, float curvature, vec2 across, bool valley) {
  float rays = clamp(0.8 / (curvature * p.footprint), 2.0, max(uMostRays, 2.0)), least = 1.0;
  for (int side = -1; side <= 1; side += 2) {
    ivec2 at = pixel + ivec2(round(float(side) * rays * across));
    Point q;
    if (neighbourAt(at, p, rays, q)) least = min(least, 1.0 - curvatureOf(at, valley) / curvature);
  }
  return smoothstep(0.02, 0.1, least);
}

vec4 ridgeLine(ivec2 pixel, Point p, bool valley) {
  vec4 none = vec4(0.0, 0.0, far, 0.0), kappa = texelFetch(uKappa, pixel, 0);
  float curvature = curvatureOf(pixel, valley), other = abs(valley ? kappa.x : kappa.y);
  float part = curvature / max(valley ? uRidgeThresholds.y : uRidgeThresholds.x, 1e-30);
  float distinct = kappa.w * smoothstep(0.0, 0.3, (curvature - other) / max(curvature, 1e-30));
  if (!(part > 0.25) || !(distinct > 0.0)) return none;
  vec3 direction = directionOf(pixel, p, valley);
  vec2 across = onScreen(direction, pixel);
  // A line that is broken here would run along the other direction.
  vec2 guess = onScreen(cross(p.outward, direction), pixel);
  if (!(length(guess) > 1e-3) || !(length(across) > 1e-3)) return none;
  none.xy = normalize(guess);
  int reach = differenceReach(p, 0.5);
  float here, distance_ = float(reach);
  vec2 gradient;
  if (!extremumAt(pixel, p, 1.0, direction, valley, here) ||
      !slopeAlong(pixel, ivec2(reach, 0), p, direction, valley, here, gradient.x) ||
      !slopeAlong(pixel, ivec2(0, reach), p, direction, valley, here, gradient.y))
    return none;
  if (!(dot(gradient, across) < 0.0)) return none;  // least curved here, not most
  vec4 line = lineAlong(gradient, here, min(part, 2.0) * distinct);
  if (abs(line.z) < 12.0 + distance_) line.w *= prominence(pixel, p, curvature, normalize(across), valley);
  return line;
}
#endif

#if defined(SUGGESTIVE) || defined(CONTOURS)
uniform float uContourWidth;  // rays

// Curvature of the surface along the view direction projected into its tangent plane, positive where it bends away
// from the viewer: Euler's formula. `toViewer` receives that tangent, unit; 0 where the surface faces the viewer.
float radialCurvature(Point p, ivec2 pixel, out vec3 toViewer) {
  vec2 kappa = texelFetch(uKappa, pixel, 0).xy;
  toViewer = safeNormalize(-p.ray + dot(p.ray, p.normal) * p.normal, vec3(0.0));
  float along = dot(toViewer, texelFetch(uDirection, pixel, 0).xyz);
  return p.side * mix(kappa.y, kappa.x, along * along);
}
#endif

#ifdef CONTOURS
layout(location = AT_CONTOURS) out vec4 oContours;

// Kindlmann et al. 2003 sec. 5: the surface near its silhouette is a circle of curvature kv, so that n.v = c lies
// (1 - sqrt(1 - c^2)) / kv inside the outline; their n.v <= sqrt(T kv (2 - T kv)) is that distance <= T. On what is
// small or rough the line takes no more than an eighth of the radius: it is not blackened whole.
vec4 silhouette(ivec2 pixel, Point p) {
  vec3 toViewer;
  float kv = radialCurvature(p, pixel, toViewer);
  vec2 outside = onScreen(p.normal, pixel);
  vec4 none = vec4(0.0, 0.0, far, 0.0);
  if (!(length(outside) > 1e-3)) return none;
  outside = normalize(outside);
  none.xy = vec2(-outside.y, outside.x);
  if (!(kv > 0.0)) return none;  // flat or hollow: no outline
  float c = -dot(p.normal, p.ray), inset = c * c / (1.0 + sqrt(1.0 - c * c));  // c < 1: not seen head on
  float width = min(uContourWidth, 0.125 / (kv * p.footprint));
  // Its middle lies half a width inside.
  float inside = inset / (kv * p.footprint) - width + 0.5 * uContourWidth;
  float strength = texelFetch(uKappa, pixel, 0).w * smoothstep(0.2, 0.8, width);  // thinner than a ray: too small
  return vec4(none.xy, clamp(inside, -far, far), strength);
}
#endif

#ifdef SUGGESTIVE
uniform float uCurvatureScale;  // of the surface as a whole, 1/mm
layout(location = AT_SUGGESTIVE) out vec4 oSuggestive;

bool radialCurvatureAt(ivec2 pixel, Point p, float reach, out float kr) {
  kr = 0.0;
  Point q;
  if (!neighbourAt(pixel, p, reach, q)) return false;
  vec3 toViewer;
  kr = radialCurvature(q, pixel, toViewer);
  return true;
}

// DeCarlo et al. 2003: where the radial curvature crosses zero and rises toward the viewer, there would be an outline
// from a view nearby. Its distance is |kr| / |gradient of kr on screen|.
vec4 suggestiveContour(ivec2 pixel, Point p) {
  vec3 toViewer;
  vec4 none = vec4(0.0, 0.0, far, 0.0);
  float kr = radialCurvature(p, pixel, toViewer);
  // A surface seen head on has no direction toward the viewer; near there the zeros mean nothing.
  float fade = smoothstep(0.2, 0.5, sqrt(max(1.0 - pow(dot(p.normal, p.ray), 2.0), 0.0)));
  vec2 toward = vec2(dot(toViewer, uRightWorld), dot(toViewer, uUpWorld));
  if (fade <= 0.0 || !(length(toward) > 1e-3)) return none;
  float left, right, down, up, near, behind;
  int step_ = differenceReach(p, 0.5);
  float distance_ = float(step_);
  if (!radialCurvatureAt(pixel - ivec2(step_, 0), p, distance_, left) ||
      !radialCurvatureAt(pixel + ivec2(step_, 0), p, distance_, right) ||
      !radialCurvatureAt(pixel - ivec2(0, step_), p, distance_, down) ||
      !radialCurvatureAt(pixel + ivec2(0, step_), p, distance_, up))
    return none;
  vec4 line = lineAlong(vec2(right - left, up - down) / (2.0 * distance_), kr, fade);
  if (abs(line.z) > uContourWidth + 4.0 + distance_) return none;
  // A feature is hollow behind the line and bulges before it, as far off as is seen as one: zeros of noise are not.
  float reach = float(uPictureSize.y) / 90.0;
  ivec2 offset = ivec2(round(reach * normalize(toward)));
  if (!radialCurvatureAt(pixel + offset, p, reach, near) || !radialCurvatureAt(pixel - offset, p, reach, behind))
    return none;
  line.w *= texelFetch(uKappa, pixel, 0).w * smoothstep(0.0, 0.16, min(near, -behind) / uCurvatureScale);
  return line;
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  bool seen = surface.w >= 0.0;
  Point p = pointAt(pixel, surface);
#ifdef RIDGES
  oRidges = oValleys = vec4(0.0, 0.0, far, 0.0);
  if (seen) oRidges = ridgeLine(pixel, p, false);
  if (seen) oValleys = ridgeLine(pixel, p, true);
#endif
#ifdef SUGGESTIVE
  oSuggestive = seen ? suggestiveContour(pixel, p) : vec4(0.0, 0.0, far, 0.0);
#endif
#ifdef CONTOURS
  oContours = seen ? silhouette(pixel, p) : vec4(0.0, 0.0, far, 0.0);
#endif
}
