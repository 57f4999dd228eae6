#include "volume/read/input/payload.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/streams.h"

namespace isolux::volume {

using base::throwInput;

static_assert(std::endian::native == std::endian::little, "voxels are swapped to little endian");

namespace {

constexpr std::size_t chunkBytes = std::size_t{1} << 20;

// Where the data of one file begin: after the skipped lines and bytes.
std::uint64_t beginOf(const Payload& payload, const Bytes& bytes, std::uint64_t dataBytes) {
  if (payload.fromEnd) {
    if (dataBytes > bytes.size())
      throwInput(bytes.name(), "",
                 "truncated: " + std::to_string(dataBytes) + " bytes of voxels are announced, the file has " +
                     std::to_string(bytes.size()));
    return bytes.size() - dataBytes;
  }
  std::uint64_t at = payload.offset;
  std::vector<std::byte> buffer(payload.lineSkip > 0 ? std::size_t{4096} : 0);
  for (std::uint64_t lines = payload.lineSkip; lines > 0;) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(buffer.size(), bytes.size() - std::min(at, bytes.size())));
    if (count == 0) throwInput(bytes.name(), "line skip", "the file has fewer lines than are to be skipped");
    bytes.read(at, std::span(buffer).first(count));
    std::size_t used = 0;
    while (used < count && lines > 0)
      if (buffer[used++] == std::byte{'\n'}) --lines;
    at += used;
  }
  if (__builtin_add_overflow(at, payload.skipBytes, &at)) at = std::numeric_limits<std::uint64_t>::max();
  if (at > bytes.size())
    throwInput(bytes.name(), "byte " + std::to_string(at),
               "truncated: the voxels start behind the end of the file (" + std::to_string(bytes.size()) +
                   " bytes)");
  return at;
}

// Refuses a claim that the bytes from `begin` on cannot hold.
void checkClaim(const Payload& payload, const Bytes& bytes, std::uint64_t begin, std::uint64_t dataBytes,
                std::uint64_t elements) {
  std::uint64_t available = bytes.size() - begin;
  const auto truncated = [&](const std::string& what) {
    throwInput(
        bytes.name(), "byte " + std::to_string(begin),
        "truncated: the header announces " + std::to_string(dataBytes) + " bytes of voxels, but " + what);
  };
  switch (payload.encoding) {
    case Encoding::raw:
      if (dataBytes > available) truncated("only " + std::to_string(available) + " follow");
      break;
    case Encoding::zlib: {
      if (payload.compressedBytes > available)
        throwInput(bytes.name(), "byte " + std::to_string(begin),
                   "truncated: the header announces " + std::to_string(payload.compressedBytes) +
                       " compressed bytes, but only " + std::to_string(available) + " follow");
      if (payload.compressedBytes > 0) available = payload.compressedBytes;
      const auto markBytes = static_cast<std::size_t>(std::min<std::uint64_t>(4, available));
      if (dataBytes / bestRatio(bytes.text(begin, markBytes)) > available)
        truncated(std::to_string(available) + " compressed bytes cannot hold that");
      break;
    }
    case Encoding::ascii:
      if (elements - 1 > available / 2) truncated("only " + std::to_string(available) + " characters follow");
      break;
  }
}

std::uint64_t filesOf(const Payload& payload) {
  return std::max<std::uint64_t>(1, payload.files.size());
}

// That each data file holds.
std::uint64_t elementsOfFile(const ImageHeader& header, const std::string& file) {
  const std::uint64_t files = filesOf(header.payload);
  if (header.elements() % files != 0)
    throwInput(file, "data file",
               std::to_string(files) + " data files cannot share " + std::to_string(header.elements()) +
                   " values equally");
  return header.elements() / files;
}

// A data file, which can hold its share of what the header claims.
PlainBytes payloadFile(const ImageHeader& header, const Bytes& own, const OpenBeside& beside,
                       std::uint64_t file) {
  const Payload& payload = header.payload;
  const std::uint64_t share = elementsOfFile(header, own.name()), shareBytes = share * bytesOf(header.type);
  PlainBytes place;
  if (!payload.files.empty()) place.beside = beside(payload.files[file]);
  const Bytes& bytes = place.beside ? *place.beside : own;
  place.begin = beginOf(payload, bytes, shareBytes);
  checkClaim(payload, bytes, place.begin, shareBytes, share);
  return place;
}

// The voxel stream of the whole payload, file after file.
class PayloadStream {
 public:
  PayloadStream(const ImageHeader& header, const Bytes& own, const OpenBeside& beside,
                const base::Progress& progress)
      : header_(header), own_(own), beside_(beside), progress_(progress) {
    shareBytes_ = elementsOfFile(header, own.name()) * bytesOf(header.type);
    // All files are looked at before the first voxel is stored.
    for (std::uint64_t file = filesOf(header.payload); file-- > 0;) open(file);
  }

