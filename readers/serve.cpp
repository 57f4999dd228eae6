#include "readers/serve.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "readers/limits.h"
#include "volume/read/process/wire.h"

#ifdef ISOLUX_COVERAGE
extern "C" void __gcov_dump();  // of libgcov, whose header knows no C++
#endif

namespace isolux::readers {

using namespace volume;  // the other half of the exchange
using base::Error;
using base::ErrorKind;

namespace {

constexpr int socketNumber = 3, memoryNumber = 4;  // as the program starts its readers

// The program's end is gone: there is nobody left to read for.
[[noreturn]] void endUnheard() {
  std::_Exit(0);
}

class Connection {
 public:
  void send(MessageKind kind, std::string_view body) {
    WireWriter wire;
    wire.put(kMessageMark);
    wire.put(static_cast<std::uint64_t>(kind));
    wire.put(body);
    std::string_view rest = wire.bytes();
    const std::lock_guard lock(mutex_);
    while (!rest.empty()) {
      const ssize_t sent = ::send(socketNumber, rest.data(), rest.size(), MSG_NOSIGNAL);
      if (sent <= 0) endUnheard();
      rest.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

  std::string receive(MessageKind kind) {
    const std::string head = take(kMessageHeadBytes);
    WireReader wire(head);
    if (wire.number() != kMessageMark || wire.number() != static_cast<std::uint64_t>(kind)) endUnheard();
    return take(static_cast<std::size_t>(wire.number(0, kLongestMessage)));
  }

 private:
  static std::string take(std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t have = 0; have < count;) {
      const ssize_t got = ::recv(socketNumber, bytes.data() + have, count - have, 0);
      if (got <= 0) endUnheard();
      have += static_cast<std::size_t>(got);
    }
    return bytes;
  }

  std::mutex mutex_;
};

Connection& connectionToProgram() {
  static Connection connection;
  return connection;
}

// Passes on how far the work is, ten times a second.
class ProgressSender {
 public:
  ProgressSender(Connection& connection, const base::Progress& progress)
      : thread_([&connection, &progress](const std::stop_token& stop) {
          constexpr auto step = std::chrono::milliseconds(100);
          std::mutex mutex;
          std::condition_variable_any wake;
          std::unique_lock lock(mutex);
          for (double last = 0.0; !wake.wait_for(lock, stop, step, [&] { return stop.stop_requested(); });) {
            const double now = progress.fraction();
            if (now == last) continue;
            WireWriter wire;
            wire.put(last = now);
            connection.send(MessageKind::progress, wire.bytes());
          }
        }) {}

 private:
  std::jthread thread_;
};

// The memory that both share, once the program has given it its size.
class SharedMemory {
 public:
  explicit SharedMemory(Connection& connection) {
    connection.receive(MessageKind::goOn);
    struct stat status {};
    ::fstat(memoryNumber, &status);
    size_ = static_cast<std::size_t>(status.st_size);
    if (size_ == 0) return;
    void* const begin = ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, memoryNumber, 0);
    if (begin == MAP_FAILED) throw std::bad_alloc();
    begin_ = static_cast<std::byte*>(begin);
  }

