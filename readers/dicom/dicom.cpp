#include "readers/dicom/dicom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <vtkDataArray.h>

#include "base/error.h"
#include "base/number_text.h"
#include "readers/dicom/segmentation.h"
#include "readers/dicom/series.h"
#include "readers/limits.h"
#include "readers/serve.h"
#include "readers/vtk_messages.h"
#include "volume/read/dicom/dicom_files.h"
#include "volume/read/dicom/slice_stack.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/text.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

// Headers of all DICOM files in `folder` and its subfolders, to that depth, folder by folder; also objects
// that are no scans. One scan at least.
std::vector<DicomFile> scanDicomFolder(const fs::path& folder, int depth, base::Progress& progress,
                                       std::vector<std::string>& warnings) {
  std::vector<DicomFile> files;
  int broken = 0, others = 0;
  std::string firstReason, firstOther;
  const std::vector<fs::path> paths = dicomFilesIn(folder, depth);
  std::uint64_t bytes = 0;
  for (const fs::path& path : paths) bytes += FileBytes(path).size();
  allowHeaders(paths.size(), bytes);
  for (const fs::path& path : paths) {
    progress.throwIfStopped();
    nowReading(path);
    try {
      DicomFile file = readWholeHeader(path);
      if (!file.notAScan.empty() && others++ == 0)
        firstOther = path.string() + " " + file.notAScan + (file.isSegmentation ? "; open it by itself" : "");
      if (!file.frames.empty()) files.push_back(std::move(file));
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input) throw;
      if (broken++ == 0) firstReason = error.what();
    }
  }
  const bool hasScans =
      std::ranges::any_of(files, [](const DicomFile& file) { return file.notAScan.empty(); });
  if (!hasScans && broken > 0) throwInput(folder.string(), "", "no usable DICOM image; " + firstReason);
  if (!hasScans && others > 0) throwInput(folder.string(), "", "has no DICOM scan; " + firstOther);
  if (!hasScans) throwInput(folder.string(), "", "has no DICOM images");
  if (broken > 0)
    warnings.push_back(std::to_string(broken) +
                       " DICOM files are unreadable and left out; the first: " + firstReason);
  if (others > 0)
    warnings.push_back(std::to_string(others) +
                       " DICOM objects are not scans and are skipped; the first: " + firstOther);
  return files;
}

// The series asked for, else the one with most slices; and the list of all.
std::vector<DicomFile> chooseSeries(std::vector<DicomFile> files, const std::string& wanted,
                                    const std::string& folder, std::vector<std::string>& choices) {
  struct Series {
    std::string description;
    std::size_t slices = 0;
  };
  std::map<std::string, Series> all;
  for (const DicomFile& file : files) {
    Series& series = all[file.series];
    if (!file.notAScan.empty()) continue;
    series.slices += file.frames.size();
    if (series.description.empty()) series.description = file.description;
  }
  std::string chosen = wanted;
  if (wanted.empty()) {
    std::size_t most = 0;
    for (const auto& [uid, series] : all)
      if (series.slices > most) {
        most = series.slices;
        chosen = uid;
      }
  } else if (!all.contains(wanted)) {
    base::throwUsage(folder, "source.series",
                     "no series " + inQuotes(wanted) + "; the folder has " + std::to_string(all.size()) +
                         ", the first is " + all.begin()->first);
  }
  for (const auto& [uid, series] : all)
    if (series.slices > 0)
      choices.push_back(uid + "\t" + (series.description.empty() ? "no description" : series.description) +
                        ", " + std::to_string(series.slices) + " slices");
  std::erase_if(files, [&](const DicomFile& file) { return file.series != chosen; });
  files = onlyScans(std::move(files));
  // The order of acquisition, before the positions decide.
  std::ranges::stable_sort(files,
                           [](const DicomFile& a, const DicomFile& b) { return a.instance < b.instance; });
  return files;
}

// One value of `slice` blended with the next one of the stack.
template <typename T>
void blendSlices(const T* a, const T* b, double fraction, std::size_t count, T* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const double value = (1.0 - fraction) * static_cast<double>(a[i]) + fraction * static_cast<double>(b[i]);
    out[i] = std::is_integral_v<T> ? static_cast<T>(std::llround(value)) : static_cast<T>(value);
  }
}

// The decoded frames in the order of the stack, each rescaled when they differ, resampled when needed.
class Assembly {
 public:
  Assembly(const std::vector<DicomSource>& sources, const SliceStack& stack, std::size_t sliceVoxels,
           bool rescale)
      : sources_(sources), stack_(stack), sliceVoxels_(sliceVoxels), rescale_(rescale) {}

