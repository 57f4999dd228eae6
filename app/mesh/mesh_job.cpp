#include "app/mesh/mesh_job.h"

#include <new>
#include <utility>

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
  try {
    work.made = exportMesh(work.wish, work.resolved, *work.volume, work.progress);
  } catch (const base::Error& error) {
    work.error = error;
  } catch (const std::bad_alloc&) {
    work.error.emplace(base::ErrorKind::memory, work.wish.file.string(), "",
                       "not enough memory for this mesh");
  } catch (const std::exception& error) {
    work.error.emplace(base::ErrorKind::input, work.wish.file.string(), "", error.what());
  }
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
