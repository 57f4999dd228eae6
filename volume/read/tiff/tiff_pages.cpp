// The walk over the page directories of a TIFF or BigTIFF file.
#include <algorithm>
#include <cstring>
#include <set>

#include "base/error.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/tiff/tiff_pages.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::size_t mostPages = 65535;
constexpr std::uint64_t mostEntries = 4096;

class Walk {
 public:
  Walk(const Bytes& bytes, const base::Progress& progress) : bytes_(bytes), progress_(progress) {
    const std::string head = bytes.head(16);
    if (!looksLikeTiff(head)) throwInput(bytes.name(), "byte 0", "is no TIFF header");
    swap_ = head[0] == 'M';
    wide_ = number(2, 2) == 43;
    if (wide_ && number(4, 2) != 8) throwInput(bytes.name(), "byte 4", "is no BigTIFF header");
  }

  std::vector<TiffPage> pages() {
    std::vector<TiffPage> pages;
    std::set<std::uint64_t> seen;
    std::uint64_t at = wide_ ? number(8, 8) : number(4, 4);
    for (int index = 0; at != 0; ++index) {
      if (!seen.insert(at).second)
        throwInput(bytes_.name(), "byte " + std::to_string(at), "the page directories run in a circle");
      if (seen.size() > mostPages)
        throwInput(bytes_.name(), "byte " + std::to_string(at), "more than 65535 pages");
      TiffPage page;
      page.index = index;
      if (readPage(at, page)) pages.push_back(page);
    }
    if (pages.empty()) throwInput(bytes_.name(), "", "has no page");
    return pages;
  }

 private:
  std::uint64_t number(std::uint64_t at, std::size_t width) const {
    std::byte raw[8] = {};
    bytes_.read(at, {raw, width});
    if (swap_) std::reverse(raw, raw + width);
    std::uint64_t value = 0;
    std::memcpy(&value, raw, 8);
    return value;
  }

  // The first value of an entry: 1, 2, 4 or 8 bytes wide by its type; values that do not fit are elsewhere.
  std::uint64_t valueOf(std::uint64_t entry) const {
    const std::uint64_t type = number(entry + 2, 2), count = number(entry + 4, wide_ ? 8 : 4);
    const std::size_t width = type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
    if (width == 0 || count == 0) return 0;
    const std::uint64_t field = entry + (wide_ ? 12 : 8), room = wide_ ? 8 : 4;
    const bool elsewhere = count > room / width;
    return number(elsewhere ? number(field, static_cast<std::size_t>(room)) : field, width);
  }

  // Directories and tables are looked at once each. Pages that share theirs would make the walk as long as
  // the file times the pages: four times the file is more than any writer needs. Short files may be read on
  // until what is missing is met.
  void spend(std::uint64_t bytes, const std::string& place) {
    progress_.throwIfStopped();
    spent_ += std::min(bytes, bytes_.size());  // what is longer is truncated: reading it will say so
    constexpr std::uint64_t little = std::uint64_t{1} << 20;
    if (spent_ > little && spent_ / 4 > bytes_.size())
      throwInput(bytes_.name(), place, "its directories and tables of strips lie over one another");
  }

