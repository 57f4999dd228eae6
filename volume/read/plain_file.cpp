#include "volume/read/plain_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "volume/read/file_format.h"
#include "volume/read/input/payload.h"
#include "volume/read/plain/meta_image.h"
#include "volume/read/plain/nifti.h"
#include "volume/read/plain/nrrd.h"
#include "volume/read/plain/raw.h"
#include "volume/read/vtk/vti.h"

namespace isolux::volume {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestPlainHeader = std::size_t{1} << 20;
constexpr std::size_t kMostPlainFiles = 512;  // all are kept open

struct PlainHeader {
  ImageHeader header;
  fs::path headerPath, dataPath;
};

std::optional<PlainHeader> plainHeaderOf(const fs::path& path, const ReadOptions& options,
                                         std::string& reason) {
  PlainHeader result{.header = {}, .headerPath = path, .dataPath = path};
  const FileBytes bytes(path);
  if (!options.raw.empty()) {
    result.header = headerOfRaw(parseRawDescription(options.raw), bytes.name());
    return result;
  }
  switch (formatOf(bytes, path)) {
    case FileFormat::nrrd:
      result.header = parseNrrdHeader(bytes.head(kLongestPlainHeader), bytes.name());
      break;
    case FileFormat::metaImage:
      result.header = parseMetaImageHeader(bytes.head(kLongestMetaImageHeader), bytes.name());
      break;
    case FileFormat::nifti: {
      NiftiFiles files = openNifti(path);
      result = {std::move(files.header), files.headerPath, files.dataPath};
      break;
    }
    case FileFormat::vti: {
      VtiHeader vti = parseVtiHeader(bytes, options);
      if (!vti.plain) {
        reason = "its voxels are not written as plain bytes (appended, raw, not compressed)";
        return std::nullopt;
      }
      result.header = std::move(vti.image);
      result.header.payload = std::move(*vti.plain);
      break;
    }
    default:
      reason = "only raw, NRRD, MetaImage, NIfTI and .vti files are";
      return std::nullopt;
  }
  return result;
}

// Swaps the bytes of `count` numbers of `width` bytes.
void swapNumbers(std::byte* bytes, std::size_t count, std::size_t width) {
  for (std::size_t i = 0; i < count; ++i, bytes += width) std::reverse(bytes, bytes + width);
}

class PlainFile final : public ChunkedVolume {
 public:
  PlainFile(PlainHeader from, std::string name, std::vector<PlainBytes> places)
      : header_(std::move(from.header)), places_(std::move(places)) {
    if (!places_.front().beside) own_.emplace(from.dataPath);
    facts_.name = std::move(name);
    facts_.format = header_.format;
    facts_.unit = header_.unit;
    facts_.axes = header_.axes;
    facts_.storedType = header_.type;
    const bool scaled =
        std::isfinite(header_.slope) && header_.slope != 0.0 && std::isfinite(header_.intercept);
    if (scaled) {
      facts_.slope = header_.slope;
      facts_.intercept = header_.intercept;
    }
    ChunkedLevel level;
    level.geometry.dims = {static_cast<int>(header_.dims[0]), static_cast<int>(header_.dims[1]),
                           static_cast<int>(header_.dims[2])};
    level.geometry.worldFromVoxel = header_.worldFromVoxel;
    level.chunkDims = {level.geometry.dims.x, 1, 1};
    level.cheapParts = true;
    facts_.levels = {level};
    facts_.times = static_cast<int>(header_.timeSteps);
    facts_.channels = static_cast<int>(header_.components * header_.slowComponents);
    facts_.warnings = header_.warnings;
    shareElements_ = header_.elements() / places_.size();
  }

  const ChunkedFacts& facts() const override { return facts_; }

  std::size_t read(VolumePart part, std::size_t level, glm::ivec3 low, glm::ivec3 size,
                   std::span<std::byte> voxels) const override {
    const glm::ivec3 dims = facts_.levels[level].geometry.dims;
    if (glm::any(glm::lessThan(low, glm::ivec3(0))) || glm::any(glm::greaterThan(low + size, dims)) ||
        glm::any(glm::lessThan(size, glm::ivec3(1))))
      throw std::logic_error("PlainFile::read(): beyond the volume");
    // Rows that are whole follow one another, and so do slices of them.
    glm::ivec3 run(size.x, 1, 1);
    if (size.x == dims.x) {
      run.y = size.y;
      if (size.y == dims.y) run.z = size.z;
    }
    const std::size_t width = bytesOf(header_.type);
    const auto count =
        static_cast<std::size_t>(run.x) * static_cast<std::size_t>(run.y) * static_cast<std::size_t>(run.z);
    std::size_t bytes = 0;
    std::byte* out = voxels.data();
    for (int z = 0; z < size.z; z += run.z)
      for (int y = 0; y < size.y; y += run.y, out += count * width)
        bytes += readRun(part, low + glm::ivec3(0, y, z), count, out);
    if (header_.type == VoxelType::float32) markMissing(voxels);
    return bytes;
  }

