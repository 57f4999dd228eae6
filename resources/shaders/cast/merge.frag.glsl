// The crossings of one group of surfaces where they are nearer than those of the groups before: one after another, these
// leave the nearest of all. Of two at the same place, that of the earlier group stays.
#include "common.glsl"
#include "hit_info.glsl"

uniform sampler2D uNearest, uWaiting;  // what is drawn into: each pixel reads itself
uniform sampler2D uSurface, uInfo;     // of the group
uniform int uGroup;
layout(location = 0) out vec4 oSurface;
layout(location = 1) out vec2 oInfo;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 nearest = texelFetch(uNearest, pixel, 0), own = texelFetch(uSurface, pixel, 0);
  vec2 info = texelFetch(uInfo, pixel, 0).rg;
  bool found = own.w >= 0.0;
  if (nearest.w >= 0.0 ? !found || own.w >= nearest.w : !found && !waits(int(info.g))) discard;
  oSurface = own;
  oInfo = vec2(info.r, info.g + float(256 * uGroup));
}
