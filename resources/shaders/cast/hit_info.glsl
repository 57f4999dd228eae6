// What a cast knows of a crossing, packed into a number as volume/cast/hit_info.h says.
//
// ALL_SURFACES: how many numbers there are of surfaces, four for each group; without it there is one group.
#ifndef ALL_SURFACES
#define ALL_SURFACES 4
#endif

int placeOf(int info) { return info & 3; }  // of the surface in its group
int sidesBehind(int info) { return info >> 2 & 15; }
int groupOf(int info) { return info >> 8; }
int surfaceOf(int info) { return 4 * groupOf(info) + placeOf(info); }
bool waits(int info) { return (info & 128) != 0; }
bool risesBehind(int info) { return (sidesBehind(info) >> placeOf(info) & 1) != 0; }
