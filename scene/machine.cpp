#include "scene/machine.h"

#include <algorithm>
#include <cassert>

#include "scene/setting/assignment.h"
#include "scene/setting/setting_entry.h"

namespace isolux::scene {

namespace {

std::vector<MachineSetting> makeMachineSettings() {
  std::vector<MachineSetting> list;
  list.push_back(entry<Machine>("memory.gpu_budget_mb", ISOLUX_MEMBER(memory.gpuBudgetMb), {16, 1048576},
                                "MiB", "Graphics memory that the voxels may use."));
  list.push_back(choiceEntry<Machine>(
      "memory.layout", ISOLUX_MEMBER(memory.layout),
      "The volume as one texture, or as bricks of which only those needed are resident; auto takes one "
      "texture where it fits."));
  list.push_back(choiceEntry<Machine>(
      "memory.voxels", ISOLUX_MEMBER(voxels),
      "Where a volume's voxels are while it is drawn: all in memory, or in the file, of which parts are read "
      "when they are needed; auto leaves them in the file where they do not fit into memory."));
  list.push_back(entry<Machine>("memory.ram_budget_mb", ISOLUX_MEMBER(ramBudgetMb), {16, 1048576}, "MiB",
                                "Memory for parts of a volume that stays in its file."));
  list.push_back(entry<Machine>("gi.threads", ISOLUX_MEMBER(threads), {1, 1024}, "",
                                "Threads that compute light; auto is one per core."));
  list.push_back(entry<Machine>(
      "picture.adaptive", ISOLUX_MEMBER(adaptive), noRange, "",
      "Pictures in motion shrink until they are quick enough; the full picture follows at rest."));
  list.push_back(entry<Machine>("picture.motion_target", ISOLUX_MEMBER(motionTarget), {5, 2000}, "ms",
                                "How long a picture in motion may take."));
  list.push_back(choiceEntry<Machine>(
      "picture.executor", ISOLUX_MEMBER(executor),
      "What computes hits and derivatives of pictures: the graphics card, or the processor (exact hits "
      "only); auto takes the processor where OpenGL is software."));
  return list;
}

}  // namespace

std::span<const MachineSetting> machineSettings() {
  static const std::vector<MachineSetting> list = makeMachineSettings();
  return list;
}

const MachineSetting* machineSetting(std::string_view path) {
  const std::span<const MachineSetting> list = machineSettings();
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.path == path; });
  return found == list.end() ? nullptr : &*found;
}

bool isOfMachine(std::string_view assignment) {
  return machineSetting(pathOf(assignment)) != nullptr;
}

void applyAssignment(Machine& machine, std::string_view assignment) {
  const MachineSetting* const target = machineSetting(pathOf(assignment));
  assert(target && "isOfMachine()");
  target->set(machine, valueOf(*target, assignment));
}

}  // namespace isolux::scene
