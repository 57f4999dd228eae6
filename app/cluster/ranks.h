// Processes that do one job together, as each of them sees the others: numbered from 0, sending each other
// messages of bytes. Nothing waits but broadcast() and end(): who wants to hear asks next() now and then.
//
// Real ones are MPI's (mpi_ranks.h); those of the tests are threads. All members from one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/progress.h"

namespace isolux::app {

struct RankMessage {
  int from = 0, kind = 0;
  std::string bytes;
};

class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  // From rank 0 to all, the same number of bytes everywhere. Throws Error{interrupted} when stopped,
  // after which MPI can only be aborted.
  virtual void broadcast(std::span<std::byte> bytes, const base::Progress& progress) = 0;
  // Below 2 GiB. Messages to one rank arrive in their order.
  virtual void send(int to, int kind, std::string bytes) = 0;
  virtual std::optional<RankMessage> next() = 0;
  virtual bool allSent() = 0;
  virtual void end() = 0;  // waits for all
};

// Of rank 0's text; the others' is replaced.
void broadcastText(Ranks& ranks, std::string& text, const base::Progress& progress);

}  // namespace isolux::app
