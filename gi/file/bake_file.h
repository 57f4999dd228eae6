// Reads and writes baked lighting as VTK XML image data (.vti), which ParaView opens at its position in the
// world.
//
// Point data, one point per texel: `irradiance` (3 components; light of one channel three times) or
// `transfer` (order^2 or 3 order^2 components). Also `samples` (paths; 0: not baked), `irradiance_lamps` and
// `samples_lamps` (of the light sources), and `normal` (world). Field data, texts: `key`, `key_lamps`
// (lightKey()), `content`, `volume_hash`, `arithmetic` (gi/arithmetic.h) and, for one part of a bake, `part`.
// Arrays are zlib-compressed, appended, raw.
//
// All numbers are stored as in memory. With the same arithmetic, a bake resumed from the file is therefore
// bit-identical to an uninterrupted one. A file computed by two kinds of arithmetic names both.
//
// Files are written to a temporary file in the same folder, flushed to the disk and renamed. Whenever the
// program ends, the file is the complete old or the complete new one. Lattices may be filled meanwhile; each
// block is written as it was at one moment. Needs memory for a few layers of blocks as plain arrays, and for
// the old state of blocks that a bake replaces meanwhile. Throws base::Error: input, naming the file, the
// array and the reason; memory; interrupted.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/progress.h"
#include "gi/lattice/lattice_part.h"
#include "gi/lattice/light_lattice.h"
#include "volume/grid.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::gi {

// One part of a bake's texels, in a separate file.
struct BakedPart {
  LatticePart part;
  std::uint32_t samples = 0;  // requested paths per texel
  std::string texels;         // the requested texels, in words that are the same for all parts of a bake
  bool complete = false;      // all requested texels are baked
};

// Describes how the file was computed.
struct BakeFacts {
  std::string arithmetic;  // several kinds: alphabetical, separated by ", "; empty: not stated
  std::optional<BakedPart> part;
};

struct StoredLight {
  std::shared_ptr<LightLattice> sky, lamps;  // of one geometry; either may be null
  BakeFacts facts{};
};

// Writes a bake. Requires at least one of the lattices.
void writeBakeFile(const std::filesystem::path& path, const volume::Grid& grid, const StoredLight& light,
                   base::Progress& progress);

// Writes the light as slabs in separate .vti files, and their index (.pvti), which ParaView opens. Writes at
// most `pieces` slabs, and at most one per layer of blocks; neighbours share a slice. Each file is complete
// or as before; the index is written last. Throws as writeBakeFile().
void writeBakePieces(const std::filesystem::path& index, int pieces, const volume::Grid& grid,
                     const StoredLight& light, base::Progress& progress);
// Returns the path of a slab next to its index: L.pvti has L.piece-1-of-4.vti.
std::filesystem::path bakePieceFile(const std::filesystem::path& index, int number, int count);

// Reads the lattices with those keys; an empty key requests none. A lattice is null if the file does not
// contain it. Throws for a file of another volume and for lattices of another key; the message states the
// difference. `hidden`: of the tracer that computed the light (IsosurfaceTracer::hidden()).
StoredLight readBakeFile(const std::filesystem::path& path, const volume::Grid& grid,
                         std::span<const volume::HiddenOfSurface> hidden, const std::string& skyKey,
                         const std::string& lampsKey, base::Progress& progress);

// Returns whether the file's texels are lit on one displayed isosurface (LatticeGeometry::isovalue). Throws
// as readBakeFile().
bool isOfOneIsovalue(const std::filesystem::path& path);

// Returns whether the file begins as writeBakeFile() begins, complete or not. Reports no errors.
bool looksLikeBakeFile(const std::filesystem::path& path);

// Returns how two light keys differ, in words ("albedo differs"), or "" if they do not.
std::string keyDifference(const std::string& stored, const std::string& wanted);

}  // namespace isolux::gi
