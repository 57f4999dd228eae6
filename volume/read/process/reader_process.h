// One run of a reader: a program of its own that parses a file with somebody else's library.
//
// The reader may do whatever damaged data make it do: end by a signal, run out of memory, spin, answer
// nonsense. All of that becomes a base::Error that names the file; a stop wanted by Progress ends it within
// 20 ms. The reader limits itself before it looks at the file (readers/limits.h). One thread at a time per
// object.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <sys/types.h>

#include "base/progress.h"
#include "volume/read/process/reader_messages.h"

namespace isolux::volume {

// Where the readers lie, for programs that are not ours (Python). To be called before anything is read.
void setReaderFolder(std::filesystem::path folder);
// A reader, which lies beside the running program, or in that folder. `name`: "isolux-reader-vtk". Throws
// Error{input} when there is none.
std::filesystem::path readerProgram(const std::string& name);

// Closes a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int get() const { return number_; }
  int release() noexcept { return std::exchange(number_, -1); }

 private:
  int number_;
};

class ReaderProcess {
 public:
  struct Message {
    MessageKind kind;
    std::string body;
  };

  // Starts `program` and sends the request. A reader that neither works nor answers for `patienceSeconds` is
  // ended.
  ReaderProcess(const std::filesystem::path& program, Request request, base::Progress& progress,
                double patienceSeconds = 30.0);
  ~ReaderProcess() { end(); }  // ends the reader if it still runs
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  // The body of the next message, which must be of this kind; progress is passed on, failures are thrown.
  std::string expect(MessageKind kind) { return expectEither(kind, kind).body; }
  // One of two kinds, where what comes next is the reader's choice.
  Message expectEither(MessageKind one, MessageKind other);
  // What `decode` makes of that body; its errors name the file.
  template <typename Decode>
  auto announced(MessageKind kind, Decode&& decode) {
    const std::string body = expect(kind);
    return named([&] { return decode(body); });
  }
  // Puts so many bytes into the shared memory for the reader, written by `fill`, and tells it so.
  void lend(std::uint64_t bytes, const std::function<void(std::span<std::byte>)>& fill);
  // Lets the reader fill that many bytes of shared memory, and waits until it has. Error{memory} above the
  // request's budget.
  void receive(std::uint64_t bytes);
  // Of the shared memory, after receive().
  void read(std::uint64_t offset, std::span<std::byte> out) const;
  void forgetMemory() { memory_ = Descriptor(); }

 private:
  // Calls f; errors that name no file name the one that is read.
  template <typename F>
  auto named(F&& f) const {
    try {
      return f();
    } catch (const base::Error& error) {
      if (!error.file().empty() || error.kind() == base::ErrorKind::interrupted) throw;
      throw base::Error(error.kind(), request_.path, error.place(), error.reason());
    }
  }
  [[noreturn]] void fail(base::ErrorKind kind, const std::string& reason) const;
  bool takeMessage(Message& message);
  void waitForBytes();
  void send(MessageKind kind, std::string_view body);
  bool hasEnded() const;
  [[noreturn]] void explainEnd();
  int end();  // by force; the status of waitpid()
  double processorSeconds() const;

  Request request_;
  std::string program_;
  base::Progress& progress_;
  double patienceSeconds_;
  Descriptor socket_, memory_;
  pid_t pid_ = -1;
  std::string file_;  // that the reader is at
  std::string received_;
};

}  // namespace isolux::volume
