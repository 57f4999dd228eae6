// Holds a volume as it was read: its grid, and what the file states about it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/world_axes.h"
#include "volume/grid.h"

namespace isolux::volume {

struct LabelTable;

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
  int coarsestLevel = 0;              // of a volume read at a level (volume/large/coarse_level.h)
  std::string damage;                 // unreadable parts, one line; "": none (Source::aroundDamage)
  std::optional<double> isovalue;     // to show first, if the source states it
  std::optional<double> noise;        // standard deviation of a voxel, data units, if the source states it
  bool isMesh = false;                // a distance field: its roughness is that of the mesh
  int labels = 0;                     // of a label map (volume/statistics/label_map.h); 0: not a label map
  std::shared_ptr<const LabelTable> labelTable;  // names, and what states that values are labels; or null
  std::vector<std::string> seriesChoices;        // DICOM: "UID<TAB>description, N slices"
  // Import warnings, one line each: converted, resampled, missing voxels, ignored fields.
  std::vector<std::string> warnings;
};

// The path of a volume that was an array in memory begins so: sessions and images name it, nothing reads it.
inline constexpr const char* kArrayPath = "array:";

}  // namespace isolux::volume
