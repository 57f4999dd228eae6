#include "volume/prepared_volume.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "volume/phantom.h"

namespace isolux::volume {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The world box of the voxel domain; an axis along which it has no extent (a single slice) gets half a voxel
// on both sides, so that a camera can be placed before any volume.
scene::VolumeFacts factsOf(const Grid& grid) {
  scene::VolumeFacts facts;
  grid.geometry().worldBounds(facts.boundsMinMm, facts.boundsMaxMm);
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const glm::dvec3 extent = facts.boundsMaxMm - facts.boundsMinMm;
  const double least = std::min({spacing.x, spacing.y, spacing.z});
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] >= least * 1e-6) continue;
    facts.boundsMinMm[axis] -= 0.5 * least;
    facts.boundsMaxMm[axis] += 0.5 * least;
  }
  return facts;
}

std::shared_ptr<PreparedVolume> prepare(Volume volume, scene::Progress& progress) {
  const Clock::time_point start = Clock::now();
  auto prepared = std::make_shared<PreparedVolume>();
  prepared->volume = std::move(volume);
  progress.report(0.0, "building blocks");
  prepared->blocks = std::make_shared<MinMaxBlocks>(prepared->grid(), kBlockCells, progress);
  progress.report(0.6, "counting values");
  prepared->histogram = makeHistogram(prepared->grid());
  progress.throwIfStopped();
  prepared->facts = factsOf(prepared->grid());
  prepared->facts.suggestedIsovalue =
      suggestIsovalue(prepared->grid(), prepared->histogram, prepared->volume.unit);
  prepared->prepareSeconds = secondsSince(start);
  progress.report(1.0, "ready");
  return prepared;
}

}  // namespace

std::shared_ptr<const PreparedVolume> prepareVolume(Volume volume, scene::Progress& progress) {
  return prepare(std::move(volume), progress);
}

std::shared_ptr<const PreparedVolume> loadVolume(const scene::Source& source, scene::Progress& progress) {
  const Clock::time_point start = Clock::now();
  progress.report(0.0, "reading");
  Volume volume = readVolume(source.path, readOptions(source), progress);
  const double readSeconds = secondsSince(start);
  const std::shared_ptr<PreparedVolume> prepared = prepare(std::move(volume), progress);
  prepared->readSeconds = readSeconds;
  constexpr std::string_view prefix = "phantom:";
  if (source.path.starts_with(prefix)) {
    const std::string name = parsePhantom(std::string_view(source.path).substr(prefix.size())).name;
    for (const PhantomInfo& info : phantoms()) {
      const bool inRange =
          prepared->grid().minimum() < info.isovalue && info.isovalue < prepared->grid().maximum();
      if (info.name == name && inRange) prepared->facts.suggestedIsovalue = info.isovalue;
    }
  }
  return prepared;
}

}  // namespace isolux::volume
