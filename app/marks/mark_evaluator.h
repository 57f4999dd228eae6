// What marks say of a volume and the isosurfaces of a scene.
//
// A mark's points stay where they are in mm, whatever the isovalue is. What needs the surface (a way along
// it, a thickness, a piece) takes the isosurface that is nearest to the mark's first point among those that
// are shown, and of that the point nearest to the mark's; how far that is off is said in a note once it is
// more than half a voxel's diagonal. Definitions and errors: volume/measure, docs/explanation/measurement.md.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/marks/mark_report.h"
#include "base/task.h"
#include "scene/scene.h"
#include "volume/edge/surface_edges.h"
#include "volume/measure/piece_measure.h"
#include "volume/measure/point_probe.h"
#include "volume/measure/points.h"
#include "volume/measure/surface_graph.h"
#include "volume/measure/surface_point.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Whether a mark of this kind may take long: more than a look at a few voxels.
bool isSlow(scene::MarkKind kind);

// Keeps what several marks need (graph, pieces, fields) once it is made. Used by one thread at a time.
class MarkEvaluator {
 public:
  // `resolved`: scene::resolve() of this volume. anyway: lengths are measured though they are doubtful.
  MarkEvaluator(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
                bool anyway = false);

  // Of the same volume and of a scene whose marks say the same: the camera and the look do not matter.
  bool isFor(const std::shared_ptr<const volume::PreparedVolume>& volume, const scene::Scene& resolved) const;

  // A wrong number of points, doubtful lengths, and points without a surface are the report's problem.
  // Throws Error: interrupted, memory.
  MarkReport evaluate(const scene::Mark& mark, base::Progress& progress);

 private:
  struct Surface {
    int number;  // its position in the list, from 1
    volume::SurfaceOf of;
    std::optional<volume::SurfaceGraph> graph{};
    std::shared_ptr<const volume::Pieces> pieces{};
    std::optional<volume::PieceMeasures> sizes{};
  };
  struct Placed {  // a point of a mark, and the surface's nearest to it
    volume::UncertainPoint at;
    std::optional<volume::SurfacePoint> onSurface;
  };
  Surface& nearestSurface(glm::dvec3 world);
  std::vector<Placed> placed(const Surface& surface, const scene::Mark& mark) const;
  const volume::SurfaceGraph& graphOf(Surface& surface, base::Progress& progress) const;
  void measureNoise(base::Progress& progress);
  void addNotes(const Surface& surface, const std::vector<Placed>& points, MarkReport& report) const;
  bool onSurface(const Surface& surface, const std::vector<Placed>& points, MarkReport& report) const;

  void point(const scene::Mark& mark, MarkReport& report, base::Progress& progress);
  void addShape(glm::dvec3 world, MarkReport& report, base::Progress& progress);
  void distance(const std::vector<Placed>& points, MarkReport& report) const;
  void path(Surface& surface, const std::vector<Placed>& points, MarkReport& report,
            base::Progress& progress) const;
  void angle(const std::vector<Placed>& points, MarkReport& report) const;
  void circle(const std::vector<Placed>& points, MarkReport& report) const;
  void thickness(Surface& surface, const Placed& point, MarkReport& report, base::Progress& progress) const;
  void piece(Surface& surface, const Placed& point, MarkReport& report, base::Progress& progress) const;

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Scene scene_;
  std::optional<std::string> doubt_;
  bool anyway_, noiseMeasured_ = false;
  std::vector<Surface> surfaces_;
  std::optional<volume::PointProbe> probe_;
  std::optional<volume::SurfaceEdges> edges_;
  std::optional<double> curvatureNoise_;  // standard deviation, 1/mm, at the scale that is used
};

// Measures marks on a background thread, the quick ones first. Its news: which of the marks have been
// measured, with their reports. What failed, as for want of memory, is the mark's problem. Nobody else uses
// the evaluator until it has finished.
using MarkTask = base::Task<void, std::vector<std::pair<std::size_t, MarkReport>>>;
std::unique_ptr<MarkTask> markTask(std::shared_ptr<MarkEvaluator> evaluator, std::vector<scene::Mark> marks);

}  // namespace isolux::app
