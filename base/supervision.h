// Reports to a command's supervisor (app/launcher) which files are being written and whether the final
// message was printed. Safe from any thread. Does nothing without a supervisor.
#pragma once

#include <filesystem>

namespace isolux::base {

// Call announcePending() before the file is created, and withdrawPending() when it has its final name or is
// removed.
void announcePending(const std::filesystem::path& file) noexcept;
void withdrawPending(const std::filesystem::path& file) noexcept;

// Returns true to the first caller among command and supervisor. That caller prints the one line about how
// the command ended.
bool claimReport() noexcept;
// As claimReport(), for the line about an interrupt. A supervisor prints that line itself: it may kill the
// command at any time, also between claiming and printing.
bool claimInterruptReport() noexcept;

}  // namespace isolux::base
