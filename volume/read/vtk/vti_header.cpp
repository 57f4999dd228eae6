// The check that stands before VTK's reader: tags, extents, and the size of the chosen array.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "base/error.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"
#include "volume/read/vtk/vti.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::size_t firstPiece = std::size_t{1} << 20;  // most files have their tags in it

std::optional<VoxelType> vtiType(std::string_view name) {
  static constexpr std::string_view names[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                               "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  for (int type = 0; type < 10; ++type)
    if (names[type] == name) return static_cast<VoxelType>(type);
  return std::nullopt;
}

// How the arrays of the file are written.
struct Layout {
  bool big = false, header64 = false;
  std::string compressor;  // empty: none
  bool hasAppended = false, appendedBase64 = false;
  std::size_t appendedAt = 0;  // of the byte after '_'
};

struct Array {
  Tag tag;
  std::string name, type;
  bool cells = false;
};

class Check {
 public:
  Check(const Bytes& bytes, const ReadOptions& options) : bytes_(bytes), file_(bytes.name()) {
    load(options);
  }
  VtiHeader run();

 private:
  void load(const ReadOptions& options);
  void cutAppended(std::size_t appended);
  void checkText(std::size_t begin) const;
  std::array<std::int64_t, 6> extentOf(const Tag& tag, std::string_view key) const;
  glm::dvec3 threeReals(const Tag& tag, std::string_view key, double otherwise) const;
  void refuseType(const std::string& type);
  [[noreturn]] void refuseParallel() const;
  void readImageTag(const Tag& tag);
  void readTag(const Tag& tag);
  const Array& chosenArray();
  void placeVoxels();
  void checkSize(const Array& array);
  void checkBinary(std::uint64_t begin, std::uint64_t end, bool base64);
  std::string bytesAt(std::uint64_t begin, std::uint64_t end, bool base64, std::uint64_t skip,
                      std::size_t count) const;
  std::uint64_t number(const std::string& text, std::size_t index) const;

  const Bytes& bytes_;
  std::string file_;
  std::string text_;
  Layout layout_;
  VtiHeader header_;
  bool parallel_ = false;             // of a .pvti
  std::vector<std::string> sources_;  // of its pieces
  bool hasFile_ = false, hasImage_ = false, hasPiece_ = false;
  std::string_view section_;  // PointData or CellData, while in it
  std::string wanted_[2];     // of points, of cells
  std::vector<Array> arrays_;
  glm::dvec3 spacing_{1.0}, origin_{0.0};
  glm::dmat3 directions_{1.0};
  std::array<std::int64_t, 6> whole_{};
};

// The tags: all before the appended data, which may be rubbish to a parser; else the whole file, piece by
// piece: what is no text is found before all of it is read.
void Check::load(const ReadOptions& options) {
  constexpr std::string_view tag = "<AppendedData";
  for (std::size_t have = 0;;) {
    const std::size_t rest = static_cast<std::size_t>(bytes_.size()) - have;
    text_.resize(have + std::min(rest, have == 0 ? firstPiece : std::size_t{64} << 20));
    bytes_.read(have, std::as_writable_bytes(std::span(text_)).subspan(have));
    const std::size_t appended = text_.find(tag, have - std::min(have, tag.size()));
    if (appended != std::string::npos) return cutAppended(appended);
    checkText(have);
    have = text_.size();
    if (have == bytes_.size()) return;
    checkBudget(bytes_.size(), "the file", "", file_, options);
  }
}

void Check::cutAppended(std::size_t appended) {
  std::size_t mark = text_.find('_', appended);
  if (mark == std::string::npos && text_.size() < bytes_.size()) {  // the tag itself is cut
    constexpr std::size_t longestTag = 4096;
    text_.resize(appended);
    text_ += bytes_.text(appended, longestTag);
    mark = text_.find('_', appended);
  }
  if (mark == std::string::npos) throwInput(file_, "AppendedData", "truncated: the data do not start");
  layout_.hasAppended = true;
  layout_.appendedAt = mark + 1;
  text_.resize(mark);
}

void Check::checkText(std::size_t begin) const {
  const std::size_t zero = text_.find('\0', begin);
  if (zero != std::string::npos)
    throwInput(file_, "byte " + std::to_string(zero), "is a zero byte, which XML does not have");
}

std::array<std::int64_t, 6> Check::extentOf(const Tag& tag, std::string_view key) const {
  const std::string place = std::string(tag.name) + " " + std::string(key);
  const auto text = tag.find(key);
  if (!text) throwInput(file_, place, "is missing");
  const auto values = integersOf(*text);
  if (!values || values->size() != 6) throwInput(file_, place, inQuotes(*text) + " is not six whole numbers");
  std::array<std::int64_t, 6> extent{};
  for (std::size_t i = 0; i < 6; ++i) {
    extent[i] = (*values)[i];
    if (std::abs(static_cast<double>(extent[i])) > 2147483647.0) throwInput(file_, place, "is out of range");
  }
  for (std::size_t a = 0; a < 3; ++a)
    if (extent[2 * a + 1] < extent[2 * a]) throwInput(file_, place, "is empty or negative along an axis");
  return extent;
}

glm::dvec3 Check::threeReals(const Tag& tag, std::string_view key, double otherwise) const {
  const auto text = tag.find(key);
  if (!text) return glm::dvec3(otherwise);
  const auto values = realsOf(*text);
  if (!values || values->size() != 3)
    throwInput(file_, "ImageData " + std::string(key), inQuotes(*text) + " is not three numbers");
  return {(*values)[0], (*values)[1], (*values)[2]};
}

void Check::readImageTag(const Tag& tag) {
  whole_ = extentOf(tag, "WholeExtent");
  for (std::size_t a = 0; a < 3; ++a) header_.image.dims[a] = whole_[2 * a + 1] - whole_[2 * a] + 1;
  checkDims(header_.image, file_, "ImageData WholeExtent");
  spacing_ = threeReals(tag, "Spacing", 1.0);
  origin_ = threeReals(tag, "Origin", 0.0);
  if (const auto text = tag.find("Direction")) {
    const auto values = realsOf(*text);
    if (!values || values->size() != 9)
      throwInput(file_, "ImageData Direction", inQuotes(*text) + " is not nine numbers");
    auto value = values->begin();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) directions_[column][row] = *value++;
  }
}

