// What the lines of curvature read of pixels nearby. Needs surface.glsl.
uniform sampler2D uKappa;      // kappa1 >= kappa2 (1/mm), confidence, its part from the gradient
uniform sampler2D uDirection;  // of kappa1, world
uniform float uDetail;         // mm: what varies faster is the voxels' doing
uniform float uMostDifference;  // rays

// The surface point under a pixel nearby. False where the surface does not go on there: an edge in depth, the other
// side. `reach`: rays between the pixels.
bool neighbourAt(ivec2 pixel, Point p, float reach, out Point q) {
  q = p;
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(uSurface, 0)))) return false;
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return false;
  q = pointAt(pixel, surface);
  return q.side == p.side && abs(dot(q.position - p.position, p.normal)) <= 4.0 * reach * p.footprint;
}

// Rays over which differences are taken: `part` of uDetail.
int differenceReach(Point p, float part) {
  return int(max(min(part * uDetail / p.footprint, uMostDifference) + 0.5, 1.0));
}

// A direction as it moves over the picture, not normalised; its depth shifts it in perspective.
vec2 onScreen(vec3 direction, ivec2 pixel) {
  vec3 camera = vec3(dot(direction, uRightWorld), dot(direction, uUpWorld), dot(direction, uForwardWorld));
  return uOrthographic != 0 ? camera.xy : camera.xy - camera.z * imagePlane(vec2(pixel) + 0.5);
}
