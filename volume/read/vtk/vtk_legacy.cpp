#include "volume/read/vtk/vtk_legacy.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/text.h"
#include "volume/read/length_doubt.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::size_t longestLegacyHeader = std::size_t{1} << 16;  // up to the first array

std::optional<VoxelType> legacyTypeNamed(std::string_view name) {
  struct Name {
    std::string_view name;
    VoxelType type;
  };
  // "long" has the 8 bytes it had on the 64-bit machine that wrote it.
  static constexpr Name names[] = {{"char", VoxelType::int8},
                                   {"signed_char", VoxelType::int8},
                                   {"unsigned_char", VoxelType::uint8},
                                   {"short", VoxelType::int16},
                                   {"unsigned_short", VoxelType::uint16},
                                   {"int", VoxelType::int32},
                                   {"unsigned_int", VoxelType::uint32},
                                   {"long", VoxelType::int64},
                                   {"unsigned_long", VoxelType::uint64},
                                   {"vtktypeint64", VoxelType::int64},
                                   {"vtktypeuint64", VoxelType::uint64},
                                   {"vtkidtype", VoxelType::int32},
                                   {"float", VoxelType::float32},
                                   {"double", VoxelType::float64}};
  for (const Name& entry : names)
    if (sameIgnoringCase(entry.name, name)) return entry.type;
  return std::nullopt;
}

class Parser {
 public:
  explicit Parser(const Bytes& bytes)
      : file_(bytes.name()), text_(bytes.head(longestLegacyHeader)), lines_(text_) {}
  ImageHeader parse();

 private:
  using Words = std::vector<std::string_view>;

  std::string place() const { return linePlace(lines_.number(), keyword_); }
  [[noreturn]] void fail(const std::string& reason) const { throwInput(file_, place(), reason); }

  // The words of the next line that has any.
  std::optional<Words> next() {
    while (const auto line = lines_.next()) {
      Words words = wordsOf(*line);
      if (words.empty()) continue;
      keyword_ = words[0].substr(0, 20);
      return words;
    }
    return std::nullopt;
  }
  Words need(const std::string& what) {
    auto words = next();
    if (!words) throwInput(file_, linePlace(lines_.number()), "truncated: " + what + " is missing");
    return *words;
  }
  glm::dvec3 threeReals(const Words& words) const {
    glm::dvec3 result(0.0);
    if (words.size() != 4) fail("three numbers are needed");
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = realOf(words[i + 1]);
      if (!value) fail(inQuotes(words[i + 1]) + " is not a number");
      result[static_cast<int>(i)] = *value;
    }
    return result;
  }
  std::int64_t count(std::string_view word) const {
    const auto value = integerOf(word);
    if (!value || *value < 1) fail(inQuotes(word) + " is no number of values");
    return *value;
  }
  void readType(std::string_view name) {
    const auto type = legacyTypeNamed(name);
    if (!type) fail("the voxel type " + inQuotes(name) + " is not supported");
    header_.type = *type;
  }
  void readStructure();
  void readAttributes();
  bool readArray(const Words& words);

  std::string file_, text_;
  Lines lines_;
  std::string keyword_;
  ImageHeader header_;
  bool text8_ = false, hasDims_ = false, hasSpacing_ = false, cells_ = false;
  glm::dvec3 spacing_{1.0}, origin_{0.0};
  std::int64_t tuples_ = 0;
};

// DATASET, DIMENSIONS, SPACING, ORIGIN up to POINT_DATA or CELL_DATA.
void Parser::readStructure() {
  for (;;) {
    const Words words = need("POINT_DATA");
    const std::string key = lowered(words[0]);
    if (key == "dimensions") {
      if (words.size() != 4) fail("three sizes are needed");
      for (std::size_t i = 0; i < 3; ++i) {
        const auto n = integerOf(words[i + 1]);
        if (!n) fail(inQuotes(words[i + 1]) + " is not a whole number");
        header_.dims[i] = *n;
      }
      checkDims(header_, file_, place());
      hasDims_ = true;
    } else if (key == "spacing" || key == "aspect_ratio") {
      spacing_ = threeReals(words);
      hasSpacing_ = true;
    } else if (key == "origin") {
      origin_ = threeReals(words);
    } else if (key == "point_data" || key == "cell_data") {
      if (words.size() != 2) fail("one number is needed");
      if (!hasDims_) fail("DIMENSIONS must come before");
      tuples_ = count(words[1]);
      cells_ = key == "cell_data";
      return;
    } else if (key == "field") {
      fail("field data before the dimensions are not supported");
    } else if (key != "metadata" && key != "information" && key != "name" && key != "data") {
      fail("the keyword " + inQuotes(words[0]) + " is not known here");
    }
  }
}

