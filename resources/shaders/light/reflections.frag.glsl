// The surface points that reflections are traced for, one of each cell of the picture: the processor traces them
// (gi/gloss/reflections.h). A cell whose middle ray meets no front face has none.
#include "common.glsl"
#include "surface.glsl"

uniform int uCell;        // rays on each side
uniform ivec2 uFirstCell;  // in the picture, that the image begins with
layout(location = 0) out vec4 oPoint;   // voxel; index of the surface, -1: none
layout(location = 1) out vec4 oNormal;  // unit, world; depth, mm
layout(location = 2) out vec4 oRay;     // unit, world, from the eye to the point

void main() {
  ivec2 cell = uFirstCell + ivec2(gl_FragCoord.xy);
  ivec2 pixel = cell * uCell + uCell / 2 - uTileOrigin;
  oPoint = vec4(0.0, 0.0, 0.0, -1.0);
  oNormal = oRay = vec4(0.0);
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, textureSize(uSurface, 0)))) return;
  vec4 surface = texelFetch(uSurface, pixel, 0);
  if (surface.w < 0.0) return;
  Point p = pointAt(pixel, surface);
  if (p.side < 0.0) return;
  oPoint = vec4(surface.xyz, float(surfaceOf(int(texelFetch(uInfo, pixel, 0).g))));
  oNormal = vec4(p.normal, p.depth);
  oRay = vec4(p.ray, 0.0);
}