  // The values of an entry; `place` names the page when there are too many.
  std::vector<std::uint64_t> valuesOf(std::uint64_t entry, const std::string& place) {
    const std::uint64_t type = number(entry + 2, 2), count = number(entry + 4, wide_ ? 8 : 4);
    const std::size_t width = type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
    if (width == 0 || count > bytes_.size() / width)
      throwInput(bytes_.name(), place, "truncated: its table of strips is longer than the file");
    spend(count * width, place);
    const std::uint64_t field = entry + (wide_ ? 12 : 8), room = wide_ ? 8 : 4;
    const std::uint64_t at = count > room / width ? number(field, static_cast<std::size_t>(room)) : field;
    std::vector<std::byte> raw(static_cast<std::size_t>(count) * width);
    bytes_.read(at, raw);
    std::vector<std::uint64_t> values;
    values.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < raw.size(); i += width) {
      if (i % (std::size_t{1} << 20) == 0) progress_.throwIfStopped();
      if (swap_)
        std::reverse(raw.begin() + static_cast<std::ptrdiff_t>(i),
                     raw.begin() + static_cast<std::ptrdiff_t>(i + width));
      std::uint64_t value = 0;
      std::memcpy(&value, raw.data() + i, width);
      values.push_back(value);
    }
    return values;
  }

  // Each strip or tile must lie in the file; OpenImageIO shows zeros for those that do not.
  void checkStrips(std::uint64_t offsets, std::uint64_t counts, const std::string& place) {
    if (offsets == 0 || counts == 0) throwInput(bytes_.name(), place, "does not say where its pixels are");
    const auto at = valuesOf(offsets, place), sizes = valuesOf(counts, place);
    if (at.size() != sizes.size()) throwInput(bytes_.name(), place, "its tables of strips disagree");
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] > bytes_.size() || sizes[i] > bytes_.size() - at[i])
        throwInput(bytes_.name(), place,
                   "truncated: strip " + std::to_string(i + 1) + " lies behind the end of the file");
  }

  // Reads the directory at `at`, moves `at` to the next one; false for thumbnails and masks.
  bool readPage(std::uint64_t& at, TiffPage& page) {
    const std::string place = "page " + std::to_string(page.index + 1);
    const std::size_t entryBytes = wide_ ? 20 : 12;
    const std::uint64_t entries = number(at, wide_ ? 8 : 2);
    if (entries > mostEntries)
      throwInput(bytes_.name(), place, "has " + std::to_string(entries) + " entries");
    spend(entries * entryBytes, place);
    std::uint64_t entry = at + (wide_ ? 8 : 2), compression = 1, kind = 0, offsets = 0, counts = 0;
    for (std::uint64_t i = 0; i < entries; ++i, entry += entryBytes) {
      const std::uint64_t tag = number(entry, 2);
      const auto value = [&] {
        return static_cast<std::int64_t>(std::min<std::uint64_t>(valueOf(entry), std::uint64_t{1} << 40));
      };
      switch (tag) {
        case 254:
          kind = valueOf(entry);
          break;
        case 256:
          page.width = value();
          break;
        case 257:
          page.height = value();
          break;
        case 258:
          page.bits = value();
          break;
        case 259:
          compression = valueOf(entry);
          break;
        case 273:
        case 324:
          offsets = entry;
          break;
        case 279:
        case 325:
          counts = entry;
          break;
        case 277:
          page.samples = value();
          break;
        default:
          break;
      }
    }
    at = number(entry, wide_ ? 8 : 4);
    constexpr std::uint64_t reducedOrMask = 1 | 4;
    if (kind & reducedOrMask) return false;
    if (page.width < 1 || page.height < 1 || page.width > 65535 || page.height > 65535)
      throwInput(bytes_.name(), place,
                 "has " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                     " pixels; 1 to 65535 are read along each axis");
    if (page.samples < 1 || page.samples > 1000 || page.bits < 1 || page.bits > 64)
      throwInput(
          bytes_.name(), place,
          "has pixels of " + std::to_string(page.samples) + " x " + std::to_string(page.bits) + " bits");
    const auto claim = static_cast<std::uint64_t>(page.width * page.height * page.samples * page.bits) / 8;
    if (claim / bestRatio(compression) > bytes_.size())
      throwInput(bytes_.name(), place,
                 "truncated: " + std::to_string(claim) + " bytes are announced, the file has " +
                     std::to_string(bytes_.size()));
    checkStrips(offsets, counts, place);
    total_ += compression == 1 ? claim : 0;
    if (total_ > bytes_.size())
      throwInput(bytes_.name(), place,
                 "truncated: the pages announce more than the " + std::to_string(bytes_.size()) +
                     " bytes of the file");
    return true;
  }

  static std::uint64_t bestRatio(std::uint64_t compression) {
    switch (compression) {
      case 1:
        return 1;  // none
      case 32773:
        return 64;  // PackBits
      case 8:
      case 32946:
        return kBestDeflateRatio;
      case 5:
        return 4096;  // LZW
      default:
        return 100000;
    }
  }

  const Bytes& bytes_;
  const base::Progress& progress_;
  bool swap_ = false, wide_ = false;
  std::uint64_t total_ = 0, spent_ = 0;
};

}  // namespace

bool looksLikeTiff(std::string_view head) {
  if (head.size() < 8) return false;
  const std::string_view mark = head.substr(0, 4);
  using namespace std::string_view_literals;
  return mark == "II*\0"sv || mark == "MM\0*"sv || mark == "II+\0"sv || mark == "MM\0+"sv;
}

std::vector<TiffPage> tiffPages(const Bytes& bytes, const base::Progress& progress) {
  return Walk(bytes, progress).pages();
}

bool naturalLess(std::string_view a, std::string_view b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      const auto run = [&](std::string_view text, std::size_t& at) {
        while (at < text.size() && text[at] == '0') ++at;
        const std::size_t begin = at;
        while (at < text.size() && digit(text[at])) ++at;
        return text.substr(begin, at - begin);
      };
      const std::string_view x = run(a, i), y = run(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  if ((i < a.size()) != (j < b.size())) return j < b.size();
  return a < b;  // "01" and "1": any fixed order
}

std::vector<fs::path> tiffFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string extension = lowered(entry.path().extension().string());
    std::error_code ignored;
    if ((extension == ".tif" || extension == ".tiff") && entry.is_regular_file(ignored))
      files.push_back(entry.path());
  }
  if (error) throwInput(folder.string(), "", "cannot be listed: " + error.message());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return files;
}

}  // namespace isolux::volume
