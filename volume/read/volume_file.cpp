#include "volume/read/volume_file.h"

#include <cmath>
#include <new>

#include "base/error.h"
#include "volume/phantom/phantom.h"
#include "volume/read/chunks/array_volume.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/file_format.h"
#include "volume/read/hdf5/hdf5.h"
#include "volume/read/input/chunked_header.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/text.h"
#include "volume/read/known_formats.h"
#include "volume/read/label_files.h"
#include "volume/read/mesh/mesh.h"
#include "volume/read/plain_file.h"
#include "volume/read/process/foreign.h"
#include "volume/read/step_files.h"
#include "volume/read/tiff/tiff_pages.h"
#include "volume/read/zarr/zarr.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

using ReadFunction = Volume (*)(const fs::path&, const ReadOptions&, base::Progress&);

Volume readFolder(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  if (hasDicomFiles(path)) return readDicom(path, options, progress);
  if (!tiffFilesIn(path).empty()) return readTiff(path, options, progress);
  throwInput(path.string(), "",
             knownButNotReadIn(path).value_or("the folder has neither DICOM nor TIFF files"));
}

Volume refuseUnknown(const fs::path& path, const ReadOptions&, base::Progress&) {
  throwInput(path.string(), "byte 0",
             knownButNotRead(FileBytes(path), path)
                 .value_or("unknown volume format; for raw voxels give size and type, e.g. --raw "
                           "\"256x256x109 uint16\""));
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

// Of formats without a header that is parsed here.
ReadFunction readerOf(FileFormat format) {
  if (format == FileFormat::mesh) return readMesh;
  if (format == FileFormat::tiff) return readTiff;
  return format == FileFormat::dicom ? readDicom : refuseUnknown;
}

VolumeFile readWholeBy(ReadFunction read, const fs::path& path, std::string why) {
  return {nullptr, std::move(why), [read, path](const ReadOptions& options, base::Progress& progress) {
            return read(path, options, progress);
          }};
}

VolumeFile fileOfArrays(std::shared_ptr<const ArrayVolume> arrays) {
  return {arrays, "", [arrays](const ReadOptions& options, base::Progress& progress) {
            return wholeVolume(*arrays, options, progress);
          }};
}

VolumeFile describedOrForeign(const fs::path& path, const ReadOptions& options) {
  FileFormat format = FileFormat::unknown;
  const std::shared_ptr<const DescribedFile> found = describedFile(path, options, format);
  if (!found) return readWholeBy(readerOf(format), path, kOnlyThese);
  checkChoices(found->header, found->data->name(), options);
  VolumeFile file;
  if (format == FileFormat::vti)
    file = readWholeBy(readVti, path, "");
  else
    file.readWhole = [found](const ReadOptions& how, base::Progress& progress) {
      return volumeFrom(found->header, *found->data, found->beside, how, progress);
    };
  file.parts = plainVolume(found, path.string(), file.whyWhole);
  return file;
}

// `named`: the file or folder that the volume is named after.
VolumeFile opened(const std::string& path, const ReadOptions& options, fs::path& named,
                  base::Progress& progress) {
  constexpr std::string_view phantom = "phantom:";
  if (path.starts_with(phantom))
    return {nullptr, "a phantom is not a file",
            [text = path.substr(phantom.size())](const ReadOptions& how, base::Progress& making) {
              return readPhantom(text, how, making);
            }};
  if (path.empty()) throwInput("", "path", "is empty");
  if (path.find('\0') != std::string::npos) throwInput("", "path", "contains a zero byte");
  named = path;
  if (!named.has_filename()) named = named.parent_path();  // "folder/"
  std::error_code ignored;
  if (const fs::path zarr = zarrFolderOf(named); !zarr.empty()) {
    named = zarr;
    return fileOfArrays(openZarr(zarr, options.series));
  }
  if (fs::is_directory(named, ignored)) return readWholeBy(readFolder, named, "it is a folder");
  if (options.raw.empty())
    if (const auto dataset = hdf5PathOf(path))
      return fileOfArrays(openHdf5(*dataset, options.series, progress));
  return describedOrForeign(named, options);
}

template <class F>
auto withPath(const std::string& path, const F& f) {
  try {
    return f();
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path, "", "not enough memory for this volume");
  } catch (const fs::filesystem_error& error) {
    throwInput(path, "", error.code().message());
  }
}

}  // namespace

VolumeFile openVolume(const std::string& path, const ReadOptions& options, base::Progress& progress) {
  if (fs::path(path).filename().string().starts_with(kArrayPath))
    throwInput(path, "", "the volume was an array in memory; open the data that it was made of");
  fs::path named;
  VolumeFile file = withPath(path, [&] { return opened(path, options, named, progress); });
  file.readWhole = [path, named, read = std::move(file.readWhole)](const ReadOptions& how,
                                                                   base::Progress& reading) {
    Volume volume = withPath(path, [&] { return read(how, reading); });
    // "None" is what some programs write for a description that nobody gave.
    if (volume.name.empty() || sameIgnoringCase(volume.name, "none")) volume.name = named.filename().string();
    if (!named.empty()) addLabelFiles(volume, named);
    return volume;
  };
  return file;
}

VolumeFile openSource(const scene::Source& source, base::Progress& progress) {
  if (source.timeStep != std::floor(source.timeStep))
    return {nullptr, "two time steps are blended (source.time_step)", {}};
  if (!stepFiles(source.path).empty()) return {nullptr, "its time steps are files of their own", {}};
  const ReadOptions options = readOptions(source);
  VolumeFile file = openVolume(source.path, options, progress);
  if (!file.parts) return file;
  if (source.csg != scene::Csg::none)
    file.whyWhole = "a second volume is combined with it (source.csg)";
  else if (source.component < 0)
    file.whyWhole = "it is read as a magnitude (source.component)";
  const ChunkedFacts& facts = file.parts->facts();
  if (!file.whyWhole.empty())
    file.parts.reset();
  else
    checkChoices(chunkedHeader(facts, facts.levels.front().geometry, facts.storedType), facts.name, options);
  return file;
}

}  // namespace isolux::volume
