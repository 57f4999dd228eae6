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

constexpr std::size_t mostPages = std::size_t{1} << 20;
constexpr std::uint64_t mostEntries = 4096;

class Walk {
 public:
  Walk(const Bytes& bytes, const base::Progress& progress) : bytes_(bytes), progress_(progress) {
    const std::string head = bytes.head(16);
    if (!looksLikeTiff(head)) throwInput(bytes.name(), "byte 0", "is not a TIFF header");
    file_.bigEndian = head[0] == 'M';
    wide_ = number(2, 2) == 43;
    if (wide_ && number(4, 2) != 8) throwInput(bytes.name(), "byte 4", "is not a BigTIFF header");
  }

  TiffFile pages() {
    std::set<std::uint64_t> seen;
    std::uint64_t at = wide_ ? number(8, 8) : number(4, 4);
    for (int index = 0; at != 0; ++index) {
      if (!seen.insert(at).second)
        throwInput(bytes_.name(), "byte " + std::to_string(at), "the page directories run in a circle");
      if (seen.size() > mostPages)
        throwInput(bytes_.name(), "byte " + std::to_string(at),
                   "more than " + std::to_string(mostPages) + " pages");
      TiffPage page;
      page.index = index;
      page.directory = at;
      if (readPage(at, page)) file_.pages.push_back(page);
    }
    if (file_.pages.empty()) throwInput(bytes_.name(), "", "has no page");
    return std::move(file_);
  }

 private:
  struct Entry {
    std::uint64_t tag = 0, type = 0, count = 0;
    std::uint64_t at = 0;  // of its values
  };

  std::uint64_t number(std::uint64_t at, std::size_t width) const {
    std::byte raw[8] = {};
    const bool known = at >= directoryAt_ && at - directoryAt_ < directory_.size() &&
                       width <= directory_.size() - (at - directoryAt_);
    if (known)
      std::copy_n(directory_.begin() + static_cast<std::ptrdiff_t>(at - directoryAt_), width, raw);
    else
      bytes_.read(at, {raw, width});
    if (file_.bigEndian) std::reverse(raw, raw + width);
    std::uint64_t value = 0;
    std::memcpy(&value, raw, 8);
    return value;
  }

  // Bytes of a value: byte, text, short, long, ratio (two longs), signed byte, anything; double; long of 8
  // bytes.
  static std::size_t widthOf(std::uint64_t type) {
    static constexpr std::size_t widths[] = {0, 1, 1, 2, 4, 8, 1, 1, 0, 0, 0, 0, 8, 0, 0, 0, 8};
    return type < std::size(widths) ? widths[type] : 0;
  }

  Entry entryAt(std::uint64_t at) const {
    Entry entry{number(at, 2), number(at + 2, 2), number(at + 4, wide_ ? 8 : 4), at + (wide_ ? 12 : 8)};
    const std::uint64_t room = wide_ ? 8 : 4;
    const std::size_t width = widthOf(entry.type);
    if (width > 0 && entry.count > room / width) entry.at = number(entry.at, static_cast<std::size_t>(room));
    return entry;
  }

  // The first value of an entry of whole numbers.
  std::int64_t valueOf(const Entry& entry) const {
    const std::size_t width = widthOf(entry.type);
    if (width == 0 || entry.count == 0 || entry.type == 5 || entry.type == 12) return 0;
    return static_cast<std::int64_t>(
        std::min<std::uint64_t>(number(entry.at, width), std::uint64_t{1} << 40));
  }

  double ratioOf(const Entry& entry) const {
    if (entry.type != 5 || entry.count < 1) return 0.0;
    const std::uint64_t below = number(entry.at + 4, 4);
    return below == 0 ? 0.0 : static_cast<double>(number(entry.at, 4)) / static_cast<double>(below);
  }

  std::vector<std::byte> rawOf(const Entry& entry, std::uint64_t most) const {
    std::vector<std::byte> raw(static_cast<std::size_t>(std::min(entry.count, most)) * widthOf(entry.type));
    bytes_.read(entry.at, raw);
    return raw;
  }

