// Keeps the light of a scene: decides what is stored of it, bakes that on background threads, and hands
// pictures what there is so far.
//
// The owner (the window, or a command) tells it scenes and what is seen, and polls; nothing calls back. A
// planner thread does what takes longer than a moment (light probe, tracer, texel sets, compression);
// gi::LightBake's threads do the rest. What a change of the scene invalidates is decided by keys
// (gi::lightKey): view, isovalue, look, exposure, colour of a unit sky, and with stored transfer the
// environment and its rotation, invalidate nothing; lamps drop the lamps' light only. All members are safe
// from one owner thread.
#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "gi/bake/light_bake.h"
#include "gi/file/bake_file.h"
#include "gi/picture_light.h"
#include "gi/seen_points.h"
#include "scene/rules/gi_choice.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

struct LightState {
  enum class Phase { off, preparing, baking, paused, finished, failed };
  Phase phase = Phase::off;
  scene::GiChoice choice;     // what is stored, and why
  std::string mode;           // modeName()
  gi::BakeCounters counters;  // of the sky's and the lamps' light together
  // How much of what is seen is lit without coarse noise (gi::kSmoothSamples); none: nothing is known of it
  // yet, or nothing is seen.
  std::optional<double> smooth;
  std::optional<base::Error> error;
  std::vector<std::string> warnings;  // "3 pixels of the light probe are not numbers"
};

// "irradiance", "transfer + lamps", "off"
std::string modeName(const scene::GiChoice& choice);

class LightController {
 public:
  struct Options {
    bool background = false;                             // bake politely: gi::LightBake::Options
    std::optional<int> threads = std::nullopt;           // scene::Machine::threads
    bool innerSides = true;                              // lit where they are seen; else their light is local
    std::optional<gi::LatticePart> part = std::nullopt;  // light of these texels only
    bool around = false;  // light around what is seen, too, as always in the background: less noise at rims
  };
  explicit LightController(Options options);
  ~LightController();  // stops all work without waiting for its end: base/retire.h

  // `resolved` by scene::resolve; `volume` may be null.
  void setScene(const scene::Scene& resolved, std::shared_ptr<const volume::PreparedVolume> volume);
  // The surface points of the picture: Renderer::hitVoxels().
  void setVisible(gi::SeenPoints hitVoxels);
  void setThreads(std::optional<int> threads);  // from now on
  void setPaused(bool paused);
  bool paused() const;
  void yield(bool yielding);  // gi::LightBake::yield()

  // For Renderer::setLight(); null while there is none. The same pointer until something but the lattices
  // changes. After setScene() or setVisible() it may take a moment: settle().
  std::shared_ptr<const gi::PictureLight> light() const;
  // Changes whenever a picture drawn anew would show other light.
  std::uint64_t revision() const;
  LightState state() const;

  // Waits until the planner has taken in everything told so far; false at the timeout.
  bool settle(double timeoutSeconds) const;
  // Waits until all that is wanted has all its paths. Reports to `progress`; false when that is stopped, or
  // at the timeout. Throws what a bake or the planner failed with.
  bool finish(base::Progress& progress, double timeoutSeconds = std::numeric_limits<double>::infinity());
  // Keeps the light it has and stops wanting more, until the scene or the view changes.
  void cancel();

  // The bake as a file (gi/file/bake_file.h); none is written before anything is planned. `part`: what the
  // file says of the part that it is. load() takes over light that fits the scene: throws base::Error naming
  // what differs. A file says by which arithmetic its light was computed, that of what was loaded included;
  // load() returns what the file says of itself.
  void save(const std::filesystem::path& file, base::Progress& progress,
            const std::optional<gi::BakedPart>& part = std::nullopt) const;
  gi::StoredLight stored() const;  // what save() writes
  gi::BakeFacts load(const std::filesystem::path& file, base::Progress& progress);
  // gi::arithmeticOf() what is planned, once that is settled; empty: nothing is.
  std::string arithmetic() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::app
