// One bake over ranks: what rank 0 does from its scene to its file, and what the others do.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cluster/cluster_master.h"
#include "app/cluster/ranks.h"
#include "app/light/light_controller.h"
#include "base/error.h"

namespace isolux::app {

struct ClusterOptions {
  std::filesystem::path out{};
  double checkpointSeconds = 60.0;
  double farewellSeconds = 5.0;  // that ranks are given to answer when they are told to stop
  bool mixArithmetic = false, sendVolume = false;
  std::optional<int> threads{};  // of this rank; none: as many as --threads allows
  bool threadsAsked = false;     // somebody has said how many
};

struct ClusterResult {
  LightState state;  // of all ranks together
  std::vector<RankReport> ranks;
  gi::StoredLight light;
  std::vector<std::string> notes;  // lines about ranks
};

// On rank 0. Begins as it is made: the others wait for it, and must be told when nothing comes of it.
class ClusterBake {
 public:
  ClusterBake(Ranks& ranks, ClusterOptions options) : ranks_(ranks), options_(std::move(options)) {}

  // `path` as the command line has it; `scene` is resolved. Writes the file: checkpoints, and the whole. When
  // stopped it has written what is finished, and throws. Throws as ClusterMaster and gi::writeBakeFile().
  ClusterResult run(const std::string& path, ClusterScene scene, base::Progress& progress);
  // Tells the others that there is nothing (more) to do. True: all have answered, and Ranks::end() may
  // follow. Once run() has returned it knows.
  bool release();

 private:
  void sendScene(const std::string& path, ClusterScene& scene, base::Progress& progress);
  // Goes on with the file where it fits, else begins anew.
  gi::StoredLight begin(const ClusterScene& scene, const ClusterLight& light, std::string& replaced,
                        base::Progress& progress) const;
  void bake(const gi::StoredLight& finished, const ClusterScene& scene, base::Progress& progress);
  gi::StoredLight stamped(const gi::StoredLight& finished) const;  // with the arithmetic of all ranks
  ClusterResult result(const gi::StoredLight& finished) const;

  Ranks& ranks_;
  ClusterOptions options_;
  bool setUp_ = false;  // the others have heard of the scene, or that there is none
  std::optional<bool> released_;
  std::optional<ClusterLight> light_;
  std::optional<ClusterMaster> master_;
  double bakedSeconds_ = 0.0;  // from the first tile to the last
};

// On the others, until rank 0 has no more to do: bakes what it is given. `load` reads the volume of a path of
// rank 0's command line, or of this one's own where they differ. Its errors are rank 0's to print; returns
// one that rank 0 does not hear, after which all must be aborted.
using LoadVolume = std::function<VolumePointer(const std::string& path, const scene::Source& source)>;
std::optional<base::Error> serveClusterBake(Ranks& ranks, const ClusterOptions& options,
                                            const LoadVolume& load, base::Progress& progress);

}  // namespace isolux::app
