#include "app/series/camera_request.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/overlay_text/free_rooms.h"
#include "scene/framing.h"
#include "scene/named_camera.h"
#include "volume/prepared/surface_outline.h"
#include "volume/prepared/surface_reach.h"

namespace isolux::app {

namespace {

scene::Camera framedSurface(const scene::Scene& resolved, const volume::PreparedVolume& volume,
                            const scene::Rooms& rooms, base::Progress& progress) {
  const scene::Camera& camera = resolved.camera;
  const auto reach =
      volume::surfaceReach(volume, resolved, scene::framingDirections(camera, rooms), progress);
  return reach ? scene::framing(camera, rooms, *reach) : camera;
}

// What an automatic camera frames.
scene::Camera framedOutline(const scene::Scene& resolved, const volume::PreparedVolume& volume,
                            const scene::Rooms& rooms, base::Progress& progress) {
  const auto outline = volume::surfaceOutline(volume, resolved, false, progress);
  return outline.pointsMm.empty() ? resolved.camera
                                  : scene::framing(resolved.camera, rooms, outline.pointsMm);
}

// By name and turned: everything but how near.
scene::Camera directedCamera(const CameraRequest& request, const scene::Scene& resolved,
                             const scene::VolumeFacts& facts) {
  scene::Camera camera = resolved.camera;
  if (!request.view.empty())
    camera = scene::standardView(camera, scene::standardViewNamed(request.view, facts.axes), facts.axes,
                                 facts.boundsMinMm, facts.boundsMaxMm);
  return scene::rolled(scene::turned(camera, request.azimuth, request.elevation), glm::radians(request.roll));
}

}  // namespace

scene::Camera requestedCamera(const CameraRequest& request, const scene::Scene& scene,
                              const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress,
                              glm::ivec2 overlayLegend) {
  const bool automatic = !scene.camera.eye && !scene.camera.target;
  if (!automatic && !request.any()) return scene.camera;
  const scene::VolumeFacts& facts = volume.facts;
  scene::Scene directed = scene::resolve(scene, facts);
  directed.camera = directedCamera(request, directed, facts);
  const scene::Rooms rooms = freeRooms(directed, volume, size, {}, overlayLegend);
  if (request.fit == Framing::volume) {
    const glm::dvec3 low = facts.boundsMinMm, high = facts.boundsMaxMm;
    directed.camera = rooms == scene::wholePicture(static_cast<double>(size.x) / size.y)
                          ? scene::fitted(directed.camera, low, high)
                          : scene::framing(directed.camera, rooms, scene::cornersOf(low, high));
  } else if (request.fit == Framing::surface) {
    directed.camera = framedSurface(directed, volume, rooms, progress);
  } else if (automatic && directed.camera.frames == scene::Frames::surface) {
    directed.camera = framedOutline(directed, volume, rooms, progress);
  }
  return request.zoom == 1.0 ? directed.camera : scene::zoomed(directed.camera, request.zoom);
}

scene::Camera turntableStart(const CameraRequest& request, bool automatic, const scene::Scene& resolved,
                             const volume::PreparedVolume& volume, glm::ivec2 size,
                             base::Progress& progress) {
  const scene::VolumeFacts& facts = volume.facts;
  scene::Scene directed = resolved;
  directed.camera = directedCamera(request, resolved, facts);
  scene::Camera camera = directed.camera;
  const bool staysPut = !request.fit && !automatic && request.view.empty();
  if (!staysPut) {
    const volume::Ball box{0.5 * (facts.boundsMinMm + facts.boundsMaxMm),
                           0.5 * glm::length(facts.boundsMaxMm - facts.boundsMinMm)};
    const volume::Ball ball =
        request.fit == Framing::volume ? box : volume::surfaceBall(volume, resolved, progress).value_or(box);
    // A legend may cover some of what turns: beside it, in the middle of the picture, little room is left.
    directed.look.legend = false;
    camera =
        scene::framingBall(camera, freeRooms(directed, volume, size, {}, {}), ball.centreMm, ball.radiusMm);
  }
  return request.zoom == 1.0 ? camera : scene::zoomed(camera, request.zoom);
}

scene::Camera turntableCamera(const scene::Camera& start, scene::WorldAxes axes, int index, int count) {
  if (index == 0) return start;
  return scene::turnedAbout(start, scene::upOf(axes), 360.0 * index / count);
}

}  // namespace isolux::app
