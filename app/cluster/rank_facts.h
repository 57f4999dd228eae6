// What a rank tells of itself and its machine.
#pragma once

#include <optional>
#include <string>

#include "app/cluster/cluster_light.h"

namespace isolux::app {

std::string hostName();
int coresOfMachine();
// Whether the launcher gives this process one of several cores.
bool isBoundToOneCore();
// That `who` is: a note.
std::string boundNote(const std::string& who, int cores);

// `threads` as ClusterOptions: none are as many as --threads allows.
ClusterHello helloOf(const ClusterLight& light, const volume::Grid& grid, std::optional<int> threads,
                     bool threadsAsked);

}  // namespace isolux::app
