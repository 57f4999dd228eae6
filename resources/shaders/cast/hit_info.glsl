// What a cast knows of a crossing, packed into a number as volume/cast/hit_info.h says.
//
// ALL_SURFACES: how many numbers there are of surfaces, four for each group; without it there is one group.
#ifndef ALL_SURFACES
#define ALL_SURFACES 4
#endif

int placeOf(int info) { return info & 3; }  // of the surface in its group
int sidesBehind(int info) { return info >> 2 & 15; }
int groupOf(int info) { return info >> 8 & 63; }
int surfaceOf(int info) { return 4 * groupOf(info) + placeOf(info); }
bool isJoined(int info) { return (info & 16384) != 0; }
// What a cast of surfaces from `first` on knows, as it is known of all.
int amongAll(int info, int first) {
  int surface = first + placeOf(info);
  return (info & 192) | (surface & 3) | (sidesBehind(info) << (first & 3) & 15) << 2 | surface >> 2 << 8;
}
bool waits(int info) { return (info & 128) != 0; }
bool risesBehind(int info) { return (sidesBehind(info) >> placeOf(info) & 1) != 0; }
