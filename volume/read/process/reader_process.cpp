#include "volume/read/process/reader_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/error.h"
#include "volume/read/input/payload.h"
#include "volume/read/process/wire.h"

extern char** environ;

namespace isolux::volume {

namespace fs = std::filesystem;
using base::ErrorKind;

namespace {

constexpr int pollMilliseconds = 20;
// What the reader finds: its end of the connection and the shared memory, under these numbers.
constexpr int readerSocket = 3, readerMemory = 4, firstFree = 5;

[[noreturn]] void throwSystem(const std::string& what) {
  throw base::Error(ErrorKind::memory, "", "", what + ": " + std::strerror(errno));
}

// Away from the numbers that the reader's ends will have.
Descriptor highNumber(int number) {
  const Descriptor low(number);
  Descriptor high(::fcntl(number, F_DUPFD_CLOEXEC, 16));
  if (high.get() < 0) throwSystem("a reader of files cannot be connected");
  return high;
}

struct SpawnActions {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  SpawnActions() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  ~SpawnActions() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
};

// In a process group of its own: an interrupt from the terminal reaches the program, which ends its readers.
// Signals are as at the start of a program; nothing else that is open here is open there.
pid_t spawn(const std::string& program, int socket, int memory) {
  SpawnActions actions;
  posix_spawn_file_actions_addopen(&actions.files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions.files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions.files, socket, readerSocket);
  posix_spawn_file_actions_adddup2(&actions.files, memory, readerMemory);
  posix_spawn_file_actions_addclosefrom_np(&actions.files, firstFree);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&actions.attributes, &none);
  posix_spawnattr_setsigdefault(&actions.attributes, &all);
  posix_spawnattr_setpgroup(&actions.attributes, 0);
  posix_spawnattr_setflags(&actions.attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  std::string name = program;
  std::array<char*, 2> arguments{name.data(), nullptr};
  pid_t pid = -1;
  const int failed =
      ::posix_spawn(&pid, program.c_str(), &actions.files, &actions.attributes, arguments.data(), environ);
  if (failed != 0)
    base::throwInput(program, "",
                     std::string("the reader of such files cannot be started: ") + std::strerror(failed));
  return pid;
}

std::string signalText(int signal) {
  static constexpr std::pair<int, const char*> known[] = {{SIGSEGV, "a segmentation fault"},
                                                          {SIGBUS, "a bus error"},
                                                          {SIGABRT, "an abort"},
                                                          {SIGFPE, "an arithmetic error"},
                                                          {SIGILL, "an illegal instruction"}};
  for (const auto& [number, text] : known)
    if (number == signal) return text;
  return "signal " + std::to_string(signal);
}

fs::path& otherFolder() {
  static fs::path folder;
  return folder;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

void setReaderFolder(fs::path folder) {
  otherFolder() = std::move(folder);
}

fs::path readerProgram(const std::string& name) {
  std::error_code error;
  fs::path folder = otherFolder();
  if (folder.empty()) folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (!error && ::access((folder / name).c_str(), X_OK) == 0) return folder / name;
  base::throwInput(name, "",
                   "the program that reads such files is missing; it belongs in " + folder.string());
}

ReaderProcess::ReaderProcess(const fs::path& program, Request request, base::Progress& progress,
                             double patienceSeconds)
    : request_(std::move(request)),
      program_(program.string()),
      progress_(progress),
      patienceSeconds_(patienceSeconds),
      file_(request_.path) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throwSystem("a reader of files cannot be connected");
  socket_ = Descriptor(ends[0]);
  const Descriptor theirs = highNumber(ends[1]);
  memory_ = highNumber(::memfd_create("isolux", MFD_CLOEXEC));
  request_.parent = ::getpid();
  pid_ = spawn(program_, theirs.get(), memory_.get());
  send(MessageKind::request, encode(request_));
}

int ReaderProcess::end() {
  if (pid_ < 0) return 0;
  ::kill(pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

void ReaderProcess::fail(ErrorKind kind, const std::string& reason) const {
  throw base::Error(kind, file_, "", reason);
}

double ReaderProcess::processorSeconds() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return -1.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ReaderProcess::send(MessageKind kind, std::string_view body) {
  WireWriter wire;
  wire.put(kMessageMark);
  wire.put(static_cast<std::uint64_t>(kind));
  wire.put(body);
  std::string_view rest = wire.bytes();
  while (!rest.empty()) {
    const ssize_t sent = ::send(socket_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) explainEnd();
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void ReaderProcess::waitForBytes() {
  using Clock = std::chrono::steady_clock;
  double busySeconds = processorSeconds();
  Clock::time_point lastSign = Clock::now();
  for (;;) {
    progress_.throwIfStopped();  // the destructor ends the reader
    pollfd waiting{socket_.get(), POLLIN, 0};
    const int ready = ::poll(&waiting, 1, pollMilliseconds);
    if (ready > 0) break;
    if (const double now = processorSeconds(); now != busySeconds) {
      busySeconds = now;
      lastSign = Clock::now();
    }
    if (base::secondsSince(lastSign) > patienceSeconds_)
      fail(ErrorKind::input, "cannot be read: its reader neither works nor answers");
  }
  std::array<char, 65536> buffer;
  const ssize_t got = ::recv(socket_.get(), buffer.data(), buffer.size(), 0);
  if (got < 0 && errno == EINTR) return;
  if (got <= 0) explainEnd();
  received_.append(buffer.data(), static_cast<std::size_t>(got));
}

bool ReaderProcess::takeMessage(Message& message) {
  if (received_.size() < kMessageHeadBytes) return false;
  WireReader wire(std::string_view(received_).substr(0, kMessageHeadBytes));
  if (wire.number() != kMessageMark) throwBadAnswer("the reader is not of this version of the program");
  message.kind = static_cast<MessageKind>(wire.number(static_cast<std::uint64_t>(MessageKind::request),
                                                      static_cast<std::uint64_t>(MessageKind::done)));
  const auto length = static_cast<std::size_t>(wire.number(0, kLongestMessage));
  if (received_.size() - kMessageHeadBytes < length) return false;
  message.body = received_.substr(kMessageHeadBytes, length);
  received_.erase(0, kMessageHeadBytes + length);
  return true;
}

ReaderProcess::Message ReaderProcess::expectEither(MessageKind one, MessageKind other) {
  return named([&]() -> Message {
    for (;;) {
      Message message{};
      while (!takeMessage(message)) waitForBytes();
      if (message.kind == MessageKind::progress) {
        WireReader wire(message.body);
        progress_.report(std::clamp(wire.finite(), 0.0, 1.0), "reading");
        wire.end();
        continue;
      }
      if (message.kind == MessageKind::file) {
        file_ = std::move(message.body);
        continue;
      }
      if (message.kind == MessageKind::failure) throw decodeError(message.body);
      if (message.kind != one && message.kind != other) throwBadAnswer("does not answer the request");
      return message;
    }
  });
}

void ReaderProcess::receive(std::uint64_t bytes) {
  checkBudget(bytes, "its content", "", file_, request_.options);
  if (::ftruncate(memory_.get(), static_cast<off_t>(bytes)) != 0)
    fail(ErrorKind::memory, std::string("no shared memory for its content: ") + std::strerror(errno));
  send(MessageKind::goOn, {});
  expect(MessageKind::done);
  end();  // from here on nobody changes what was handed over
  struct stat status {};
  if (::fstat(memory_.get(), &status) != 0 || static_cast<std::uint64_t>(status.st_size) != bytes)
    fail(ErrorKind::input, "its reader sent another size than announced");
}

void ReaderProcess::lend(std::uint64_t bytes, const std::function<void(std::span<std::byte>)>& fill) {
  const auto size = static_cast<std::size_t>(bytes);
  void* const begin = ::ftruncate(memory_.get(), static_cast<off_t>(bytes)) == 0
                          ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, memory_.get(), 0)
                          : MAP_FAILED;
  if (begin == MAP_FAILED)
    fail(ErrorKind::memory, std::string("no shared memory for it: ") + std::strerror(errno));
  fill({static_cast<std::byte*>(begin), size});
  ::munmap(begin, size);
  send(MessageKind::goOn, {});
}

void ReaderProcess::read(std::uint64_t offset, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t got = ::pread(memory_.get(), out.data(), out.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail(ErrorKind::input, "the data from its reader cannot be read");
    offset += static_cast<std::uint64_t>(got);
    out = out.subspan(static_cast<std::size_t>(got));
  }
}

// The reader ends within a second on its own.
bool ReaderProcess::hasEnded() const {
  for (int i = 0; i < 500; ++i) {
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0)
      return true;
    ::poll(nullptr, 0, 2);
  }
  return false;
}

// The reader has closed its end without a last word.
void ReaderProcess::explainEnd() {
  const double seconds = processorSeconds();
  const bool onItsOwn = hasEnded();
  const int status = end();
  if (!onItsOwn) fail(ErrorKind::input, "the file is damaged: its reader closed the connection");
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU)
      fail(ErrorKind::input, "the file is damaged, or takes too long: its reader was ended after " +
                                 std::to_string(static_cast<int>(seconds)) + " s of processor time");
    if (signal == SIGKILL)
      fail(ErrorKind::memory, "its reader was ended by the system, most likely for lack of memory");
    fail(ErrorKind::input, "the file is damaged: its reader ended by " + signalText(signal));
  }
  if (WEXITSTATUS(status) == 127)
    throw base::Error(ErrorKind::input, program_, "", "the reader cannot be started: a library is missing");
  fail(ErrorKind::input,
       "the file is damaged: its reader ended with code " + std::to_string(WEXITSTATUS(status)));
}

}  // namespace isolux::volume
