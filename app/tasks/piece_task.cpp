#include "app/tasks/piece_task.h"

#include <string>
#include <utility>

#include "volume/measure/voxel_noise.h"
#include "volume/pieces/piece_seeds.h"

namespace isolux::app {

std::unique_ptr<PieceTask> pieceTask(PieceSubject asked, scene::Scene resolved, bool measured) {
  const std::string file = asked.volume->volume.name;
  const auto work = [subject = std::move(asked), scene = std::move(resolved),
                     measured](base::Progress& progress) {
    const volume::PreparedVolume& volume = *subject.volume;
    FoundPieces found{volume.pieces->at(subject.isovalue, subject.inside, progress), {}, {}};
    if (!measured) return found;
    const volume::SurfaceQuestion question{
        subject.isovalue, subject.inside, std::nullopt, voxelNoise(volume, scene, progress), {}};
    found.measures = measurePieces(*found.pieces, *volume.blocks, question, {}, progress).pieces;
    for (const glm::ivec3& seed : pieceSeeds(*found.pieces, progress))
      found.seedsMm.push_back(volume.grid().geometry().worldOf(seed));
    return found;
  };
  return PieceTask::start({file, "find the connected components of the isosurface"}, work);
}

}  // namespace isolux::app
