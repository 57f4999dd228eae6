// The triangles of a mesh as Embree's scene: what rays of benchmarks are traced against.
#pragma once

#include <embree3/rtcore.h>

#include "bench/triangles.h"

namespace isolux::bench {

class EmbreeScene {
 public:
  explicit EmbreeScene(const Triangles& mesh, RTCSceneFlags flags = RTC_SCENE_FLAG_NONE);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene get() const { return scene_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace isolux::bench
