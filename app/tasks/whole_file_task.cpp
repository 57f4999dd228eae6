#include "app/tasks/whole_file_task.h"

#include <algorithm>
#include <utility>

#include "app/ready/give_way.h"
#include "app/ready/ready_fields.h"
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

std::unique_ptr<WholeFileTask> wholeFileTask(scene::Source source, scene::HostSettings host) {
  source.level = 0;
  const auto work = [source = std::move(source), host = std::move(host)](base::Progress& progress) {
    giveWay();
    WholeFile whole{nullptr, host};
    whole.host.voxels = scene::VoxelPlace::file;
    whole.host.executor = scene::Executor::automatic;
    whole.host.ramBudgetMb = halfOfLeft(host.ramBudgetMb);
    whole.volume = volume::loadVolume(source, whole.host, progress);
    // Textures of software OpenGL are memory, too.
    whole.host.memory.gpuBudgetMb = halfOfLeft(host.memory.gpuBudgetMb);
    return whole;
  };
  return WholeFileTask::start({"", "open the volume itself"}, work);
}

scene::Scene sceneOfWholeFile(const scene::Scene& asked, const scene::Scene& shown,
                              const volume::PreparedVolume& whole) {
  scene::Scene scene = asked;
  scene.source.level = 0;
  scene.camera = shown.camera;
  scene.surfaces.front().value = shown.surfaces.front().value;
  scene = scene::resolve(std::move(scene), whole.facts);
  base::Progress progress;
  if (const std::optional<std::string> needs = scene::needsWholeVoxels(scene))
    throw base::Error(base::ErrorKind::memory, "", "", "all voxels in memory would be needed for " + *needs);
  completeFields(scene, whole, false, progress);
  return scene;
}

}  // namespace isolux::app
