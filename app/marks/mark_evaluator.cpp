#include "app/marks/mark_evaluator.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "app/marks/mark_kinds.h"
#include "base/decimal_text.h"
#include "base/number_text.h"
#include "volume/measure/voxel_noise.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::app {

namespace {

using scene::MarkKind;
using volume::SurfacePoint;

// All that marks depend on, of a scene.
scene::Scene measuredPart(const scene::Scene& scene) {
  scene::Scene part;
  part.isosurface.inside = scene.isosurface.inside;
  part.surfaces.clear();  // all that is not copied stays at its default
  for (const scene::Surface& surface : scene.surfaces) {
    const bool measured = part.surfaces.empty() || surface.shown;
    part.surfaces.push_back({.shown = measured, .value = measured ? surface.value : std::nullopt});
  }
  part.hit.field = scene.hit.field;
  part.derivatives = scene.derivatives;
  part.edge = scene.edge;
  return part;
}

// Positions of files that state where the patient lies have letters: "L 12.3, P 4.5, S 6.7 mm".
std::string placeOf(scene::WorldAxes axes, glm::dvec3 world) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const bool letters = axes == scene::WorldAxes::anatomical;
    const std::string number = base::fixedText(letters ? std::abs(world[axis]) : world[axis], 2);
    const std::string name = letters ? scene::axisEnd(axes, axis, world[axis] >= 0.0)
                                     : std::string(1, static_cast<char>('X' + axis));
    text += (text.empty() ? "" : ", ") + name + ' ' + number;
  }
  return text + " mm";
}

double halfDiagonal(const volume::Grid& grid) {
  return 0.5 * glm::length(grid.geometry().spacingMm());
}

MarkReport reportOf(MarkEvaluator& evaluator, const scene::Mark& mark, base::Progress& progress) {
  MarkReport report;
  const auto error = base::caughtError("", "measure", [&] { report = evaluator.evaluate(mark, progress); });
  if (error && error->kind() == base::ErrorKind::interrupted) throw *error;
  if (error) report.problem = error->what();
  return report;
}

}  // namespace

bool isSlow(MarkKind kind) {
  return kind == MarkKind::path || kind == MarkKind::thickness || kind == MarkKind::piece ||
         kind == MarkKind::point;
}

MarkEvaluator::MarkEvaluator(std::shared_ptr<const volume::PreparedVolume> volume,
                             const scene::Scene& resolved, bool anyway)
    : volume_(std::move(volume)),
      scene_(measuredPart(resolved)),
      doubt_(volume::spacingDoubt(volume_->volume.warnings)),
      anyway_(anyway) {
  const scene::Inside inside = scene_.isosurface.inside;
  const auto add = [&](int number, const std::optional<double>& value) {
    surfaces_.push_back(
        {number, {volume_->grid(), value.value_or(volume_->facts.suggestedIsovalue), inside, {}}});
  };
  for (std::size_t i = 0; i < scene_.surfaces.size(); ++i)
    if (scene_.surfaces[i].shown) add(static_cast<int>(i) + 1, scene_.surfaces[i].value);
}

bool MarkEvaluator::isFor(const std::shared_ptr<const volume::PreparedVolume>& volume,
                          const scene::Scene& resolved) const {
  return volume == volume_ && measuredPart(resolved) == scene_;
}

void MarkEvaluator::measureNoise(base::Progress& progress) {
  if (noiseMeasured_) return;
  const scene::NoiseModel noise = voxelNoise(*volume_, scene_, progress);
  for (Surface& surface : surfaces_) surface.of.noise = noise;
  noiseMeasured_ = true;
}

MarkEvaluator::Surface& MarkEvaluator::nearestSurface(glm::dvec3 world) {
  Surface* nearest = &surfaces_.front();
  double least = std::numeric_limits<double>::infinity();
  for (Surface& surface : surfaces_) {
    const auto point = nearestPoint(surface.of, world);
    if (!point || !(glm::length(point->world - world) < least)) continue;
    least = glm::length(point->world - world);
    nearest = &surface;
  }
  return *nearest;
}

std::vector<MarkEvaluator::Placed> MarkEvaluator::placed(const Surface& surface,
                                                         const scene::Mark& mark) const {
  std::vector<Placed> points;
  const double reach = halfDiagonal(surface.of.grid);
  for (const glm::dvec3& world : mark.points) {
    const auto near = nearestPoint(surface.of, world);
    const bool on = near && glm::length(near->world - world) <= reach;
    points.push_back({{world, on ? offsetError(*near) : 0.0}, near});
  }
  return points;
}

// Said of each point that is none of the surface: the mark stays where it was set, its surface does not.
void MarkEvaluator::addNotes(const Surface& surface, const std::vector<Placed>& points,
                             MarkReport& report) const {
  const double reach = halfDiagonal(surface.of.grid);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Placed& point = points[i];
    const std::string which = points.size() == 1 ? "the point" : "point " + std::to_string(i + 1);
    if (!point.onSurface) {
      report.notes.push_back(which + " is not on the surface: no surface within three voxels");
      continue;
    }
    const double off = glm::length(point.onSurface->world - point.at.world);
    if (off > reach)
      report.notes.push_back(which + " lies " + base::shortText(off, 2) + " mm off the surface");
  }
}

bool MarkEvaluator::onSurface(const Surface& surface, const std::vector<Placed>& points,
                              MarkReport& report) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].onSurface) continue;
    report.problem = "no isosurface of " + base::shortText(surface.of.isovalue) + " within three voxels of " +
                     (points.size() == 1 ? "the point" : "point " + std::to_string(i + 1));
    report.notes.clear();
    return false;
  }
  return true;
}

