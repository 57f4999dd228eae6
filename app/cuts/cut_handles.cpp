#include "app/cuts/cut_handles.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::app {

namespace {

constexpr double knobReach = 11.0, outlineReach = 5.0;  // pixels
constexpr double knobMargin = 14.0;                     // pixels between a knob and the picture's edge

bool onPicture(const ProjectedPoint& place, const CutStage& stage) {
  return place.before && place.pixel.x >= knobMargin && place.pixel.y >= knobMargin &&
         place.pixel.x <= stage.pixels.x - knobMargin && place.pixel.y <= stage.pixels.y - knobMargin;
}

// What of a line lies before the eye.
std::optional<CutLine> lineOn(const CutStage& stage, glm::dvec3 a, glm::dvec3 b, bool far) {
  if (stage.frame.projection == scene::Projection::perspective) {
    const double least = 1e-3 * stage.frame.distance;
    const double depthA = -glm::dot(a - stage.frame.eye, stage.frame.back),
                 depthB = -glm::dot(b - stage.frame.eye, stage.frame.back);
    if (depthA < least && depthB < least) return std::nullopt;
    const double at = (least - depthA) / (depthB - depthA);
    if (depthA < least) a = glm::mix(a, b, at);
    if (depthB < least) b = glm::mix(a, b, at);
  }
  return CutLine{projectedOn(stage, a).pixel, projectedOn(stage, b).pixel, far};
}

double distanceTo(const CutLine& line, glm::dvec2 pixel) {
  const glm::dvec2 way = line.to - line.from;
  const double length2 = glm::dot(way, way);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(pixel - line.from, way) / length2, 0.0, 1.0) : 0.0;
  return glm::distance(pixel, line.from + t * way);
}

bool facesEye(const CutStage& stage, const glm::dvec3& point, const glm::dvec3& normal) {
  if (stage.frame.projection == scene::Projection::orthographic)
    return glm::dot(normal, stage.frame.back) > 0.0;
  return glm::dot(normal, stage.frame.eye - point) > 0.0;
}

CutShape planeShape(const scene::Clip& clip, std::size_t plane, const CutStage& stage) {
  const int number = static_cast<int>(plane) + 1;
  CutShape shape{number, {}, {}};
  const std::vector<glm::dvec3> outline = faceOf(clip, plane, stage.volumeMm);
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (const auto line = lineOn(stage, outline[i], outline[(i + 1) % outline.size()], false))
      shape.outline.push_back(*line);
  const glm::dvec3 knob = knobOf(clip, plane, stage), normal = glm::normalize(clip.planes[plane].normal);
  const ProjectedPoint place = projectedOn(stage, knob);
  if (!onPicture(place, stage)) return shape;
  const ProjectedPoint tip = projectedOn(stage, knob + kCutArrow * place.mmPerPixel * normal);
  glm::dvec2 arrow = tip.before ? tip.pixel - place.pixel : glm::dvec2(0.0);
  const double length = glm::length(arrow);
  if (length < kCutArrowLeast)
    arrow = kCutArrowLeast * (length > 1.0 ? arrow / length : glm::dvec2(0.0, -1.0));
  const bool away = !facesEye(stage, knob, normal);
  shape.knobs.push_back({{number, CutPart::move, 0}, place.pixel, false});
  shape.knobs.push_back({{number, CutPart::turn, 0}, place.pixel + arrow, away});
  return shape;
}

CutShape boxShape(const scene::Clip& clip, int number, const CutStage& stage) {
  CutShape shape{number, {}, {}};
  const TurnedBox box = turnedBox(clip, number);
  bool faces[6];
  for (int face = 0; face < 6; ++face) faces[face] = facesEye(stage, box.faceMiddle(face), box.outward(face));
  const auto seen = [&](int corner, int axis) { return faces[2 * axis + ((corner >> axis) & 1)]; };
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      if ((i >> axis) & 1) continue;
      const bool far = !seen(i, (axis + 1) % 3) && !seen(i, (axis + 2) % 3);
      if (const auto line = lineOn(stage, box.corner(i), box.corner(i | (1 << axis)), far))
        shape.outline.push_back(*line);
    }
  const auto add = [&](CutPart part, int index, const glm::dvec3& at, bool far) {
    const ProjectedPoint place = projectedOn(stage, at);
    if (onPicture(place, stage)) shape.knobs.push_back({{number, part, index}, place.pixel, far});
  };
  for (int i = 0; i < 8 && number == 0; ++i)
    add(CutPart::turn, i, box.corner(i), !seen(i, 0) && !seen(i, 1) && !seen(i, 2));
  for (int face = 0; face < 6; ++face) add(CutPart::face, face, box.faceMiddle(face), !faces[face]);
  add(CutPart::move, 0, box.middle, false);
  return shape;
}

}  // namespace

