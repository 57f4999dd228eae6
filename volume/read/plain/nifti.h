// NIfTI-1 and NIfTI-2: .nii, .nii.gz, and .hdr + .img (each may be gzipped).
//
// Read by our own parser: VTK 9.1's reader loses origin, sform and slope unless asked through extra getters,
// reads one component only and trusts the sizes; vtk-dicom's does not know the pair with a gzipped .img.
//
// The affine is the sform, else the qform, else the voxel sizes alone (with a warning); it is converted from
// RAS to LPS and, by xyzt_units, to mm. scl_slope 0 or not finite means none. ANALYZE 7.5 files (no magic)
// are refused: they do not say what is left. Throws base::Error{input} with the field's name.
#pragma once

#include <filesystem>
#include <string_view>

#include "volume/read/input/image_header.h"

namespace isolux::volume {

constexpr std::size_t niftiHeaderBytes = 540;  // the longer of the two versions

// `head`: the first 348 (NIfTI-1) or 540 (NIfTI-2) bytes, inflated. The payload of the result tells where
// the voxels start in the inflated file; `pairs` is set when they are in an .img file.
ImageHeader parseNiftiHeader(std::string_view head, const std::string& file, bool& pairs);

bool looksLikeNifti(std::string_view head);

// "scan.hdr" -> "scan.img" and the like, plain or gzipped; empty if there is no such file.
std::filesystem::path counterpart(const std::filesystem::path& path, std::string_view wanted);

// Of one file, or of a pair of which `path` is either: header, and where the voxels are.
struct NiftiFiles {
  ImageHeader header;
  std::filesystem::path headerPath, dataPath;
};
NiftiFiles openNifti(const std::filesystem::path& path);

}  // namespace isolux::volume
