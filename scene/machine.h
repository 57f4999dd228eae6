// Settings of the machine: what the user's hardware is asked for, whatever is shown.
//
// They are no part of the Scene: sessions, recordings and undo know none of them. On the command line they
// are set like settings of the scene (--set memory.gpu_budget_mb=512); the window keeps them for its user.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scene/choices.h"
#include "scene/setting/setting.h"

namespace isolux::scene {

// What computes hits and derivatives: automatic is the processor where OpenGL is software.
enum class Executor { automatic, gpu, cpu };

// Where the voxels of a volume are while it is drawn: automatic leaves them in the file where that can be
// read in parts and they do not fit into memory.
enum class VoxelPlace : std::uint8_t { automatic, memory, file };

// What textures are made by.
struct Memory {
  int gpuBudgetMb = 2048;
  MemoryLayout layout = MemoryLayout::automatic;  // whole where it fits, else bricks
  bool operator==(const Memory&) const = default;
};

struct Machine {
  Memory memory{};
  std::optional<int> threads{};  // that compute light; automatic: as many as the process may use
  bool adaptive = true;          // pictures in motion shrink until they are quick enough
  double motionTarget = 25.0;    // milliseconds of a picture in motion
  Executor executor = Executor::automatic;
  VoxelPlace voxels = VoxelPlace::automatic;
  int ramBudgetMb = 1024;  // for voxels that stay in a file
  bool operator==(const Machine&) const = default;
};

using MachineSetting = SettingOf<Machine>;

std::span<const MachineSetting> machineSettings();
const MachineSetting* machineSetting(std::string_view path);  // null: the path is none of them
// Whether an assignment "PATH=VALUE" or a path is of the machine, not of the scene.
bool isOfMachine(std::string_view assignment);
// As scene::applyAssignment(Scene&, ...).
void applyAssignment(Machine& machine, std::string_view assignment);

}  // namespace isolux::scene
