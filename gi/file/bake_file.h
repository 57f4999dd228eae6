// Stored light as a file: VTK XML image data (.vti) that ParaView opens in its place in the world.
//
// Point data, one point a texel: `irradiance` (3 components; light of one channel three times) or `transfer`
// (order^2 or 3 order^2 components), `samples` (paths; 0: not baked), and of the lamps `irradiance_lamps` and
// `samples_lamps`; `normal` (world). All numbers are as they are in memory, so that a bake goes on from the
// file bit by bit as if it had never stopped. Field data, texts: `key`, `key_lamps` (lightKey()), `content`,
// `volume_hash`, `arithmetic` (gi/arithmetic.h) and, of one part of a bake, `part`. zlib-compressed,
// appended, raw. Bit by bit means by the same arithmetic; what was computed by two kinds names both.
//
// Written beside its name, flushed to the disk and renamed: whenever the program ends, the file is the old
// one or the new one, whole. Lattices may go on being filled meanwhile; each block is as it was at one
// moment. Memory: a few layers of blocks as plain arrays, and the old state of blocks that a bake replaces
// meanwhile. Errors: base::Error{input} naming the file, the array and the reason; {memory}; {interrupted}.
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
#include "volume/pieces/hidden_pieces.h"

namespace isolux::gi {

// A bake of a part of the texels, in a file of its own.
struct BakedPart {
  LatticePart part;
  std::uint32_t samples = 0;  // paths a texel that were asked for
  std::string texels;         // which were: words that are the same for all parts of a bake
  bool complete = false;      // all of them are there
};

// What a file says of how it came about.
struct BakeFacts {
  std::string arithmetic;  // several: in alphabetical order, separated by ", "; empty: it does not say
  std::optional<BakedPart> part;
};

struct StoredLight {
  std::shared_ptr<LightLattice> sky, lamps;  // of one geometry; either may be null
  BakeFacts facts{};
};

// At least one of the lattices must be there.
void writeBakeFile(const std::filesystem::path& path, const volume::Grid& grid, const StoredLight& light,
                   base::Progress& progress);

// The same light as slabs, each a .vti of its own, and their index (.pvti), which ParaView opens: at most
// `pieces`, as many as there are layers of blocks. Neighbours share a slice. Each file is whole or as before;
// the index comes last. Errors as above.
void writeBakePieces(const std::filesystem::path& index, int pieces, const volume::Grid& grid,
                     const StoredLight& light, base::Progress& progress);
// The piece's file beside its index: L.pvti has L.piece-1-of-4.vti.
std::filesystem::path bakePieceFile(const std::filesystem::path& index, int number, int count);

// The lattices of those keys; an empty key: not wanted. Null where the file has no such lattice. Refuses a
// file of another volume, and lattices of another key, with what differs as the reason. hidden: as of the
// tracer that the light is of (IsosurfaceTracer::hidden()).
StoredLight readBakeFile(const std::filesystem::path& path, const volume::Grid& grid,
                         std::span<const volume::HiddenOfSurface> hidden, const std::string& skyKey,
                         const std::string& lampsKey, base::Progress& progress);

// Whether a file's texels are lit where one isosurface passes them (LatticeGeometry::isovalue). Throws as
// readBakeFile().
bool isOfOneIsovalue(const std::filesystem::path& path);

// True for files that begin as writeBakeFile() begins them, whole or not. No errors.
bool looksLikeBakeFile(const std::filesystem::path& path);

// What differs between two keys of light, in words ("albedo differs"); empty where nothing does.
std::string keyDifference(const std::string& stored, const std::string& wanted);

}  // namespace isolux::gi
