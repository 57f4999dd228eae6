#include "scene/settings/host_settings.h"

#include <algorithm>
#include <cassert>

#include "scene/settings/assignment.h"
#include "scene/settings/setting_entry.h"

namespace isolux::scene {

namespace {

std::vector<HostSetting> makeHostSettings() {
  SettingList<HostSettings> list;
  list.add("memory.gpu_budget_mb", ISOLUX_MEMBER(memory.gpuBudgetMb), {16, 1048576}, "MiB",
           "Graphics memory for voxels, baked light and images.");
  list.add("memory.layout", ISOLUX_MEMBER(memory.layout),
           "Layout of the volume on the GPU: one texture, or bricks of which only those needed are resident. "
           "auto uses one texture if it fits.");
  list.add("memory.voxels", ISOLUX_MEMBER(voxels),
           "Location of the voxels while drawing: memory, or the file, which is read in parts when needed "
           "(out of core). auto uses the file if the volume does not fit in memory.");
  list.add("memory.ram_budget_mb", ISOLUX_MEMBER(ramBudgetMb), {16, 1048576}, "MiB",
           "Memory for bricks of an out-of-core volume.");
  list.add("gi.threads", ISOLUX_MEMBER(threads), {1, 1024}, "",
           "CPU threads that compute light; auto is one per core.");
  list.add("picture.adaptive", ISOLUX_MEMBER(adaptive),
           "Draws interactive frames at a lower resolution until they are fast enough; the full image "
           "follows when the view is idle.");
  list.add("picture.motion_target", ISOLUX_MEMBER(motionTarget), {5, 2000}, "ms",
           "Time limit of an interactive frame.");
  list.add("picture.executor", ISOLUX_MEMBER(executor),
           "Device that computes hits and derivatives: the GPU, or the CPU (exact hits only). auto uses the "
           "CPU if OpenGL is software.");
  list.add("window.canvas", ISOLUX_MEMBER(canvas),
           "How the window shows images: as textures that stay on the graphics card, or as pixels copied to "
           "main memory. auto uses textures on a graphics card. A change to textures may need a restart.");
  return list.take();
}

}  // namespace

std::span<const HostSetting> hostSettings() {
  static const std::vector<HostSetting> list = makeHostSettings();
  return list;
}

const HostSetting* hostSetting(std::string_view path) {
  const std::span<const HostSetting> list = hostSettings();
  const auto found = std::ranges::find_if(list, [&](const auto& s) { return s.path == path; });
  return found == list.end() ? nullptr : &*found;
}

bool isHostSetting(std::string_view assignment) {
  return hostSetting(pathOf(assignment)) != nullptr;
}

void applyAssignment(HostSettings& host, std::string_view assignment) {
  const HostSetting* const target = hostSetting(pathOf(assignment));
  assert(target && "isOfMachine()");
  target->set(host, valueOf(*target, assignment));
}

}  // namespace isolux::scene
