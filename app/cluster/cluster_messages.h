// What the ranks of a bake tell each other, as bytes. Reading them throws base::Error{input} where they are
// not what writing makes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/cluster/tile_baker.h"
#include "base/error.h"
#include "gi/visible_point_set.h"

namespace isolux::app {

enum class ClusterMessage : int {
  here,    // a worker to rank 0 at once: its host
  hello,   // a worker to rank 0, when it is ready
  work,    // rank 0 to a worker: a tile, and what is lit of it
  light,   // a worker to rank 0: a finished tile
  drop,    // rank 0 to a worker: somebody else has finished the tile
  failed,  // a worker to rank 0: what ended it; it waits for `stop`
  stop,    // rank 0 to a worker: no more
  bye      // a worker to rank 0: its work, and that it leaves
};

// Broadcast by rank 0 before anything else.
struct ClusterSetup {
  bool failed = false;  // rank 0 has ended with an error: there is nothing to do
  std::string version;  // of the program
  std::string path;     // the volume's name on rank 0's command line
  std::string scene;    // resolved, JSON of scene::toJson()
  gi::VisiblePointSet seen{};
  bool ofOneIsovalue = false, resumes = false;  // texels are as those of the file that is gone on from
  bool sendsVolume = false;
  int probeWidth = 0, probeHeight = 0;  // of the light probe that follows; 0: none
};

struct ClusterHello {
  std::string host, version, skyKey, lampsKey, arithmetic, target;
  std::uint64_t volumeHash = 0;
  int threads = 1;
  bool bound = false;  // it may use one core, its machine has more, and nobody asked for one thread
  int coresOfMachine = 1;
};

struct TileMessage {
  std::uint32_t tile = 0;
  std::string sky, lamps;  // tileBytes()
  RankWork work{};         // of the sender so far
};

// Convert the messages above and RankWork to bytes and back. messageFrom() throws base::Error{input}.
template <class Message>
std::string bytesOf(const Message& message);
template <class Message>
Message messageFrom(std::string_view bytes);

std::string bytesOf(const base::Error& error);
base::Error errorFrom(std::string_view bytes);

}  // namespace isolux::app
