// Memory that a command and its supervisor (app/launcher) share, so that the supervisor can tidy up after a
// command that was ended in the middle of anything.
//
// The descriptor of the memory is in the environment variable kBoardVariable. Plain data: both map it,
// neither trusts the other to be alive.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace isolux::base {

inline constexpr char kBoardVariable[] = "ISOLUX_SUPERVISION";

struct SupervisionBoard {
  // Of a file that goes away unless it is completed: an absolute path, terminated by 0. The path is written
  // while the state is `taken`.
  struct Slot {
    static constexpr std::uint32_t free = 0, taken = 1, announced = 2;
    std::atomic<std::uint32_t> state;
    char path[4096];
  };
  std::atomic<std::uint32_t> reported;  // 1: the line about the command's end was printed
  Slot slots[64];
};

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

}  // namespace isolux::base
