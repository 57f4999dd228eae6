// Which corners of a cell hang together inside it: connected components of {f >= 0} of the trilinear
// interpolant of the eight corner values, exactly.
//
// Corner x + 2 y + 4 z lies at (x, y, z). f is linear along each axis, so every component holds a corner.
// Values are those less the isovalue. The rule sweeps slices along one axis, t: a slice is bilinear, each of
// its components holds one of its corners, and a corner moves along an edge of the cell. Two such edges hang
// together where one slice has both in one component: neighbouring ones where both are inside, the two of a
// diagonal where a(t) d(t) - b(t) c(t) >= 0, the asymptotic decider of the slice (Nielson & Hamann 1991).
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "volume/hit/bernstein_cubic.h"

namespace isolux::volume {

// Of each corner the smallest corner that it hangs together with; 8 for corners outside (f < 0).
std::array<std::uint8_t, 8> cellPieces(const CellCorners& values);

// The corner reached from a point of the cell ([0, 1] per axis) by going to that end where f is larger, axis
// after axis: f never falls on that way, so a point inside reaches an inside corner of its own component.
int cornerAbove(const CellCorners& values, glm::dvec3 local);

}  // namespace isolux::volume