// True when `words` start an array; then the rest of its header is read, too.
bool Parser::readArray(const Words& words) {
  const std::string key = lowered(words[0]);
  if (key == "scalars") {
    if (words.size() < 3 || words.size() > 4) fail("name and type are needed");
    readType(words[2]);
    if (words.size() == 4) header_.components = count(words[3]);
    const Words table = need("LOOKUP_TABLE");
    if (!sameIgnoringCase(table[0], "lookup_table")) fail("LOOKUP_TABLE must follow SCALARS");
    return true;
  }
  if (key == "vectors" || key == "normals") {
    if (words.size() != 3) fail("name and type are needed");
    readType(words[2]);
    header_.components = 3;
    return true;
  }
  if (key == "color_scalars") {
    if (words.size() != 3) fail("name and number of components are needed");
    header_.components = count(words[2]);
    if (text8_) fail("colours as text are not supported");
    header_.type = VoxelType::uint8;
    return true;
  }
  if (key == "field") {
    const Words array = need("a field array");
    if (array.size() != 4) fail("name, components, tuples and type are needed");
    header_.components = count(array[1]);
    if (count(array[2]) != tuples_)
      fail("has " + std::string(array[2]) + " tuples for " + std::to_string(tuples_) + " points");
    readType(array[3]);
    return true;
  }
  return false;
}

void Parser::readAttributes() {
  bool skipping = false;
  for (;;) {
    const Words words = need("an array");
    const std::string key = lowered(words[0]);
    if (key == "metadata") {
      skipping = true;  // up to the next array
      continue;
    }
    if (readArray(words)) return;
    if (!skipping) fail("the attribute " + inQuotes(words[0]) + " is not supported");
  }
}

ImageHeader Parser::parse() {
  header_.format = "VTK legacy";
  const auto magic = lines_.next();
  if (!magic || !magic->starts_with("# vtk DataFile Version"))
    throwInput(file_, "line 1", "is no VTK header");
  lines_.next();  // the title
  const Words encoding = need("ASCII or BINARY");
  text8_ = sameIgnoringCase(encoding[0], "ascii");
  if (!text8_ && !sameIgnoringCase(encoding[0], "binary")) fail("is neither ASCII nor BINARY");
  const Words dataset = need("DATASET");
  if (!sameIgnoringCase(dataset[0], "dataset") || dataset.size() != 2) fail("DATASET is expected here");
  if (!sameIgnoringCase(dataset[1], "structured_points"))
    fail("a dataset of kind " + inQuotes(dataset[1]) +
         " is no regular volume; only STRUCTURED_POINTS is read");
  readStructure();

  glm::dvec3 origin = origin_;
  if (!hasSpacing_) header_.warnings.push_back("SPACING is missing; " + std::string(kSpacingAssumed));
  header_.worldFromVoxel = checkedGeometry(glm::dmat3(1.0), spacing_, origin, file_, header_.warnings);
  if (cells_) {  // a value per cell: the samples are the centres of the cells
    header_.warnings.push_back(
        "the file has values of cells, not of points; each is taken at its cell's centre");
    for (int axis = 0; axis < 3; ++axis) {
      auto& n = header_.dims[static_cast<std::size_t>(axis)];
      if (n < 2) continue;
      --n;
      header_.worldFromVoxel[3] += header_.worldFromVoxel[axis] * 0.5;
    }
  }
  if (static_cast<std::uint64_t>(tuples_) != header_.voxels())
    fail("has " + std::to_string(tuples_) + " values for " + std::to_string(header_.voxels()) +
         (cells_ ? " cells" : " points"));
  readAttributes();
  checkDims(header_, file_, place());
  header_.payload.offset = lines_.offset();
  header_.payload.encoding = text8_ ? Encoding::ascii : Encoding::raw;
  header_.payload.endianness = Endianness::big;
  header_.payload.moreMayFollow = true;  // other arrays, metadata
  return header_;
}

}  // namespace

ImageHeader parseVtkLegacyHeader(const Bytes& bytes) {
  return Parser(bytes).parse();
}

Volume readVtkLegacy(const std::filesystem::path& path, const ReadOptions& options,
                     base::Progress& progress) {
  const FileBytes bytes(path);
  return volumeFrom(parseVtkLegacyHeader(bytes), bytes, openBeside(path), options, progress);
}

}  // namespace isolux::volume
