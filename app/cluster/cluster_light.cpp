#include "app/cluster/cluster_light.h"

#include "app/cluster/tile_bytes.h"

namespace isolux::app {

ClusterLight::ClusterLight(const ClusterScene& of, std::optional<int> threads, base::Progress& progress) {
  planner_.setOnlyPlans();
  planner_.setThreads(threads);
  if (of.probe) planner_.setEnvironment(of.probe);
  scene::Scene scene = of.scene;
  if (scene.gi.texels == scene::GiTexels::automatic && of.texels) scene.gi.texels = *of.texels;
  const LightPlan& plan = planner_.plan(scene, of.volume, progress);
  planner_.request(of.seen, progress);
  if (plan.sky) working_.sky = plan.sky->lattice();
  if (plan.lamps) working_.lamps = plan.lamps->lattice();
  const auto& any = working_.sky ? working_.sky : working_.lamps;
  requests_ = tileRequests(any->geometry(), planner_.requests(gi::LightPart::sky),
                           planner_.requests(gi::LightPart::lamps));
  baker_ = std::make_unique<TileBaker>(plan.sky, plan.lamps, requests_,
                                       static_cast<std::uint32_t>(of.scene.gi.samples));
}

gi::StoredLight ClusterLight::fresh() const {
  const auto like = [](const std::shared_ptr<gi::LightLattice>& lattice) {
    return lattice
               ? std::make_shared<gi::LightLattice>(lattice->geometry(), lattice->content(), lattice->key())
               : nullptr;
  };
  return {like(working_.sky), like(working_.lamps)};
}

TileMessage tileMessage(std::uint32_t tile, const TileRequest& request, const gi::StoredLight& light) {
  TileMessage message;
  message.tile = tile;
  if (light.sky) message.sky = tileBytes(*light.sky, request.sky);
  if (light.lamps) message.lamps = tileBytes(*light.lamps, request.lamps);
  return message;
}

void takeTile(const TileMessage& message, const TileRequest& request, const gi::StoredLight& into) {
  if (into.sky) takeTileBytes(message.sky, request.sky, *into.sky);
  if (into.lamps) takeTileBytes(message.lamps, request.lamps, *into.lamps);
}

void shareTile(const TileRequest& request, const gi::StoredLight& from, const gi::StoredLight& into) {
  for (const gi::BlockRequest& wanted : request.sky)
    if (from.sky) into.sky->share(wanted.block, from.sky->at(wanted.block));
  for (const gi::BlockRequest& wanted : request.lamps)
    if (from.lamps) into.lamps->share(wanted.block, from.lamps->at(wanted.block));
}

}  // namespace isolux::app
