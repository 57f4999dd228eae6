// Unpacks what a cast knows of a crossing from the number that images hold
// (resources/shaders/cast/cast.frag.glsl).
#pragma once

namespace isolux::volume {

// surface in its group + 4 * (sides behind the crossing, a bit for each surface of the group) + 64 if a root
// was not isolated + 128 if the ray waits for a brick + 256 * group, below 64, + 16384 if it leaves a solid
// where the ray enters another that touches it: it is not drawn (resources/shaders/cast/merge.frag.glsl). Up
// to 2048, half floats hold it exactly.
struct HitInfo {
  static constexpr int kSurfaces = 4, kJoined = 16384;  // surfaces in a group
  int bits = 0;
  static HitInfo of(float packed) { return {static_cast<int>(packed)}; }
  int inGroup() const { return bits & 3; }
  int sides() const { return bits >> 2 & 15; }
  int group() const { return bits >> 8 & 63; }
  int surface() const { return kSurfaces * group() + inGroup(); }       // among all that are shown
  bool risesBehind() const { return (sides() >> inGroup() & 1) != 0; }  // above the isovalue
  HitInfo before() const { return {bits ^ 4 << inGroup()}; }            // with the sides before the crossing
  // Returns what a cast knows, whose first surface is `first` among all, as the merged images hold it.
  HitInfo amongAll(int first) const {
    const int of = first + inGroup();
    return {(bits & 192) | (of & 3) | (sides() << (first & 3) & 15) << 2 | of >> 2 << 8};
  }
  bool isJoined() const { return (bits & kJoined) != 0; }
  HitInfo joined() const { return {bits | kJoined}; }
  float packed() const { return static_cast<float>(bits); }
};

}  // namespace isolux::volume
