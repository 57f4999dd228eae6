// The fraction of the light that reaches the ground behind a point of the picture: gi/ground/ground_shadow.h.
uniform sampler2D uGround;
uniform mat3 uGroundPlaces;  // homogeneous: from the picture, -1 .. 1, to places on the ground
uniform float uGroundCrowding;

float groundAt(vec2 picture) {  // 0 .. 1, from the lower left
  vec3 ground = uGroundPlaces * vec3(picture * 2.0 - 1.0, 1.0);
  if (ground.z <= 0.0) return 1.0;
  vec2 place = ground.xy / ground.z;
  if (max(abs(place.x), abs(place.y)) >= 1.0) return 1.0;
  vec2 lattice = place * (1.0 + uGroundCrowding) / (1.0 + uGroundCrowding * abs(place));
  float points = float(textureSize(uGround, 0).x);
  return textureLod(uGround, 0.5 + 0.5 * lattice * (points - 1.0) / points, 0.0).r;
}