void Check::refuseType(const std::string& type) {
  if (type == "PImageData") {
    parallel_ = true;
  } else if (type.ends_with("PolyData")) {
    throwInput(file_, "VTKFile type", "is " + type + ", a mesh; save it as one .vtp file");
  } else {
    throwInput(
        file_, "VTKFile type",
        (type.empty() ? "is missing" : "is " + inQuotes(type)) +
            "; of volumes ImageData is read: resample it (ParaView: Resample To Image) and save it as .vti");
  }
}

// A .pvti has no voxels: it names the files that do.
void Check::refuseParallel() const {
  if (sources_.empty())
    throwInput(file_, "Piece Source", "is missing: a .pvti names the files of its voxels");
  std::string files;
  for (std::size_t i = 0; i < std::min<std::size_t>(sources_.size(), 3); ++i)
    files += (i > 0 ? ", " : "") + sources_[i];
  if (sources_.size() == 1)
    throwInput(file_, "Piece Source", "the voxels are in " + inQuotes(files) + ": open that file");
  throwInput(file_, "Piece Source",
             "the voxels are in " + std::to_string(sources_.size()) + " files (" + files +
                 (sources_.size() > 3 ? ", ..." : "") + "); write them as one .vti, or open one of them");
}

void Check::readTag(const Tag& tag) {
  const auto text = [&](std::string_view key) { return std::string(tag.find(key).value_or("")); };
  if (tag.name == "DataArray" || tag.name == "Array") checkArrayClaims(tag, bytes_);
  if (tag.name == "VTKFile") {
    if (const std::string type = text("type"); type != "ImageData") refuseType(type);
    layout_.big = text("byte_order") == "BigEndian";
    layout_.header64 = text("header_type") == "UInt64";
    if (const auto compressor = tag.find("compressor")) layout_.compressor = *compressor;
    hasFile_ = true;
  } else if (tag.name == "Piece" && parallel_) {
    sources_.push_back(text("Source"));
  } else if (tag.name == "ImageData") {
    readImageTag(tag);
    hasImage_ = true;
  } else if (tag.name == "Piece") {
    if (!hasImage_) throwInput(file_, "Piece", "is outside of ImageData");
    if (hasPiece_)
      throwInput(file_, "Piece",
                 "the image is cut into several pieces; write it in one (ParaView: save the data as .vti)");
    if (extentOf(tag, "Extent") != whole_) throwInput(file_, "Piece Extent", "is not the whole extent");
    hasPiece_ = true;
  } else if (tag.name == "PointData" || tag.name == "CellData") {
    section_ = tag.name;
    if (const auto scalars = tag.find("Scalars")) wanted_[section_ == "CellData"] = *scalars;
  } else if (tag.name == "/PointData" || tag.name == "/CellData") {
    section_ = {};
  } else if (tag.name == "DataArray" && hasPiece_ && !section_.empty()) {
    arrays_.push_back({tag, text("Name"), text("type"), section_ == "CellData"});
    if (arrays_.size() > 10000) throwInput(file_, "DataArray", "the file has more than 10000 arrays");
  } else if (tag.name == "AppendedData") {
    const auto encoding = tag.find("encoding");
    layout_.appendedBase64 = !encoding || *encoding == "base64";
  }
}