CutStage cutStageOf(const scene::Scene& resolved, const volume::GridGeometry& geometry, glm::dvec2 pixels) {
  return {scene::frameOf(resolved.camera), glm::max(pixels, glm::dvec2(1.0)), geometry.corners()};
}

ProjectedPoint projectedOn(const CutStage& stage, const glm::dvec3& world) {
  const scene::CameraFrame& frame = stage.frame;
  const glm::dvec3 v = world - frame.eye;
  const bool perspective = frame.projection == scene::Projection::perspective;
  ProjectedPoint place;
  place.depthMm = -glm::dot(v, frame.back);
  place.before = !perspective || place.depthMm > 1e-6 * frame.distance;
  place.mmPerPixel = 2.0 * frame.halfHeight / stage.pixels.y *
                     (!perspective   ? 1.0
                      : place.before ? place.depthMm
                                     : frame.distance);
  place.pixel =
      0.5 * stage.pixels + glm::dvec2(glm::dot(v, frame.right), -glm::dot(v, frame.up)) / place.mmPerPixel;
  return place;
}

glm::dvec3 knobOf(const scene::Clip& clip, std::size_t number, const CutStage& stage) {
  const scene::ClipPlane& plane = clip.planes[number];
  const glm::dvec3 middle = middleOfFace(clip, number, stage.volumeMm);
  if (onPicture(projectedOn(stage, middle), stage)) return middle;
  const scene::Ray ray = scene::rayThrough(stage.frame, {0.0, 0.0}, stage.pixels.x / stage.pixels.y);
  const double along = glm::dot(plane.normal, ray.direction);
  if (std::abs(along) < 0.1 * glm::length(plane.normal)) return middle;  // seen from its edge
  const double t = glm::dot(plane.normal, plane.point - ray.origin) / along;
  if (!(t > 0.0) || outlineOf(plane, stage.volumeMm).empty()) return middle;
  return ray.origin + t * ray.direction;
}

std::vector<CutShape> cutShapes(const scene::Clip& clip, const CutStage& stage) {
  std::vector<CutShape> shapes;
  if (clip.box.size() == 2) shapes.push_back(boxShape(clip, 0, stage));
  for (int i = 1; 2 * static_cast<std::size_t>(i) <= clip.removed.size(); ++i)
    shapes.push_back(boxShape(clip, -i, stage));
  for (std::size_t i = 0; i < clip.planes.size(); ++i) shapes.push_back(planeShape(clip, i, stage));
  return shapes;
}

std::optional<CutGrip> cutAt(const std::vector<CutShape>& shapes, glm::dvec2 pixel) {
  std::optional<CutGrip> nearest;
  double least = knobReach;
  bool leastFar = true;
  // What is painted later lies on top; what is seen goes before what is behind the box.
  for (const CutShape& shape : shapes)
    for (const CutKnob& knob : shape.knobs) {
      const double distance = glm::distance(knob.pixel, pixel);
      if (distance > knobReach) continue;
      if (nearest && (knob.far != leastFar ? knob.far : distance > least)) continue;
      least = distance;
      leastFar = knob.far;
      nearest = knob.grip;
    }
  if (nearest) return nearest;
  least = outlineReach;
  for (const CutShape& shape : shapes)
    for (const CutLine& line : shape.outline) {
      if (shape.plane <= 0 || distanceTo(line, pixel) > least) continue;
      least = distanceTo(line, pixel);
      nearest = CutGrip{shape.plane, CutPart::move, 0};
    }
  return nearest;
}

}  // namespace isolux::app
