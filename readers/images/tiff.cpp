#include <algorithm>
#include <bit>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include <tiffio.h>
#include <glm/gtc/packing.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "readers/images/images.h"
#include "readers/limits.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/tiff/tiff_pages.h"
#include "volume/read/tiff/tiff_stack.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

// Numbers of the TIFF 6.0 specification that are not libtiff's to name.
constexpr int kUnsigned = 1, kSigned = 2, kReal = 3, kComplexReal = 6;

struct PageOfFile {
  fs::path file;
  TiffPage page;
};

// How the samples of a page are stored, and as what they are read.
struct Samples {
  VoxelType type = VoxelType::uint8;
  int bits = 8;            // of a stored number
  std::int64_t count = 1;  // of a pixel; a complex number is two
};

Samples samplesOf(const PageOfFile& from) {
  const TiffPage& page = from.page;
  const auto bits = static_cast<int>(page.bits);
  const bool isReal = page.sampleFormat == kReal;
  if (page.sampleFormat == kComplexReal && (bits == 64 || bits == 128))
    return {bits == 64 ? VoxelType::float32 : VoxelType::float64, bits / 2, page.samples * 2};
  if (isReal && (bits == 16 || bits == 32)) return {VoxelType::float32, bits, page.samples};
  if (isReal && bits == 64) return {VoxelType::float64, bits, page.samples};
  const bool isSigned = page.sampleFormat == kSigned;
  if (bits > 64 || isReal || page.sampleFormat < kUnsigned || page.sampleFormat > 4)
    throwInput(from.file.string(), "page " + std::to_string(page.index + 1),
               "numbers of " + std::to_string(bits) + " bits in SampleFormat " +
                   std::to_string(page.sampleFormat) + " are not supported");
  const std::size_t bytes = std::bit_ceil(static_cast<unsigned>(bits + 7) / 8);
  return {*integerType(bytes, isSigned), bits, page.samples};
}

// Number `index` of a row of numbers of `bits` bits, of which the highest bit comes first; the sign is kept.
std::uint64_t packedNumber(const std::byte* row, std::int64_t index, int bits, bool isSigned) {
  std::uint64_t value = 0;
  std::uint64_t at = static_cast<std::uint64_t>(index) * static_cast<std::uint64_t>(bits);
  for (int left = bits; left > 0;) {
    const int offset = static_cast<int>(at % 8), some = std::min(left, 8 - offset);
    const unsigned byte = std::to_integer<unsigned>(row[at / 8]);
    value = value << some | (byte >> (8 - offset - some) & ((1u << some) - 1));
    at += static_cast<unsigned>(some);
    left -= some;
  }
  const bool negative = isSigned && bits < 64 && (value >> (bits - 1) & 1) != 0;
  return negative ? value | ~std::uint64_t{0} << bits : value;
}

// Moves `count` stored numbers of a row, from number `first` on, to every `stride`-th place of `out`.
void unpack(const std::byte* row, std::int64_t first, std::int64_t count, const Samples& samples,
            std::byte* out, std::int64_t stride) {
  const std::size_t width = bytesOf(samples.type);
  const bool whole = static_cast<std::size_t>(samples.bits) == width * 8;
  if (whole && stride == 1) {
    std::memcpy(out, row + static_cast<std::size_t>(first) * width, static_cast<std::size_t>(count) * width);
    return;
  }
  const bool isSigned = samples.type == VoxelType::int8 || samples.type == VoxelType::int16 ||
                        samples.type == VoxelType::int32 || samples.type == VoxelType::int64;
  const std::size_t step = static_cast<std::size_t>(stride) * width;
  for (std::int64_t i = first; i < first + count; ++i, out += step) {
    if (whole) {
      std::memcpy(out, row + static_cast<std::size_t>(i) * width, width);
    } else if (samples.type == VoxelType::float32) {
      std::uint16_t half;
      std::memcpy(&half, row + i * 2, 2);
      const float value = glm::unpackHalf1x16(half);
      std::memcpy(out, &value, width);
    } else if (samples.bits == 24) {  // libtiff turns these into the machine's byte order
      std::int32_t value = 0;
      std::memcpy(&value, row + i * 3, 3);
      if (isSigned) value = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << 8) >> 8;
      std::memcpy(out, &value, width);
    } else {
      const std::uint64_t value = packedNumber(row, i, samples.bits, isSigned);
      std::memcpy(out, &value, width);
    }
  }
}

