// The crossings of one group of surfaces where they are nearer than those of the groups before: one after another, these
// leave the nearest of all. Of two at the same place, that of the earlier group stays.
//
// JOIN: marks the nearest crossings that leave a solid less than half a voxel from where the ray enters that of uSurface:
// neighbours touch there, and one skin is drawn.
#include "common.glsl"
#include "hit_info.glsl"

uniform sampler2D uNearest, uWaiting;  // what is drawn into: each pixel reads itself
uniform sampler2D uSurface, uInfo;     // of the group; JOIN: or of the layer before
uniform int uFirst;                    // the group's first surface
#ifdef JOIN
uniform float uOutward;  // times gradient
#endif
layout(location = 0) out vec4 oSurface;
layout(location = 1) out vec2 oInfo;

#ifdef JOIN
bool enters(int info) { return risesBehind(info) == (uOutward < 0.0); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 nearest = texelFetch(uNearest, pixel, 0), other = texelFetch(uSurface, pixel, 0);
  vec2 info = texelFetch(uWaiting, pixel, 0).rg;
  int known = int(info.g), known2 = int(texelFetch(uInfo, pixel, 0).g);
  if (nearest.w < 0.0 || other.w < 0.0 || enters(known) || isJoined(known) || !enters(known2)) discard;
  vec3 origin, direction;
  pixelRay(gl_FragCoord.xy, origin, direction);
  vec3 steps = abs(direction);
  if (abs(other.w - nearest.w) * max(max(steps.x, steps.y), steps.z) > 0.5) discard;
  oSurface = nearest;
  oInfo = vec2(info.r, float(known | 16384));
}
#else
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 nearest = texelFetch(uNearest, pixel, 0), own = texelFetch(uSurface, pixel, 0);
  vec2 info = texelFetch(uInfo, pixel, 0).rg;
  bool found = own.w >= 0.0;
  if (nearest.w >= 0.0 ? !found || own.w >= nearest.w : !found && !waits(int(info.g))) discard;
  oSurface = own;
  oInfo = vec2(info.r, float(amongAll(int(info.g), uFirst)));
}
#endif
