// A reader that does what no reader should (tests/volume/read/reader_process_test.cpp): the name of the file
// it is asked for says what. It speaks the protocol of volume/read/process/reader_messages.h with bare hands.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include "readers/limits.h"
#include "volume/read/process/reader_messages.h"
#include "volume/read/process/wire.h"

namespace {

using namespace isolux::volume;
using isolux::base::ErrorKind;

constexpr int socketNumber = 3, memoryNumber = 4;

void send(MessageKind kind, const std::string& body, std::uint64_t mark = kMessageMark) {
  WireWriter wire;
  wire.put(mark);
  wire.put(static_cast<std::uint64_t>(kind));
  wire.put(std::string_view(body));
  ::send(socketNumber, wire.bytes().data(), wire.bytes().size(), MSG_NOSIGNAL);
}

std::string receive() {
  std::string bytes(65536, '\0');
  const ssize_t got = ::recv(socketNumber, bytes.data(), bytes.size(), 0);
  if (got < static_cast<ssize_t>(kMessageHeadBytes)) std::_Exit(0);
  return bytes.substr(kMessageHeadBytes, static_cast<std::size_t>(got) - kMessageHeadBytes);
}

// 2 x 2 x 2 voxels of uint8, as a good reader announces them.
DecodedVolume smallVolume() {
  DecodedVolume volume;
  volume.header.format = "fake";
  volume.header.dims = {2, 2, 2};
  volume.voxels = std::vector<std::uint8_t>();
  return volume;
}

void announce(const DecodedVolume& volume) {
  send(MessageKind::volume, encode(volume));
}

void fillMemory(std::size_t bytes) {
  receive();  // goOn
  auto* const memory =
      static_cast<std::uint8_t*>(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memoryNumber, 0));
  for (std::size_t i = 0; i < bytes; ++i) memory[i] = static_cast<std::uint8_t>(i);
  send(MessageKind::done, "");
}

void spin() {
  for (volatile unsigned i = 0;;) i = i + 1;
}

