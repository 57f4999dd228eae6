// isolux-mpi.so: the only file that knows MPI. Nothing here waits inside MPI, where a rank that waits takes a
// core to itself, and one that stands still would hold up the others.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <list>
#include <thread>
#include <utility>

#include <mpi.h>
#include <unistd.h>

#include "app/cluster/mpi_ranks.h"

namespace isolux::app {

namespace {

struct Outgoing {
  std::string bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};
struct Incoming {
  RankMessage message;
  MPI_Request request = MPI_REQUEST_NULL;
  bool complete = false;
};

bool isDone(MPI_Request& request) {
  int done = 0;
  MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return done != 0;
}

class ModuleRanks : public MpiRanks {
 public:
  ModuleRanks() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  void broadcast(std::span<std::byte> bytes, const base::Progress& progress) override {
    constexpr std::size_t most = std::size_t{1} << 28;
    while (!bytes.empty()) {
      const std::span<std::byte> now = bytes.first(std::min(bytes.size(), most));
      MPI_Request request = MPI_REQUEST_NULL;
      MPI_Ibcast(now.data(), static_cast<int>(now.size()), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
      while (!isDone(request)) {
        progress.throwIfStopped();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      bytes = bytes.subspan(now.size());
    }
  }
  void send(int to, int kind, std::string bytes) override {
    Outgoing& message = outgoing_.emplace_back(Outgoing{std::move(bytes)});
    MPI_Isend(message.bytes.data(), static_cast<int>(message.bytes.size()), MPI_BYTE, to, kind,
              MPI_COMM_WORLD, &message.request);
  }
  std::optional<RankMessage> next() override {
    allSent();  // messages go out while MPI is asked
    take();
    for (auto one = incoming_.begin(); one != incoming_.end(); ++one) {
      const bool earlier = std::any_of(incoming_.begin(), one, [&](const Incoming& before) {
        return before.message.from == one->message.from;  // and is still on its way
      });
      if (!one->complete || earlier) continue;
      RankMessage message = std::move(one->message);
      incoming_.erase(one);
      return message;
    }
    return std::nullopt;
  }
  bool allSent() override {
    outgoing_.remove_if([](Outgoing& message) { return isDone(message.request); });
    return outgoing_.empty();
  }
  void end() override { MPI_Finalize(); }
  [[noreturn]] void abort(int exitCode) override {
    std::fflush(nullptr);
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    ::_exit(exitCode);
  }

 private:
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
      Incoming& one = incoming_.emplace_back();
      one.message = {status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(count), '\0')};
      MPI_Imrecv(one.message.bytes.data(), count, MPI_BYTE, &handle, &one.request);
    }
    for (Incoming& one : incoming_)
      if (!one.complete) one.complete = isDone(one.request);
  }

  int rank_ = 0, size_ = 1;
  std::list<Outgoing> outgoing_;
  std::list<Incoming> incoming_;
};

}  // namespace

MpiRanks* isoluxMpiRanks() {
  int level = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level) != MPI_SUCCESS) return nullptr;
  return new ModuleRanks;
}

}  // namespace isolux::app
