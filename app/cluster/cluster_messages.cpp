#include "app/cluster/cluster_messages.h"

#include <cstring>
#include <limits>

#include "volume/read/process/wire.h"

namespace isolux::app {

namespace {

using volume::WireReader;
using volume::WireWriter;

constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 30;

// What each message holds, for WireWriter and WireReader.

constexpr auto passFlag = [](auto& wire, auto& flag) { wire.pass(flag, 0, 1); };
constexpr auto passCount = [](auto& wire, auto& count) { wire.pass(count, 0, kLargestCount); };
constexpr auto passNumber = [](auto& wire, auto& number) {
  wire.pass(number, 0, std::numeric_limits<std::uint64_t>::max());
};

void passPoints(WireWriter& out, const std::vector<glm::vec3>& points) {
  out.put(std::string_view(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(glm::vec3)));
}

void passPoints(WireReader& in, std::vector<glm::vec3>& points) {
  const std::string bytes = in.text();
  if (bytes.size() % sizeof(glm::vec3) != 0) volume::throwBadAnswer("points are cut off");
  points.resize(bytes.size() / sizeof(glm::vec3));
  if (!points.empty()) std::memcpy(static_cast<void*>(points.data()), bytes.data(), bytes.size());
}

constexpr auto passSetup = [](auto& wire, auto& setup) {
  passFlag(wire, setup.failed);
  wire.pass(setup.version);
  wire.pass(setup.path);
  wire.pass(setup.scene);
  passPoints(wire, setup.seen.outer);
  passPoints(wire, setup.seen.inner);
  passFlag(wire, setup.ofOneIsovalue);
  passFlag(wire, setup.resumes);
  passFlag(wire, setup.sendsVolume);
  passCount(wire, setup.probeWidth);
  passCount(wire, setup.probeHeight);
};

constexpr auto passHello = [](auto& wire, auto& hello) {
  for (auto* text :
       {&hello.host, &hello.version, &hello.skyKey, &hello.lampsKey, &hello.arithmetic, &hello.target})
    wire.pass(*text);
  passNumber(wire, hello.volumeHash);
  passCount(wire, hello.threads);
  passFlag(wire, hello.bound);
  passCount(wire, hello.coresOfMachine);
};

constexpr auto passWork = [](auto& wire, auto& work) {
  passNumber(wire, work.tiles);
  passNumber(wire, work.paths);
  passNumber(wire, work.rays);
  wire.passFinite(work.seconds);
  wire.passFinite(work.idleSeconds);
};

constexpr auto passTile = [](auto& wire, auto& message) {
  wire.pass(message.tile, 0, 0xffffffffu);
  wire.pass(message.sky);
  wire.pass(message.lamps);
  passWork(wire, message.work);
};

}  // namespace

std::string bytesOf(const ClusterSetup& setup) {
  return volume::messageBytes(setup, passSetup);
}

ClusterSetup setupFrom(std::string_view bytes) {
  return volume::messageOf<ClusterSetup>(bytes, passSetup);
}

std::string bytesOf(const ClusterHello& hello) {
  return volume::messageBytes(hello, passHello);
}

ClusterHello helloFrom(std::string_view bytes) {
  return volume::messageOf<ClusterHello>(bytes, passHello);
}

std::string bytesOf(const TileMessage& message) {
  return volume::messageBytes(message, passTile);
}

TileMessage tileFrom(std::string_view bytes) {
  return volume::messageOf<TileMessage>(bytes, passTile);
}

std::string bytesOf(const RankWork& work) {
  return volume::messageBytes(work, passWork);
}

RankWork workFrom(std::string_view bytes) {
  return volume::messageOf<RankWork>(bytes, passWork);
}

std::string bytesOf(const base::Error& error) {
  WireWriter out;
  out.put(static_cast<std::uint64_t>(error.kind()));
  out.put(std::string_view(error.file()));
  out.put(std::string_view(error.place()));
  out.put(std::string_view(error.reason()));
  return out.bytes();
}

base::Error errorFrom(std::string_view bytes) {
  WireReader in(bytes);
  const auto kind = static_cast<base::ErrorKind>(in.number(2, 130));
  std::string file = in.text(), place = in.text(), reason = in.text();
  in.end();
  return {kind, std::move(file), std::move(place), std::move(reason)};
}

}  // namespace isolux::app
