#include "app/jobs/whole_file_job.h"

#include <algorithm>

#include "app/jobs/field_job.h"
#include "base/memory_budget.h"
#include "scene/rules/automatic.h"
#include "scene/rules/whole_voxels.h"

namespace isolux::app {

void WholeFileWork::run(base::Progress& progress) {
  constexpr std::size_t least = 16;  // MiB, as the setting has it
  const std::size_t half = base::machineMemory().left() / 2 >> 20;
  subject.source.level = 0;
  subject.machine.voxels = scene::VoxelPlace::file;
  subject.machine.ramBudgetMb = static_cast<int>(
      std::clamp(half, least, static_cast<std::size_t>(std::max(subject.machine.ramBudgetMb, 16))));
  volume = volume::loadVolume(subject.source, subject.machine, progress);
}

scene::Scene sceneOfWholeFile(const scene::Scene& asked, const scene::Scene& shown,
                              const volume::PreparedVolume& whole) {
  scene::Scene scene = asked;
  scene.source.level = 0;
  scene.camera = shown.camera;
  scene.isosurface.value = shown.isosurface.value;
  scene = scene::resolve(std::move(scene), whole.facts);
  base::Progress progress;
  if (const std::optional<std::string> needs = scene::needsWholeVoxels(scene))
    throw base::Error(base::ErrorKind::memory, "", "", "all voxels in memory would be needed for " + *needs);
  completeFields(scene, whole, false, progress);
  return scene;
}

}  // namespace isolux::app
