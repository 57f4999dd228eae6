#include "app/cuts/cut_drag.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace isolux::app {

namespace {

constexpr double steepest = 0.17;      // sine of the angle to the line of sight, below which height counts
constexpr double thinnestBox = 1e-3;   // of the volume's diagonal
constexpr double farthestCutMm = 1e8;  // within the range of the settings

double diagonalMm(const CutStage& stage) {
  return glm::distance(stage.volumeMm[0], stage.volumeMm[7]);
}

scene::Ray rayAt(const CutStage& stage, glm::dvec2 pixel) {
  return scene::rayThrough(stage.frame,
                           {2.0 * pixel.x / stage.pixels.x - 1.0, 1.0 - 2.0 * pixel.y / stage.pixels.y},
                           stage.pixels.x / stage.pixels.y);
}

// Where on the axis the pointer is: the axis' nearest point to the pixel's ray.
double alongAxis(const scene::Ray& ray, const glm::dvec3& point, const glm::dvec3& axis) {
  const double cosine = glm::dot(axis, ray.direction);
  const glm::dvec3 between = ray.origin - point;
  return (glm::dot(between, axis) - cosine * glm::dot(between, ray.direction)) / (1.0 - cosine * cosine);
}

// How far a drag goes along an axis through a point, mm.
double draggedAlong(const CutStage& stage, const glm::dvec3& point, const glm::dvec3& axis, glm::dvec2 from,
                    glm::dvec2 to) {
  const ProjectedPoint place = projectedOn(stage, point);
  const glm::dvec3 sight = rayAt(stage, place.pixel).direction;
  const double farthest = 2.0 * diagonalMm(stage);
  double moved = 0.0;
  if (glm::length(glm::cross(sight, axis)) < steepest)
    moved = (to.y - from.y) * place.mmPerPixel * (glm::dot(axis, sight) < 0.0 ? 1.0 : -1.0);
  else
    moved = alongAxis(rayAt(stage, to), point, axis) - alongAxis(rayAt(stage, from), point, axis);
  return std::isfinite(moved) ? std::clamp(moved, -farthest, farthest) : 0.0;
}

// The point of the ball under a pixel, as a direction from its middle; beyond its rim, along the rim.
glm::dvec3 directionOnBall(const CutStage& stage, const glm::dvec3& middle, double radius, glm::dvec2 pixel,
                           bool nearSide) {
  const scene::Ray ray = rayAt(stage, pixel);
  const glm::dvec3 closest = ray.origin + glm::dot(middle - ray.origin, ray.direction) * ray.direction;
  const glm::dvec3 missed = closest - middle;
  const double missed2 = glm::dot(missed, missed), rest2 = radius * radius - missed2;
  if (rest2 <= 0.0) return missed / std::sqrt(missed2);
  return (missed + (nearSide ? -1.0 : 1.0) * std::sqrt(rest2) * ray.direction) / radius;
}

// The nearest of the axes and of the directions halfway between two of them.
glm::dvec3 snapped(const glm::dvec3& direction) {
  glm::dvec3 best = direction;
  double most = -1.0;
  for (int i = 0; i < 27; ++i) {
    const glm::dvec3 request(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const double length = glm::length(request);
    if (length == 0.0 || length > 1.5) continue;
    const double cosine = glm::dot(request, direction) / length;
    if (cosine <= most) continue;
    most = cosine;
    best = request;
  }
  return best;
}

scene::ClipPlane movedBy(const scene::ClipPlane& plane, const CutStage& stage, double mm) {
  const glm::dvec3 normal = glm::normalize(plane.normal);
  double low = 0.0, high = 0.0;  // of the volume from the plane; where it is now is allowed
  for (const glm::dvec3& corner : stage.volumeMm) {
    const double above = glm::dot(normal, corner - plane.point);
    low = std::min(low, above);
    high = std::max(high, above);
  }
  return {plane.point + std::clamp(mm, low, high) * normal, plane.normal};
}

// About its knob.
scene::ClipPlane turnedBy(const scene::ClipPlane& plane, const glm::dvec3& knob, const CutStage& stage,
                          glm::dvec2 by, bool constrained) {
  const glm::dvec3 normal = glm::normalize(plane.normal);
  const ProjectedPoint place = projectedOn(stage, knob);
  const double radius = kCutArrow * place.mmPerPixel;
  const glm::dvec3 toEye =
      stage.frame.projection == scene::Projection::orthographic ? stage.frame.back : stage.frame.eye - knob;
  const ProjectedPoint tip = projectedOn(stage, knob + radius * normal);
  if (!tip.before) return plane;
  const glm::dvec3 turned =
      directionOnBall(stage, knob, radius, tip.pixel + by, glm::dot(normal, toEye) >= 0.0);
  return {knob, constrained ? snapped(turned) : turned};
}

void setBox(scene::Clip& clip, int number, const glm::dvec3& middle, const glm::dvec3& half) {
  const glm::dvec3 within = glm::clamp(middle, glm::dvec3(-farthestCutMm), glm::dvec3(farthestCutMm));
  glm::dvec3* const corners =
      number == 0 ? clip.box.data() : &clip.removed[2 * static_cast<std::size_t>(-number - 1)];
  corners[0] = within - half;
  corners[1] = within + half;
}

void moveFace(scene::Clip& clip, int number, const CutStage& stage, int face, double mm) {
  TurnedBox box = turnedBox(clip, number);
  const int axis = face / 2;
  const double thinnest = 0.5 * thinnestBox * diagonalMm(stage);
  const double half = std::max(box.half[axis] + 0.5 * mm, std::min(thinnest, box.half[axis]));
  box.middle += (half - box.half[axis]) * box.outward(face);
  box.half[axis] = half;
  setBox(clip, number, box.middle, box.half);
}

// From one direction to the other, the short way.
glm::dquat arc(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 across = glm::cross(from, to);
  const double length = glm::length(across);
  if (length < 1e-12) return {1.0, 0.0, 0.0, 0.0};
  return glm::angleAxis(std::atan2(length, glm::dot(from, to)), across / length);
}

// The part of a turn about the box's axis that it is most about.
glm::dquat aboutOneAxis(const glm::dquat& turn, const glm::dmat3& axes) {
  const glm::dvec3 vector(turn.x, turn.y, turn.z);
  int most = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(glm::dot(vector, axes[axis])) > std::abs(glm::dot(vector, axes[most]))) most = axis;
  return glm::angleAxis(2.0 * std::atan2(glm::dot(vector, axes[most]), turn.w), axes[most]);
}

void turnBox(scene::Clip& clip, const CutStage& stage, int corner, glm::dvec2 by, bool constrained) {
  const TurnedBox box = turnedBox(clip);
  const glm::dvec3 arm = box.corner(corner) - box.middle;
  const double radius = glm::length(arm);
  const ProjectedPoint place = projectedOn(stage, box.corner(corner));
  if (!(radius > 0.0) || !place.before) return;
  const glm::dvec3 sight = rayAt(stage, place.pixel).direction;
  const glm::dvec3 to =
      directionOnBall(stage, box.middle, radius, place.pixel + by, glm::dot(arm, sight) <= 0.0);
  glm::dquat turn = arc(arm / radius, to);
  if (constrained) turn = aboutOneAxis(turn, box.axes);
  const glm::dquat whole = glm::normalize(turn * glm::quat_cast(box.axes));
  clip.boxRotation = {whole.w, whole.x, whole.y, whole.z};
}

}  // namespace