  std::string textOf(const Entry& entry) const {
    constexpr std::uint64_t longest = std::uint64_t{64} << 20;
    if (entry.type != 2 || entry.count > std::min(longest, bytes_.size())) return {};
    const std::vector<std::byte> raw = rawOf(entry, longest);
    const std::string text(reinterpret_cast<const char*>(raw.data()), raw.size());
    return text.substr(0, text.find('\0'));
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
  std::vector<std::uint64_t> valuesOf(const Entry& entry, const std::string& place) {
    const std::size_t width =
        entry.type == 3 || entry.type == 4 || entry.type == 16 ? widthOf(entry.type) : 0;
    if (width == 0 || entry.count > bytes_.size() / width)
      throwInput(bytes_.name(), place, "truncated: its table of strips is longer than the file");
    spend(entry.count * width, place);
    std::vector<std::byte> raw = entry.count == 1 ? std::vector<std::byte>() : rawOf(entry, entry.count);
    if (entry.count == 1) return {number(entry.at, width)};
    if (file_.bigEndian) swapBytes(raw, width);
    std::vector<std::uint64_t> values;
    values.reserve(static_cast<std::size_t>(entry.count));
    for (std::size_t i = 0; i < raw.size(); i += width) {
      if (i % (std::size_t{1} << 20) == 0) progress_.throwIfStopped();
      std::uint64_t value = 0;
      std::memcpy(&value, raw.data() + i, width);
      values.push_back(value);
    }
    return values;
  }

  // Each strip or tile must lie in the file.
  void checkStrips(const Entry& offsets, const Entry& counts, TiffPage& page, const std::string& place) {
    if (offsets.tag == 0 || counts.tag == 0)
      throwInput(bytes_.name(), place, "does not state where its pixels are");
    const auto at = valuesOf(offsets, place), sizes = valuesOf(counts, place);
    if (at.size() != sizes.size()) throwInput(bytes_.name(), place, "its tables of strips disagree");
    if (at.empty()) throwInput(bytes_.name(), place, "does not state where its pixels are");
    page.pixels = at.front();
    page.contiguous = page.compression == 1 && offsets.tag == 273;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at[i] > bytes_.size() || sizes[i] > bytes_.size() - at[i])
        throwInput(bytes_.name(), place,
                   "truncated: strip " + std::to_string(i + 1) + " is beyond the end of the file");
      if (i > 0 && at[i] != at[i - 1] + sizes[i - 1]) page.contiguous = false;
    }
  }

  // Of the first page.
  void readStatement(const Entry& entry) {
    TiffStatements& says = file_.says;
    static const std::pair<std::uint64_t, const char*> unread[] = {
        {33550, "GeoTIFF"},     {33922, "GeoTIFF"},   {34264, "GeoTIFF"},
        {33560, "Olympus SIS"}, {34361, "FluoView"},  {34680, "FEI"},
        {34682, "FEI"},         {33628, "MetaMorph"}, {51123, "Micro-Manager"}};
    static constexpr std::pair<std::uint64_t, std::string TiffStatements::*> texts[] = {
        {270, &TiffStatements::description},
        {42112, &TiffStatements::gdalMetadata},
        {42113, &TiffStatements::noData}};
    for (const auto& [tag, text] : texts)
      if (tag == entry.tag) says.*text = textOf(entry);
    for (const auto& [tag, name] : unread)
      if (tag == entry.tag && (says.unreadRecords.empty() || says.unreadRecords.back() != name))
        says.unreadRecords.emplace_back(name);
    if (entry.tag == 282) says.xResolution = ratioOf(entry);
    if (entry.tag == 283) says.yResolution = ratioOf(entry);
    if (entry.tag == 296) says.resolutionUnit = static_cast<int>(std::min<std::int64_t>(valueOf(entry), 4));
    if (entry.tag == 33629)
      says.uicPlanes = static_cast<std::int64_t>(std::min<std::uint64_t>(entry.count, mostPages));
    if (entry.tag == 34412 && entry.count >= 64 && widthOf(entry.type) == 1) says.lsmInfo = rawOf(entry, 64);
  }

  void holdDirectory(std::uint64_t at, std::uint64_t bytes) {
    directory_.clear();
    directoryAt_ = at;
    std::vector<std::byte> held(static_cast<std::size_t>(bytes));
    bytes_.read(at, held);
    directory_ = std::move(held);
  }

  // Reads the directory at `at`, moves `at` to the next one; false for thumbnails and masks.
  bool readPage(std::uint64_t& at, TiffPage& page) {
    const std::string place = "page " + std::to_string(page.index + 1);
    const std::size_t entryBytes = wide_ ? 20 : 12;
    const std::uint64_t entries = number(at, wide_ ? 8 : 2);
    if (entries > mostEntries)
      throwInput(bytes_.name(), place, "has " + std::to_string(entries) + " entries");
    spend(entries * entryBytes, place);
    const std::uint64_t begin = at + (wide_ ? 8 : 2), end = begin + entries * entryBytes;
    holdDirectory(begin, end - begin + (wide_ ? 8 : 4));
    bool reduced = false;
    Entry offsets, counts;
    for (std::uint64_t from = begin; from < end; from += entryBytes) {
      static constexpr std::pair<std::uint64_t, std::int64_t TiffPage::*> numbers[] = {
          {256, &TiffPage::width},       {257, &TiffPage::height},      {258, &TiffPage::bits},
          {259, &TiffPage::compression}, {262, &TiffPage::photometric}, {274, &TiffPage::orientation},
          {277, &TiffPage::samples},     {339, &TiffPage::sampleFormat}};
      const Entry entry = entryAt(from);
      constexpr std::int64_t reducedOrMask = 1 | 4;
      reduced |= entry.tag == 254 && (valueOf(entry) & reducedOrMask) != 0;
      reduced |= entry.tag == 255 && valueOf(entry) == 2;
      if (entry.tag == 273 || entry.tag == 324) offsets = entry;
      if (entry.tag == 279 || entry.tag == 325) counts = entry;
      for (const auto& [tag, number] : numbers)
        if (entry.tag == tag) page.*number = valueOf(entry);
    }
    const std::uint64_t next = number(end, wide_ ? 8 : 4);
    if (!reduced) checkPage(page, offsets, counts, place);
    if (!reduced && file_.pages.empty())
      for (std::uint64_t entry = begin; entry < end; entry += entryBytes) readStatement(entryAt(entry));
    at = next;
    return !reduced;
  }

  void checkPage(TiffPage& page, const Entry& offsets, const Entry& counts, const std::string& place) {
    if (page.width < 1 || page.height < 1 || page.width > 65535 || page.height > 65535)
      throwInput(bytes_.name(), place,
                 "has " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                     " pixels; 1 to 65535 are read along each axis");
    if (page.samples < 1 || page.samples > 1000 || page.bits < 1 || page.bits > 128)
      throwInput(
          bytes_.name(), place,
          "has pixels of " + std::to_string(page.samples) + " x " + std::to_string(page.bits) + " bits");
    constexpr int jpeg = 7, yCbCr = 6, logL = 32844, logLuv = 32845;
    if (page.photometric == logL || page.photometric == logLuv ||
        (page.photometric == yCbCr && page.compression != jpeg))
      throwInput(bytes_.name(), place,
                 page.photometric == yCbCr ? "has YCbCr pixels, which are read from JPEG only"
                                           : "has LogLuv pixels, which are not read");
    const std::uint64_t claim = page.rawBytes();
    if (claim / bestRatio(page.compression) > bytes_.size())
      throwInput(bytes_.name(), place,
                 "truncated: " + std::to_string(claim) + " bytes are announced, the file has " +
                     std::to_string(bytes_.size()));
    checkStrips(offsets, counts, page, place);
    total_ += page.compression == 1 ? claim : 0;
    if (total_ > bytes_.size())
      throwInput(bytes_.name(), place,
                 "truncated: the pages announce more than the " + std::to_string(bytes_.size()) +
                     " bytes of the file");
  }

  static std::uint64_t bestRatio(std::int64_t compression) {
    if (compression == 1) return 1;       // none
    if (compression == 32773) return 64;  // PackBits
    if (compression == 5) return 4096;    // LZW
    return compression == 8 || compression == 32946 ? kBestDeflateRatio : 100000;
  }

  const Bytes& bytes_;
  const base::Progress& progress_;
  TiffFile file_;
  bool wide_ = false;
  std::uint64_t total_ = 0, spent_ = 0;
  std::vector<std::byte> directory_;  // that is being read
  std::uint64_t directoryAt_ = 0;
};

}  // namespace

bool looksLikeTiff(std::string_view head) {
  if (head.size() < 8) return false;
  const std::string_view mark = head.substr(0, 4);
  using namespace std::string_view_literals;
  return mark == "II*\0"sv || mark == "MM\0*"sv || mark == "II+\0"sv || mark == "MM\0+"sv;
}

TiffFile tiffPages(const Bytes& bytes, const base::Progress& progress) {
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
  std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return files;
}

}  // namespace isolux::volume