 private:
  // `count` voxels that follow one another in memory.
  std::size_t readRun(VolumePart part, glm::ivec3 from, std::size_t count, std::byte* out) const {
    const auto components = static_cast<std::uint64_t>(header_.components);
    const auto channel = static_cast<std::uint64_t>(part.channel);
    const std::uint64_t step = channel / components * static_cast<std::uint64_t>(header_.timeSteps) +
                               static_cast<std::uint64_t>(part.time);
    const std::uint64_t voxel =
        step * header_.voxels() +
        (static_cast<std::uint64_t>(from.z) * static_cast<std::uint64_t>(header_.dims[1]) +
         static_cast<std::uint64_t>(from.y)) *
            static_cast<std::uint64_t>(header_.dims[0]) +
        static_cast<std::uint64_t>(from.x);
    const std::size_t width = bytesOf(header_.type);
    if (components == 1) {
      readElements(voxel, {out, count * width});
    } else {
      std::vector<std::byte> mixed(count * static_cast<std::size_t>(components) * width);
      readElements(voxel * components, mixed);
      const std::byte* at = mixed.data() + channel % components * width;
      for (std::size_t i = 0; i < count; ++i, at += components * width, out += width)
        std::memcpy(out, at, width);
      out -= count * width;
    }
    if (header_.payload.endianness == Endianness::big && width > 1) swapNumbers(out, count, width);
    return count * static_cast<std::size_t>(components) * width;
  }

  // From the element `first` of the payload on, whichever files it lies in.
  void readElements(std::uint64_t first, std::span<std::byte> out) const {
    const std::size_t width = bytesOf(header_.type);
    while (!out.empty()) {
      const std::uint64_t file = first / shareElements_, at = first % shareElements_;
      const auto count =
          static_cast<std::size_t>(std::min<std::uint64_t>(shareElements_ - at, out.size() / width));
      const PlainBytes& place = places_[file];
      const Bytes& bytes = place.beside ? *place.beside : static_cast<const Bytes&>(*own_);
      bytes.read(place.begin + at * width, out.first(count * width));
      first += count;
      out = out.subspan(count * width);
    }
  }

  static void markMissing(std::span<std::byte> voxels) {
    for (std::size_t i = 0; i + sizeof(float) <= voxels.size(); i += sizeof(float)) {
      float value;
      std::memcpy(&value, &voxels[i], sizeof value);
      if (std::isfinite(value)) continue;
      value = std::numeric_limits<float>::quiet_NaN();
      std::memcpy(&voxels[i], &value, sizeof value);
    }
  }

  ImageHeader header_;
  std::optional<FileBytes> own_;
  std::vector<PlainBytes> places_;
  std::uint64_t shareElements_ = 0;
  ChunkedFacts facts_;
};

}  // namespace

std::optional<ImageHeader> headerOfPlainFile(const fs::path& path, const ReadOptions& options) {
  std::string reason;
  std::optional<PlainHeader> plain = plainHeaderOf(path, options, reason);
  return plain ? std::optional(std::move(plain->header)) : std::nullopt;
}

std::shared_ptr<const ChunkedVolume> openPlainFile(const fs::path& path, const ReadOptions& options,
                                                   std::string& reason) {
  std::optional<PlainHeader> found = plainHeaderOf(path, options, reason);
  if (!found) return nullptr;
  const ImageHeader& header = found->header;
  if (header.payload.encoding != Encoding::raw) {
    reason = header.payload.encoding == Encoding::ascii ? "its voxels are written as text"
                                                        : "its voxels are compressed";
    return nullptr;
  }
  if (header.type > VoxelType::uint16 && header.type != VoxelType::float32) {
    reason = "its voxels are " + std::string(nameOf(header.type)) +
             ", which are stored as another type; int8, uint8, int16, uint16 and float32 are";
    return nullptr;
  }
  if (header.payload.files.size() > kMostPlainFiles) {
    reason = "it has more than " + std::to_string(kMostPlainFiles) + " data files";
    return nullptr;
  }
  const FileBytes own(found->dataPath);
  std::vector<PlainBytes> places = plainBytes(header, own, openBeside(found->headerPath));
  return std::make_shared<PlainFile>(std::move(*found), path.string(), std::move(places));
}

}  // namespace isolux::volume
