// The triangles of a mesh as Embree's scene: what rays of benchmarks are traced against.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define ISOLUX_EMBREE_RAYS(rays) rays
#else  // Embree 3, Debian 12's, wants a context before the rays.
#include <embree3/rtcore.h>
#define ISOLUX_EMBREE_RAYS(rays) &context_, rays
#endif

#include "bench/triangles.h"

namespace isolux::bench {

class EmbreeScene {
 public:
  explicit EmbreeScene(const Triangles& mesh, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // The first triangle on a ray, or whether there is any; of sixteen rays, those that are valid (-1).
  void intersect(RTCRayHit& ray) const { rtcIntersect1(scene_, ISOLUX_EMBREE_RAYS(&ray)); }
  void intersect(const int* valid, RTCRayHit16& rays) const {
    rtcIntersect16(valid, scene_, ISOLUX_EMBREE_RAYS(&rays));
  }
  void occluded(RTCRay& ray) const { rtcOccluded1(scene_, ISOLUX_EMBREE_RAYS(&ray)); }
  void occluded(const int* valid, RTCRay16& rays) const {
    rtcOccluded16(valid, scene_, ISOLUX_EMBREE_RAYS(&rays));
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
#if RTC_VERSION_MAJOR < 4
  mutable RTCIntersectContext context_;  // nothing writes it: the scene has no instances
#endif
};

#undef ISOLUX_EMBREE_RAYS

}  // namespace isolux::bench
