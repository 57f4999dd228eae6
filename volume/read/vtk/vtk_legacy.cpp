#include "volume/read/vtk/vtk_legacy.h"

#include <cmath>
#include <optional>

#include "base/error.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::size_t longestLegacyHeader = std::size_t{1} << 20;  // up to the first array

std::optional<VoxelType> legacyTypeNamed(std::string_view name) {
  // "long" has the 8 bytes it had on the 64-bit machine that wrote it.
  static constexpr TypeName names[] = {{"char", VoxelType::int8},
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
  return typeNamed(names, name);
}

class Parser {
 public:
  explicit Parser(const Bytes& bytes)
      : file_(bytes.name()), text_(bytes.head(longestLegacyHeader)), lines_(text_) {}
  ImageHeader parse();

 private:
  using Words = std::vector<std::string_view>;

  int line() const { return linesBefore_ + lines_.number(); }
  std::size_t offset() const { return skipped_ + lines_.offset(); }  // of the byte after it
  std::string place() const { return linePlace(line(), keyword_); }
  // Goes on behind so many bytes of binary data.
  void skip(std::size_t bytes) {
    linesBefore_ = line();
    skipped_ = offset() + bytes;
    lines_ = Lines(std::string_view(text_).substr(skipped_));
  }
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
    if (!words) throwInput(file_, linePlace(line()), "truncated: " + what + " is missing");
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
    if (!value || *value < 1) fail(inQuotes(word) + " is not a number of values");
    return *value;
  }
  void readType(std::string_view name) {
    const auto type = legacyTypeNamed(name);
    if (!type) fail("the voxel type " + inQuotes(name) + " is not supported");
    header_.type = *type;
  }
  std::vector<double> numbers(std::uint64_t count, VoxelType type);
  void skipFields(const Words& words);
  void readCoordinates(int axis, const Words& words);
  void readStructure();
  void readAttributes();
  bool readArray(const Words& words);

  std::string file_, text_;
  Lines lines_;  // of the text behind `skipped_`
  std::size_t skipped_ = 0;
  int linesBefore_ = 0;
  std::string keyword_;
  ImageHeader header_;
  bool text8_ = false, rectilinear_ = false, hasDims_ = false, hasSpacing_ = false, cells_ = false;
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
      skipFields(words);
    } else if (rectilinear_ && key.size() == 13 && key.ends_with("_coordinates")) {
      readCoordinates(key[0] - 'x', words);
    } else if (key != "metadata" && key != "information" && key != "name" && key != "data") {
      fail("the keyword " + inQuotes(words[0]) + " is not known here");
    }
  }
}

// Numbers of a text or binary array at the end of the header so far. The header is read on behind them.
std::vector<double> Parser::numbers(std::uint64_t count, VoxelType type) {
  const std::size_t width = bytesOf(type), at = offset();
  if (count > text_.size()) fail("has more numbers than a header holds");
  std::vector<double> values;
  if (text8_) {
    while (values.size() < count) {
      const Words words = need("a number");
      for (const std::string_view word : words) {
        const auto value = realOf(word);
        if (!value) fail(inQuotes(word) + " is not a number");
        values.push_back(*value);
      }
    }
    if (values.size() > count) fail("has more numbers than it announces");
    return values;
  }
  if (text_.size() - at < count * width) fail("is longer than the 1 MiB of a header, or truncated");
  withType(type, [&]<class T>(T) {
    for (std::uint64_t i = 0; i < count; ++i)
      values.push_back(static_cast<double>(numberAt<T>(&text_[at + i * width], true)));
  });
  skip(static_cast<std::size_t>(count) * width);
  return values;
}

// TIME, CYCLE and the like, which VisIt and ParaView write there: nothing that a volume needs.
void Parser::skipFields(const Words& words) {
  if (words.size() != 3) fail("name and number of arrays are needed");
  const std::int64_t arrays = count(words[2]);
  for (std::int64_t i = 0; i < arrays; ++i) {
    const Words array = need("a field array");
    if (array.size() != 4) fail("name, components, tuples and type are needed");
    const std::int64_t components = count(array[1]), tuples = count(array[2]);
    if (components > 65536 || tuples > 65536) fail("has more numbers than a header holds");
    const auto type = legacyTypeNamed(array[3]);
    if (!type) fail("the type " + inQuotes(array[3]) + " is not supported before the data");
    numbers(static_cast<std::uint64_t>(components * tuples), *type);
  }
}

// One axis of a rectilinear grid, which is a volume where its steps are even.
void Parser::readCoordinates(int axis, const Words& words) {
  if (words.size() != 3) fail("number and type are needed");
  const std::int64_t n = count(words[1]);
  if (!hasDims_ || n != header_.dims[static_cast<std::size_t>(axis)]) fail("does not fit DIMENSIONS");
  const auto type = legacyTypeNamed(words[2]);
  if (!type) fail("the type " + inQuotes(words[2]) + " is not supported");
  const std::string keyword = keyword_;
  const std::vector<double> positions = numbers(static_cast<std::uint64_t>(n), *type);
  keyword_ = keyword;
  const double step = n > 1 ? (positions.back() - positions.front()) / static_cast<double>(n - 1) : 1.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(std::abs(positions[i] - positions[0] - static_cast<double>(i) * step) <= 1e-3 * std::abs(step)))
      fail("its steps are uneven; resample the grid (ParaView: Resample To Image) and save it as .vti");
  spacing_[axis] = step;
  origin_[axis] = positions[0];
  hasSpacing_ = true;
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
    header_.type = text8_ ? VoxelType::float32 : VoxelType::uint8;  // as text from 0 to 1
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
    throwInput(file_, "line 1", "is not a VTK header");
  lines_.next();  // the title
  const Words encoding = need("ASCII or BINARY");
  text8_ = sameIgnoringCase(encoding[0], "ascii");
  if (!text8_ && !sameIgnoringCase(encoding[0], "binary")) fail("is neither ASCII nor BINARY");
  Words dataset = need("DATASET");
  while (sameIgnoringCase(dataset[0], "field")) {  // written by some before the dataset
    skipFields(dataset);
    dataset = need("DATASET");
  }
  if (!sameIgnoringCase(dataset[0], "dataset") || dataset.size() != 2) fail("DATASET is expected here");
  const std::string kind = lowered(dataset[1]);
  rectilinear_ = kind == "rectilinear_grid";
  if (kind == "polydata") fail("is POLYDATA, a mesh; save it as .vtp, .ply or .stl");
  if (!rectilinear_ && kind != "structured_points")
    fail("a dataset of kind " + inQuotes(dataset[1]) +
         " is not a regular volume; resample it (ParaView: Resample To Image) and save it as .vti");
  readStructure();

  if (!hasSpacing_) header_.warnings.push_back("SPACING is missing; " + std::string(kSpacingAssumed));
  header_.worldFromVoxel = checkedGeometry(glm::dmat3(1.0), spacing_, origin_, file_, header_.warnings);
  if (cells_) {  // a value per cell: the samples are the centres of the cells
    header_.warnings.emplace_back(kValuesOfCells);
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
  header_.payload.offset = offset();
  header_.payload.encoding = text8_ ? Encoding::ascii : Encoding::raw;
  header_.payload.endianness = Endianness::big;
  header_.payload.moreMayFollow = true;  // other arrays, metadata
  return header_;
}

}  // namespace

ImageHeader parseVtkLegacyHeader(const Bytes& bytes) {
  return Parser(bytes).parse();
}

}  // namespace isolux::volume