  void read(std::span<std::byte> out) {
    while (!out.empty()) {
      if (left_ == 0) open(file_ + 1);
      const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), left_));
      if (stream_)
        stream_->read(out.first(part));
      else
        bytes_->read(begin() + (shareBytes_ - left_), out.first(part));
      left_ -= part;
      out = out.subspan(part);
    }
  }

  // Passes over bytes; without reading them where the file allows it.
  void skip(std::uint64_t bytes) {
    while (bytes > 0) {
      if (left_ == 0) open(file_ + 1);
      const std::uint64_t part = std::min(bytes, left_);
      bytes -= part;
      left_ -= part;
      if (stream_) discard(part);
    }
  }

  // After everything was read: do data follow that the header does not know of?
  bool hasMore() {
    if (left_ == 0 && !header_.payload.fromEnd && !header_.payload.moreMayFollow) lookBehind();
    return more_;
  }
  // Of packed data that were read: is the checksum at their end missing?
  bool isCut() const { return cut_; }

 private:
  void discard(std::uint64_t bytes) {
    std::vector<std::byte> scratch(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, chunkBytes)));
    while (bytes > 0) {
      progress_.throwIfStopped();
      const auto part =
          std::span(scratch).first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, scratch.size())));
      stream_->read(part);
      bytes -= part.size();
    }
  }

  void lookBehind() {
    more_ = (stream_ ? stream_->hasMore() : begin() + shareBytes_ < bytes_->size()) || more_;
    cut_ = (stream_ && stream_->isCut()) || cut_;
  }

  void open(std::uint64_t file) {
    progress_.throwIfStopped();
    const Payload& payload = header_.payload;
    if (stream_ && left_ == 0 && payload.encoding == Encoding::zlib) lookBehind();
    file_ = file;
    opened_ = payloadFile(header_, own_, beside_, file);
    bytes_ = opened_.beside ? opened_.beside.get() : &own_;
    left_ = shareBytes_;
    if (payload.encoding == Encoding::ascii) stream_ = textStream(*bytes_, begin(), header_.type);
    if (payload.encoding != Encoding::zlib) return;
    const std::uint64_t length =
        payload.compressedBytes > 0 ? payload.compressedBytes : bytes_->size() - begin();
    stream_ = inflateStream(*bytes_, begin(), length);
    discard(payload.skipDecoded);
  }
  std::uint64_t begin() const { return opened_.begin; }

  const ImageHeader& header_;
  const Bytes& own_;
  const OpenBeside& beside_;
  const base::Progress& progress_;
  PlainBytes opened_;
  const Bytes* bytes_ = nullptr;
  std::unique_ptr<VoxelStream> stream_;  // null: the voxels are the file's bytes
  std::uint64_t file_ = 0, shareBytes_ = 0, left_ = 0;
  bool more_ = false, cut_ = false;
};

// Passes one volume of the payload, chunk by chunk of whole voxels, to f(values: span<T>).
template <typename T, typename F>
void forEachChunk(const ImageHeader& header, PayloadStream& stream, const base::Progress& progress, F&& f) {
  const auto components = static_cast<std::uint64_t>(header.components);
  const std::uint64_t chunkVoxels = std::max<std::uint64_t>(1, chunkBytes / (components * sizeof(T)));
  const bool swap =
      header.payload.endianness == Endianness::big && header.payload.encoding != Encoding::ascii;
  std::vector<T> chunk;
  for (std::uint64_t done = 0; done < header.voxels();) {
    progress.throwIfStopped();
    const std::uint64_t count = std::min(chunkVoxels, header.voxels() - done);
    chunk.resize(static_cast<std::size_t>(count * components));
    stream.read(std::as_writable_bytes(std::span(chunk)));
    if (swap && sizeof(T) > 1) swapBytes(std::as_writable_bytes(std::span(chunk)), sizeof(T));
    f(std::span<const T>(chunk));
    done += count;
  }
}

