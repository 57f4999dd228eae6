// The light of a bake over ranks on one of them: planned as any other, and baked tile by tile.
#pragma once

#include <memory>
#include <optional>

#include "app/cluster/cluster_messages.h"
#include "app/cluster/tile_baker.h"
#include "app/light/light_planner.h"
#include "gi/file/bake_file.h"
#include "scene/scene.h"

namespace isolux::app {

struct ClusterScene {
  scene::Scene scene;  // resolved
  VolumePointer volume;
  std::shared_ptr<const gi::Environment> probe;  // of the scene's file; null: it names none
  gi::VisiblePointSet seen{};
  std::optional<scene::GiTexels> texels{};  // of the file that is gone on from
};

class ClusterLight {
 public:
  // Throws base::Error as LightPlanner.
  ClusterLight(const ClusterScene& scene, std::optional<int> threads, base::Progress& progress);

  const LightPlan& plan() const { return planner_.current(); }
  TileBaker& baker() { return *baker_; }
  const TileRequests& requests() const { return requests_; }
  // What the baker bakes into.
  const gi::StoredLight& working() const { return working_; }
  // Dark, for what is finished.
  gi::StoredLight fresh() const;

 private:
  LightPlanner planner_{false, false};
  gi::StoredLight working_;
  TileRequests requests_;
  std::unique_ptr<TileBaker> baker_;
};

// Light of tiles between lattices and messages.
TileMessage tileMessage(std::uint32_t tile, const TileRequest& request, const gi::StoredLight& light);
void takeTile(const TileMessage& message, const TileRequest& request, const gi::StoredLight& into);
// Without a copy.
void shareTile(const TileRequest& request, const gi::StoredLight& from, const gi::StoredLight& into);

}  // namespace isolux::app