  template <typename T>
  FileVoxels run(const T* decoded, int component, std::size_t components, std::size_t timeStep,
                 const base::Progress& progress) {
    if (rescale_ || component < 0) return assemble<float>(decoded, component, components, timeStep, progress);
    return assemble<T>(decoded, component, components, timeStep, progress);
  }

  // A padding value that was met, stored and as shown.
  const std::optional<std::pair<double, double>>& padding() const { return padding_; }

 private:
  template <typename To, typename T>
  FileVoxels assemble(const T* decoded, int component, std::size_t components, std::size_t timeStep,
                      const base::Progress& progress) {
    std::vector<To> voxels;
    voxels.reserve(stack_.slices() * sliceVoxels_);
    std::vector<To> a(sliceVoxels_), b(sliceVoxels_);
    const auto load = [&](std::size_t place, std::vector<To>& slice) {
      const DicomSource& source = sources_[stack_.order[timeStep * stack_.sourceSlices() + place]];
      const DicomFile& file = *source.file;
      // Padding is a value of grey pixels; without one, nothing is between these.
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const auto [low, high] =
          components == 1 && file.padding ? *file.padding : std::pair(infinity, -infinity);
      auto out = slice.begin();
      for (int y = 0; y < file.rows; ++y) {
        const T* in = decoded + (source.filePixel + file.decodedRow(source.frameIndex, y)) * components;
        for (int x = 0; x < file.columns; ++x, in += components) {
          double value = 0.0;
          if (component < 0)
            for (std::size_t c = 0; c < components; ++c)
              value = std::hypot(value, static_cast<double>(in[c]));
          else
            value = static_cast<double>(in[component]);
          if (value >= low && value <= high) padding_ = {value, file.valueOf(source.frame(), value)};
          *out++ = static_cast<To>(rescale_ ? file.valueOf(source.frame(), value) : value);
        }
      }
    };
    for (std::size_t k = 0; k < stack_.slices(); ++k) {
      progress.throwIfStopped();
      if (stack_.resampled.empty()) {
        load(k, a);
      } else {
        const auto& blend = stack_.resampled[k];
        load(blend.first, a);
        load(blend.first + 1, b);
        blendSlices(a.data(), b.data(), blend.fraction, sliceVoxels_, a.data());
      }
      voxels.insert(voxels.end(), a.begin(), a.end());
    }
    return voxels;
  }

  const std::vector<DicomSource>& sources_;
  const SliceStack& stack_;
  std::size_t sliceVoxels_;
  bool rescale_;
  std::optional<std::pair<double, double>> padding_;
};

std::vector<DicomSource> stepOf(const std::vector<DicomSource>& sources, const SliceStack& stack,
                                int timeStep) {
  std::vector<DicomSource> slices;
  const std::size_t first = static_cast<std::size_t>(timeStep) * stack.sourceSlices();
  for (std::size_t i = 0; i < stack.sourceSlices(); ++i) slices.push_back(sources[stack.order[first + i]]);
  return slices;
}

// Unit, slope and intercept of the slices of a time step; true: they must be applied slice by slice.
bool setMeaning(const std::vector<DicomSource>& slices, ImageHeader& header,
                std::vector<std::string>& warnings) {
  const auto agree = [&](const auto& value) {
    return std::ranges::all_of(
        slices, [&](const DicomSource& slice) { return value(slice) == value(slices.front()); });
  };
  if (agree([](const DicomSource& slice) { return slice.frame().unit; }))
    header.unit = slices.front().frame().unit;
  else
    warnings.emplace_back("the slices state different units of their values; none is shown");
  if (!agree([](const DicomSource& slice) -> const auto& { return slice.file->lut.values; }))
    warnings.emplace_back("the modality LUT differs from slice to slice; applied, values stored as float32");
  if (std::ranges::any_of(slices, [](const DicomSource& slice) { return !slice.file->lut.values.empty(); }))
    return true;
  if (!agree(
          [](const DicomSource& slice) { return std::pair(slice.frame().slope, slice.frame().intercept); })) {
    warnings.emplace_back("the rescale slope differs from slice to slice; applied, values stored as float32");
    return true;
  }
  header.slope = slices.front().frame().slope;
  header.intercept = slices.front().frame().intercept;
  return false;
}

}  // namespace

std::optional<VoxelType> voxelTypeOf(vtkDataArray* array) {
  static constexpr std::pair<int, VoxelType> types[] = {{VTK_CHAR, VoxelType::int8},
                                                        {VTK_SIGNED_CHAR, VoxelType::int8},
                                                        {VTK_UNSIGNED_CHAR, VoxelType::uint8},
                                                        {VTK_SHORT, VoxelType::int16},
                                                        {VTK_UNSIGNED_SHORT, VoxelType::uint16},
                                                        {VTK_INT, VoxelType::int32},
                                                        {VTK_UNSIGNED_INT, VoxelType::uint32},
                                                        {VTK_FLOAT, VoxelType::float32},
                                                        {VTK_DOUBLE, VoxelType::float64}};
  for (const auto& [known, type] : types)
    if (known == array->GetDataType()) return type;
  return std::nullopt;
}

