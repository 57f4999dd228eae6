#include "app/view_math/mark_view.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "app/view_math/surface_pick.h"

namespace isolux::app {

namespace {

using scene::MarkKind;

constexpr std::size_t kMostCorners = 128;
constexpr int kCircleCorners = 96;

double depthOf(const scene::CameraFrame& frame, glm::dvec3 world) {
  return -glm::dot(world - frame.eye, frame.back);
}

std::vector<glm::dvec3> thinned(const std::vector<glm::dvec3>& corners) {
  if (corners.size() <= kMostCorners) return corners;
  std::vector<glm::dvec3> fewer;
  for (std::size_t i = 0; i < kMostCorners; ++i)
    fewer.push_back(corners[i * (corners.size() - 1) / (kMostCorners - 1)]);
  return fewer;
}

MarkLine circleLine(glm::dvec3 centre, glm::dvec3 normal, glm::dvec3 through) {
  const glm::dvec3 u = through - centre, v = glm::cross(normal, u);
  MarkLine line;
  for (int i = 0; i <= kCircleCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCircleCorners;
    line.corners.push_back(centre + std::cos(angle) * u + std::sin(angle) * v);
  }
  return line;
}

std::vector<MarkLine> linesOf(const scene::Mark& mark, const MarkReport& report) {
  const auto& p = mark.points;
  switch (mark.kind) {
    case MarkKind::path:
      if (!report.line.empty()) return {{thinned(report.line), true, {}}};
      return {{p, false, {}}};
    case MarkKind::circle:
      if (report.centre && !p.empty()) return {circleLine(*report.centre, report.normal, p.front())};
      return {{p, false, {}}};
    case MarkKind::angle:
      if (p.size() == 4) return {{{p[0], p[1]}, false, {}}, {{p[2], p[3]}, false, {}}};
      return {{p, false, {}}};
    case MarkKind::thickness:
      return {{report.line, false, {}}};
    case MarkKind::distance:
      return {{p, false, {}}};
    case MarkKind::point:
    case MarkKind::piece:
      break;
  }
  return {};
}

glm::dvec3 anchorOf(const scene::Mark& mark, const MarkReport& report) {
  const auto& p = mark.points;
  switch (mark.kind) {
    case MarkKind::path:
      if (!report.line.empty()) return report.line[report.line.size() / 2];
      [[fallthrough]];
    case MarkKind::distance:
      return p.size() == 2 ? 0.5 * (p[0] + p[1]) : p[p.size() / 2];
    case MarkKind::angle:
      return p.size() == 3 ? p[1] : p.front();
    default:
      return p.front();
  }
}

}  // namespace

std::optional<glm::dvec2> pixelOf(const scene::CameraFrame& frame, glm::dvec3 worldMm, glm::dvec2 size) {
  const glm::dvec3 v = worldMm - frame.eye;
  const double depth = frame.projection == scene::Projection::perspective ? depthOf(frame, worldMm) : 1.0;
  if (!(depth > 1e-9 * frame.distance)) return std::nullopt;
  const double scale = 0.5 * size.y / (frame.halfHeight * depth);
  return glm::dvec2(0.5 * size.x + scale * glm::dot(v, frame.right),
                    0.5 * size.y - scale * glm::dot(v, frame.up));
}

bool isBehindSurface(const volume::PreparedVolume& volume, const scene::Scene& resolved, glm::dvec3 worldMm,
                     double aspect) {
  const scene::CameraFrame frame = scene::frameOf(resolved.camera);
  const auto pixel = pixelOf(frame, worldMm, {2.0 * aspect, 2.0});
  if (!pixel) return false;
  const auto pick = pickSurface(volume, resolved, {pixel->x / aspect - 1.0, 1.0 - pixel->y}, aspect);
  const double slack = 0.5 * glm::length(volume.grid().geometry().spacingMm());
  return pick && depthOf(frame, pick->worldMm) < depthOf(frame, worldMm) - slack;
}

MarkShape markShape(const scene::Mark& mark, const MarkReport& report) {
  MarkShape shape;
  shape.points.corners = mark.points;
  if (mark.kind == MarkKind::thickness && report.line.size() == 2)
    shape.points.corners.push_back(report.line.back());
  shape.lines = linesOf(mark, report);
  shape.anchor = anchorOf(mark, report);
  shape.label = mark.name;
  if (report.problem.empty())
    if (const std::string value = summaryText(report); !value.empty())
      shape.label += (shape.label.empty() ? "" : "  ") + value;
  shape.color = mark.color;
  return shape;
}

}  // namespace isolux::app
