// Reads any supported volume into a Grid and reports the conversions made.
//
// Formats are recognised by content first, then by name: raw, VTK legacy, .vti, MetaImage, NRRD, NIfTI,
// FreeSurfer MGH, DICOM folder or file, TIFF (pages, or a folder of numbered files), triangle meshes (STL,
// OBJ, PLY, VTK PolyData) as distance fields, and the built-in phantoms ("phantom:NAME[:SIZE]"). Bad input
// throws base::Error{input} naming file, place and reason. No allocation exceeds twice what the header
// claims, nor the budget. A claim that the file's size cannot hold is rejected before allocating.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "volume/read/input/read_options.h"
#include "volume/volume.h"

namespace isolux::volume {

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
