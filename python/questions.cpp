#include "python/questions.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/report/label_measures.h"
#include "app/report/measure_report.h"
#include "base/error.h"
#include "base/number_text.h"
#include "volume/clip/surface_cut.h"
#include "volume/hit/exact_hit.h"
#include "volume/labels/mask_field.h"
#include "volume/measure/point_probe.h"
#include "volume/measure/surface_point.h"
#include "volume/measure/voxel_noise.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::python {

namespace py = pybind11;

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPiece = 256;  // rays or points at a time: a stop is heard between

// What all rays of a question have in common.
struct Question {
  const volume::PreparedVolume& prepared;
  const volume::SurfaceOf& surface;
  const volume::SurfaceCut& cut;
  glm::dmat4 voxelFromWorld;
};

// Returns why lengths are doubtful. Throws Error{input} if they are, unless that is to be accepted.
std::optional<std::string> refuseDoubt(const Core& core, bool anyway) {
  auto doubt = volume::spacingDoubt(core.prepared()->volume.warnings);
  if (doubt && !anyway)
    base::throwInput(core.path(), "",
                     "lengths are doubtful: " + *doubt + "; anyway=True measures all the same");
  return doubt;
}

void hitOne(const Question& question, glm::dvec3 origin, glm::dvec3 given, std::size_t i, Hits& hits) {
  const double length = glm::length(given);
  if (!(length > 0.0) || !std::isfinite(length)) return;
  const glm::dvec3 direction = glm::normalize(given);
  const glm::dvec3 from(question.voxelFromWorld * glm::dvec4(origin, 1.0)),
      along(question.voxelFromWorld * glm::dvec4(direction, 0.0));
  const double isovalue = question.surface.isovalue;
  std::optional<volume::RayHit> hit;
  for (const auto& [begin, end] : question.cut.segmentsOf(isovalue, {from, along})) {
    hit = firstHit(question.prepared.grid(), *question.prepared.blocks, isovalue, {from, along, begin, end});
    if (hit) break;
  }
  if (!hit) return;
  hits.t[i] = hit->t;
  hits.position[i] = origin + direction * hit->t;
  hits.valueError[i] = hit->valueError;
  hits.entering[i] = hit->entering == (question.surface.inside == scene::Inside::above);
  const auto point = surfacePoint(question.surface, hits.position[i]);
  if (!point) return;
  hits.normal[i] = point->normal;
  const double cosine = std::abs(glm::dot(point->normal, direction));
  if (cosine > 0.0) hits.error[i] = offsetError(*point) / cosine;
}

}  // namespace

Hits hits(Core& core, const app::SceneOptions& options, std::vector<glm::dvec3> origins,
          std::vector<glm::dvec3> directions, const py::object& told) {
  return core.ask(
      options,
      [origins = std::move(origins), directions = std::move(directions), prepared = core.prepared()](
          const scene::Scene& scene, base::Progress& progress) {
        const std::size_t count = origins.size();
        Hits hits;
        hits.t.assign(count, kNothing);
        hits.error = hits.valueError = hits.t;
        hits.position.assign(count, glm::dvec3(kNothing));
        hits.normal = hits.position;
        hits.entering.assign(count, 0);
        const double isovalue = scene.surfaces.front().value.value();
        const volume::SurfaceOf surface{
            prepared->grid(),
            isovalue,
            scene.isosurface.inside,
            {{isovalue}, {scene.derivatives.noise.value_or(0.0)}, glm::dvec3(0.0)}};
        const volume::SurfaceCut cut(scene, prepared->grid().geometry());
        const Question question{*prepared, surface, cut, prepared->grid().geometry().voxelFromWorld()};
        volume::parallelPieces(count, kPiece, progress, {0.0, 1.0, "casting rays"},
                               [&](std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end; ++i)
                                   hitOne(question, origins[i], directions[i], i, hits);
                               });
        return hits;
      },
      told);
}

Probed probe(Core& core, const app::SceneOptions& options, std::vector<glm::dvec3> points,
             const py::object& told) {
  return core.ask(
      options,
      [points = std::move(points), prepared = core.prepared()](const scene::Scene& scene,
                                                               base::Progress& progress) {
        const std::size_t count = points.size();
        Probed probed;
        probed.value.assign(count, kNothing);
        probed.confidence = probed.value;
        probed.gradient.assign(count, glm::dvec3(kNothing));
        probed.normal = probed.gradient;
        probed.hessian.assign(count,
                              glm::dmat3(glm::dvec3(kNothing), glm::dvec3(kNothing), glm::dvec3(kNothing)));
        probed.kappa.assign(count, glm::dvec2(kNothing));
        probed.scaleMm = scene.derivatives.scale.value_or(0.0);
        const volume::PointProbe probe(prepared, scene, progress);
        volume::parallelPieces(count, kPiece, progress, {0.0, 1.0, "probing"},
                               [&](std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end; ++i) {
                                   const auto point = probe.at(points[i]);
                                   if (!point) continue;
                                   probed.value[i] = point->value;
                                   probed.gradient[i] = point->gradient;
                                   probed.hessian[i] = point->hessian;
                                   probed.confidence[i] = point->confidence;
                                   if (point->curvature.normal == glm::dvec3(0.0)) continue;
                                   probed.normal[i] = point->curvature.normal;
                                   probed.kappa[i] = {point->curvature.kappa1, point->curvature.kappa2};
                                 }
                               });
        return probed;
      },
      told);
}

std::string measure(Core& core, const app::SceneOptions& options, bool anyway, const py::object& told) {
  const auto doubt = refuseDoubt(core, anyway);
  return core.ask(
      options,
      [doubt, prepared = core.prepared()](const scene::Scene& scene, base::Progress& progress) {
        app::refuseCuts(scene, "measure");
        const volume::SurfaceQuestion question{scene.surfaces.front().value.value(),
                                               scene.isosurface.inside,
                                               std::nullopt,
                                               volume::voxelNoise(*prepared, scene, progress),
                                               {}};
        const app::SizedSurface sized = app::sizedSurface(*prepared, scene, question, progress);
        if (sized.whole.cells == 0)
          base::throwUsage("", "isovalue " + base::shortText(question.isovalue),
                           volume::whyNoSurface(prepared->grid()));
        return app::surfaceJson(*prepared, question, sized, doubt).dump();
      },
      told);
}

std::string measureLabels(Core& core, double smoothing, bool anyway, const py::object& told) {
  if (!(smoothing >= 0.0 && smoothing <= volume::kMostSmoothing))
    base::throwUsage("", "smoothing", "must be from 0 to 2 voxels");
  refuseDoubt(core, anyway);
  return core.ask(
      {},
      [smoothing, file = core.path(), prepared = core.prepared()](const scene::Scene&,
                                                                  base::Progress& progress) {
        return app::labelMeasuresJson(*prepared, file, smoothing, true, progress).dump();
      },
      told);
}

}  // namespace isolux::python
