// What ranks other than 0 do (cluster_bake.h).
#include <chrono>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cluster/cluster_bake.h"
#include "app/cluster/cluster_volume.h"
#include "app/cluster/rank_facts.h"
#include "base/error.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using base::Error;
using base::ErrorKind;

void tell(Ranks& ranks, ClusterMessage kind, std::string bytes) {
  ranks.send(0, static_cast<int>(kind), std::move(bytes));
}

// False: rank 0 has ended before there was anything to do.
bool receiveScene(Ranks& ranks, const LoadVolume& load, ClusterScene& scene, base::Progress& progress) {
  std::string bytes;
  broadcastText(ranks, bytes, progress);
  const ClusterSetup setup = messageFrom<ClusterSetup>(bytes);
  if (setup.failed) return false;
  scene.scene = scene::fromJson(nlohmann::json::parse(setup.scene));
  scene.seen = setup.seen;
  if (setup.resumes) scene.texels = setup.ofOneIsovalue ? scene::GiTexels::shown : scene::GiTexels::own;
  scene.probe = broadcastProbe(ranks, nullptr, setup.probeWidth, setup.probeHeight, progress);
  if (setup.sendsVolume) {
    scene.volume = broadcastVolume(ranks, nullptr, progress);
    return true;
  }
  try {
    scene.volume = load(setup.path, scene.scene.source);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    throw Error(error.kind(), error.file(), error.place(),
                error.reason() + "; --send-volume sends it from rank 0");
  }
  return true;
}

class Worker {
 public:
  Worker(Ranks& ranks, ClusterLight& light) : ranks_(ranks), light_(light) {}

  void run(const base::Progress& progress) {
    Pause pause;
    while (!stopped_) {
      progress.throwIfStopped();
      bool happened = false;
      while (const auto message = ranks_.next()) {
        hear(*message);
        happened = true;
      }
      for (const std::uint32_t tile : light_.baker().takeFinished()) {
        TileMessage message = tileMessage(tile, light_.baker().requestOf(tile), light_.working());
        message.work = light_.baker().work();
        tell(ranks_, ClusterMessage::light, bytesOf(message));
        light_.baker().forget(tile);
        happened = true;
      }
      pause.after(happened);
    }
    tell(ranks_, ClusterMessage::bye, bytesOf(light_.baker().work()));
  }

 private:
  void hear(const RankMessage& message) {
    const auto kind = static_cast<ClusterMessage>(message.kind);
    if (kind == ClusterMessage::stop) stopped_ = true;
    if (kind != ClusterMessage::work && kind != ClusterMessage::drop) return;
    const TileMessage tile = messageFrom<TileMessage>(message.bytes);
    if (kind == ClusterMessage::drop) return light_.baker().drop(tile.tile);
    takeTile(tile, light_.baker().requestOf(tile.tile), light_.working());
    light_.baker().begin(tile.tile);
  }

  Ranks& ranks_;
  ClusterLight& light_;
  bool stopped_ = false;
};

// Until rank 0 has heard of the error and says stop, or does not.
bool waitForStop(Ranks& ranks, const base::Progress& progress) {
  constexpr auto patience = std::chrono::seconds(10);
  const auto begin = std::chrono::steady_clock::now();
  Pause pause;
  while (std::chrono::steady_clock::now() - begin < patience) {
    progress.throwIfStopped();
    const auto message = ranks.next();
    if (message && static_cast<ClusterMessage>(message->kind) == ClusterMessage::stop) return true;
    pause.after(message.has_value());
  }
  return false;
}

}  // namespace

std::optional<Error> serveClusterBake(Ranks& ranks, const ClusterOptions& options, const LoadVolume& load,
                                      base::Progress& progress) {
  tell(ranks, ClusterMessage::here, hostName());
  std::optional<Error> failure;
  try {
    ClusterScene scene;
    if (!receiveScene(ranks, load, scene, progress)) return std::nullopt;
    ClusterLight light(scene, options.threads, progress);
    tell(ranks, ClusterMessage::hello,
         bytesOf(helloOf(light, scene.volume->grid(), options.threads, options.threadsAsked)));
    Worker(ranks, light).run(progress);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    failure = error;
  } catch (const std::bad_alloc&) {
    failure = Error(ErrorKind::memory, "", "", "not enough memory");
  }
  if (failure) tell(ranks, ClusterMessage::failed, bytesOf(*failure));
  if (failure && !waitForStop(ranks, progress)) return failure;
  if (failure) return std::nullopt;
  while (!ranks.allSent()) {
    progress.throwIfStopped();
    ranks.next();
  }
  return std::nullopt;
}

}  // namespace isolux::app
