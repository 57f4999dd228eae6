// Shared by all passes: the ray of a pixel.

// The camera in voxel space, per unit of world length: a point at t mm along a ray is origin + t * direction.
uniform vec3 uEyeVoxel;      // where the ray through the middle starts
uniform float uStartDepth;   // perspective: rays start on the plane that far before the eye, mm; 0 unless the eye is so
                             // far away that floats would lose the rays on their way
uniform vec3 uRightVoxel, uUpVoxel, uForwardVoxel;  // A^-1 of the camera's unit axes
uniform vec2 uHalfExtent;   // of the image plane: at unit distance (perspective) or in mm (orthographic)
uniform int uOrthographic;
uniform ivec2 uPictureSize;  // rays, supersamples included
uniform ivec2 uTileOrigin;   // of the images drawn into, within the picture: pictures may be drawn in parts

uniform int uFirstRow;       // of the images read, that the image drawn into begins with: some are drawn in bands

// Where the images are read.
vec2 fragment() { return gl_FragCoord.xy + vec2(0.0, float(uFirstRow)); }
vec2 inPicture(vec2 fragment) { return fragment + vec2(uTileOrigin); }
vec2 imagePlane(vec2 fragment) { return (inPicture(fragment) / vec2(uPictureSize) * 2.0 - 1.0) * uHalfExtent; }

// mm per ray across the view direction, at this depth along it.
float footprintAt(float depth) {
  return 2.0 * uHalfExtent.y / float(uPictureSize.y) * (uOrthographic != 0 ? 1.0 : depth);
}

void pixelRay(vec2 fragment, out vec3 origin, out vec3 direction) {
  vec2 xy = imagePlane(fragment);
  vec3 offset = xy.x * uRightVoxel + xy.y * uUpVoxel;
  if (uOrthographic != 0) {
    origin = uEyeVoxel + offset;
    direction = uForwardVoxel;
  } else {
    origin = uEyeVoxel + uStartDepth * offset;
    direction = (uForwardVoxel + offset) * inversesqrt(1.0 + dot(xy, xy));
  }
}
