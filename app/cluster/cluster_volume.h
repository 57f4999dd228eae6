// A volume and a light probe from rank 0 to all.
#pragma once

#include <memory>

#include "app/cluster/ranks.h"
#include "gi/sampling/environment.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// `volume` is rank 0's; null elsewhere. Returns it, prepared there. Throws base::Error{memory},
// {interrupted}.
std::shared_ptr<const volume::PreparedVolume> broadcastVolume(
    Ranks& ranks, std::shared_ptr<const volume::PreparedVolume> volume, base::Progress& progress);

// Of this size; `probe` is rank 0's, null elsewhere.
std::shared_ptr<const gi::Environment> broadcastProbe(Ranks& ranks,
                                                      std::shared_ptr<const gi::Environment> probe, int width,
                                                      int height, base::Progress& progress);

}  // namespace isolux::app