bool hasGrip(const scene::Clip& clip, const CutGrip& grip) {
  if (grip.plane == 0) return clip.box.size() == 2;
  if (grip.plane < 0) return 2 * static_cast<std::size_t>(-grip.plane) <= clip.removed.size();
  return grip.plane > 0 && static_cast<std::size_t>(grip.plane) <= clip.planes.size();
}

scene::Clip draggedCut(const scene::Clip& clip, const CutGrip& grip, const CutStage& stage, glm::dvec2 from,
                       glm::dvec2 to, bool constrained) {
  scene::Clip dragged = clip;
  if (!hasGrip(clip, grip) || from == to) return dragged;
  if (grip.plane > 0) {
    scene::ClipPlane& plane = dragged.planes[static_cast<std::size_t>(grip.plane - 1)];
    const glm::dvec3 normal = glm::normalize(plane.normal),
                     knob = knobOf(clip, static_cast<std::size_t>(grip.plane - 1), stage);
    plane = grip.part == CutPart::turn ? turnedBy(plane, knob, stage, to - from, constrained)
                                       : movedBy(plane, stage, draggedAlong(stage, knob, normal, from, to));
    return dragged;
  }
  const TurnedBox box = turnedBox(clip, grip.plane);
  if (grip.part == CutPart::turn) {
    turnBox(dragged, stage, grip.index, to - from, constrained);
  } else if (grip.part == CutPart::face) {
    moveFace(dragged, grip.plane, stage, grip.index,
             draggedAlong(stage, box.faceMiddle(grip.index), box.outward(grip.index), from, to));
  } else {
    const glm::dvec2 mm = (to - from) * projectedOn(stage, box.middle).mmPerPixel;
    setBox(dragged, grip.plane, box.middle + mm.x * stage.frame.right - mm.y * stage.frame.up, box.half);
  }
  return dragged;
}

scene::Clip steppedCut(const scene::Clip& clip, const CutGrip& grip, const CutStage& stage, double mm) {
  scene::Clip stepped = clip;
  if (!hasGrip(clip, grip)) return stepped;
  const auto away = [&](const glm::dvec3& outward) {
    return glm::dot(outward, stage.frame.back) > 0.0 ? -mm : mm;
  };
  if (grip.plane > 0) {
    scene::ClipPlane& plane = stepped.planes[static_cast<std::size_t>(grip.plane - 1)];
    plane = movedBy(plane, stage, away(plane.normal));
  } else if (grip.part == CutPart::face) {
    moveFace(stepped, grip.plane, stage, grip.index, away(turnedBox(clip, grip.plane).outward(grip.index)));
  }
  return stepped;
}

}  // namespace isolux::app