template <typename T>
FileVoxels decodeAs(const ImageHeader& header, PayloadStream& stream, const ReadOptions& options,
                    base::Progress& progress, bool& dataFollow) {
  const auto voxels = static_cast<std::size_t>(header.voxels());
  const auto components = static_cast<std::size_t>(header.components);
  const std::uint64_t volumeBytes =
      header.voxels() * static_cast<std::uint64_t>(header.components) * sizeof(T);
  const auto steps = static_cast<std::uint64_t>(header.timeSteps);
  const auto step = static_cast<std::uint64_t>(options.timeStep);
  const auto slow = static_cast<std::uint64_t>(header.slowComponents);
  std::uint64_t position = 0;  // volumes passed
  std::size_t done = 0;
  // Passes the time step of a slow component, of `blocks` that are read.
  const auto readBlock = [&](std::uint64_t block, std::uint64_t blocks, const auto& use) {
    const std::uint64_t volume = block * steps + step;
    stream.skip((volume - position) * volumeBytes);
    position = volume + 1;
    forEachChunk<T>(header, stream, progress, [&](std::span<const T> chunk) {
      use(chunk);
      done += chunk.size() / components;
      progress.report(static_cast<double>(done) / static_cast<double>(voxels * blocks), "reading");
    });
    dataFollow = position == slow * steps && stream.hasMore();
  };

  if (options.component < 0) {  // the magnitude, in float32 whatever the type
    std::vector<float> magnitude;
    resizeStoppably(magnitude, voxels, progress);
    for (std::uint64_t block = 0; block < slow; ++block) {
      std::size_t voxel = 0;
      readBlock(block, slow, [&](std::span<const T> chunk) {
        for (std::size_t i = 0; i < chunk.size(); i += components, ++voxel) {
          double length = static_cast<double>(magnitude[voxel]);
          for (std::size_t c = 0; c < components; ++c)
            length = std::hypot(length, static_cast<double>(chunk[i + c]));
          magnitude[voxel] = std::isfinite(length) ? static_cast<float>(std::min(length, 3.4e38))
                                                   : std::numeric_limits<float>::quiet_NaN();
        }
      });
    }
    return magnitude;
  }

  const auto component = static_cast<std::size_t>(options.component);
  std::vector<T> values;
  values.reserve(voxels);
  readBlock(component / components, 1, [&](std::span<const T> chunk) {
    if (components == 1)
      values.insert(values.end(), chunk.begin(), chunk.end());
    else
      for (std::size_t i = component % components; i < chunk.size(); i += components)
        values.push_back(chunk[i]);
  });
  return values;
}

// "2 layers of labels that overlap, layer 0 (liver, tumour) is shown; source.component chooses another"
std::string layerText(const LabelTable& table, int layers, int layer) {
  constexpr std::size_t mostNames = 5;
  const std::vector<Label> labels = labelsOfLayer(table, layer).labels;
  std::string names;
  for (std::size_t i = 0; i < std::min(labels.size(), mostNames); ++i)
    names +=
        (i > 0 ? ", " : "") + (labels[i].name.empty() ? std::to_string(labels[i].value) : labels[i].name);
  if (labels.size() > mostNames) names += ", ...";
  return std::to_string(layers) + " layers of labels, layer " + std::to_string(layer) + " (" + names +
         ") is shown; source.component chooses another";
}

}  // namespace

void checkChoices(const ImageHeader& header, const std::string& file, const ReadOptions& options) {
  const std::int64_t components = header.components * header.slowComponents;
  if (options.component == -1 && header.labels)
    base::throwUsage(file, "source.component", "labels have no magnitude; choose a layer, 0 is the first");
  if (options.component < -1 || options.component >= components)
    base::throwUsage(file, "source.component",
                     "channel " + std::to_string(options.component) + " does not exist; the file has " +
                         std::to_string(components) + " (0 is the first, -1 the magnitude)");
  if (options.timeStep < 0 || options.timeStep >= header.timeSteps)
    base::throwUsage(file, "source.time_step",
                     "time step " + std::to_string(options.timeStep) + " does not exist; the file has " +
                         std::to_string(header.timeSteps) + " (0 is the first)");
}

void checkBudget(const ImageHeader& header, const std::string& file, const ReadOptions& options) {
  const VoxelType type = header.type;
  const bool wide = type >= VoxelType::int32 && type != VoxelType::float32;  // another type is made of it
  checkBudget(header.voxels() * (bytesOf(type) + (wide ? sizeof(float) : 0)), "the volume", "", file,
              options);
}

void checkBudget(std::uint64_t bytes, std::string_view what, std::string_view remedy, const std::string& file,
                 const ReadOptions& options) {
  if (bytes <= options.budgetBytes) return;
  const std::size_t held = base::machineMemory().held();
  throw base::Error(base::ErrorKind::memory, file, "",
                    base::overBudgetText(bytes, held, options.budgetBytes + held, what, remedy));
}

FileVoxels decodePayload(const ImageHeader& header, const Bytes& own, const OpenBeside& beside,
                         const ReadOptions& options, base::Progress& progress,
                         std::vector<std::string>& warnings) {
  checkChoices(header, own.name(), options);
  progress.report(0.0, "reading");
  PayloadStream stream(header, own, beside, progress);  // compares the claim with the files
  checkBudget(header, own.name(), options);
  bool dataFollow = false;
  FileVoxels voxels = withType(header.type, [&](auto zero) {
    return decodeAs<decltype(zero)>(header, stream, options, progress, dataFollow);
  });
  if (dataFollow)
    warnings.push_back("the file holds more data than the header announces; the rest is ignored");
  if (stream.isCut())
    warnings.push_back(
        "the compressed data are cut off: all voxels are there, the checksum at the end is missing; take a "
        "complete copy");
  return voxels;
}