// True when the limits hold: no file grows, no memory beyond the limit, and the shared memory still works.
bool limitsHold() {
  isolux::readers::limitReader(std::size_t{1} << 20);
  const std::string file = "/tmp/isolux_fake_reader_" + std::to_string(::getpid());
  const int number = ::open(file.c_str(), O_CREAT | O_WRONLY | O_EXCL, 0600);
  const bool written = ::write(number, "x", 1) == 1;
  ::unlink(file.c_str());
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return !written;  // they need memory without limit
#else
  return !written &&
         ::mmap(nullptr, std::size_t{1} << 30, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED;
#endif
}

// As the system does it: sanitizers have handlers of their own, which end with an exit code.
void endBy(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Ends at its first files, unless it is told to pass them by.
void indexFiles(const Request& request) {
  if (request.path != "/index") endBy(SIGSEGV);
  for (std::size_t i = request.skip.size(); i < 2; ++i) {
    send(MessageKind::file, "/index/bad" + std::to_string(i + 1));
    endBy(SIGSEGV);
  }
  DicomSeries series;
  series.series = "1";
  series.description = "skipped " + std::to_string(request.skip.size());
  send(MessageKind::series, encode(series));
  send(MessageKind::index, encode(DicomIndexEnd{}));
}

void behave(const std::string& name) {
  DecodedVolume volume = smallVolume();
  if (name == "good") {
    announce(volume);
    fillMemory(8);
  } else if (name == "limits") {
    if (!limitsHold()) std::_Exit(9);
    announce(volume);
    fillMemory(8);
  } else if (name == "crash") {
    endBy(SIGSEGV);
  } else if (name == "abort") {
    endBy(SIGABRT);
  } else if (name == "killed") {
    std::raise(SIGKILL);
  } else if (name == "exit") {
    std::_Exit(1);
  } else if (name == "crash in another file") {
    send(MessageKind::file, "/data/other.dcm");
    endBy(SIGSEGV);
  } else if (name == "crash after the announcement") {
    announce(volume);
    receive();
    endBy(SIGSEGV);
  } else if (name == "spin") {
    isolux::readers::limitReader(std::size_t{1} << 20);
    spin();
  } else if (name == "sleep") {
    std::this_thread::sleep_for(std::chrono::hours(1));
  } else if (name == "spin without limits") {
    spin();
  } else if (name == "closes and stays") {
    ::close(socketNumber);
    spin();
  } else if (name == "error") {
    send(MessageKind::failure, encode(isolux::base::Error(ErrorKind::usage, "f", "p", "r")));
  } else if (name == "error of another kind") {
    WireWriter wire;
    wire.put(std::uint64_t{130});
    send(MessageKind::failure, wire.bytes());
  } else if (name == "another version") {
    send(MessageKind::volume, encode(volume), kMessageMark + 1);
  } else if (name == "unknown message") {
    send(static_cast<MessageKind>(99), "");
  } else if (name == "mesh instead") {
    send(MessageKind::mesh, encode(isolux::volume::TriangleMesh()));
  } else if (name == "endless message") {
    WireWriter wire;
    wire.put(kMessageMark);
    wire.put(static_cast<std::uint64_t>(MessageKind::volume));
    wire.put(std::numeric_limits<std::uint64_t>::max());
    ::send(socketNumber, wire.bytes().data(), wire.bytes().size(), MSG_NOSIGNAL);
    spin();
  } else if (name == "truncated body") {
    const std::string body = encode(volume);
    send(MessageKind::volume, body.substr(0, body.size() / 2));
  } else if (name == "body too long") {
    send(MessageKind::volume, encode(volume) + "more");
  } else if (name == "long text") {
    WireWriter wire;
    wire.put(std::uint64_t{1} << 60);
    send(MessageKind::volume, wire.bytes());
  } else if (name == "no voxels") {
    volume.header.dims = {0, 2, 2};
    announce(volume);
  } else if (name == "negative size") {
    volume.header.dims = {-2, 2, 2};
    announce(volume);
  } else if (name == "too large") {
    volume.header.dims = {65535, 65535, 65535};
    announce(volume);
  } else if (name == "nan matrix") {
    volume.header.worldFromVoxel[1][1] = std::numeric_limits<double>::quiet_NaN();
    announce(volume);
  } else if (name == "flat matrix") {
    volume.header.worldFromVoxel[2] = volume.header.worldFromVoxel[1];
    announce(volume);
  } else if (name == "nan progress") {
    WireWriter wire;
    wire.put(std::numeric_limits<double>::quiet_NaN());
    send(MessageKind::progress, wire.bytes());
    announce(volume);
    fillMemory(8);
  } else if (name == "shrinks the memory") {
    announce(volume);
    receive();
    if (::ftruncate(memoryNumber, 1) != 0) std::_Exit(9);
    send(MessageKind::done, "");
  } else if (name == "wrong triangle") {
    TriangleMesh mesh;
    mesh.points.resize(3);
    mesh.triangles.emplace_back(0, 1, 7);
    send(MessageKind::mesh, encode(mesh));
    receive();
    void* const memory = ::mmap(nullptr, 84, PROT_READ | PROT_WRITE, MAP_SHARED, memoryNumber, 0);
    static_cast<int*>(memory)[20] = 7;  // behind 3 points of 24 bytes and two corners
    send(MessageKind::done, "");
  } else if (name == "endless image") {
    WireWriter wire;
    wire.put(std::uint64_t{1} << 26);
    wire.put(std::uint64_t{1} << 26);
    send(MessageKind::image, wire.bytes());
  }
}

}  // namespace

int main() {
  const Request request = decodeRequest(receive());
  if (!isolux::readers::endWithParent(request.parent)) return 0;
  if (request.task == Task::index && request.path.starts_with('/')) indexFiles(request);
  behave(request.path);
  std::_Exit(0);
}
