// Ranks that an MPI launcher (mpirun, srun --mpi=pmix) has started.
#pragma once

#include <memory>

#include "app/cluster/ranks.h"

namespace isolux::app {

// Whether a launcher's variables are there (OMPI_COMM_WORLD_SIZE, PMIX_RANK, PMI_RANK with PMI_SIZE).
bool startedByMpi();
// The only one: it needs no MPI, which starts once in a rank, and not again for the next bake of a script.
bool isOnlyRank();

class MpiRanks : public Ranks {
 public:
  // Ends all ranks, and the launcher with this exit code. For what end() would wait for in vain: one of them
  // stands still. What is printed until then is flushed first.
  [[noreturn]] virtual void abort(int exitCode) = 0;
};

// Starts MPI; isolux-mpi.so (mpi_module.cpp) exports it. Returns null on failure. All calls from one thread.
extern "C" MpiRanks* isoluxMpiRanks();

// Opens isolux-mpi.so, which lies beside the program. Once in a process. Throws base::Error{input} with what
// is missing.
std::unique_ptr<MpiRanks> connectMpi();

}  // namespace isolux::app
