// What a command tells its supervisor (app/launcher), if it has one: which files are under construction, and
// whether the line about its end was printed. Safe from any thread; without a supervisor nothing happens.
#pragma once

#include <filesystem>

namespace isolux::base {

// Announce before the file is made, withdraw when it has its final name or is gone.
void announcePending(const std::filesystem::path& file) noexcept;
void withdrawPending(const std::filesystem::path& file) noexcept;

// True for the first of command and supervisor: whoever gets it prints the one line about how the command
// ended.
bool claimReport() noexcept;
// The same for the line about an interrupt. A supervisor prints it itself: it may kill the command at any
// moment, also between claiming and printing.
bool claimInterruptReport() noexcept;

}  // namespace isolux::base
