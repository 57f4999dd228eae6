// isolux-mpi.so: the only file that knows MPI. Nothing here waits inside MPI, where a rank that waits takes a
// core to itself, and one that stands still would hold up the others.
#include "app/cluster/mpi_module.h"

#include <chrono>
#include <list>
#include <thread>
#include <vector>

#include <mpi.h>

namespace {

struct Outgoing {
  std::vector<unsigned char> bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};
struct Incoming {
  int from = 0, kind = 0;
  std::vector<unsigned char> bytes;
  MPI_Request request = MPI_REQUEST_NULL;
  bool complete = false;
};
std::list<Outgoing> outgoing;
std::list<Incoming> incoming;

bool isDone(MPI_Request& request) {
  int done = 0;
  MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return done != 0;
}

int begin() {
  int level = 0;
  return MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) == MPI_SUCCESS ? 0 : 1;
}

int rank() {
  int number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &number);
  return number;
}

int size() {
  int number = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &number);
  return number;
}

int broadcast(void* bytes, size_t count, int (*stop)(void* context), void* context) {
  constexpr size_t piece = size_t{1} << 28;
  auto* at = static_cast<unsigned char*>(bytes);
  while (count > 0) {
    const size_t now = count < piece ? count : piece;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(at, static_cast<int>(now), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
    while (!isDone(request)) {
      if (stop(context) != 0) return 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    at += now;
    count -= now;
  }
  return 0;
}

int unsent() {
  outgoing.remove_if([](Outgoing& message) { return isDone(message.request); });
  return static_cast<int>(outgoing.size());
}

void send(int to, int kind, const void* bytes, size_t count) {
  const auto* const first = static_cast<const unsigned char*>(bytes);
  Outgoing& message = outgoing.emplace_back();
  message.bytes.assign(first, first + count);
  MPI_Isend(message.bytes.data(), static_cast<int>(count), MPI_BYTE, to, kind, MPI_COMM_WORLD,
            &message.request);
}

// Begins to take what has arrived, and sees what of that is complete.
void take() {
  for (;;) {
    int found = 0;
    MPI_Message handle = MPI_MESSAGE_NULL;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &found, &handle, &status);
    if (found == 0) break;
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    Incoming& message = incoming.emplace_back();
    message.from = status.MPI_SOURCE;
    message.kind = status.MPI_TAG;
    message.bytes.resize(static_cast<size_t>(count));
    MPI_Imrecv(message.bytes.data(), count, MPI_BYTE, &handle, &message.request);
  }
  for (Incoming& message : incoming)
    if (!message.complete) message.complete = isDone(message.request);
}

int next(int* from, int* kind, unsigned char** bytes, size_t* count) {
  unsent();
  take();
  for (auto message = incoming.begin(); message != incoming.end(); ++message) {
    bool earlier = false;  // of the same sender, and still on its way
    for (auto before = incoming.begin(); before != message; ++before)
      earlier = earlier || before->from == message->from;
    if (!message->complete || earlier) continue;
    *from = message->from;
    *kind = message->kind;
    *count = message->bytes.size();
    *bytes = new unsigned char[message->bytes.size() + 1];
    for (size_t i = 0; i < message->bytes.size(); ++i) (*bytes)[i] = message->bytes[i];
    incoming.erase(message);
    return 1;
  }
  return 0;
}

void release(unsigned char* bytes) {
  delete[] bytes;
}

void abortAll(int exitCode) {
  MPI_Abort(MPI_COMM_WORLD, exitCode);
}

void end() {
  MPI_Finalize();
}

}  // namespace

extern "C" const IsoluxMpiModule* isoluxMpiModule() {
  static const IsoluxMpiModule module{begin,  rank, size,    broadcast, send,
                                      unsent, next, release, abortAll,  end};
  return &module;
}
