// Unpacks what a cast knows of a crossing from the number that images hold
// (resources/shaders/cast/cast.frag.glsl).
#pragma once

namespace isolux::volume {

// surface in its group + 4 * (sides behind the crossing, a bit for each surface of the group) + 64 if a root
// was not isolated + 128 if the ray waits for a brick + 256 * group. Up to 2048, half floats hold it exactly.
struct HitInfo {
  static constexpr int kSurfaces = 4;  // in a group
  int bits = 0;
  static HitInfo of(float packed) { return {static_cast<int>(packed)}; }
  int inGroup() const { return bits & 3; }
  int sides() const { return bits >> 2 & 15; }
  int group() const { return bits >> 8; }
  int surface() const { return kSurfaces * group() + inGroup(); }       // among all that are shown
  bool risesBehind() const { return (sides() >> inGroup() & 1) != 0; }  // above the isovalue
  HitInfo before() const { return {bits ^ 4 << inGroup()}; }            // with the sides before the crossing
  HitInfo inGroupOf(int group) const { return {bits | group << 8}; }
  float packed() const { return static_cast<float>(bits); }
};

}  // namespace isolux::volume