// What libtiff says last; this process reads one file at a time.
std::string& complaint() {
  static std::string text;
  return text;
}
void keepComplaint(const char* /*module*/, const char* format, va_list values) {
  char text[400];
  std::vsnprintf(text, sizeof text, format, values);
  complaint() = text;
  std::ranges::replace(complaint(), '\n', ' ');
}

// Pixels as stored: no palette, no sense of white, no stretching to full bytes. One open file at a time.
class PageReader {
 public:
  explicit PageReader(std::vector<std::string>& warnings) : warnings_(warnings) {
    TIFFSetErrorHandler(keepComplaint);
    TIFFSetWarningHandler(nullptr);
  }

  // All samples of a page's pixels, interleaved.
  void read(const PageOfFile& from, const Samples& samples, std::span<std::byte> out,
            base::Progress& progress) {
    complaint().clear();
    open(from);
    complaint().clear();
    TIFFSetWarningHandler(keepComplaint);  // of damaged pixels that libtiff goes on with
    readBlocks(from, samples, out, progress);
    TIFFSetWarningHandler(nullptr);
    if (!complaint().empty() && warnings_.size() < 100) warnings_.push_back(place(from) + ": " + complaint());
  }

 private:
  static std::string place(const PageOfFile& from) { return "page " + std::to_string(from.page.index + 1); }

  [[noreturn]] static void fail(const PageOfFile& from) {
    throwInput(from.file.string(), place(from), complaint().empty() ? "cannot be read" : complaint());
  }

