#include "volume/read/plain_file.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "volume/read/chunks/array_volume.h"
#include "volume/read/chunks/chunk_format.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/streams.h"
#include "volume/read/plain/meta_image.h"
#include "volume/read/plain/mgh.h"
#include "volume/read/plain/nifti.h"
#include "volume/read/plain/nrrd.h"
#include "volume/read/plain/raw.h"
#include "volume/read/vtk/vti.h"
#include "volume/read/vtk/vtk_legacy.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::size_t kMostPlainFiles = 512;  // all are kept open

// The bytes of all voxels in one run, whichever files they lie in.
class PayloadBytes final : public Bytes {
 public:
  explicit PayloadBytes(std::shared_ptr<const DescribedFile> file)
      : file_(std::move(file)), places_(plainBytes(file_->header, *file_->data, file_->beside)) {
    name_ = file_->data->name();
    size_ = file_->header.elements() * bytesOf(file_->header.type);
  }

 private:
  void doRead(std::uint64_t offset, std::span<std::byte> out) const override {
    const std::uint64_t share = size_ / places_.size();  // of each file
    while (!out.empty()) {
      const PlainBytes& place = places_[offset / share];
      const std::uint64_t at = offset % share;
      const auto part = out.first(static_cast<std::size_t>(std::min<std::uint64_t>(share - at, out.size())));
      (place.beside ? *place.beside : *file_->data).read(place.begin + at, part);
      offset += part.size();
      out = out.subspan(part.size());
    }
  }

  std::shared_ptr<const DescribedFile> file_;
  std::vector<PlainBytes> places_;
};

// The voxels as one chunk with the axes channel, time, z, y, x. One channel is read at a time.
class PlainArray final : public ChunkedArray {
 public:
  explicit PlainArray(const std::shared_ptr<const DescribedFile>& file) : bytes_(file) {
    const ImageHeader& header = file->header;
    const auto count = [](std::int64_t n) { return static_cast<std::uint64_t>(n); };
    const std::uint64_t slow = count(header.slowComponents), components = count(header.components),
                        times = count(header.timeSteps);
    const std::uint64_t x = count(header.dims[0]), y = count(header.dims[1]), z = count(header.dims[2]);
    format_.number = {header.type, false, header.payload.endianness == Endianness::big};
    format_.dims = {slow, times, z, y, x, components};
    format_.order = {0, 1, 2, 3, 4, 5};
    layout_.dims = layout_.chunk = {slow * components, times, z, y, x};
    layout_.type = header.type;
    layout_.keepsRows = true;
  }

  const ArrayLayout& layout() const override { return layout_; }
  bool plain() const override { return true; }
  ArrayChunk read(std::span<const std::uint64_t>, std::span<const std::uint64_t> low,
                  std::span<const std::uint64_t> size) const override {
    const std::uint64_t components = format_.dims.back(), slow = low[0] / components;
    const std::uint64_t first[] = {slow, low[1], low[2], low[3], low[4], 0},
                        count[] = {1, size[1], size[2], size[3], size[4], components};
    ArrayChunk chunk = readPlainChunk(format_, bytes_, 0, first, count);
    // The components of a voxel lie side by side: they take the place of the first axis.
    chunk.start.pop_back();
    chunk.start[0] = slow * components;
    chunk.strides[0] = chunk.strides.back();
    chunk.strides.pop_back();
    return chunk;
  }

 private:
  PayloadBytes bytes_;
  ChunkFormat format_;
  ArrayLayout layout_;
};

}  // namespace

std::shared_ptr<const DescribedFile> describedFile(const fs::path& path, const ReadOptions& options,
                                                   FileFormat& format) {
  auto bytes = std::make_unique<FileBytes>(path);
  auto file = std::make_shared<DescribedFile>();
  file->beside = openBeside(path);
  if (!options.raw.empty()) {
    file->header = headerOfRaw(parseRawDescription(options.raw), bytes->name());
    file->data = std::move(bytes);
    return file;
  }
  if (bytes->size() == 0) throwInput(bytes->name(), "", "the file is empty");
  format = formatOf(*bytes, path);
  switch (format) {
    case FileFormat::nrrd:
      file->header = parseNrrdHeader(bytes->head(kLongestNrrdHeader), bytes->name());
      break;
    case FileFormat::metaImage:
      file->header = parseMetaImageHeader(bytes->head(kLongestMetaImageHeader), bytes->name());
      break;
    case FileFormat::nifti: {
      NiftiFiles files = openNifti(path);
      file->header = std::move(files.header);
      file->beside = openBeside(files.headerPath);
      bytes = std::make_unique<FileBytes>(files.dataPath);
      break;
    }
    case FileFormat::mgh: {
      const std::string head = bytes->head(kMghHeaderBytes);
      const bool packed = isPacked(head);
      file->header =
          parseMghHeader(packed ? inflatedHead(*bytes, kMghHeaderBytes) : head, packed, bytes->name());
      break;
    }
    case FileFormat::vti: {
      VtiHeader vti = parseVtiHeader(*bytes, options);
      file->header = std::move(vti.image);
      if (vti.plain)
        file->header.payload = std::move(*vti.plain);
      else
        file->whyWhole = "its voxels are not written as plain bytes (appended, raw, not compressed)";
      break;
    }
    case FileFormat::vtkLegacy:
      file->header = parseVtkLegacyHeader(*bytes);
      file->whyWhole = kOnlyThese;
      break;
    default:
      return nullptr;
  }
  file->data = std::move(bytes);
  return file;
}

std::shared_ptr<const ChunkedVolume> plainVolume(const std::shared_ptr<const DescribedFile>& file,
                                                 std::string name, std::string& whyWhole) {
  const ImageHeader& header = file->header;
  const VoxelType type = header.type;
  if (!file->whyWhole.empty())
    whyWhole = file->whyWhole;
  else if (header.payload.encoding != Encoding::raw)
    whyWhole = header.payload.encoding == Encoding::ascii ? "its voxels are written as text"
                                                          : "its voxels are compressed";
  else if (type > VoxelType::uint16 && type != VoxelType::float32)
    whyWhole = "its voxels are " + std::string(nameOf(type)) +
               ", which are stored as another type; int8, uint8, int16, uint16 and float32 are";
  else if (header.payload.files.size() > kMostPlainFiles)
    whyWhole = "it has more than " + std::to_string(kMostPlainFiles) + " data files";
  if (!whyWhole.empty()) return nullptr;
  ChunkedFacts facts;
  facts.name = std::move(name);
  facts.format = header.format;
  facts.unit = header.unit;
  facts.axes = header.axes;
  if (std::isfinite(header.slope) && header.slope != 0.0 && std::isfinite(header.intercept)) {
    facts.slope = header.slope;
    facts.intercept = header.intercept;
  }
  facts.levels.resize(1);
  facts.levels.front().geometry.worldFromVoxel = header.worldFromVoxel;
  facts.labels = header.labels;
  facts.warnings = header.warnings;
  return std::make_shared<ArrayVolume>(
      std::move(facts), ArrayAxes{.x = 4, .y = 3, .z = 2, .time = 1, .channel = 0},
      std::vector<std::shared_ptr<const ChunkedArray>>{std::make_shared<PlainArray>(file)});
}

}  // namespace isolux::volume
