#include "app/view_math/lamp_handles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/cuts/cut_handles.h"
#include "scene/rules/needs.h"

namespace isolux::app {

namespace {

constexpr double margin = 26.0;      // pixels between a handle and the picture's edge
constexpr double grabReach = 12.0;   // pixels about a handle
constexpr double ringReach = 5.0;    // pixels to both sides of an outline
constexpr double farthestMm = 1e13;  // the range of a lamp's position

// A lamp behind the eye moves in the plane through what is looked at.
ProjectedPoint project(const glm::dvec3& world, const LampStage& stage) {
  return projectedOn({stage.frame, stage.pixels}, world);
}

glm::dvec3 placeOf(const scene::Lamp& lamp, const LampStage& stage) {
  if (lamp.kind != scene::LampKind::directional) return lamp.position.value_or(stage.centreMm);
  const double length = glm::length(lamp.direction);
  const glm::dvec3 toward = length > 0.0 ? lamp.direction / length : stage.frame.back;
  return stage.centreMm + stage.reachMm * toward;
}

bool inside(glm::dvec2 pixel, glm::dvec2 pixels) {
  return pixel.x >= margin && pixel.y >= margin && pixel.x <= pixels.x - margin &&
         pixel.y <= pixels.y - margin;
}

// Along the line from the picture's centre, to where it leaves the margin.
glm::dvec2 atEdge(glm::dvec2 direction, glm::dvec2 pixels) {
  const glm::dvec2 half = glm::max(0.5 * pixels - margin, glm::dvec2(1.0));
  const double longest = std::max({std::abs(direction.x) / half.x, std::abs(direction.y) / half.y, 1e-12});
  return 0.5 * pixels + direction / longest;
}

// Of a ball's outline; in perspective its rim is nearer than its middle.
double outlinePixels(double radiusMm, const ProjectedPoint& place, const LampStage& stage) {
  if (stage.frame.projection == scene::Projection::orthographic) return radiusMm / place.mmPerPixel;
  const double d = place.depthMm, behind = d * d - radiusMm * radiusMm;
  if (!place.before || !(behind > 0.0)) return 0.0;  // the eye is in it
  const double unitPerPixel = 2.0 * stage.frame.halfHeight / std::max(1.0, stage.pixels.y);
  return radiusMm / std::sqrt(behind) / unitPerPixel;
}

bool facesViewer(const scene::Lamp& lamp, const LampStage& stage) {
  if (stage.frame.projection == scene::Projection::orthographic)
    return glm::dot(lamp.direction, stage.frame.back) >= 0.0;
  return glm::dot(lamp.direction, stage.frame.eye - placeOf(lamp, stage)) >= 0.0;
}

// The point of the ball under a pixel, on its near or far side; of its rim where the ray misses it.
glm::dvec3 onBall(glm::dvec2 pixel, const LampStage& stage, bool nearSide) {
  const glm::dvec2 ndc(2.0 * pixel.x / stage.pixels.x - 1.0, 1.0 - 2.0 * pixel.y / stage.pixels.y);
  const scene::Ray ray = scene::rayThrough(stage.frame, ndc, stage.pixels.x / stage.pixels.y);
  const double along = glm::dot(stage.centreMm - ray.origin, ray.direction);
  const glm::dvec3 closest = ray.origin + along * ray.direction;
  const double missed2 = glm::dot(closest - stage.centreMm, closest - stage.centreMm);
  const double reach2 = stage.reachMm * stage.reachMm;
  if (missed2 >= reach2) return stage.centreMm + (closest - stage.centreMm) * std::sqrt(reach2 / missed2);
  const double half = std::sqrt(reach2 - missed2);
  const bool eyeInside = along - half < 0.0;  // there is no near side
  return closest + (nearSide && !eyeInside ? -half : half) * ray.direction;
}

glm::dvec3 clamped(glm::dvec3 position) {
  return glm::clamp(position, glm::dvec3(-farthestMm), glm::dvec3(farthestMm));
}

}  // namespace

LampStage lampStageOf(const scene::Scene& resolved, const scene::VolumeFacts& facts, glm::dvec2 pixels) {
  return {scene::frameOf(resolved.camera), glm::max(pixels, glm::dvec2(1.0)),
          0.5 * (facts.boundsMinMm + facts.boundsMaxMm),
          std::max(0.5 * glm::length(facts.boundsMaxMm - facts.boundsMinMm), 1e-9)};
}

const scene::Lamp* lampOf(const scene::Scene& scene, const std::string& id) {
  const auto found = std::ranges::find(scene.lamps, id, &scene::Lamp::id);
  return found == scene.lamps.end() ? nullptr : &*found;
}

scene::Lamp* lampOf(scene::Scene& scene, const std::string& id) {
  return const_cast<scene::Lamp*>(lampOf(std::as_const(scene), id));
}

std::vector<LampHandle> lampHandles(const scene::Scene& resolved, const LampStage& stage) {
  std::vector<LampHandle> handles;
  if (scene::shadingOf(resolved) != scene::Shading::gi) return handles;
  const ProjectedPoint centre = project(stage.centreMm, stage);
  int number = 0;
  for (const scene::Lamp& lamp : resolved.lamps) {
    ++number;
    if (!lamp.shown) continue;
    const glm::dvec3 world = placeOf(lamp, stage);
    const ProjectedPoint place = project(world, stage);
    LampHandle handle;
    handle.id = lamp.id;
    handle.number = number;
    handle.kind = lamp.kind;
    handle.color = lamp.color;
    handle.outside = !place.before || !inside(place.pixel, stage.pixels);
    const glm::dvec3 v = world - stage.frame.eye;
    const glm::dvec2 side(glm::dot(v, stage.frame.right), -glm::dot(v, stage.frame.up));
    const glm::dvec2 offset = place.before ? place.pixel - 0.5 * stage.pixels : side;
    const double length = glm::length(offset);
    handle.toward = length > 0.0 ? offset / length : glm::dvec2(0.0, -1.0);
    handle.pixel = handle.outside ? atEdge(handle.toward, stage.pixels) : place.pixel;
    handle.far = place.depthMm > centre.depthMm;
    if (lamp.kind == scene::LampKind::sphere)
      handle.ringPixels = outlinePixels(lamp.radius.value_or(0.0), place, stage);
    if (lamp.kind == scene::LampKind::directional)
      handle.ringPixels = outlinePixels(stage.reachMm, centre, stage);
    handle.ballPixel = lamp.kind == scene::LampKind::directional ? centre.pixel : place.pixel;
    handles.push_back(handle);
  }
  return handles;
}

std::optional<LampGrip> lampAt(const std::vector<LampHandle>& handles, glm::dvec2 pixel) {
  std::optional<LampGrip> nearest;
  double least = grabReach;
  for (const LampHandle& handle : handles) {
    const double distance = glm::distance(handle.pixel, pixel);
    if (distance > least) continue;
    least = distance;
    nearest = LampGrip{handle.id, handle.number, LampPart::handle};
  }
  if (nearest) return nearest;
  for (const LampHandle& handle : handles) {
    if (handle.kind != scene::LampKind::sphere || handle.outside || handle.ringPixels <= grabReach) continue;
    if (std::abs(glm::distance(handle.ballPixel, pixel) - handle.ringPixels) <= ringReach)
      return LampGrip{handle.id, handle.number, LampPart::ring};
  }
  return std::nullopt;
}

scene::Lamp lampMovedTo(const scene::Lamp& lamp, const LampStage& stage, glm::dvec2 pixel) {
  const scene::CameraFrame& frame = stage.frame;
  scene::Lamp moved = lamp;
  if (lamp.kind != scene::LampKind::directional) {
    const ProjectedPoint place = project(placeOf(lamp, stage), stage);
    const glm::dvec2 side = (pixel - 0.5 * stage.pixels) * place.mmPerPixel;
    const double depth = place.before ? place.depthMm : frame.distance;
    moved.position = clamped(frame.eye + frame.right * side.x - frame.up * side.y - frame.back * depth);
    return moved;
  }
  moved.direction = onBall(pixel, stage, facesViewer(lamp, stage)) - stage.centreMm;
  return moved;
}

scene::Lamp lampMovedAway(const scene::Lamp& lamp, const LampStage& stage, double fraction) {
  const scene::CameraFrame& frame = stage.frame;
  scene::Lamp moved = lamp;
  if (lamp.kind == scene::LampKind::directional) {
    // Over the ball, away from the viewer or toward them.
    const glm::dvec3 toward = glm::normalize(lamp.direction);
    glm::dvec3 sideways = toward - glm::dot(toward, frame.back) * frame.back;
    sideways = glm::length(sideways) > 1e-9 ? glm::normalize(sideways) : frame.up;
    const double angle = std::acos(std::clamp(glm::dot(toward, frame.back), -1.0, 1.0));
    const double turned = std::clamp(angle + 3.0 * fraction, 0.0, 3.141592653589793);
    moved.direction = frame.back * std::cos(turned) + sideways * std::sin(turned);
    return moved;
  }
  const glm::dvec3 position = placeOf(lamp, stage);
  const ProjectedPoint place = project(position, stage);
  if (frame.projection == scene::Projection::perspective && place.before) {
    moved.position = clamped(frame.eye + (position - frame.eye) * std::exp(2.0 * fraction));
  } else {  // also toward the eye from behind it
    moved.position = clamped(position - frame.back * (fraction * 2.0 * stage.reachMm));
  }
  return moved;
}

scene::Lamp lampResizedTo(const scene::Lamp& lamp, const LampStage& stage, glm::dvec2 pixel) {
  scene::Lamp resized = lamp;
  const ProjectedPoint place = project(placeOf(lamp, stage), stage);
  double radius = glm::distance(place.pixel, pixel) * place.mmPerPixel;
  if (stage.frame.projection == scene::Projection::perspective) {  // the inverse of outlinePixels()
    const double tangent = radius / place.depthMm;
    radius /= std::sqrt(1.0 + tangent * tangent);
  }
  resized.radius = std::clamp(radius, 1e-12, farthestMm);
  return resized;
}

}  // namespace isolux::app
