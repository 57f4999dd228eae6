// The corners of one block face (instance), from its packed form (render/block_faces.h).
#include "common.glsl"

layout(location = 0) in uint aFace;
uniform int uBlockCells;
uniform ivec3 uDims;
out vec3 vVoxel;

void main() {
  ivec3 block = ivec3(aFace & 511u, (aFace >> 9) & 511u, (aFace >> 18) & 511u);
  int axis = int((aFace >> 27) & 3u);
  bool highSide = ((aFace >> 29) & 1u) != 0u;
  // Two triangles 0 1 2, 2 1 3 over the face's corners, counter-clockwise seen from outside in a right-handed
  // voxel space; which side faces the viewer is decided per fragment, so handedness does not matter.
  const int order[6] = int[6](0, 1, 2, 2, 1, 3);
  int corner = order[gl_VertexID];
  ivec3 step = ivec3(0);
  step[axis] = highSide ? 1 : 0;
  step[(axis + 1) % 3] = corner & 1;
  step[(axis + 2) % 3] = corner >> 1;
  vVoxel = vec3(min((block + step) * uBlockCells, uDims - 1));

  // Camera coordinates without matrices: solve A^-1 (right, up, forward) * c = vVoxel - eye.
  vec3 c = inverse(mat3(uRightVoxel, uUpVoxel, uForwardVoxel)) * (vVoxel - uEyeVoxel);
  // z = 0: no near or far plane ever cuts a face; w > 0 drops what lies behind the eye.
  gl_Position = uOrthographic != 0 ? vec4(c.xy / uHalfExtent, 0.0, 1.0) : vec4(c.xy / uHalfExtent, 0.0, c.z);
}
