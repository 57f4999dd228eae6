// Where the pixel's ray meets a face: the least t is gathered by blending, so one pass over all faces gives the first
// entry. Hadwiger et al. 2005 sec. 3.1, without a depth buffer; rays leave where the volume ends, since what is empty
// behind the last face is walked through block by block.
#include "common.glsl"

in vec3 vVoxel;
layout(location = 0) out float oStart;

void main() {
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  oStart = dot(vVoxel - origin, direction) / dot(direction, direction);
}
