// What a rank tells of itself and its machine.
#pragma once

#include <optional>
#include <string>

#include "app/cluster/cluster_light.h"

namespace isolux::app {

std::string hostName();

// `threads` as ClusterOptions: none are as many as --threads allows.
ClusterHello helloOf(const ClusterLight& light, const volume::Grid& grid, std::optional<int> threads,
                     bool threadsAsked);

}  // namespace isolux::app