  ~SharedMemory() {
    if (begin_ != nullptr) ::munmap(begin_, size_);
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::span<const std::byte> bytes() const { return {begin_, size_}; }
  void append(std::span<const std::byte> bytes) {
    if (bytes.size() > size_ - at_) endUnheard();  // the program gave less than was asked for
    if (!bytes.empty()) std::memcpy(begin_ + at_, bytes.data(), bytes.size());
    at_ += bytes.size();
  }

 private:
  std::byte* begin_ = nullptr;
  std::size_t size_ = 0, at_ = 0;
};

void handOver(Connection& connection, const DecodedVolume& volume) {
  connection.send(MessageKind::volume, encode(volume));
  SharedMemory memory(connection);
  std::visit([&](const auto& voxels) { memory.append(std::as_bytes(std::span(voxels))); }, volume.voxels);
}

void handOver(Connection& connection, const TriangleMesh& mesh) {
  connection.send(MessageKind::mesh, encode(mesh));
  SharedMemory memory(connection);
  memory.append(std::as_bytes(std::span(mesh.points)));
  memory.append(std::as_bytes(std::span(mesh.triangles)));
}

void handOver(Connection& connection, const DecodedImage& image) {
  connection.send(MessageKind::image, encode(image));
  SharedMemory memory(connection);
  memory.append(std::as_bytes(std::span(image.pixels)));
}

void handOver(Connection& connection, const Hdf5Table& table) {
  connection.send(MessageKind::chunks, encode(table.layout));
  SharedMemory memory(connection);
  memory.append(std::as_bytes(std::span(table.chunks)));
}

// Runs `read` with its progress passed on.
template <typename Read>
auto watched(Connection& connection, Read&& read) {
  base::Progress progress;
  const ProgressSender sender(connection, progress);
  return read(progress);
}

[[noreturn]] void refuseTask() {
  base::throwInput("", "", "this reader does not read such files");
}

TriangleMesh contoured(Connection& connection, const Abilities& abilities, const Request& request) {
  const SharedMemory lent(connection);
  const glm::ivec3 dims = request.contourDims;
  const std::size_t count = volume::Extent3{dims}.count();
  if (lent.bytes().size() != count * sizeof(float)) endUnheard();
  allowDecoding(lent.bytes().size());
  const std::span samples(reinterpret_cast<const float*>(lent.bytes().data()), count);
  return watched(connection,
                 [&](base::Progress& progress) { return abilities.contour(samples, dims, progress); });
}

// Hands over what `ability`, one of Abilities, makes of `arguments`.
template <class Ability, class... Arguments>
void handOverMade(Connection& connection, const Ability& ability, const Arguments&... arguments) {
  if (!ability) refuseTask();
  handOver(connection,
           watched(connection, [&](base::Progress& progress) { return ability(arguments..., progress); }));
}

void answer(Connection& connection, const Abilities& abilities, const Request& request) {
  switch (request.task) {
    case Task::volume:
      return handOverMade(connection, abilities.volume, request.path, request.options);
    case Task::mesh:
      return handOverMade(connection, abilities.mesh, request.path);
    case Task::image:
      return handOverMade(connection, abilities.image, request.path);
    case Task::contour:
      if (!abilities.contour) refuseTask();
      return handOver(connection, contoured(connection, abilities, request));
    case Task::index: {
      if (!abilities.index) refuseTask();
      const DicomIndexEnd end = watched(connection, [&](base::Progress& progress) {
        return abilities.index(
            request.path, request.skip,
            [&](const DicomSeries& series) { connection.send(MessageKind::series, encode(series)); },
            progress);
      });
      return connection.send(MessageKind::index, encode(end));
    }
    case Task::preview:
      return handOverMade(connection, abilities.preview, request.path, request.options);
    case Task::chunks:
      return handOverMade(connection, abilities.chunks, request.path, request.options);
    case Task::versions:
      return connection.send(MessageKind::text, abilities.versions());
  }
}

// Null: all went well.
std::optional<Error> errorOf(Connection& connection, const Abilities& abilities, const Request& request) {
  try {
    answer(connection, abilities, request);
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorKind::memory, request.path, "", "not enough memory for its content");
  } catch (const std::exception& error) {
    return Error(ErrorKind::input, request.path, "",
                 std::string("the file is damaged: its reader gave up (") + error.what() + ")");
  }
}

}  // namespace

void nowReading(const std::filesystem::path& file) {
  connectionToProgram().send(MessageKind::file, file.string());
}

int serve(const Abilities& abilities) {
  Connection& connection = connectionToProgram();
  struct stat status {};
  if (::fstat(socketNumber, &status) != 0 || !S_ISSOCK(status.st_mode)) {
    std::cerr << "isolux: this program reads files for isolux; run isolux instead\n";
    return 2;
  }
  const Request request = decodeRequest(connection.receive(MessageKind::request));
  if (!endWithParent(request.parent)) return 0;
  limitReader(request.options.budgetBytes);
  const std::optional<Error> error = errorOf(connection, abilities, request);
#ifdef ISOLUX_COVERAGE
  __gcov_dump();  // after the last message the program may end this one
#endif
  if (error)
    connection.send(MessageKind::failure, encode(*error));
  else if (request.task != Task::versions && request.task != Task::index)
    connection.send(MessageKind::done, {});
  std::_Exit(0);  // no library needs to tidy up
}

}  // namespace isolux::readers
