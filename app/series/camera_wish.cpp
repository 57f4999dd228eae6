#include "app/series/camera_wish.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/annotation/free_rooms.h"
#include "base/error.h"
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
scene::Camera directedCamera(const CameraWish& wish, const scene::Scene& resolved,
                             const scene::VolumeFacts& facts) {
  scene::Camera camera = resolved.camera;
  if (!wish.view.empty())
    camera = scene::standardView(camera, scene::standardViewNamed(wish.view, facts.axes), facts.axes,
                                 facts.boundsMinMm, facts.boundsMaxMm);
  return scene::rolled(scene::turned(camera, wish.azimuth, wish.elevation), glm::radians(wish.roll));
}

}  // namespace

scene::Camera wishedCamera(const CameraWish& wish, const scene::Scene& scene,
                           const volume::PreparedVolume& volume, glm::ivec2 size, base::Progress& progress,
                           glm::ivec2 overlayLegend) {
  const bool automatic = !scene.camera.eye && !scene.camera.target;
  if (!automatic && !wish.any()) return scene.camera;
  const scene::VolumeFacts& facts = volume.facts;
  scene::Scene directed = scene::resolve(scene, facts);
  directed.camera = directedCamera(wish, directed, facts);
  const scene::Rooms rooms = freeRooms(directed, volume, size, {}, overlayLegend);
  if (wish.fit == Framing::volume) {
    const glm::dvec3 low = facts.boundsMinMm, high = facts.boundsMaxMm;
    directed.camera = rooms == scene::wholePicture(static_cast<double>(size.x) / size.y)
                          ? scene::fitted(directed.camera, low, high)
                          : scene::framing(directed.camera, rooms, scene::cornersOf(low, high));
  } else if (wish.fit == Framing::surface) {
    directed.camera = framedSurface(directed, volume, rooms, progress);
  } else if (automatic && directed.camera.frames == scene::Frames::surface) {
    directed.camera = framedOutline(directed, volume, rooms, progress);
  }
  return wish.zoom == 1.0 ? directed.camera : scene::zoomed(directed.camera, wish.zoom);
}

scene::Camera turntableStart(const CameraWish& wish, bool automatic, const scene::Scene& resolved,
                             const volume::PreparedVolume& volume, glm::ivec2 size,
                             base::Progress& progress) {
  const scene::VolumeFacts& facts = volume.facts;
  scene::Scene directed = resolved;
  directed.camera = directedCamera(wish, resolved, facts);
  scene::Camera camera = directed.camera;
  const bool staysPut = !wish.fit && !automatic && wish.view.empty();
  if (!staysPut) {
    const volume::Ball box{0.5 * (facts.boundsMinMm + facts.boundsMaxMm),
                           0.5 * glm::length(facts.boundsMaxMm - facts.boundsMinMm)};
    const volume::Ball ball =
        wish.fit == Framing::volume ? box : volume::surfaceBall(volume, resolved, progress).value_or(box);
    // A legend may cover some of what turns: beside it, in the middle of the picture, little room is left.
    directed.look.legend = false;
    camera =
        scene::framingBall(camera, freeRooms(directed, volume, size, {}, {}), ball.centreMm, ball.radiusMm);
  }
  return wish.zoom == 1.0 ? camera : scene::zoomed(camera, wish.zoom);
}

scene::Camera turntableCamera(const scene::Camera& start, scene::WorldAxes axes, int index, int count) {
  if (index == 0) return start;
  return scene::turnedAbout(start, scene::upOf(axes), 360.0 * index / count);
}

}  // namespace isolux::app
