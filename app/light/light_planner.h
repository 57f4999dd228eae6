// The slow part of LightController, on its planner thread: from a scene, a volume and what is seen to bakes
// and what they are asked for.
//
// Owned by one, called by one thread at a time. Bakes that it gives up end elsewhere
// (base/destroy_in_background.h). Keeps what the next scene is likely to need again: the light probe, the
// tracer, and the bakes, as long as their keys hold.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/bake/light_bake.h"
#include "gi/gloss/reflections.h"
#include "gi/ground/ground_shadow.h"
#include "gi/lattice/lattice_part.h"
#include "gi/light_scene.h"
#include "gi/picture_light.h"
#include "gi/trace/exposure_meter.h"
#include "gi/visible_point_set.h"
#include "scene/rules/gi_choice.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

// What the owner of the planner shows; values and shared pointers.
struct LightPlan {
  scene::GiChoice choice;
  std::shared_ptr<const gi::PictureLight> light;
  std::shared_ptr<gi::LightBake> sky, lamps;  // of the outer sides
  std::shared_ptr<gi::LightBake> innerSky, innerLamps;
  std::vector<std::string> warnings;
  std::vector<volume::HiddenOfSurface> hidden;  // what its tracer's rays pass
  std::string arithmetic;                       // gi::arithmeticOf() its tracer; empty: nothing is traced
  std::string target;  // the instructions it is traced with: IsosurfaceTracer::target()

  std::vector<std::shared_ptr<gi::LightBake>> bakes() const;  // those that there are
};

class LightPlanner {
 public:
  // `innerSides`: light of inner sides is planned, too. `around`: so is light around what is seen, that the
  // filter of what is seen reads; always in the background.
  explicit LightPlanner(bool background, bool innerSides = true, bool around = false)
      : background_(background), innerSides_(innerSides), around_(around || background) {}
  void setThreads(std::optional<int> threads) { threads_ = threads; }  // of the next plan
  // Wishes are for texels of this part of the lattice only. Before the first plan.
  void setPart(std::optional<gi::LatticePart> part) { part_ = part; }
  // Bakes are asked for nothing: requests() tells what for. Before the first plan.
  void setOnlyPlans() { onlyPlans_ = true; }
  // A light probe that was read elsewhere, whatever file a scene names.
  void setEnvironment(std::shared_ptr<const gi::Environment> environment) { given_ = std::move(environment); }
  // Where texels are lit while gi.texels is automatic and the volume this one: as those of a file that is
  // read.
  void setTexelsOfFile(scene::GiTexels texels, const VolumePointer& volume) {
    texelsOfFile_ = texels;
    volumeOfFile_ = volume;
  }
  ~LightPlanner() { stop(); }
  LightPlanner(const LightPlanner&) = delete;
  LightPlanner& operator=(const LightPlanner&) = delete;

  // Decides anew. Throws base::Error (light probe, memory, stopped); the plan before holds then.
  const LightPlan& plan(const scene::Scene& given, const VolumePointer& shown, base::Progress& progress);
  // Asks the bakes for what the scene and these surface points need. True if the plan's light changed: light
  // of inner sides is planned when the first is seen. Throws Error{interrupted}, Error{memory}.
  bool request(const gi::VisiblePointSet& seen, base::Progress& progress);
  void wishNothing();
  // Compresses stored transfer anew where much was added since: true if the plan's light changed. Throws
  // Error{interrupted} when stopped.
  bool compress(const base::Progress& progress);
  // The exposure is of a surface before an isovalue was dragged, or the ground of a scene before: call
  // finishAtRest() when the scene rests.
  bool isUnfinished() const { return meterPending_ || groundPending_; }
  void finishAtRest(base::Progress& progress);  // Throws Error{interrupted}
  // Light from elsewhere (a file), for lattices of the plan's own keys.
  void adopt(std::shared_ptr<gi::LightLattice> lattice, gi::LightPart part);

  const LightPlan& current() const { return plan_; }
  // What the bake of the sky's or the lamps' light would be asked for: each block once, in their order. Of a
  // planner that only plans.
  std::vector<gi::BlockRequest> requests(gi::LightPart part) const;

