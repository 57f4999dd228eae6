// What the program calls of MPI, as a table of C functions: isolux-mpi.so (mpi_module.cpp) has them, and the
// program opens it where it is one of several ranks (mpi_ranks.h). So it neither links nor needs MPI.
//
// All calls from one thread, between begin() and end().
#pragma once

#include <stddef.h>

extern "C" {

struct IsoluxMpiModule {
  int (*begin)();  // 0: MPI is there
  int (*rank)();
  int (*size)();
  // Sends from rank 0 to all; `count` is the same everywhere. Asks `stop(context)` every millisecond. 0:
  // done; 1: stopped, after which only abort() may follow.
  int (*broadcast)(void* bytes, size_t count, int (*stop)(void* context), void* context);
  // Copies the bytes (below 2^31) and returns at once; they go out while next() is called.
  void (*send)(int to, int kind, const void* bytes, size_t count);
  int (*unsent)();  // messages that are not out yet
  // A message that has come, in the order of its sender; 0: none has. release() its bytes.
  int (*next)(int* from, int* kind, unsigned char** bytes, size_t* count);
  void (*release)(unsigned char* bytes);
  void (*abort)(int exitCode);  // ends all ranks and the launcher; does not return
  void (*end)();                // waits for all ranks
};

// The name that isolux-mpi.so has the table under.
const IsoluxMpiModule* isoluxMpiModule();

}  // extern "C"
