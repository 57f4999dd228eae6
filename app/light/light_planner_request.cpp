// What bakes are asked for: by what is seen, by what may be seen, and by what the scene wants beside it.
#include <algorithm>

#include "app/light/light_planner.h"
#include "gi/texels/texel_band.h"
#include "gi/texels/texel_sets.h"

namespace isolux::app {

int LightPlanner::reach() const {
  const scene::GiInterpolation interpolation = scene_.gi.interpolation;
  return interpolation == scene::GiInterpolation::tricubic ? 2 : 1;
}

bool LightPlanner::request(const gi::VisiblePointSet& seen, base::Progress& progress) {
  if (!plan_.light || (!outer_.sky.bake && !outer_.lamps.bake)) return false;
  innerSeen_ = innerSides_ && !seen.inner.empty();
  const bool complete = !inner_.sky.bake == !outer_.sky.bake && !inner_.lamps.bake == !outer_.lamps.bake;
  const bool changes = innerSeen_ && !complete;
  if (changes) {
    requireInner(progress);
    takeBakes();
    publish();
  }
  request(outer_, seen.outer, scene_.gi.extent, progress);
  request(inner_, seen.inner, scene::GiExtent::view, progress);
  return changes;
}

void LightPlanner::request(Side& side, const std::vector<glm::vec3>& hits, scene::GiExtent extent,
                           base::Progress& progress) {
  if (!side.sky.bake && !side.lamps.bake) return;
  const gi::LatticeGeometry& lattice = (side.sky.bake ? side.sky : side.lamps).bake->lattice()->geometry();
  const std::vector<gi::BlockRequest> visible = gi::texelsAround(lattice, hits, reach());
  std::vector<gi::BlockRequest> nearby;
  // A command asks for its picture alone, unless told otherwise; a viewer moves on.
  if (around_) nearby = gi::texelsBeside(lattice, visible, 2);
  Asked asked{extent, reach(), scene_.hit.field, {}};
  if (extent == scene::GiExtent::band) asked.band = scene_.gi.band.value();
  for (Part* part : {&side.sky, &side.lamps}) {
    if (!part->bake) continue;
    want(*part, gi::Priority::visible, visible);
    want(*part, gi::Priority::nearby, nearby);
    request(*part, asked, progress);
  }
}

void LightPlanner::request(Part& part, const Asked& asked, base::Progress& progress) {
  if (part.asked == asked) return;
  const gi::LatticeGeometry& lattice = part.bake->lattice()->geometry();
  // A command that asks for all light hears at once that it does not fit; a window's grows as far as it goes.
  // Of a part nobody knows how many texels have light.
  if (asked.extent == scene::GiExtent::full && !background_ && !part_ && !onlyPlans_)
    part.bake->lattice()->checkThatAllFits();
  std::vector<gi::BlockRequest> band;
  if (asked.extent == scene::GiExtent::band)
    band = gi::texelsOfBand(lattice, volume_->grid(), asked.band.x, asked.band.y, reach(), progress,
                            scene_.hit.field);
  want(part, gi::Priority::band, std::move(band));
  want(part, gi::Priority::rest,
       asked.extent == scene::GiExtent::full ? gi::allTexels(lattice) : std::vector<gi::BlockRequest>{});
  part.asked = asked;
}

void LightPlanner::want(Part& part, gi::Priority request, std::vector<gi::BlockRequest> blocks) const {
  if (part_) blocks = gi::blocksOfPart(part.bake->lattice()->geometry(), *part_, std::move(blocks));
  if (onlyPlans_)
    part.requested[static_cast<std::size_t>(request)] = std::move(blocks);
  else
    part.bake->want(request, std::move(blocks));
}

std::vector<gi::BlockRequest> LightPlanner::requests(gi::LightPart which) const {
  const Part& part = which == gi::LightPart::sky ? outer_.sky : outer_.lamps;
  std::vector<gi::BlockRequest> all;
  for (const auto& blocks : part.requested) all.insert(all.end(), blocks.begin(), blocks.end());
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.block < b.block; });
  std::vector<gi::BlockRequest> once;
  for (const gi::BlockRequest& wanted : all)
    if (!once.empty() && once.back().block == wanted.block)
      once.back().texels |= wanted.texels;
    else
      once.push_back(wanted);
  return once;
}

void LightPlanner::wishNothing() {
  for (Part* part : parts())
    if (part->bake) wishNothing(*part);
}

void LightPlanner::wishNothing(Part& part) {
  for (const gi::Priority kind :
       {gi::Priority::visible, gi::Priority::nearby, gi::Priority::band, gi::Priority::rest})
    part.bake->want(kind, {});
  part.asked.reset();
}

}  // namespace isolux::app
