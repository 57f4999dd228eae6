#include "app/jobs/piece_job.h"

#include "app/process/caught_error.h"
#include "volume/measure/voxel_noise.h"
#include "volume/pieces/piece_seeds.h"

namespace isolux::app {

PieceJob::PieceJob(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
                   double isovalue, bool measured)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->volume = std::move(volume);
            work->scene = resolved;
            work->isovalue = isovalue;
            work->measured = measured;
            return work;
          }(),
          run) {}

PieceJob::~PieceJob() {
  work_->progress.requestStop();
}

bool PieceJob::isFor(const volume::PreparedVolume* volume, double isovalue, scene::Inside inside) const {
  return work_->volume.get() == volume && work_->isovalue == isovalue &&
         work_->scene.isosurface.inside == inside;
}

void PieceJob::find(Work& work) {
  const volume::PreparedVolume& volume = *work.volume;
  const scene::Inside inside = work.scene.isosurface.inside;
  work.found.pieces = volume.pieces->at(work.isovalue, inside, work.progress);
  if (!work.measured) return;
  const volume::SurfaceQuestion question{
      work.isovalue, inside, std::nullopt, voxelNoise(volume, work.scene, work.progress), {}};
  work.found.measures = measurePieces(*work.found.pieces, *volume.blocks, question, {}, work.progress).pieces;
  for (const glm::ivec3& seed : pieceSeeds(*work.found.pieces, work.progress))
    work.found.seedsMm.push_back(volume.grid().geometry().worldOf(seed));
}

void PieceJob::run(Work& work) {
  work.error = caughtError(work.volume->volume.name, "find the connected components of the isosurface",
                           [&] { find(work); });
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
