// The corners of one block face (instance), from its packed form (render/volume/block_faces.h); faces turned away from the
// viewer are dropped, since only where rays enter is asked for.
#include "common.glsl"

layout(location = 0) in uint aFace;
uniform int uBlockCells;
uniform ivec3 uDims;
uniform vec2 uTileScale, uTileShift;  // of the picture's clip coordinates into those of what is drawn
uniform mat3 uCameraFromVoxel;  // (right, up, forward) coordinates of a voxel vector
out vec3 vVoxel;

void main() {
  ivec3 blocks = (uDims + (uBlockCells - 2)) / uBlockCells;  // of uDims - 1 cells
  int side = int(aFace % 6u), index = int(aFace / 6u);
  ivec3 block = ivec3(index % blocks.x, index / blocks.x % blocks.y, index / (blocks.x * blocks.y));
  int axis = side / 2;
  bool highSide = side % 2 != 0;
  float plane = float(min((block[axis] + (highSide ? 1 : 0)) * uBlockCells, uDims[axis] - 1));
  float toViewer = uOrthographic != 0 ? -uForwardVoxel[axis] : uEyeVoxel[axis] - plane - uStartDepth * uForwardVoxel[axis];
  if (highSide ? toViewer < 0.0 : toViewer > 0.0) {
    vVoxel = vec3(0.0);
    gl_Position = vec4(0.0, 0.0, 0.0, -1.0);  // outside
    return;
  }
  const int order[6] = int[6](0, 1, 2, 2, 1, 3);
  int corner = order[gl_VertexID];
  ivec3 step = ivec3(0);
  step[axis] = highSide ? 1 : 0;
  step[(axis + 1) % 3] = corner & 1;
  step[(axis + 2) % 3] = corner >> 1;
  vVoxel = vec3(min((block + step) * uBlockCells, uDims - 1));

  vec3 c = uCameraFromVoxel * (vVoxel - uEyeVoxel);
  // z = 0: no near or far plane ever cuts a face; w > 0 drops what lies behind the eye.
  gl_Position = vec4(c.xy / uHalfExtent, 0.0, uOrthographic != 0 ? 1.0 : c.z + uStartDepth);
  gl_Position.xy = gl_Position.xy * uTileScale + gl_Position.w * uTileShift;
}
