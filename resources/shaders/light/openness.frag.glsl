// How much light from all around reaches the surface point, by what stands near it in the picture [Jimenez et al. 2016]:
// in one plane through the line of sight, the part between the horizons on both sides, weighted by the cosine. Of one
// ray of each cell; the plane changes from cell to cell, within squares of 4 x 4 (occlusion.frag.glsl). Red: that part;
// green: its value where nothing stands near; blue and alpha: the depth, 0 to 1 of uDepthRange, as the sum of two halves.
#include "common.glsl"
#include "surface.glsl"

uniform float uRadius;    // mm: what is farther away counts as nothing
uniform float uMostRays;  // how far it is looked for
uniform int uCell;        // rays on each side
uniform vec2 uDepthRange;
layout(location = 0) out vec4 oOpenness;

const int kSteps = 4;  // on each side
const float kPi = 3.14159265;

// The cosine of the horizon's angle to the line of sight along `way` (rays). `tangent`: that of the tangent plane.
float horizon(ivec2 pixel, vec2 way, float start, Point p, float tangent) {
  float highest = tangent;
  for (int i = 0; i < kSteps; ++i) {
    float part = (float(i) + start) / float(kSteps);
    ivec2 at = pixel + ivec2(floor(way * part * part + 0.5));
    if (at == pixel || any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, textureSize(uSurface, 0)))) continue;
    vec4 surface = texelFetch(uSurface, at, 0);
    if (surface.w < 0.0) continue;
    vec3 toward = uWorldFromVoxel * surface.xyz - p.position;
    float square = max(dot(toward, toward), 1e-30);
    float far = min(square / (uRadius * uRadius), 1.0);
    highest = max(highest, mix(-dot(toward, p.ray) * inversesqrt(square), tangent, far * far));
  }
  return highest;
}

// Between the normal's angle to the line of sight and a horizon, both in the plane.
float between(float horizonAngle, float normal) {
  return 0.25 * (cos(normal) - cos(2.0 * horizonAngle - normal) + 2.0 * horizonAngle * sin(normal));
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  // Beyond the images there are no hits.
  ivec2 pixel = min(cell * uCell + uCell / 2, uPictureSize - 1) - uTileOrigin;
  oOpenness = vec4(0.0);
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(uSurface, 0)))) return;
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  cell &= 3;
  float turn = kPi * (float((cell.x * 4 + cell.y * 5 + (cell.y & 1) * 8) & 15) + 0.5) / 16.0;
  float start = (float((cell.x + 2 * cell.y) & 3) + 0.5) / 4.0;
  vec2 line = vec2(cos(turn), sin(turn));

  vec3 toEye = -p.ray, across = line.x * uRightWorld + line.y * uUpWorld;
  vec3 side = safeNormalize(across - dot(across, toEye) * toEye, uRightWorld);
  vec3 axis = cross(side, toEye);
  vec3 inPlane = p.normal - dot(p.normal, axis) * axis;
  float weight = length(inPlane);
  float normal = atan(dot(inPlane, side), max(dot(inPlane, toEye), 0.0));  // toward `side`

  float rays = min(uRadius / p.footprint, uMostRays);
  float right = acos(clamp(horizon(pixel, line * rays, start, p, cos(normal + 0.5 * kPi)), -1.0, 1.0));
  float left = -acos(clamp(horizon(pixel, -line * rays, start, p, cos(normal - 0.5 * kPi)), -1.0, 1.0));
  float free = weight * (between(right, normal) + between(left, normal));
  float all = weight * (between(normal + 0.5 * kPi, normal) + between(normal - 0.5 * kPi, normal));
  float depth = (p.depth - uDepthRange.x) / max(uDepthRange.y - uDepthRange.x, 1e-30);
  float coarse = unpackHalf2x16(packHalf2x16(vec2(depth, 0.0))).x;
  oOpenness = vec4(min(free, all), all, coarse, depth - coarse);
}