const volume::SurfaceGraph& MarkEvaluator::graphOf(Surface& surface, base::Progress& progress) const {
  if (!surface.graph)
    surface.graph = surfaceGraph(surface.of.grid, *volume_->blocks, surface.of.isovalue, progress);
  return *surface.graph;
}

MarkReport MarkEvaluator::evaluate(const scene::Mark& mark, base::Progress& progress) {
  MarkReport report;
  report.problem = wrongPoints(mark);
  if (!report.problem.empty()) return report;
  if (doubt_ && !anyway_ && mark.kind != MarkKind::point) {
    report.problem = "lengths are doubtful: " + *doubt_;
    return report;
  }
  if (doubt_) report.notes.push_back("lengths are doubtful: " + *doubt_);
  if (const auto apart = volume::widestSlicesMm(volume_->volume.warnings))
    report.notes.push_back("slices are up to " + base::shortText(*apart, 3) +
                           " mm apart: the error includes what may be between them");
  measureNoise(progress);
  if (mark.kind == MarkKind::point) {
    point(mark, report, progress);
    return report;
  }
  Surface& surface = nearestSurface(mark.points.front());
  const std::vector<Placed> points = placed(surface, mark);
  addNotes(surface, points, report);
  switch (mark.kind) {
    case MarkKind::distance:
      distance(points, report);
      break;
    case MarkKind::path:
      if (onSurface(surface, points, report)) path(surface, points, report, progress);
      break;
    case MarkKind::angle:
      angle(points, report);
      break;
    case MarkKind::circle:
      circle(points, report);
      break;
    case MarkKind::thickness:
      if (onSurface(surface, points, report)) thickness(surface, points.front(), report, progress);
      break;
    case MarkKind::piece:
      piece(surface, points.front(), report, progress);
      break;
    case MarkKind::point:
      break;
  }
  return report;
}

void MarkEvaluator::point(const scene::Mark& mark, MarkReport& report, base::Progress& progress) {
  const glm::dvec3 world = mark.points.front();
  const Surface& surface = nearestSurface(world);
  const std::vector<Placed> points = placed(surface, mark);
  report.place = placeOf(volume_->volume.axes, world);
  const Placed& at = points.front();
  const bool on = at.onSurface && glm::length(at.onSurface->world - world) <= halfDiagonal(volume_->grid());
  addNotes(surface, points, report);
  addShape(world, report, progress);
  const std::optional<double> error = on ? std::optional(at.at.errorMm) : std::nullopt;
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) report.quantities.push_back({names[axis], world[axis], error, "mm"});
  if (!at.onSurface) return;
  report.quantities.push_back({"surface", static_cast<double>(surface.number), {}, ""});
  report.quantities.push_back(
      {"surface_distance", glm::length(at.onSurface->world - world), offsetError(*at.onSurface), "mm"});
}

// Value, curvature and edge, from the fields that pictures take them from.
void MarkEvaluator::addShape(glm::dvec3 world, MarkReport& report, base::Progress& progress) {
  if (!probe_) {
    const volume::DerivativeQuestion question{surfaces_.front().of.isovalue, scene_.derivatives.field,
                                              scene_.derivatives.noise};
    scene::Scene complete = scene_;
    complete.surfaces.front().value = surfaces_.front().of.isovalue;
    volume_->derivativeChoices->complete(complete, progress);
    const auto choice = volume_->derivativeChoices->find(question);
    const double scale = complete.derivatives.scale.value_or(0.0);
    if (choice && scale == choice->scaleMm) curvatureNoise_ = choice->curvatureNoise[1];
    if (choice && scale == 0.0) curvatureNoise_ = choice->curvatureNoise[0];
    edges_.emplace(volume_, complete, progress);
    probe_.emplace(volume_, complete, progress);
  }
  const auto found = probe_->at(world);
  auto& list = report.quantities;
  if (!found) {
    report.problem = "the point is outside the volume or next to missing voxels";
    return;
  }
  const double noise = surfaces_.front().of.noise.at(found->value);
  list.push_back({"value", found->value, 2.0 * noise, volume_->volume.unit});
  const char* const voxels[] = {"voxel_i", "voxel_j", "voxel_k"};
  for (int axis = 0; axis < 3; ++axis) list.push_back({voxels[axis], found->voxel[axis], {}, ""});
  if (found->curvature.normal == glm::dvec3(0.0)) return;
  const auto error = curvatureNoise_ ? std::optional(2.0 * *curvatureNoise_) : std::nullopt;
  list.push_back({"kappa1", found->curvature.kappa1, error, "1/mm"});
  list.push_back({"kappa2", found->curvature.kappa2, error, "1/mm"});
  list.push_back({"confidence", found->confidence, {}, ""});
  list.push_back({"scale", found->scaleMm, {}, "mm"});
  const char* const normals[] = {"normal_x", "normal_y", "normal_z"};
  for (int axis = 0; axis < 3; ++axis) list.push_back({normals[axis], found->curvature.normal[axis], {}, ""});
  const volume::Edge edge = edges_->finder().at(found->voxel);
  if (edge.offsetMm) list.push_back({"edge_offset", *edge.offsetMm, {}, "mm"});
  list.push_back({"edge_strength", edge.strength, {}, ""});
}

std::unique_ptr<MarkTask> markTask(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks) {
  const auto work = [evaluator = std::move(evaluator), marks = std::move(marks)](base::Progress& progress,
                                                                                 const auto& tell) {
    for (const bool slow : {false, true})
      for (std::size_t i = 0; i < marks.size(); ++i) {
        if (isSlow(marks[i].kind) != slow) continue;
        MarkReport report = reportOf(*evaluator, marks[i], progress);
        tell([&](auto& reports) { reports.emplace_back(i, std::move(report)); });
      }
  };
  return MarkTask::start({"", "measure"}, work);
}

}  // namespace isolux::app
