// Exports a mesh (app/mesh/mesh_export.h) on a thread of its own; the owner polls.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/mesh/mesh_export.h"
#include "base/error.h"
#include "base/retire.h"

namespace isolux::app {

class MeshJob {
 public:
  // Starts at once. `resolved` by scene::resolve of that volume.
  MeshJob(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved, MeshWish wish);
  ~MeshJob();  // stops; the end of the work is not waited for (base/retire.h)

  const MeshWish& wish() const { return work_->wish; }
  base::Progress& progress() { return work_->progress; }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): what was written, or what went wrong (interrupted: it was stopped, nothing is written).
  const volume::SurfaceMesh& made() const { return work_->made; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene resolved;
    MeshWish wish;
    base::Progress progress;
    std::atomic<bool> finished{false};
    volume::SurfaceMesh made;
    std::optional<base::Error> error;
  };
  static void run(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
