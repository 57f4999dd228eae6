// Where the pixel's ray meets a face: minima of (t, -t) are gathered by blending, so one pass over all faces
// gives the first entry and the last exit. Hadwiger et al. 2005 sec. 3.1, without a depth buffer.
#include "common.glsl"

in vec3 vVoxel;
layout(location = 0) out vec2 oSegment;

void main() {
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  float t = dot(vVoxel - origin, direction) / dot(direction, direction);
  oSegment = vec2(t, -t);
}
