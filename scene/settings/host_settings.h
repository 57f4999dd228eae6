// Defines the host settings, which depend on the user's hardware and not on the scene.
//
// They are not part of the Scene: sessions, recordings and undo do not contain them. On the command line they
// are set like settings of the scene (--set memory.gpu_budget_mb=512); the window stores them for its user.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "scene/choices.h"
#include "scene/settings/setting.h"

namespace isolux::scene {

// The device that computes hits and derivatives; automatic: the CPU if OpenGL is software.
enum class Executor { automatic, gpu, cpu };

// Location of a volume's voxels while it is drawn. automatic: the file, if it can be read in parts and the
// voxels do not fit into memory.
enum class VoxelPlace : std::uint8_t { automatic, memory, file };

// Limits and layout of textures.
struct Memory {
  int gpuBudgetMb = 2048;
  MemoryLayout layout = MemoryLayout::automatic;  // whole if it fits, else bricks
  bool operator==(const Memory&) const = default;
};

// How the window shows pictures: as textures that stay on the graphics card, or as pixels in main memory.
// automatic: textures on a graphics card.
enum class Canvas { automatic, textures, pixels };

struct HostSettings {
  Memory memory{};
  std::optional<int> threads{};  // for computing light; automatic: as many as the process may use
  bool adaptive = true;          // interactive frames are reduced until they are fast enough
  double motionTarget = 25.0;    // target time of an interactive frame, ms
  Executor executor = Executor::automatic;
  VoxelPlace voxels = VoxelPlace::automatic;
  int ramBudgetMb = 1024;  // for voxels that stay in a file
  Canvas canvas = Canvas::automatic;
  bool operator==(const HostSettings&) const = default;
};

using HostSetting = SettingOf<HostSettings>;

std::span<const HostSetting> hostSettings();
const HostSetting* hostSetting(std::string_view path);  // null: not a path of a host setting
// Returns whether an assignment "PATH=VALUE" or a path is of a host setting.
bool isHostSetting(std::string_view assignment);
// Applies an assignment as scene::applyAssignment(Scene&, ...).
void applyAssignment(HostSettings& host, std::string_view assignment);

}  // namespace isolux::scene
