#include "app/jobs/whole_file_job.h"

#include <algorithm>

#include "app/picture/field_job.h"
#include "base/memory_budget.h"
#include "scene/rules/automatic.h"
#include "scene/rules/whole_voxels.h"

namespace isolux::app {

namespace {

// Half of what memory has left, in MiB, at most what the user allows.
int halfOfLeft(int allowed) {
  constexpr std::size_t least = 64;
  const std::size_t half = base::machineMemory().left() / 2 >> 20;
  return std::min(allowed, static_cast<int>(std::max(half, least)));
}

}  // namespace

void WholeFileWork::run(base::Progress& progress) {
  scene::Machine& machine = subject.machine;
  subject.source.level = 0;
  machine.voxels = scene::VoxelPlace::file;
  machine.executor = scene::Executor::automatic;
  machine.ramBudgetMb = halfOfLeft(machine.ramBudgetMb);
  volume = volume::loadVolume(subject.source, machine, progress);
  // Textures of software OpenGL are memory, too.
  machine.memory.gpuBudgetMb = halfOfLeft(machine.memory.gpuBudgetMb);
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
