// Which hits a pass looks at: with OF_GROUP, only those of one surface, whose volume is bound.
#ifdef OF_GROUP
#include "hit_info.glsl"
uniform sampler2D uGroupInfo;
uniform int uGroupSurface;
bool isOfOther(ivec2 pixel) { return surfaceOf(int(texelFetch(uGroupInfo, pixel, 0).g)) != uGroupSurface; }
#else
bool isOfOther(ivec2 pixel) { return false; }
#endif