 private:
  // What a bake was asked for besides what is seen.
  struct Asked {
    scene::GiExtent extent = scene::GiExtent::view;
    int reach = 0;
    scene::Field field = scene::Field::trilinear;  // that is hit
    glm::dvec2 band{0.0};
    bool operator==(const Asked&) const = default;
  };
  struct Part {
    std::string key;
    std::string keyOfAll;  // the same but for an isovalue
    std::shared_ptr<const gi::TexelEstimator> estimator;
    std::shared_ptr<gi::LightBake> bake;
    std::optional<Asked> asked;
    std::array<std::vector<gi::BlockRequest>, 4> requested;  // where it only plans: by gi::Priority
    std::shared_ptr<const gi::LightLattice> before;          // of another isovalue: PictureLight::skyBefore
  };
  struct Side {
    Part sky, lamps;
  };

  void loadEnvironment(const scene::Environment& settings);
  void considerMetering(base::Progress& progress);
  void measureBrightness(base::Progress& progress);
  void considerGround(base::Progress& progress);
  void require(Side& side, const std::shared_ptr<const gi::LightScene>& light);
  void require(Part& part, const std::shared_ptr<const gi::LightScene>& light, gi::LightPart which,
               bool wanted);
  void requireInner(base::Progress& progress);
  std::array<Part*, 4> parts() { return {&outer_.sky, &outer_.lamps, &inner_.sky, &inner_.lamps}; }
  void request(Side& side, const std::vector<glm::vec3>& hits, scene::GiExtent extent,
               base::Progress& progress);
  void request(Part& part, const Asked& asked, base::Progress& progress);
  void demand(const Part& part);  // as many paths, on as many threads as there are to be
  void keep(Part part);
  std::optional<Part> kept(const std::string& key);  // taken out
  static void wishNothing(Part& part);
  void takeBakes();
  static std::shared_ptr<const gi::LightLattice> standIn(const Part& part);
  std::shared_ptr<gi::LightBake> makeBake(const Part& part, std::shared_ptr<gi::LightLattice> lattice) const;
  int threads() const;
  void stop();
  static void stop(Side& side);
  void want(Part& part, gi::Priority request, std::vector<gi::BlockRequest> blocks) const;
  void publish();
  int reach() const;

  bool background_, innerSides_, around_, onlyPlans_ = false;
  std::optional<gi::LatticePart> part_;
  std::optional<scene::GiTexels> texelsOfFile_;
  std::weak_ptr<const volume::PreparedVolume> volumeOfFile_;
  std::optional<int> threads_;
  scene::Scene scene_;
  VolumePointer volume_;

  std::shared_ptr<const gi::Environment> given_;
  std::string environmentName_;  // what environment_ was loaded from
  std::shared_ptr<const gi::Environment> environment_;
  int projectedOrder_ = 0;
  gi::EnvironmentProjection projection_;
  std::shared_ptr<const volume::IsosurfaceTracer> tracer_;
  struct TracerKey {
    const volume::PreparedVolume* volume = nullptr;
    scene::Inside inside = scene::Inside::above;
    std::uint64_t hidden = 0;  // volume::keyOf()
    std::uint64_t cut = 0;     // volume::SurfaceCut::key()
    bool operator==(const TracerKey&) const = default;
  };
  TracerKey tracerOf_;

  std::shared_ptr<const gi::LightScene> lightScene_;
  std::shared_ptr<const gi::GlossLight> gloss_;  // null: no surface is glossy
  std::optional<gi::SurfaceBrightness> brightness_;
  scene::Scene brightnessOf_;  // as far as it depends on it, in this volume and environment:
  std::pair<const volume::PreparedVolume*, std::string> brightnessStage_;
  bool meterPending_ = false;
  std::shared_ptr<const gi::GroundShadow> ground_;  // null: none
  bool groundPending_ = false;                      // ground_ is of a scene before
  Side outer_, inner_;
  std::deque<Part> kept_;   // of settings before these, which may come back; the last first
  bool innerSeen_ = false;  // by the last request
  std::shared_ptr<const gi::TransferBasis> basis_;
  int basisComponents_ = 0, basisBits_ = 0;
  std::uint64_t basisTexels_ = 0, basisRevision_ = 0;
  std::uint64_t version_ = 0;
  LightPlan plan_;
};

}  // namespace isolux::app