std::optional<VoxelType> voxelTypeOf(const DicomFile& file) {
  if (file.bitsAllocated == 64) return VoxelType::float64;
  if (file.bitsAllocated != 1 && file.bitsAllocated % 8 != 0) return std::nullopt;
  return integerType(static_cast<std::size_t>(file.bitsAllocated + 7) / 8, file.isSigned);
}

DecodedVolume decodeDicom(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  progress.report(0.0, "reading");
  const bool isIndex = isDicomIndex(path);
  const bool isFolder = isIndex || fs::is_directory(path);
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::path folder = isFolder && !isIndex ? path : parent;
  const std::string name = path.string();
  std::vector<std::string> warnings, choices;
  std::string wanted = options.series;
  std::optional<DicomFile> named;
  if (!isFolder) {
    if (!isDicomFile(path)) throwInput(name, "", "has no DICOM image");
    allowHeaders(1, FileBytes(path).size());
    nowReading(path);
    named = readWholeHeader(path);
    if (named->isSegmentation) return decodeSegmentation(*named, options, progress);
    if (!named->notAScan.empty()) throwInput(name, "SOPClassUID", named->notAScan);
    if (named->frames.empty()) throwInput(name, "", "has no DICOM image");
    if (wanted.empty()) wanted = named->series;
  }
  std::vector<DicomFile> files =
      scanDicomFolder(folder, isFolder ? kDeepestDicomFolder : 1, progress, warnings);
  files = chooseSeries(std::move(files), wanted, name, choices);
  if (named && named->isCine && !named->frames.front().hasPosition) files = {*named};  // a clip by itself
  files = keepMajority(std::move(files), warnings);

  const std::vector<DicomSource> sources = sourcesOf(files);
  SliceStack stack = stackOf(sources, name, warnings);
  warnings.insert(warnings.end(), stack.warnings.begin(), stack.warnings.end());

  ImageHeader header;
  header.format = "DICOM";
  const DicomFile& first = files.front();
  const auto type = voxelTypeOf(first);
  if (!type)
    throwInput(first.path.string(), "BitsAllocated",
               std::to_string(first.bitsAllocated) + " bits are not supported");
  header.type = *type;
  header.dims = {first.columns, first.rows, static_cast<std::int64_t>(stack.slices())};
  header.components = first.samples;
  header.timeSteps = static_cast<std::int64_t>(stack.timeSteps);
  header.worldFromVoxel = stack.worldFromVoxel;
  if (first.frames.front().hasPosition) header.axes = scene::WorldAxes::anatomical;
  checkDims(header, name, "Rows, Columns, slices");
  checkChoices(header, name, options);
  // vtk-dicom decodes all of the series at once.
  std::uint64_t pixels = 0, fileBytes = 0;
  for (const DicomFile& file : files) {
    pixels += file.decodedPixels();
    fileBytes += FileBytes(file.path).size();
  }
  const std::uint64_t decoded = pixels * static_cast<std::uint64_t>(first.samples) * bytesOf(*type);
  checkBudget(decoded, "the series", "", name, options);
  checkBudget(header, name, options);

  allowDecoding(fileBytes);
  const VtkMessages messages;
  auto array = decodeFiles(files, name, messages, progress);
  const auto sliceVoxels = static_cast<std::size_t>(first.columns) * static_cast<std::size_t>(first.rows);
  const auto decodedType = voxelTypeOf(array);
  if (!decodedType) throwInput(name, "pixel data", "has a type that is not supported");
  header.type = *decodedType;

  const std::vector<DicomSource> slices = stepOf(sources, stack, options.timeStep);
  const bool rescale = setMeaning(slices, header, warnings);
  for (const std::string& warning : messages.warnings()) warnings.push_back("vtk-dicom: " + warning);
  Assembly assembly(sources, stack, sliceVoxels, rescale);
  FileVoxels voxels = withType(header.type, [&](auto zero) {
    return assembly.run(static_cast<const decltype(zero)*>(array->GetVoidPointer(0)), options.component,
                        static_cast<std::size_t>(first.samples), static_cast<std::size_t>(options.timeStep),
                        progress);
  });
  if (assembly.padding())
    warnings.push_back("PixelPaddingValue " + base::shortText(assembly.padding()->first) +
                       " marks pixels outside the image; shown as the value " +
                       base::shortText(assembly.padding()->second));
  header.warnings = std::move(warnings);
  array = nullptr;  // before the voxels are handed over
  return {std::move(header), std::move(voxels), first.description, std::move(choices), first.patient};
}

}  // namespace isolux::readers
