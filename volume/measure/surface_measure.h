// Area and enclosed volume of a trilinear isosurface, as a whole, within a box of the world, or of those
// cells that somebody keeps, each with its error, and the change of the volume with the isovalue.
//
// Only blocks that the isovalue crosses are looked at cell by cell; of the others whole blocks count. The
// sums do not depend on the number of threads.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/choices.h"
#include "scene/noise.h"
#include "volume/grid.h"
#include "volume/measure/box_part.h"
#include "volume/measure/measured.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SurfaceQuestion {
  double isovalue = 0.0;  // data units
  scene::Inside inside = scene::Inside::above;
  std::optional<WorldBox> box = std::nullopt;
  scene::NoiseModel noise{};  // of the voxels; without values: none is counted
  // Cells that count, whole ones too; empty: all. Called from several threads. Slower: all blocks are walked.
  std::function<bool(glm::ivec3 cell)> keeps{};
};

struct SurfaceMeasure {
  Measured areaMm2, volumeMm3;  // of the inside within the data (and the box)
  ErrorParts areaParts, volumeParts;
  double volumePerValue = 0.0;  // mm^3 by which the volume shrinks when the isovalue moves inward by one unit
  bool meetsBorder = false;     // the inside goes on beyond the volume's border:
  bool meetsMissing = false;    // or beyond voxels that are missing: then the surface is open
  std::size_t cells = 0;        // that hold the surface

  bool open() const { return meetsBorder || meetsMissing; }
};

// Throws Error{interrupted}. Grids without cells and NaN isovalues have nothing.
SurfaceMeasure measureSurface(const Grid& grid, const MinMaxBlocks& blocks, const SurfaceQuestion& question,
                              base::Progress& progress);

// Why a surface that holds no cell is none, for messages: an axis has one voxel only, every voxel is missing,
// or the values do not reach the isovalue.
std::string whyNoSurface(const Grid& grid);

}  // namespace isolux::volume
