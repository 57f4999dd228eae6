#include "volume/read/reader.h"

#include <new>

#include "base/error.h"
#include "volume/phantom/phantom.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/file_format.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"
#include "volume/read/known_formats.h"
#include "volume/read/mesh/mesh.h"
#include "volume/read/plain/meta_image.h"
#include "volume/read/plain/nifti.h"
#include "volume/read/plain/nrrd.h"
#include "volume/read/plain/raw.h"
#include "volume/read/process/foreign.h"
#include "volume/read/tiff/tiff_pages.h"
#include "volume/read/vtk/vtk_legacy.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

using ReadFunction = Volume (*)(const fs::path&, const ReadOptions&, base::Progress&);

// nullptr for a file without a known header.
ReadFunction readerOf(FileFormat format) {
  switch (format) {
    case FileFormat::nrrd:
      return readNrrd;
    case FileFormat::vtkLegacy:
      return readVtkLegacy;
    case FileFormat::mesh:
      return readMesh;
    case FileFormat::vti:
      return readVti;
    case FileFormat::tiff:
      return readTiff;
    case FileFormat::dicom:
      return readDicom;
    case FileFormat::nifti:
      return readNifti;
    case FileFormat::metaImage:
      return readMetaImage;
    case FileFormat::unknown:
      break;
  }
  return nullptr;
}

Volume readFolder(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  if (hasDicomFiles(path)) return readDicom(path, options, progress);
  if (!tiffFilesIn(path).empty()) return readTiff(path, options, progress);
  throwInput(path.string(), "",
             knownButNotReadIn(path).value_or("the folder has neither DICOM nor TIFF files"));
}

Volume readPhantom(const std::string& text, const ReadOptions& options, base::Progress& progress) {
  PhantomRequest request = parsePhantom(text);
  if (request.size == 0) request.geometry = options.grid;
  Volume volume;
  volume.grid = std::make_shared<Grid>(makePhantom(request, progress));
  volume.format = "phantom";
  volume.fileType = volume.grid->storedType();
  volume.name = request.name;
  const PhantomInfo& info = phantomNamed(request.name);
  volume.axes = info.axes;
  volume.unit = info.unit;
  if (volume.grid->minimum() < info.isovalue && info.isovalue < volume.grid->maximum())
    volume.isovalue = info.isovalue;
  if (info.name != "noise") volume.noise = 0.0;
  return volume;
}

}  // namespace

ReadOptions readOptions(const scene::Source& source) {
  ReadOptions options;
  options.raw = source.raw;
  options.series = source.series;
  options.component = source.component;
  options.timeStep = static_cast<int>(source.timeStep);
  options.meshVoxels = source.meshVoxels;
  return options;
}

namespace {

Volume readAny(const std::string& path, const ReadOptions& options, base::Progress& progress) {
  constexpr std::string_view phantom = "phantom:";
  if (path.starts_with(phantom)) return readPhantom(path.substr(phantom.size()), options, progress);
  if (path.empty()) throwInput("", "path", "is empty");
  if (path.find('\0') != std::string::npos) throwInput("", "path", "contains a zero byte");
  fs::path file(path);
  if (!file.has_filename()) file = file.parent_path();  // "folder/"
  std::error_code ignored;
  Volume volume;
  if (const fs::path zarr = zarrFolderOf(file); !zarr.empty()) {
    file = zarr;
    volume = readZarr(file, options, progress);
  } else if (fs::is_directory(file, ignored)) {
    volume = readFolder(file, options, progress);
  } else if (!options.raw.empty()) {
    volume = readRaw(file, options, progress);
  } else if (const auto dataset = hdf5PathOf(path)) {
    volume = readHdf5(*dataset, options, progress);
  } else {
    ReadFunction read = nullptr;
    {
      const FileBytes bytes(file);  // closed before the reader opens it
      if (bytes.size() == 0) throwInput(path, "", "the file is empty");
      read = readerOf(formatOf(bytes, file));
      if (!read)
        throwInput(path, "byte 0",
                   knownButNotRead(bytes, file)
                       .value_or("unknown volume format; for raw voxels give size and type, e.g. --raw "
                                 "\"256x256x109 uint16\""));
    }
    volume = read(file, options, progress);
  }
  // "None" is what some programs write for a description that nobody gave.
  if (volume.name.empty() || sameIgnoringCase(volume.name, "none")) volume.name = file.filename().string();
  return volume;
}

}  // namespace

Volume readVolume(const std::string& path, const ReadOptions& options, base::Progress& progress) {
  if (fs::path(path).filename().string().starts_with(kArrayPath))
    throwInput(path, "", "the volume was an array in memory; open the data that it was made of");
  try {
    return readAny(path, options, progress);
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path, "", "not enough memory for this volume");
  } catch (const fs::filesystem_error& error) {
    throwInput(path, "", error.code().message());
  }
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
  return {("Volumes (*.nii *.nii.gz *.nii.zst *.nii.bz2 *.hdr *.mhd *.mha *.nrrd *.nhdr *.vti *.vtk *.dcm "
           "*.tif *.tiff "
           "*.h5 "
           "*.hdf5 zarr.json .zattrs *.raw *.stl *.obj *.ply *.vtp)"),
          "NIfTI (*.nii *.nii.gz *.nii.zst *.nii.bz2 *.hdr *.img)",
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
