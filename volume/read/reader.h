// Reads any supported volume into a Grid and reports the conversions made.
//
// Formats are recognised by content first, then by name: raw, VTK legacy, .vti, MetaImage, NRRD, NIfTI, DICOM
// folder or file, TIFF (pages, or a folder of numbered files), triangle meshes (STL, OBJ, PLY, VTK PolyData)
// as distance fields, and the built-in phantoms ("phantom:NAME[:SIZE]"). Bad input throws base::Error{input}
// naming file, place and reason. No allocation exceeds twice what the header claims, nor the budget. A claim
// that the file's size cannot hold is rejected before allocating.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "scene/scene.h"
#include "scene/world_axes.h"
#include "volume/grid.h"
#include "volume/mesh/mesh_distance.h"

namespace isolux::volume {

enum class Endianness { little, big };

// Describes a headerless file.
struct RawDescription {
  glm::ivec3 dims{0};
  VoxelType type = VoxelType::uint8;
  Endianness endianness = Endianness::little;
  glm::dvec3 spacingMm{1.0};
  std::size_t headerBytes = 0;
};
// Parses "WxHxD TYPE [little|big] [spacing sx,sy,sz] [header BYTES]". Throws Error{usage} naming the bad
// word.
RawDescription parseRawDescription(const std::string& text);
std::string toText(const RawDescription& description);

struct ReadOptions {
  std::string raw;     // description text; empty: the file has a header
  std::string series;  // DICOM SeriesInstanceUID; empty: most slices
  int component = 0;   // channel; -1: magnitude
  int timeStep = 0;
  int meshVoxels = 128;           // of a mesh's distance field, along its longest axis
  std::optional<BoxMm> alsoHold;  // a mesh's grid is made large enough for this, too
  // The grid for sources without one of their own: meshes if its voxels are cubes, phantoms without SIZE.
  std::optional<GridGeometry> grid;
  // Limits memory: a larger volume is rejected before anything is allocated.
  std::size_t budgetBytes = base::machineMemory().left();
};
ReadOptions readOptions(const scene::Source& source);

struct Volume {
  std::shared_ptr<const Grid> grid;
  std::string name;                       // short, for the title bar: file name, or series description
  std::string format;                     // "NIfTI-1", "MetaImage", "DICOM", ...
  VoxelType fileType = VoxelType::uint8;  // in the file
  std::string unit;                       // "HU" for CT, else ""
  scene::DataKind kind = scene::DataKind::automatic;  // as requested
  scene::WorldAxes axes =
      scene::WorldAxes::zUp;          // anatomical only if the file states the patient orientation
  int components = 1, timeSteps = 1;  // available in the file; components are channels
  int coarsestLevel = 0;              // of a volume read at a level (volume/bricks/coarse_level.h)
  std::string damage;                 // unreadable parts, one line; "": none (Source::aroundDamage)
  std::optional<double> isovalue;     // to show first, if the source states it
  std::optional<double> noise;        // standard deviation of a voxel, data units, if the source states it
  bool isMesh = false;                // a distance field: its roughness is that of the mesh
  int labels = 0;                     // of a label map (volume/statistics/label_map.h); 0: not a label map
  std::vector<std::string> seriesChoices;  // DICOM: "UID<TAB>description, N slices"
  // Import warnings, one line each: converted, resampled, missing voxels, ignored fields.
  std::vector<std::string> warnings;
};

// The path of a volume that was an array in memory begins so: sessions and images name it, nothing reads it.
inline constexpr const char* kArrayPath = "array:";

// Reads a volume. `path` as Source::path. Throws base::Error (input, memory, interrupted).
Volume readVolume(const std::string& path, const ReadOptions& options, base::Progress& progress);

// Returns the box of a mesh's triangles; nullopt for any other kind of volume. Throws as readVolume().
std::optional<BoxMm> meshBounds(const std::string& path, const ReadOptions& options,
                                base::Progress& progress);

// Returns whether the file at `path` can only be read as raw (no known header): the window asks then.
bool needsRawDescription(const std::filesystem::path& path);

// Returns file name filters for the open dialog: {"NIfTI (*.nii *.nii.gz)", ...}.
std::vector<std::string> fileFilters();

}  // namespace isolux::volume
