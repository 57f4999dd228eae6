#include "app/mesh/mesh_job.h"

#include <utility>

#include "app/process/caught_error.h"

namespace isolux::app {

MeshJob::MeshJob(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved, MeshWish wish)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->volume = std::move(volume);
            work->resolved = std::move(resolved);
            work->wish = std::move(wish);
            return work;
          }(),
          run) {}

MeshJob::~MeshJob() {
  work_->progress.requestStop();
}

void MeshJob::run(Work& work) {
  work.error = caughtError(work.wish.file.string(), "make the mesh", [&] {
    work.made = exportMesh(work.wish, work.resolved, *work.volume, work.progress);
  });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
