// Manages the baked lighting of a scene: decides what is baked, bakes it on background threads, and provides
// the result so far to frames.
//
// The owner (the window, or a command) sets scenes and visible points, and polls; there are no callbacks. A
// planner thread does the longer tasks (environment map, tracer, texel sets, compression); gi::LightBake's
// threads do the rest. Keys (gi::lightKey) decide what a change of the scene invalidates. View, isovalue,
// look, exposure, the colour of a unit sky and, with transfer, the environment and its rotation invalidate
// nothing; light sources invalidate only their own light. All members are safe from one owner thread.
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
#include "gi/visible_point_set.h"
#include "scene/rules/gi_choice.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct LightState {
  enum class Phase { off, preparing, baking, paused, finished, failed };
  Phase phase = Phase::off;
  scene::GiChoice choice;     // what is baked, and why
  std::string mode;           // modeName()
  gi::BakeCounters counters;  // of the sky's and the light sources' bakes together
  // Fraction of the visible texels that are lit without coarse noise (gi::kSmoothSamples); nullopt: unknown
  // yet, or nothing is visible.
  std::optional<double> smooth;
  std::optional<base::Error> error;
  std::vector<std::string> warnings;  // "3 pixels of the light probe are not numbers"
};

// Returns "irradiance", "transfer + lamps", "off".
std::string modeName(const scene::GiChoice& choice);

class LightController {
 public:
  struct Options {
    bool background = false;                    // low priority: gi::LightBake::Options
    std::optional<int> threads = std::nullopt;  // scene::HostSettings::threads
    bool innerSides = true;                     // bake visible back faces; else their light is unshadowed
    std::optional<gi::LatticePart> part = std::nullopt;  // light of only these texels
    bool around = false;  // also around visible texels, as always in the background: less noise at rims
  };
  explicit LightController(Options options);
  ~LightController();  // stops all work without waiting for its end: base/destroy_in_background.h

  // Sets the scene. Requires `resolved` from scene::resolve; `volume` may be null.
  void setScene(const scene::Scene& resolved, std::shared_ptr<const volume::PreparedVolume> volume);
  // Automatic exposure is that of the surface as the scene's camera sees it; otherwise, and at first, as it
  // is seen from the front, so that turning the view does not change it. Takes effect with the next
  // setScene().
  void meterView(bool view);
  // Returns the automatic exposure if it is that of the view: a picture must carry it to be drawn alike
  // again.
  std::optional<double> viewExposure() const;
  // Sets the visible surface points of the image: Renderer::hitVoxels().
  void setVisible(gi::VisiblePointSet hitVoxels);
  void setThreads(std::optional<int> threads);  // takes effect at once
  void setPaused(bool paused);
  bool paused() const;
  void yield(bool yielding);  // gi::LightBake::yield()

  // Returns the light for Renderer::setLight(); null while there is none. The pointer stays the same until
  // something other than the lattices changes. An update after setScene() or setVisible() may take a moment:
  // settle().
  std::shared_ptr<const gi::PictureLight> light() const;
  // Returns a number that changes whenever a redrawn frame would show other light.
  std::uint64_t revision() const;
  LightState state() const;

  // Waits until the planner has processed all calls so far. Returns false at the timeout [s].
  bool settle(double timeoutSeconds) const;
  // Waits until all requested texels have all their paths. Reports to `progress`; returns false when that is
  // stopped, or at the timeout [s]. Throws the error of a failed bake or planner.
  bool finish(base::Progress& progress, double timeoutSeconds = std::numeric_limits<double>::infinity());
  // Keeps the light and requests no more, until the scene or the view changes.
  void cancel();

  // Writes the bake as a file (gi/file/bake_file.h); writes none before anything is planned. `part`: the part
  // of a bake that the file contains. load() takes over light that fits the scene, throws base::Error naming
  // what differs, and returns the facts stated in the file. A file names the arithmetic of its light,
  // including that of loaded light.
  void save(const std::filesystem::path& file, base::Progress& progress,
            const std::optional<gi::BakedPart>& part = std::nullopt) const;
  gi::StoredLight stored() const;  // what save() writes
  gi::BakeFacts load(const std::filesystem::path& file, base::Progress& progress);
  // Returns gi::arithmeticOf() the planned work, once that is settled; "" if nothing is planned.
  std::string arithmetic() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::app
