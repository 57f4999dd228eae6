#include "bench/embree_scene.h"

#include <algorithm>

namespace isolux::bench {

EmbreeScene::EmbreeScene(const Triangles& mesh, RTCSceneFlags flags)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
#if RTC_VERSION_MAJOR < 4
  rtcInitIntersectContext(&context_);
#endif
  rtcSetSceneFlags(scene_, flags);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                         sizeof(glm::vec3), mesh.points.size());
  std::copy(mesh.points.begin(), mesh.points.end(), static_cast<glm::vec3*>(points));
  void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                          mesh.corners.size() / 3);
  std::copy(mesh.corners.begin(), mesh.corners.end(), static_cast<std::uint32_t*>(corners));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

}  // namespace isolux::bench
