// The environment behind the surface: gi/sampling/environment.h says where the image's directions lie.
uniform sampler2D uEnvironment;
uniform mat3 uEnvironmentFromWorld;
uniform float uEnvironmentScale;  // with the picture's exposure
uniform vec3 uRightWorld, uUpWorld, uForwardWorld;
uniform vec2 uViewExtent;  // half of the picture at unit distance

vec3 environmentAt(vec2 picture) {  // 0 .. 1, from the lower left
  vec2 xy = (picture * 2.0 - 1.0) * uViewExtent;
  vec3 d = uEnvironmentFromWorld * normalize(uForwardWorld + xy.x * uRightWorld + xy.y * uUpWorld);
  const float pi = 3.14159265;
  float around = abs(d.x) + abs(d.y) > 0.0 ? atan(d.x, d.y) : 0.0;
  vec2 at = vec2(0.5 + around / (2.0 * pi), acos(clamp(d.z, -1.0, 1.0)) / pi);
  return uEnvironmentScale * textureLod(uEnvironment, at, 0.0).rgb;
}
