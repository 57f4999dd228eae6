// A tile's light as bytes: every bit of it, the same bytes for the same light.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gi/lattice/light_lattice.h"

namespace isolux::app {

// Of the blocks that are there.
std::string tileBytes(const gi::LightLattice& lattice, std::span<const gi::BlockRequest> blocks);

// Writes them to a lattice of the same geometry and content. Throws base::Error{input} of bytes that are not
// of some of these blocks, and is as before then; {memory}.
void takeTileBytes(std::string_view bytes, std::span<const gi::BlockRequest> blocks, gi::LightLattice& into);

// Paths of the lit texels.
std::uint64_t pathsOf(const gi::LightLattice& lattice, std::span<const gi::BlockRequest> blocks);

}  // namespace isolux::app