const Array& Check::chosenArray() {
  const Array* chosen = nullptr;
  for (const bool cells : {false, true})
    for (const bool named : {true, false})
      for (const Array& array : arrays_) {
        const bool fits =
            array.cells == cells && !array.name.empty() && (!named || array.name == wanted_[cells]);
        if (!chosen && fits) chosen = &array;
      }
  if (!chosen) throwInput(file_, "PointData", "has no named array");
  header_.array = chosen->name;
  header_.cells = chosen->cells;
  if (std::ranges::count_if(arrays_, [&](const Array& array) { return array.cells == chosen->cells; }) > 1)
    header_.image.warnings.push_back("the file has several arrays; " + inQuotes(header_.array) + " is shown");
  const auto voxelType = vtiType(chosen->type);
  if (!voxelType)
    throwInput(file_, "DataArray type", "the voxel type " + inQuotes(chosen->type) + " is not supported");
  header_.image.type = *voxelType;
  if (const auto components = chosen->tag.find("NumberOfComponents")) {
    const auto n = integerOf(*components);
    if (!n || *n < 1)
      throwInput(file_, "DataArray NumberOfComponents",
                 inQuotes(*components) + " is not a number of components");
    header_.image.components = *n;
  }
  return *chosen;
}

void Check::placeVoxels() {
  ImageHeader& image = header_.image;
  image.worldFromVoxel = checkedGeometry(directions_, spacing_, origin_, file_, image.warnings);
  glm::dvec3 first(static_cast<double>(whole_[0]), static_cast<double>(whole_[2]),
                   static_cast<double>(whole_[4]));
  if (header_.cells) {
    image.warnings.emplace_back(kValuesOfCells);
    for (std::size_t a = 0; a < 3; ++a) {
      if (image.dims[a] < 2)
        throwInput(file_, "CellData", "a volume of cells needs at least 2 points along each axis");
      --image.dims[a];
      first[static_cast<int>(a)] += 0.5;
    }
  }
  image.worldFromVoxel[3] = image.worldFromVoxel * glm::dvec4(first, 1.0);
  if (!usableAffine(image.worldFromVoxel)) throwInput(file_, "ImageData Origin", "is more than 1e12 mm away");
  checkDims(image, file_, "ImageData WholeExtent");
}

VtiHeader Check::run() {
  header_.image.format = "VTK XML";
  Tags tags(text_, file_);
  while (const auto tag = tags.next()) readTag(*tag);
  if (!hasFile_) throwInput(file_, "VTKFile", "is missing");
  if (parallel_) refuseParallel();
  if (!hasImage_) throwInput(file_, "ImageData", "is missing");
  if (!hasPiece_) throwInput(file_, "Piece", "is missing");
  const Array& chosen = chosenArray();
  placeVoxels();
  checkSize(chosen);
  return header_;
}

// Does the file hold what the array claims?
void Check::checkSize(const Array& array) {
  const auto format = array.tag.find("format");
  if (!format) throwInput(file_, "DataArray format", "is missing");
  const std::uint64_t elements = header_.image.elements();
  if (*format == "appended") {
    if (!layout_.hasAppended) throwInput(file_, "AppendedData", "truncated: is missing");
    const auto text = array.tag.find("offset");
    const auto offset = text ? integerOf(*text) : std::nullopt;
    if (!offset || *offset < 0)
      throwInput(file_, "DataArray offset", "is not a position in the appended data");
    const std::uint64_t begin = layout_.appendedAt + static_cast<std::uint64_t>(*offset);
    if (begin >= bytes_.size())
      throwInput(file_, "DataArray offset",
                 "truncated: beyond the end of the file (" + std::to_string(bytes_.size()) + " bytes)");
    checkBinary(begin, bytes_.size(), layout_.appendedBase64);
    return;
  }
  const std::size_t close = text_.find("</DataArray", array.tag.end);
  if (close == std::string::npos)
    throwInput(file_, "DataArray " + header_.array, "truncated: the array is not closed");
  std::uint64_t begin = array.tag.end;
  if (*format == "ascii") {
    std::uint64_t count = 0;
    bool inWord = false;
    for (std::size_t i = array.tag.end; i < close; ++i) {
      const bool space = text_[i] == ' ' || text_[i] == '\n' || text_[i] == '\t' || text_[i] == '\r';
      if (!space && !inWord) ++count;
      inWord = !space;
    }
    if (count != elements)
      throwInput(file_, "DataArray " + header_.array,
                 std::string(count < elements ? "truncated: " : "") + "has " + std::to_string(count) +
                     " numbers, the extent needs " + std::to_string(elements));
  } else if (*format == "binary") {
    while (begin < close && std::strchr(" \t\r\n", text_[static_cast<std::size_t>(begin)])) ++begin;
    checkBinary(begin, close, true);
  } else {
    throwInput(file_, "DataArray format", inQuotes(*format) + " is not known");
  }
}