std::vector<PlainBytes> plainBytes(const ImageHeader& header, const Bytes& own, const OpenBeside& beside) {
  std::vector<PlainBytes> result;
  for (std::uint64_t file = 0; file < filesOf(header.payload); ++file)
    result.push_back(payloadFile(header, own, beside, file));
  return result;
}

bool scalingIsUsable(const Grid& grid) {
  const double range = grid.maximum() - grid.minimum();
  return std::isfinite(range) && (range > 0.0 || grid.storedMinimum() == grid.storedMaximum());
}

Volume volumeOf(const ImageHeader& header, const ReadOptions& options) {
  Volume volume;
  volume.format = header.format;
  volume.fileType = header.type;
  volume.unit = header.unit;
  volume.axes = header.axes;
  volume.components = static_cast<int>(header.components * header.slowComponents);
  volume.timeSteps = static_cast<int>(header.timeSteps);
  volume.isovalue = header.isovalue;
  volume.warnings = header.warnings;
  if (header.labels) {
    volume.labelTable = std::make_shared<const LabelTable>(labelsOfLayer(*header.labels, options.component));
    if (volume.components > 1)
      volume.warnings.push_back(layerText(*header.labels, volume.components, options.component));
  } else if (volume.components > 1) {
    const std::string shown =
        options.component < 0 ? "their magnitude" : "component " + std::to_string(options.component);
    volume.warnings.push_back(std::to_string(volume.components) + " components per voxel, " + shown +
                              " is shown; source.component chooses another, -1 the magnitude");
  }
  return volume;
}

void noteStep(Volume& volume, double step) {
  if (volume.timeSteps < 2) return;
  const int whole = static_cast<int>(step);
  const std::string blend =
      step > whole ? ", a blend of " + std::to_string(whole) + " and " + std::to_string(whole + 1) + "," : "";
  volume.warnings.push_back(std::to_string(volume.timeSteps) + " time steps, step " +
                            base::shortestText(step) + blend + " is shown; source.time_step chooses another");
}

void noteMissing(Volume& volume, const Grid& grid) {
  if (grid.missingCount() > 0)
    volume.warnings.push_back(std::to_string(grid.missingCount()) + " of " +
                              std::to_string(grid.geometry().voxelCount()) +
                              " voxels are NaN or infinite and count as missing");
}

Volume finishVolume(const ImageHeader& header, FileVoxels&& voxels, const ReadOptions& options,
                    base::Progress& progress) {
  Volume volume = volumeOf(header, options);
  StoredVoxels stored = toStored(std::move(voxels), progress, volume.warnings);
  double slope = header.slope, intercept = header.intercept;
  if (!std::isfinite(slope) || slope == 0.0 || !std::isfinite(intercept)) {
    slope = 1.0;
    intercept = 0.0;
  }
  // The magnitude has no offset: slope * |v| would be its scaled length, the intercept means nothing.
  if (options.component < 0 && intercept != 0.0) {
    volume.warnings.push_back("the intercept is left out of the magnitude");
    intercept = 0.0;
  }
  double combinedSlope = slope * stored.slope, combinedIntercept = slope * stored.intercept + intercept;
  if (!std::isfinite(combinedSlope) || combinedSlope == 0.0 || !std::isfinite(combinedIntercept)) {
    volume.warnings.emplace_back(kScalingLeftOut);
    combinedSlope = stored.slope;
    combinedIntercept = stored.intercept;
  }
  progress.throwIfStopped();
  auto grid = std::make_shared<Grid>(header.geometry(), std::move(stored.voxels), combinedSlope,
                                     combinedIntercept, progress);
  const bool scaled = combinedSlope != stored.slope || combinedIntercept != stored.intercept;
  if (scaled && !scalingIsUsable(*grid)) {
    volume.warnings.emplace_back(kScalingLeftOut);
    grid = std::make_shared<Grid>(header.geometry(), std::move(*grid).takeVoxels(), stored.slope,
                                  stored.intercept, progress);
  }
  noteMissing(volume, *grid);
  volume.grid = std::move(grid);
  progress.report(1.0, "reading");
  return volume;
}

Volume volumeFrom(ImageHeader header, const Bytes& own, const OpenBeside& beside, const ReadOptions& options,
                  base::Progress& progress) {
  FileVoxels voxels = decodePayload(header, own, beside, options, progress, header.warnings);
  return finishVolume(header, std::move(voxels), options, progress);
}

}  // namespace isolux::volume
