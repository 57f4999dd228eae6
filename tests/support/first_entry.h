// Where a ray first enters the inside of the trilinear isosurface, in double precision: the reference that
// the fast tracer (isosurface_tracer.h) is judged by.
//
// It shares walk and cubic with the exact hits (volume/hit), which an independent search judges
// (tests/support/trilinear_oracle.h), and nothing with the tracer.
//
// Positions are voxel coordinates, t is in units of |direction|. Cell by cell, no blocks: slow. Inside is
// f >= isovalue (Inside::above) or f <= isovalue (Inside::below), in values, whatever the sign of the slope.
// A ray begins on the side of f at its origin, or where it meets the volume, where the side is that of f
// there; from inside it must leave before it can enter. On the surface it begins outside where f moves away
// from the inside, else inside. Touching without crossing enters nothing. Cells with a missing corner hold no
// surface, and the side behind them is found anew: coming out of a gap inside is no entry.
#pragma once

#include <optional>

#include "scene/scene.h"
#include "volume/grid.h"
#include "volume/hit/cell_walk.h"

namespace isolux::volume {

// t of the first entry in (ray.tMinimum, ray.tMaximum]. `storedIsovalue`: Grid::storedOfValue. Rays that are
// not finite or have no direction, a NaN isovalue and grids without cells: nothing.
std::optional<double> firstEntry(const Grid& grid, scene::Inside inside, double storedIsovalue,
                                 const Ray& ray);

}  // namespace isolux::volume
