// Finds the pieces of an isosurface on a background thread, and measures them where that is asked for. What
// is found stays with the volume (volume/pieces/piece_sets.h).
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "base/task.h"
#include "scene/scene.h"
#include "volume/measure/piece_measure.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Names the isosurface whose components are wanted.
struct PieceSubject {
  std::shared_ptr<const volume::PreparedVolume> volume;
  double isovalue = 0.0;  // data units
  scene::Inside inside = scene::Inside::above;
  bool operator==(const PieceSubject&) const = default;
};
struct FoundPieces {
  std::shared_ptr<const volume::Pieces> pieces;
  // Hold for each, where asked for, what `isolux info --pieces` prints, and its seed, world mm.
  std::vector<volume::PieceMeasure> measures;
  std::vector<glm::dvec3> seedsMm;
};
using PieceTask = base::Task<FoundPieces>;
// `resolved` says the noise, if it is set.
std::unique_ptr<PieceTask> pieceTask(PieceSubject asked, scene::Scene resolved, bool measured);

}  // namespace isolux::app
