#include "app/cluster/cluster_messages.h"

#include <cstring>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "volume/read/process/wire.h"

namespace isolux::app {

namespace {

using volume::WireReader;
using volume::WireWriter;
using Points = std::vector<glm::vec3>;

constexpr std::uint64_t kLargestCount = std::uint64_t{1} << 30;

// The fields of a message in the order in which they are sent.
template <class Message>
auto fieldsOf(Message& m) {
  using Kind = std::remove_const_t<Message>;
  if constexpr (std::is_same_v<Kind, ClusterSetup>)
    return std::tie(m.failed, m.version, m.path, m.scene, m.seen.outer, m.seen.inner, m.ofOneIsovalue,
                    m.resumes, m.sendsVolume, m.probeWidth, m.probeHeight);
  else if constexpr (std::is_same_v<Kind, ClusterHello>)
    return std::tie(m.host, m.version, m.skyKey, m.lampsKey, m.arithmetic, m.target, m.volumeHash, m.threads,
                    m.bound, m.coresOfMachine);
  else if constexpr (std::is_same_v<Kind, TileMessage>)
    return std::tie(m.tile, m.sky, m.lamps, m.work.tiles, m.work.paths, m.work.rays, m.work.seconds,
                    m.work.idleSeconds);
  else
    return std::tie(m.tiles, m.paths, m.rays, m.seconds, m.idleSeconds);
}

void passPoints(WireWriter& out, const Points& points) {
  out.put(std::string_view(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(glm::vec3)));
}
void passPoints(WireReader& in, Points& points) {
  const std::string bytes = in.text();
  if (bytes.size() % sizeof(glm::vec3) != 0) volume::throwBadAnswer("points are cut off");
  points.resize(bytes.size() / sizeof(glm::vec3));
  if (!points.empty()) std::memcpy(static_cast<void*>(points.data()), bytes.data(), bytes.size());
}

constexpr auto passField = [](auto& wire, auto& field) {
  using Field = std::remove_cvref_t<decltype(field)>;
  if constexpr (std::is_same_v<Field, Points>)
    passPoints(wire, field);
  else if constexpr (std::is_same_v<Field, std::string>)
    wire.pass(field);
  else if constexpr (std::is_same_v<Field, double>)
    wire.passFinite(field);
  else if constexpr (std::is_same_v<Field, bool>)
    wire.pass(field, 0, 1);
  else if constexpr (std::is_same_v<Field, int>)
    wire.pass(field, 0, kLargestCount);
  else
    wire.pass(field, 0, std::numeric_limits<Field>::max());
};

constexpr auto passFields = [](auto& wire, auto& message) {
  std::apply([&](auto&... field) { (passField(wire, field), ...); }, fieldsOf(message));
};

}  // namespace

template <class Message>
std::string bytesOf(const Message& message) {
  return volume::messageBytes(message, passFields);
}

template <class Message>
Message messageFrom(std::string_view bytes) {
  return volume::messageOf<Message>(bytes, passFields);
}

template std::string bytesOf(const ClusterSetup&);
template std::string bytesOf(const ClusterHello&);
template std::string bytesOf(const TileMessage&);
template std::string bytesOf(const RankWork&);
template ClusterSetup messageFrom(std::string_view);
template ClusterHello messageFrom(std::string_view);
template TileMessage messageFrom(std::string_view);
template RankWork messageFrom(std::string_view);

std::string bytesOf(const base::Error& error) {
  WireWriter out;
  out.put(static_cast<std::uint64_t>(error.kind()));
  for (const std::string& text : {error.file(), error.place(), error.reason()}) out.pass(text);
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