  void open(const PageOfFile& from) {
    if (!tiff_ || file_ != from.file) {
      file_ = from.file;
      tiff_.reset(TIFFOpen(file_.c_str(), "rm"));  // m: no memory map, which a file cut meanwhile would end
      if (!tiff_) fail(from);
    }
    if (!TIFFSetSubDirectory(tiff_.get(), from.page.directory)) fail(from);
    std::uint32_t width = 0, height = 0;
    std::uint16_t bits = 1, samples = 1, compression = 1, photometric = 0, planes = 1;
    TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &bits);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_COMPRESSION, &compression);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_PLANARCONFIG, &planes);
    TIFFGetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, &photometric);
    if (width != from.page.width || height != from.page.height || bits != from.page.bits ||
        samples != from.page.samples)
      throwInput(file_.string(), place(from), "its directory contradicts itself");
    if (!TIFFIsCODECConfigured(compression))
      throwInput(file_.string(), place(from),
                 "the compression " + std::to_string(compression) + " is not supported");
    const bool jpeg = compression == COMPRESSION_JPEG;
    if (jpeg && photometric == PHOTOMETRIC_YCBCR)
      TIFFSetField(tiff_.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    inPlanes_ = planes == PLANARCONFIG_SEPARATE && samples > 1;
  }

  // The numbers that a strip or tile keeps of one pixel, and the place of the first in the pixel.
  std::int64_t numbersOf(const Samples& samples, const PageOfFile& from) const {
    return inPlanes_ ? samples.count / from.page.samples : samples.count;
  }

  // One row, or the part of it that a tile has.
  void unpackRow(const std::byte* row, std::int64_t pixels, const Samples& samples, const PageOfFile& from,
                 std::uint16_t plane, std::byte* out) const {
    const std::int64_t numbers = numbersOf(samples, from);
    if (!inPlanes_) return unpack(row, 0, pixels * numbers, samples, out, 1);
    const std::size_t width = bytesOf(samples.type);
    for (std::int64_t part = 0; part < numbers; ++part) {
      std::byte* const at = out + static_cast<std::size_t>(plane * numbers + part) * width;
      if (numbers == 1)
        unpack(row, 0, pixels, samples, at, samples.count);
      else  // complex: its two numbers lie side by side
        for (std::int64_t x = 0; x < pixels; ++x)
          unpack(row, x * numbers + part, 1, samples,
                 at + static_cast<std::size_t>(x * samples.count) * width, 1);
    }
  }

  // By tiles, or by strips, which are as wide as the page.
  void readBlocks(const PageOfFile& from, const Samples& samples, std::span<std::byte> out,
                  base::Progress& progress) {
    TIFF* const tiff = tiff_.get();
    const bool tiled = TIFFIsTiled(tiff) != 0;
    const auto width = static_cast<std::uint32_t>(from.page.width);
    const auto height = static_cast<std::uint32_t>(from.page.height);
    std::uint32_t blockWidth = width, blockHeight = 0;
    if (tiled) {
      TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &blockWidth);
      TIFFGetField(tiff, TIFFTAG_TILELENGTH, &blockHeight);
      if (blockWidth < 1 || blockHeight < 1 || blockWidth > 65536 || blockHeight > 65536)
        throwInput(file_.string(), place(from), "has tiles of an absurd size");
    } else {
      TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &blockHeight);
      blockHeight = std::clamp<std::uint32_t>(blockHeight, 1, height);
    }
    const std::size_t rowBytes = out.size() / height, pixelBytes = rowBytes / width;
    const auto storedRow =
        static_cast<std::size_t>(tiled ? TIFFTileRowSize64(tiff) : TIFFScanlineSize64(tiff));
    const std::uint64_t blockBytes = tiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff);
    if (tiled && blockBytes / 4 > out.size() + (std::size_t{64} << 20))
      throwInput(file_.string(), place(from), "has tiles that are larger than the page");
    buffer_.resize(static_cast<std::size_t>(blockBytes));
    checkRows(storedRow, blockHeight, blockWidth, samples, from);
    for (std::uint16_t plane = 0; plane < (inPlanes_ ? from.page.samples : 1); ++plane)
      for (std::uint32_t y = 0; y < height; y += blockHeight)
        for (std::uint32_t x = 0; x < width; x += blockWidth) {
          progress.throwIfStopped();
          const std::uint32_t rows = std::min(blockHeight, height - y);
          const auto wanted = static_cast<tmsize_t>(tiled ? blockBytes : storedRow * rows);
          const tmsize_t got =
              tiled ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, plane), buffer_.data(), wanted)
                    : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, plane), buffer_.data(), wanted);
          if (got != wanted) fail(from);
          for (std::uint32_t row = 0; row < rows; ++row)
            unpackRow(buffer_.data() + storedRow * row, std::min(blockWidth, width - x), samples, from, plane,
                      out.data() + rowBytes * (y + row) + pixelBytes * x);
        }
  }

  // A row as libtiff decodes it holds the numbers that are taken from it, and the buffer all rows.
  void checkRows(std::size_t storedRow, std::size_t rows, std::int64_t pixels, const Samples& samples,
                 const PageOfFile& from) const {
    const std::int64_t bits = pixels * numbersOf(samples, from) * samples.bits;
    if (static_cast<std::int64_t>(storedRow) < (bits + 7) / 8 || buffer_.size() / rows < storedRow)
      throwInput(file_.string(), place(from), "its rows are shorter than its pixels");
  }

  struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };
  std::vector<std::string>& warnings_;
  fs::path file_;
  std::unique_ptr<TIFF, Close> tiff_;
  std::vector<std::byte> buffer_;
  bool inPlanes_ = false;  // each sample has strips of its own
};

