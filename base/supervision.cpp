#include "base/supervision.h"

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/supervision_board.h"

namespace isolux::base {

namespace {

using Slot = SupervisionBoard::Slot;

SupervisionBoard* mapBoard() {
  const char* const variable = std::getenv(kBoardVariable);
  if (!variable) return nullptr;
  int file = -1;
  std::from_chars(variable, variable + std::strlen(variable), file);
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0 || status.st_size != sizeof(SupervisionBoard)) return nullptr;
  void* const memory = ::mmap(nullptr, sizeof(SupervisionBoard), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::fcntl(file, F_SETFD, FD_CLOEXEC);  // programs that the command runs are not supervised themselves
  return memory == MAP_FAILED ? nullptr : static_cast<SupervisionBoard*>(memory);
}

SupervisionBoard* board() {
  static SupervisionBoard* const shared = mapBoard();
  return shared;
}

std::string absoluteName(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::absolute(file, error).string();
}

}  // namespace

void announcePending(const std::filesystem::path& file) noexcept {
  if (!board()) return;
  const std::string path = absoluteName(file);
  if (path.size() >= sizeof(Slot::path)) return;
  for (Slot& slot : board()->slots) {
    std::uint32_t state = Slot::free;
    if (!slot.state.compare_exchange_strong(state, Slot::taken)) continue;
    std::memcpy(slot.path, path.c_str(), path.size() + 1);
    slot.state.store(Slot::announced);
    return;
  }
}

void withdrawPending(const std::filesystem::path& file) noexcept {
  if (!board()) return;
  const std::string path = absoluteName(file);
  for (Slot& slot : board()->slots)
    if (slot.state.load() == Slot::announced && path == slot.path) slot.state.store(Slot::free);
}

bool claimReport() noexcept {
  return !board() || board()->reported.exchange(1) == 0;
}

bool claimInterruptReport() noexcept {
  return !board();
}

}  // namespace isolux::base
