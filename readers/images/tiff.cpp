#include <algorithm>
#include <optional>

#include <OpenImageIO/imageio.h>

#include "base/error.h"
#include "readers/images/images.h"
#include "readers/limits.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/text.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

struct PageOfFile {
  fs::path file;
  TiffPage page;
};

std::optional<VoxelType> typeOf(const OIIO::TypeDesc& format) {
  switch (format.basetype) {
    case OIIO::TypeDesc::INT8:
      return VoxelType::int8;
    case OIIO::TypeDesc::UINT8:
      return VoxelType::uint8;
    case OIIO::TypeDesc::INT16:
      return VoxelType::int16;
    case OIIO::TypeDesc::UINT16:
      return VoxelType::uint16;
    case OIIO::TypeDesc::INT32:
      return VoxelType::int32;
    case OIIO::TypeDesc::UINT32:
      return VoxelType::uint32;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return VoxelType::float32;
    case OIIO::TypeDesc::DOUBLE:
      return VoxelType::float64;
    default:
      return std::nullopt;
  }
}

// One open file at a time.
class PageReader {
 public:
  // Pixel values as stored: no palette, no premultiplied alpha.
  const OIIO::ImageSpec& open(const PageOfFile& page) {
    if (!input_ || file_ != page.file) {
      OIIO::ImageSpec config;
      config["oiio:RawColor"] = 1;
      config["oiio:UnassociatedAlpha"] = 1;
      file_ = page.file;
      input_ = OIIO::ImageInput::open(file_.string(), &config);
      if (!input_) throwInput(file_.string(), place(page), reason(OIIO::geterror()));
    }
    if (!input_->seek_subimage(page.page.index, 0))
      throwInput(file_.string(), place(page), reason(input_->geterror()));
    return input_->spec();
  }

  void read(const PageOfFile& page, VoxelType type, std::int64_t samples, std::span<std::byte> out,
            base::Progress& progress) {
    const OIIO::ImageSpec& spec = open(page);
    if (spec.width != page.page.width || spec.height != page.page.height || spec.depth > 1 ||
        spec.nchannels != samples || typeOf(spec.format) != type)
      throwInput(file_.string(), place(page), "differs in size or type from the first page");
    const OIIO::TypeDesc format =
        spec.format.basetype == OIIO::TypeDesc::HALF ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : spec.format;
    // Row by row, or tile by tile: OpenImageIO 2.4 shows zeros for damaged pixels when asked for a whole
    // image.
    const auto pixelBytes = static_cast<OIIO::stride_t>(format.size()) * spec.nchannels;
    const auto rowBytes = pixelBytes * spec.width;
    const auto failed = [&] { throwInput(file_.string(), place(page), reason(input_->geterror())); };
    if (spec.tile_width == 0) {
      for (int y = 0; y < spec.height; ++y) {
        progress.throwIfStopped();
        if (!input_->read_scanline(spec.y + y, 0, format, out.data() + y * rowBytes)) failed();
      }
      return;
    }
    for (int y = 0; y < spec.height; y += spec.tile_height)
      for (int x = 0; x < spec.width; x += spec.tile_width) {
        progress.throwIfStopped();
        const int right = std::min(x + spec.tile_width, spec.width);
        const int bottom = std::min(y + spec.tile_height, spec.height);
        if (!input_->read_tiles(page.page.index, 0, spec.x + x, spec.x + right, spec.y + y, spec.y + bottom,
                                0, 1, 0, spec.nchannels, format, out.data() + y * rowBytes + x * pixelBytes,
                                pixelBytes, rowBytes))
          failed();
      }
  }

 private:
  static std::string place(const PageOfFile& page) { return "page " + std::to_string(page.page.index + 1); }
  static std::string reason(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "cannot be read" : text;
  }

  fs::path file_;
  std::unique_ptr<OIIO::ImageInput> input_;
};

// Pages that agree with the first one; the others are left out.
std::vector<PageOfFile> pagesOf(const std::vector<fs::path>& files, base::Progress& progress,
                                std::vector<std::string>& warnings) {
  std::vector<PageOfFile> pages;
  std::size_t others = 0;
  for (const fs::path& file : files) {
    progress.throwIfStopped();
    for (const TiffPage& page : tiffPages(FileBytes(file), progress)) {
      if (pages.empty() || page.sameLayoutAs(pages.front().page))
        pages.push_back({file, page});
      else
        ++others;
    }
  }
  if (others > 0)
    warnings.push_back(std::to_string(others) +
                       " pages differ in size or type from the first and are left out");
  return pages;
}

std::uint64_t bytesOfAll(const std::vector<fs::path>& files) {
  std::uint64_t bytes = 0;
  for (const fs::path& file : files) bytes += FileBytes(file).size();
  return bytes;
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
  const std::vector<PageOfFile> pages = pagesOf(files, progress, header.warnings);
  allowDecoding(bytesOfAll(files));
  const TiffPage& first = pages.front().page;
  PageReader reader;
  const OIIO::ImageSpec spec = reader.open(pages.front());
  const auto type = typeOf(spec.format);
  if (!type)
    throwInput(pages.front().file.string(), "page 1",
               "the pixel type " + inQuotes(spec.format.c_str()) + " is not supported");
  header.type = *type;
  header.dims = {first.width, first.height, static_cast<std::int64_t>(pages.size())};
  header.components = spec.nchannels;
  checkDims(header, path.string(), "pages");
  checkChoices(header, path.string(), options);
  ReadOptions whole = options;  // all components are decoded at once
  whole.budgetBytes /= static_cast<std::size_t>(header.components);
  checkBudget(header, path.string(), whole);
  header.warnings.push_back("TIFF states no distance of slices; 1 x 1 x 1 mm assumed");

  const std::size_t pageBytes =
      static_cast<std::size_t>(first.width * first.height * header.components) * bytesOf(*type);
  std::vector<std::byte> pixels;
  pixels.reserve(pageBytes * pages.size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    pixels.resize(pageBytes * (i + 1));
    reader.read(pages[i], *type, header.components, std::span(pixels).subspan(pageBytes * i), progress);
    progress.report(static_cast<double>(i + 1) / static_cast<double>(pages.size()), "reading");
  }
  FileVoxels voxels = decodePayload(header, MemoryBytes(path.string(), pixels), openBeside(path), options,
                                    progress, header.warnings);
  std::vector<std::byte>().swap(pixels);  // before the voxels are handed over
  return {std::move(header), std::move(voxels), {}, {}, {}};
}

}  // namespace isolux::readers
