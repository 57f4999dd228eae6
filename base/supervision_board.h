// Defines the memory that a command and its supervisor (app/launcher) share, so that the supervisor can clean
// up after a command that was killed.
//
// The environment variable kBoardVariable contains the descriptor of the memory. The memory is plain data:
// both processes map it, and neither assumes that the other is alive.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace isolux::base {

inline constexpr char kBoardVariable[] = "ISOLUX_SUPERVISION";

struct SupervisionBoard {
  // A file to remove unless it is completed: an absolute path, terminated by 0. The path is written while the
  // state is `taken`.
  struct Slot {
    static constexpr std::uint32_t free = 0, taken = 1, announced = 2;
    std::atomic<std::uint32_t> state;
    char path[4096];
  };
  std::atomic<std::uint32_t> reported;  // 1: the line about the command's end has been printed
  Slot slots[64];
};

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

}  // namespace isolux::base
