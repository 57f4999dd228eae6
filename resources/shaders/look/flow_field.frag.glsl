// What streaks along a principal direction are made from, for each pixel: that direction on screen, and noise that
// lies on the surface. MINIMUM: the direction of kappa2 instead of kappa1.
//
// oField: unit direction on screen (0: none), depth (mm, -1: no surface), how much depth may differ from one ray to
//   the next.
// oNoise: noise around 0 of deviation 1; the part of the world direction that points along positive axes; confidence.
#include "common.glsl"
#include "surface.glsl"
#include "noise.glsl"

uniform sampler2D uKappa, uDirection, uCurvatureGradient;
uniform float uGrain;           // rays
uniform float uCurvatureScale;  // of the surface as a whole, 1/mm
uniform float uFlat;            // curvature below which a surface counts as flat, 1/mm
layout(location = 0) out vec4 oField;
layout(location = 1) out vec4 oNoise;

// Noise fixed in space whose grain is about uGrain rays wherever it is seen: octaves that differ by two, blended so
// that the variance stays.
float surfaceNoise(Point p) {
  float level = log2(uGrain * p.footprint), octave = floor(level);
  float angle = (level - octave) * 1.57079633;
  vec3 fine = p.position * exp2(-octave);
  float a = valueNoise(fine) - 0.5, b = valueNoise(0.5 * fine + 101.0) - 0.5;
  return (cos(angle) * a + sin(angle) * b) / valueNoiseDeviation;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oField = vec4(0.0, 0.0, -1.0, 0.0);
  oNoise = vec4(0.0);
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  vec3 direction = texelFetch(uDirection, pixel, 0).xyz;
#ifdef MINIMUM
  vec3 gradient = texelFetch(uCurvatureGradient, pixel, 0).xyz;  // normals may be made of another one
  direction = cross(safeNormalize(uOutward * gradient, -p.ray), direction);
#endif
  // The tangent as it moves over the picture; its depth shifts it in perspective.
  vec3 camera = vec3(dot(direction, uRightWorld), dot(direction, uUpWorld), dot(direction, uForwardWorld));
  vec2 onScreen = camera.xy;
  if (uOrthographic == 0) onScreen -= camera.z * imagePlane(gl_FragCoord.xy);
  float foreshortened = length(onScreen);
  vec2 unit = foreshortened > 1e-6 ? onScreen / foreshortened : vec2(0.0);

  float cosine = max(-dot(p.normal, p.ray), 0.1);
  oField = vec4(unit, p.depth, 3.0 * p.footprint / cosine);
  // Which way the streaks move: seams must lie somewhere, since directions have no sign. Weights by the world axes,
  // squares of a unit vector's components, let them fade instead.
  vec3 squares = direction * direction;
  float forward = dot(squares, vec3(greaterThan(direction, vec3(0.0))));
  vec4 kappa = texelFetch(uKappa, pixel, 0);
  // Where the surface bends nearly alike every way, a direction says nothing, however sure it is.
  float alike = texelFetch(uDirection, pixel, 0).w * uFlat + 0.1 * uCurvatureScale;
  float confidence = kappa.z * smoothstep(0.05, 0.3, foreshortened) * smoothstep(0.5, 1.0, (kappa.x - kappa.y) / max(alike, 1e-30));
  oNoise = vec4(surfaceNoise(p), forward, confidence, 0.0);
}