// Planes of which the file describes the first only, in the machine's byte order.
void readRawPlane(const Bytes& bytes, const TiffPage& page, std::size_t plane, bool bigEndian,
                  const Samples& samples, std::span<std::byte> out) {
  std::vector<std::byte> raw(static_cast<std::size_t>(page.rawBytes()));
  bytes.read(page.pixels + plane * raw.size(), raw);
  const auto width = static_cast<std::size_t>(samples.bits / 8);
  if (bigEndian && width > 1) swapBytes(raw, width);
  const auto numbers = static_cast<std::int64_t>(out.size() / bytesOf(samples.type));
  unpack(raw.data(), 0, numbers, samples, out.data(), 1);
}

struct Pages {
  std::vector<PageOfFile> all;  // of one layout
  TiffFile first;               // the first file, with those of its pages that are among them
};

// Pages of the layout that most have, of these the first; the others are left out.
Pages pagesOf(const std::vector<fs::path>& files, base::Progress& progress,
              std::vector<std::string>& warnings) {
  Pages pages;
  std::vector<std::pair<TiffPage, std::size_t>> layouts;
  for (const fs::path& file : files) {
    progress.throwIfStopped();
    TiffFile read = tiffPages(FileBytes(file), progress);
    for (const TiffPage& page : read.pages) {
      pages.all.push_back({file, page});
      const auto known =
          std::ranges::find_if(layouts, [&](const auto& layout) { return page.sameLayoutAs(layout.first); });
      if (known == layouts.end() && layouts.size() < 1000)
        layouts.emplace_back(page, 1);
      else if (known != layouts.end())
        ++known->second;
    }
    if (file == files.front()) pages.first = std::move(read);
  }
  const TiffPage kept = std::ranges::max_element(layouts, [](const auto& a, const auto& b) {
                          return a.second < b.second;
                        })->first;
  const std::size_t before = pages.all.size();
  std::erase_if(pages.all, [&](const PageOfFile& page) { return !page.page.sameLayoutAs(kept); });
  std::erase_if(pages.first.pages, [&](const TiffPage& page) { return !page.sameLayoutAs(kept); });
  if (const std::size_t others = before - pages.all.size(); others > 0)
    warnings.push_back(std::to_string(others) + " of " + std::to_string(before) +
                       " pages differ in size or type from the others and are left out");
  return pages;
}

std::uint64_t bytesOfAll(const std::vector<fs::path>& files) {
  std::uint64_t bytes = 0;
  for (const fs::path& file : files) bytes += FileBytes(file).size();
  return bytes;
}

// Of a folder the first file speaks for all; what it says of its own pages cannot be said of those of others.
TiffStack stackOf(const Pages& pages, const std::vector<fs::path>& files, const std::string& path) {
  const std::string first = files.front().string();
  if (pages.first.pages.empty())
    throwInput(first, "page 1", "differs in size or type from most files of the folder");
  TiffStack stack = tiffStackOf(pages.first, first, FileBytes(first).size());
  if (files.size() == 1) return stack;
  if (stack.channels * stack.frames > 1 || stack.inOnePage)
    throwInput(path, "", "each file of the folder is a stack of channels or frames; open one of them");
  if (stack.slices == 1 && stack.spacingMm != glm::dvec3(1.0))
    stack.warnings.push_back(base::shortText(stack.spacingMm.z) + " mm " +
                             std::string(kSliceDistanceAssumed));
  stack.slices = static_cast<std::int64_t>(pages.all.size());
  stack.planes.resize(pages.all.size());
  for (std::size_t i = 0; i < stack.planes.size(); ++i) stack.planes[i] = i;
  return stack;
}

// Voxels of `noData` become missing, which only real numbers can be.
void leaveOutNoData(double noData, FileVoxels& voxels, std::vector<std::string>& warnings) {
  std::visit(
      [&]<typename T>(std::vector<T>& values) {
        const auto marked = [&](T value) { return static_cast<double>(value) == noData; };
        if (std::ranges::none_of(values, marked)) return;
        using Real = std::conditional_t<(sizeof(T) < 4) || std::is_same_v<T, float>, float, double>;
        std::vector<Real> reals(values.size());
        std::transform(values.begin(), values.end(), reals.begin(), [&](T value) {
          return marked(value) ? std::numeric_limits<Real>::quiet_NaN() : static_cast<Real>(value);
        });
        warnings.push_back("voxels of the file's no-data value count as missing");
        FileVoxels(std::move(reals)).swap(voxels);
      },
      voxels);
}

}  // namespace

