#include "app/cluster/cluster_messages.h"

#include <cstring>

#include "volume/read/process/wire.h"

namespace isolux::app {

namespace {

using volume::WireReader;
using volume::WireWriter;

constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 30;

void putPoints(WireWriter& out, const std::vector<glm::vec3>& points) {
  out.put(std::string_view(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(glm::vec3)));
}

std::vector<glm::vec3> pointsFrom(WireReader& in) {
  const std::string bytes = in.text();
  if (bytes.size() % sizeof(glm::vec3) != 0) volume::throwBadAnswer("points are cut off");
  std::vector<glm::vec3> points(bytes.size() / sizeof(glm::vec3));
  if (!points.empty()) std::memcpy(static_cast<void*>(points.data()), bytes.data(), bytes.size());
  return points;
}

void putFlag(WireWriter& out, bool flag) {
  out.put(std::uint64_t{flag ? 1u : 0u});
}

bool flagFrom(WireReader& in) {
  return in.number(0, 1) == 1;
}

int countFrom(WireReader& in) {
  return static_cast<int>(in.number(0, kLargestCount));
}

void putWork(WireWriter& out, const RankWork& work) {
  out.put(work.tiles);
  out.put(work.paths);
  out.put(work.rays);
  out.put(work.seconds);
  out.put(work.idleSeconds);
}

RankWork workFrom(WireReader& in) {
  RankWork work;
  work.tiles = in.number();
  work.paths = in.number();
  work.rays = in.number();
  work.seconds = in.finite();
  work.idleSeconds = in.finite();
  return work;
}

}  // namespace

std::string bytesOf(const ClusterSetup& setup) {
  WireWriter out;
  putFlag(out, setup.failed);
  out.put(std::string_view(setup.version));
  out.put(std::string_view(setup.path));
  out.put(std::string_view(setup.scene));
  putPoints(out, setup.seen.outer);
  putPoints(out, setup.seen.inner);
  putFlag(out, setup.ofOneIsovalue);
  putFlag(out, setup.resumes);
  putFlag(out, setup.sendsVolume);
  out.put(static_cast<std::uint64_t>(setup.probeWidth));
  out.put(static_cast<std::uint64_t>(setup.probeHeight));
  return out.bytes();
}

ClusterSetup setupFrom(std::string_view bytes) {
  WireReader in(bytes);
  ClusterSetup setup;
  setup.failed = flagFrom(in);
  setup.version = in.text();
  setup.path = in.text();
  setup.scene = in.text();
  setup.seen.outer = pointsFrom(in);
  setup.seen.inner = pointsFrom(in);
  setup.ofOneIsovalue = flagFrom(in);
  setup.resumes = flagFrom(in);
  setup.sendsVolume = flagFrom(in);
  setup.probeWidth = countFrom(in);
  setup.probeHeight = countFrom(in);
  in.end();
  return setup;
}

std::string bytesOf(const ClusterHello& hello) {
  WireWriter out;
  for (const std::string* text :
       {&hello.host, &hello.version, &hello.skyKey, &hello.lampsKey, &hello.arithmetic, &hello.target})
    out.put(std::string_view(*text));
  out.put(hello.volumeHash);
  out.put(static_cast<std::uint64_t>(hello.threads));
  putFlag(out, hello.bound);
  out.put(static_cast<std::uint64_t>(hello.coresOfMachine));
  return out.bytes();
}

ClusterHello helloFrom(std::string_view bytes) {
  WireReader in(bytes);
  ClusterHello hello;
  for (std::string* text :
       {&hello.host, &hello.version, &hello.skyKey, &hello.lampsKey, &hello.arithmetic, &hello.target})
    *text = in.text();
  hello.volumeHash = in.number();
  hello.threads = countFrom(in);
  hello.bound = flagFrom(in);
  hello.coresOfMachine = countFrom(in);
  in.end();
  return hello;
}

std::string bytesOf(const TileMessage& message) {
  WireWriter out;
  out.put(std::uint64_t{message.tile});
  out.put(std::string_view(message.sky));
  out.put(std::string_view(message.lamps));
  putWork(out, message.work);
  return out.bytes();
}

TileMessage tileFrom(std::string_view bytes) {
  WireReader in(bytes);
  TileMessage message;
  message.tile = static_cast<std::uint32_t>(in.number(0, 0xffffffffu));
  message.sky = in.text();
  message.lamps = in.text();
  message.work = workFrom(in);
  in.end();
  return message;
}

std::string bytesOf(const RankWork& work) {
  WireWriter out;
  putWork(out, work);
  return out.bytes();
}

RankWork workFrom(std::string_view bytes) {
  WireReader in(bytes);
  const RankWork work = workFrom(in);
  in.end();
  return work;
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
