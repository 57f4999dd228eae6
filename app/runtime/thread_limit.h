// How many threads the system gives (`ulimit -u`, a container's limit), asked before libraries find out by
// ending the process.
#pragma once

#include <exception>
#include <memory>
#include <string>

namespace isolux::app {

// How many of so many threads could be started at once. They have ended again.
int threadsAvailable(int wanted);

// Is this oneTBB's word for a thread that the system refused?
bool refusesThreads(const std::exception& error) noexcept;

// Where the system gives fewer threads than every library taking one for each core needs, all get their share
// while this lives; else nothing changes. Throws Error{memory} where the system gives none at all.
struct ThreadShare {
  std::shared_ptr<void> limit;
  std::string note;  // for stderr; empty: there are enough
};
ThreadShare shareThreads();

}  // namespace isolux::app
