#include "volume/read/reader.h"

#include "base/error.h"
#include "volume/read/file_format.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/input/bytes.h"
#include "volume/read/known_formats.h"
#include "volume/read/mesh/mesh.h"
#include "volume/read/volume_file.h"

namespace isolux::volume {

namespace fs = std::filesystem;

ReadOptions readOptions(const scene::Source& source) {
  ReadOptions options;
  options.raw = source.raw;
  options.series = source.series;
  options.component = source.component;
  options.timeStep = static_cast<int>(source.timeStep);
  options.meshVoxels = source.meshVoxels;
  return options;
}

Volume readVolume(const std::string& path, const ReadOptions& options, base::Progress& progress) {
  return openVolume(path, options, progress).readWhole(options, progress);
}

std::optional<BoxMm> meshBounds(const std::string& path, const ReadOptions& options,
                                base::Progress& progress) {
  std::error_code ignored;
  if (!options.raw.empty() || !fs::is_regular_file(path, ignored)) return std::nullopt;
  if (const FileBytes bytes(path); formatOf(bytes, path) != FileFormat::mesh) return std::nullopt;
  return readMeshBounds(path, options, progress);
}

bool needsRawDescription(const fs::path& path) {
  try {
    const FileBytes bytes(path);
    if (looksLikeHdf5(bytes)) return false;
    return bytes.size() > 0 && formatOf(bytes, path) == FileFormat::unknown && !knownButNotRead(bytes, path);
  } catch (const base::Error&) {
    return false;
  }
}

std::vector<std::string> fileFilters() {
  return {("Volumes (*.nii *.nii.gz *.nii.zst *.nii.bz2 *.mgz *.mgh *.hdr *.mhd *.mha *.nrrd *.nhdr *.vti "
           "*.vtk *.dcm "
           "*.tif *.tiff "
           "*.h5 "
           "*.hdf5 zarr.json .zattrs *.raw *.stl *.obj *.ply *.vtp)"),
          "NIfTI (*.nii *.nii.gz *.nii.zst *.nii.bz2 *.hdr *.img)",
          "FreeSurfer (*.mgz *.mgh)",
          "MetaImage (*.mhd *.mha)",
          "NRRD (*.nrrd *.nhdr)",
          "VTK (*.vti *.vtk)",
          "DICOM (*.dcm)",
          "TIFF (*.tif *.tiff)",
          "Zarr (zarr.json .zattrs .zarray .zgroup)",
          "HDF5 (*.h5 *.hdf5 *.hdf *.ilp *.nxs *.mat *.nc *.mnc *.ims *.vtkhdf)",
          "Triangle meshes (*.stl *.obj *.ply *.vtp)",
          "Raw (*.raw *.bin *.dat *.img)",
          "All files (*)"};
}

}  // namespace isolux::volume
