// Shared by all passes: the ray of a pixel, and the exact trilinear field.

// The camera in voxel space, per unit of world length: a point at t mm along a ray is origin + t * direction.
uniform vec3 uEyeVoxel;
uniform vec3 uRightVoxel, uUpVoxel, uForwardVoxel;  // A^-1 of the camera's unit axes
uniform vec2 uHalfExtent;   // of the image plane: at unit distance (perspective) or in mm (orthographic)
uniform int uOrthographic;
uniform ivec2 uPictureSize;  // rays, supersamples included

vec2 imagePlane(vec2 fragment) { return (fragment / vec2(uPictureSize) * 2.0 - 1.0) * uHalfExtent; }

void pixelRay(vec2 fragment, out vec3 origin, out vec3 direction) {
  vec2 xy = imagePlane(fragment);
  vec3 offset = xy.x * uRightVoxel + xy.y * uUpVoxel;
  if (uOrthographic != 0) {
    origin = uEyeVoxel + offset;
    direction = uForwardVoxel;
  } else {
    origin = uEyeVoxel;
    direction = (uForwardVoxel + offset) * inversesqrt(1.0 + dot(xy, xy));
  }
}
