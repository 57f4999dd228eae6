#include "app/cluster/mpi_ranks.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "isolux-mpi.so";

[[noreturn]] void failMpi(const std::string& reason) {
  base::throwInput(kModule, "",
                   reason + "; --no-mpi bakes without, isolux bake --part shares a bake out without MPI");
}

// Where the launcher is not MPI's own: tasks that find each other only by a plug-in of it.
int tasksOfLauncher() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) return 1;
  int most = 1;
  for (const char* name : {"PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* const text = std::getenv(name)) most = std::max(most, std::atoi(text));
  return most;
}

// MPI starts once in a rank, and ends the job the second time: the launcher's folder, which goes with the
// job, remembers it.
void claimRank() {
  const auto text = [](const char* name) {
    const char* const set = std::getenv(name);
    return std::string(set ? set : "");
  };
  const std::string folder = text("PMIX_SERVER_TMPDIR"), rank = text("PMIX_RANK");
  if (folder.empty() || rank.empty()) return;
  const fs::path claim = fs::path(folder) / ("isolux-" + text("PMIX_NAMESPACE") + "-" + rank);
  const int file = ::open(claim.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file >= 0)
    ::close(file);
  else if (errno == EEXIST)
    failMpi("MPI has been started in this rank before, and starts once: give each bake its own mpirun");
}

}  // namespace

bool startedByMpi() {
  const auto has = [](const char* name) { return std::getenv(name) != nullptr; };
  return has("OMPI_COMM_WORLD_SIZE") || has("PMIX_RANK") || (has("PMI_RANK") && has("PMI_SIZE"));
}

bool isOnlyRank() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* const ranks = std::getenv(name)) return std::atoi(ranks) == 1;
  return false;
}

std::unique_ptr<MpiRanks> connectMpi() {
  std::error_code unknown;
  const fs::path module = fs::read_symlink("/proc/self/exe", unknown).parent_path() / kModule;
  // Global: MPI's own plug-ins look for its symbols.
  void* const library = ::dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!library) {
    const char* const reason = ::dlerror();
    failMpi(std::string("cannot be opened: ") + (reason ? reason : "unknown reason"));
  }
  const auto begin = reinterpret_cast<decltype(&isoluxMpiRanks)>(::dlsym(library, "isoluxMpiRanks"));
  if (!begin) failMpi("is another program's");
  claimRank();
  std::unique_ptr<MpiRanks> ranks(begin());
  if (!ranks) failMpi("MPI cannot be started");
  const int started = tasksOfLauncher();
  if (ranks->size() == 1 && started > 1)
    failMpi("MPI does not connect the " + std::to_string(started) +
            " tasks that were started (srun --mpi=pmix does)");
  return ranks;
}

}  // namespace isolux::app
