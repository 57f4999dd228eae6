#include "app/series/camera_wish.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "scene/framing.h"
#include "scene/named_camera.h"
#include "volume/statistics/surface_outline.h"
#include "volume/statistics/surface_reach.h"

namespace isolux::app {

namespace {

constexpr double kBetweenLetters = 0.88;  // of the picture's width and height

scene::Camera framedSurface(const scene::Scene& resolved, const volume::PreparedVolume& volume, double aspect,
                            base::Progress& progress) {
  const scene::Camera& camera = resolved.camera;
  const scene::FramingDirections directions = scene::framingDirections(camera, aspect);
  const auto reach = volume::surfaceReach(volume, resolved, directions, progress);
  if (!reach) return camera;
  std::array<double, scene::framingDirectionCount> farthest{};
  std::copy(reach->begin(), reach->end(), farthest.begin());
  return scene::framing(camera, aspect, farthest);
}

// What an automatic camera frames, for a picture that is not square.
scene::Camera framedOutline(const scene::Scene& resolved, const volume::PreparedVolume& volume, double aspect,
                            base::Progress& progress) {
  const auto outline = volume::surfaceOutline(volume, resolved, false, progress);
  const double part = resolved.picture.letters ? kBetweenLetters : 1.0;
  return outline.pointsMm.empty()
             ? resolved.camera
             : scene::framing(resolved.camera, part * glm::dvec2(aspect, 1.0), outline.pointsMm);
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
                           const volume::PreparedVolume& volume, double aspect, base::Progress& progress) {
  const bool automatic = !scene.camera.eye && !scene.camera.target;
  if (!automatic && !wish.any()) return scene.camera;
  const scene::VolumeFacts& facts = volume.facts;
  scene::Scene directed = scene::resolve(scene, facts);
  directed.camera = directedCamera(wish, directed, facts);
  if (wish.fit == Framing::volume)
    directed.camera = scene::fitted(directed.camera, facts.boundsMinMm, facts.boundsMaxMm);
  else if (wish.fit == Framing::surface)
    directed.camera = framedSurface(directed, volume, aspect, progress);
  else if (automatic && directed.camera.frames == scene::Frames::surface)
    directed.camera = framedOutline(directed, volume, aspect, progress);
  return wish.zoom == 1.0 ? directed.camera : scene::zoomed(directed.camera, wish.zoom);
}

scene::Camera turntableStart(const CameraWish& wish, bool automatic, const scene::Scene& resolved,
                             const volume::PreparedVolume& volume, double aspect, base::Progress& progress) {
  const scene::VolumeFacts& facts = volume.facts;
  scene::Camera camera = directedCamera(wish, resolved, facts);
  const bool staysPut = !wish.fit && !automatic && wish.view.empty();
  if (!staysPut) {
    const volume::Ball box{0.5 * (facts.boundsMinMm + facts.boundsMaxMm),
                           0.5 * glm::length(facts.boundsMaxMm - facts.boundsMinMm)};
    const volume::Ball ball =
        wish.fit == Framing::volume ? box : volume::surfaceBall(volume, resolved, progress).value_or(box);
    camera = scene::framingBall(camera, aspect, ball.centreMm, ball.radiusMm);
  }
  return wish.zoom == 1.0 ? camera : scene::zoomed(camera, wish.zoom);
}

scene::Camera turntableCamera(const scene::Camera& start, scene::WorldAxes axes, int index, int count) {
  if (index == 0) return start;
  return scene::turnedAbout(start, scene::upOf(axes), 360.0 * index / count);
}

}  // namespace isolux::app