// `count` decoded bytes behind `skip` decoded bytes of what starts at `begin`; shorter at the end.
std::string Check::bytesAt(std::uint64_t begin, std::uint64_t end, bool base64, std::uint64_t skip,
                           std::size_t count) const {
  const std::uint64_t first = base64 ? begin + skip / 3 * 4 : begin + skip;
  if (first >= end) return {};
  const std::uint64_t wanted = base64 ? (skip % 3 + count + 2) / 3 * 4 : count;
  const std::string text = bytes_.text(first, static_cast<std::size_t>(std::min(wanted, end - first)));
  if (!base64) return text;
  std::string_view rest = text;
  const std::string decoded = decodedBase64(rest);
  const auto drop = static_cast<std::size_t>(skip % 3);
  return decoded.size() <= drop ? std::string() : decoded.substr(drop, count);
}

std::uint64_t Check::number(const std::string& text, std::size_t index) const {
  const std::size_t width = layout_.header64 ? 8 : 4;
  if (text.size() < (index + 1) * width)
    throwInput(file_, "DataArray " + header_.array, "truncated: the size of the data is missing");
  const char* const at = &text[index * width];
  return layout_.header64 ? numberAt<std::uint64_t>(at, layout_.big)
                          : numberAt<std::uint32_t>(at, layout_.big);
}

void Check::checkBinary(std::uint64_t begin, std::uint64_t end, bool base64) {
  const std::string place = "DataArray " + header_.array;
  const std::uint64_t claim = header_.image.elements() * bytesOf(header_.image.type);
  const std::size_t width = layout_.header64 ? 8 : 4;
  const std::uint64_t held = base64 ? (end - begin) / 4 * 3 : end - begin;  // decoded
  const auto differs = [&](std::uint64_t stated) {
    throwInput(
        file_, place,
        "the data have " + std::to_string(stated) + " bytes, the extent needs " + std::to_string(claim));
  };
  const auto truncated = [&] {
    throwInput(
        file_, place,
        "truncated: " + std::to_string(claim) + " bytes of voxels are announced, the file is too short");
  };
  if (layout_.compressor.empty()) {
    const std::uint64_t stated = number(bytesAt(begin, end, base64, 0, width), 0);
    if (stated != claim) differs(stated);
    if (held < width || claim > held - width) truncated();
    if (base64) return;
    header_.plain.emplace();
    header_.plain->offset = begin + width;
    header_.plain->moreMayFollow = true;
    header_.plain->endianness = layout_.big ? Endianness::big : Endianness::little;
    return;
  }
  // Compressed: number of blocks, bytes of a block, bytes of a last shorter block (0: none), compressed
  // sizes.
  const std::string first = bytesAt(begin, end, base64, 0, 3 * width);
  const std::uint64_t blocks = number(first, 0), size = number(first, 1), rest = number(first, 2);
  if (blocks == 0 || blocks > claim || size == 0 || size > claim + 65536 || rest >= size + (rest == 0) ||
      blocks > held / width)
    throwInput(file_, place, "the table of compressed blocks makes no sense");
  std::uint64_t stated = 0;
  if (__builtin_mul_overflow(blocks - (rest > 0 ? 1 : 0), size, &stated) ||
      __builtin_add_overflow(stated, rest, &stated) || stated != claim)
    differs(stated);
  std::uint64_t compressed = 0;
  const std::size_t tableBytes = static_cast<std::size_t>(3 + blocks) * width;
  const std::string table = bytesAt(begin, end, base64, 0, tableBytes);
  const std::uint64_t bestRatio = layout_.compressor == "vtkZLibDataCompressor"  ? kBestDeflateRatio
                                  : layout_.compressor == "vtkLZ4DataCompressor" ? 260
                                                                                 : 100000;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t bytes = number(table, static_cast<std::size_t>(3 + block));
    const std::uint64_t content = block + 1 == blocks && rest > 0 ? rest : size;
    if (content / bestRatio > bytes || __builtin_add_overflow(compressed, bytes, &compressed))
      throwInput(file_, place, "the table of compressed blocks makes no sense");
  }
  const std::uint64_t behind = base64 ? (tableBytes + 2) / 3 * 3 : tableBytes;
  if (behind > held || compressed > held - behind) truncated();
}

}  // namespace

VtiHeader parseVtiHeader(const Bytes& bytes, const ReadOptions& options) {
  return Check(bytes, options).run();
}

}  // namespace isolux::volume
