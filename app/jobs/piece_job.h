// Finds the pieces of an isosurface on a background thread, and measures them where that is asked for; the
// owner polls. What is found stays with the volume (volume/pieces/piece_sets.h).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
#include "scene/scene.h"
#include "volume/measure/piece_measure.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

class PieceJob {
 public:
  struct Found {
    std::shared_ptr<const volume::Pieces> pieces;
    // Of each, where asked for: what `isolux info --pieces` says, and its seed, world mm.
    std::vector<volume::PieceMeasure> measures;
    std::vector<glm::dvec3> seedsMm;
  };

  // Starts at once. isovalue: data units; `resolved` says which side is inside, and the noise if it is set.
  PieceJob(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
           double isovalue, bool measured);
  ~PieceJob();  // stops; the thread ends elsewhere
  PieceJob(const PieceJob&) = delete;
  PieceJob& operator=(const PieceJob&) = delete;

  bool isFor(const volume::PreparedVolume* volume, double isovalue, scene::Inside inside) const;
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  const base::Progress& progress() const { return work_->progress; }
  // After finished(): what was found, or why not.
  const Found& found() const { return work_->found; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene scene;
    double isovalue = 0.0;
    bool measured = false;
    base::Progress progress;
    std::atomic<bool> finished{false};
    Found found;
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void find(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