DecodedVolume decodeTiff(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
  progress.report(0.0, "reading");
  const std::vector<fs::path> files =
      fs::is_directory(path) ? tiffFilesIn(path) : std::vector<fs::path>{path};
  if (files.empty()) throwInput(path.string(), "", "has no TIFF files");
  ImageHeader header;
  header.format = "TIFF";
  allowHeaders(files.size(), bytesOfAll(files));
  const Pages pages = pagesOf(files, progress, header.warnings);
  allowDecoding(bytesOfAll(files));
  const TiffStack stack = stackOf(pages, files, path.string());
  header.warnings.insert(header.warnings.end(), stack.warnings.begin(), stack.warnings.end());
  const TiffPage& first = pages.all.front().page;
  const Samples samples = samplesOf(pages.all.front());
  header.type = samples.type;
  header.dims = {first.width, first.height, stack.slices};
  header.components = samples.count;
  header.slowComponents = stack.channels;
  header.timeSteps = stack.frames;
  header.slope = stack.slope;
  header.intercept = stack.intercept;
  header.unit = stack.unit;
  header.worldFromVoxel =
      checkedGeometry(glm::dmat3(1.0), stack.spacingMm, glm::dvec3(0.0), path.string(), header.warnings);
  checkDims(header, path.string(), "pages");
  checkChoices(header, path.string(), options);

  // The channels that are asked for, of one time step; all samples of a page are decoded at once.
  const bool magnitude = options.component < 0;
  const std::int64_t firstChannel = magnitude ? 0 : options.component / samples.count;
  ImageHeader part = header;
  part.timeSteps = 1;
  part.slowComponents = magnitude ? stack.channels : 1;
  ReadOptions ofPart = options;
  ofPart.timeStep = 0;
  ofPart.component = magnitude ? -1 : static_cast<int>(options.component % samples.count);
  ReadOptions whole = options;
  whole.budgetBytes /= static_cast<std::size_t>(part.components * part.slowComponents);
  checkBudget(header, path.string(), whole);

  const std::size_t pageBytes =
      static_cast<std::size_t>(first.width * first.height * samples.count) * bytesOf(samples.type);
  const std::int64_t planes = part.slowComponents * stack.slices;
  std::vector<std::byte> pixels;
  pixels.reserve(pageBytes * static_cast<std::size_t>(planes));
  PageReader reader(header.warnings);
  const FileBytes bytes(files.front());
  for (std::int64_t i = 0; i < planes; ++i) {
    const std::size_t plane =
        stack.plane(firstChannel + i / stack.slices, i % stack.slices, options.timeStep);
    const std::size_t at = pixels.size();
    pixels.resize(at + pageBytes);
    const auto out = std::span(pixels).subspan(at);
    if (stack.inOnePage)
      readRawPlane(bytes, first, plane, pages.first.bigEndian, samples, out);
    else
      reader.read(pages.all[plane], samples, out, progress);
    progress.report(static_cast<double>(i + 1) / static_cast<double>(planes), "reading");
  }
  FileVoxels voxels = decodePayload(part, MemoryBytes(path.string(), pixels), openBeside(path), ofPart,
                                    progress, header.warnings);
  std::vector<std::byte>().swap(pixels);  // before the voxels are handed over
  if (stack.noData && !magnitude) leaveOutNoData(*stack.noData, voxels, header.warnings);
  header.components *= header.slowComponents;
  header.slowComponents = 1;
  return {std::move(header), std::move(voxels), {}, {}, {}};
}

}  // namespace isolux::readers
