#include "volume/read/plain/meta_image.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "volume/read/input/length_unit.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::size_t mostFiles = 65535;

// The fields by lower-case key, and where the header ends.
class Fields : public HeaderFields {
 public:
  Fields(std::string_view text, const std::string& file) : HeaderFields(file) {
    Lines lines(text);
    while (const auto line = lines.next()) {
      const std::string_view content = trimmed(*line);
      if (content.empty()) continue;
      const std::size_t equals = content.find('=');
      if (equals == std::string_view::npos)
        throwInput(file_, linePlace(lines.number()), "is not a \"Key = Value\" line");
      const HeaderField field{trimmed(content.substr(0, equals)), trimmed(content.substr(equals + 1)),
                              lines.number()};
      const std::string key = lowered(field.name);
      if (key.starts_with("seq_frame")) {  // several of each frame of a tracked sequence
        isSequence_ = true;
        continue;
      }
      if (key != "comment" || !find({key})) add(key, field, "keys");
      if (key == "elementdatafile") {  // by definition the last key
        end_ = lines.offset();
        return;
      }
    }
    throwInput(file_, "ElementDataFile", "is missing");
  }

  std::size_t end() const { return end_; }
  bool isSequence() const { return isSequence_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const HeaderField* find(std::initializer_list<std::string_view> keys) const {
    for (std::string_view key : keys)
      if (const HeaderField* field = HeaderFields::find(key)) return field;
    return nullptr;
  }
  // At least so many: 2D images often have the numbers of three axes.
  std::vector<double> reals(const HeaderField& field, std::size_t count) const {
    const auto values = realsOf(field.value);
    if (!values) throwInput(file_, field.place(), inQuotes(field.value) + " is not a list of numbers");
    if (values->size() < count || (values->size() > count && values->size() > 3))
      throwInput(
          file_, field.place(),
          std::to_string(count) + " numbers are needed, " + std::to_string(values->size()) + " are given");
    return *values;
  }
  // A square matrix of at least so many rows; its rows.
  std::size_t matrix(const HeaderField& field, std::size_t axes, std::vector<double>& values) const {
    const auto numbers = realsOf(field.value);
    if (!numbers) throwInput(file_, field.place(), inQuotes(field.value) + " is not a list of numbers");
    const std::size_t rows = axes == 2 && numbers->size() == 9 ? 3 : axes;
    if (numbers->size() != rows * rows)
      throwInput(file_, field.place(),
                 std::to_string(axes * axes) + " numbers are needed, " + std::to_string(numbers->size()) +
                     " are given");
    values = *numbers;
    return rows;
  }
  bool flag(const HeaderField* field, bool otherwise) const {
    if (!field) return otherwise;
    for (std::string_view yes : {"true", "1", "t", "yes"})
      if (sameIgnoringCase(field->value, yes)) return true;
    for (std::string_view no : {"false", "0", "f", "no"})
      if (sameIgnoringCase(field->value, no)) return false;
    throwInput(file_, field->place(), inQuotes(field->value) + " is neither True nor False");
  }

 private:
  std::size_t end_ = 0;
  bool isSequence_ = false;
};

std::optional<VoxelType> metaImageType(std::string_view name) {
  // MET_LONG has 4 bytes whatever the machine, MET_LONG_LONG 8.
  static constexpr TypeName names[] = {
      {"MET_CHAR", VoxelType::int8},         {"MET_UCHAR", VoxelType::uint8},
      {"MET_ASCII_CHAR", VoxelType::int8},   {"MET_SHORT", VoxelType::int16},
      {"MET_USHORT", VoxelType::uint16},     {"MET_INT", VoxelType::int32},
      {"MET_UINT", VoxelType::uint32},       {"MET_LONG", VoxelType::int32},
      {"MET_ULONG", VoxelType::uint32},      {"MET_LONG_LONG", VoxelType::int64},
      {"MET_ULONG_LONG", VoxelType::uint64}, {"MET_FLOAT", VoxelType::float32},
      {"MET_DOUBLE", VoxelType::float64}};
  return typeNamed(names, name);
}

// TransformMatrix alone says nothing of a patient: programs write it for any image. AnatomicalOrientation
// does ("???" where nobody knows). ITK and what builds on it take the matrix as LPS and write the letters of
// the ends the axes come from ("RAI" for the identity); MetaIO's own manual has them the other way, as the
// ends they run to. Either is believed where it agrees with the matrix; letters that do not are no statement.
scene::WorldAxes axesOf(const HeaderField& orientation, const glm::dmat3& directions,
                        std::vector<std::string>& warnings) {
  const std::string letters(orientation.value);
  if (letters.find('?') != std::string::npos || letters.size() < 3 || !usableDirections(directions))
    return scene::WorldAxes::zUp;
  bool runsTo = true, comesFrom = true;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string letter = letters.substr(static_cast<std::size_t>(axis), 1);
    runsTo &= sameIgnoringCase(letter, axisEnd(scene::WorldAxes::anatomical, directions[axis]));
    comesFrom &= sameIgnoringCase(letter, axisEnd(scene::WorldAxes::anatomical, -directions[axis]));
  }
  if (runsTo || comesFrom) return scene::WorldAxes::anatomical;
  warnings.push_back("AnatomicalOrientation " + inQuotes(letters) +
                     " and TransformMatrix do not agree; left and right are not certain");
  return scene::WorldAxes::zUp;
}

// Three names for one thing, of which the first counts; `what`: their common name.
const HeaderField* oneOf(const Fields& fields, std::initializer_list<std::string_view> keys, const char* what,
                         std::vector<std::string>& warnings) {
  const HeaderField* const first = fields.find(keys);
  for (std::string_view key : keys)
    if (const HeaderField* other = fields.find({key});
        first && other && realsOf(other->value) != realsOf(first->value))
      warnings.push_back(std::string(first->name) + " and " + std::string(other->name) + " state different " +
                         what + "; " + std::string(first->name) + " is taken");
  return first;
}

void readGeometry(const Fields& fields, std::size_t axes, const std::string& file, ImageHeader& header) {
  glm::dvec3 spacing(1.0), origin(0.0);
  glm::dmat3 directions(1.0);
  double mm = 1.0;
  const HeaderField* const unit = fields.find({"distanceunits"});
  if (unit && unit->value != "?" && !unit->value.empty())
    mm = millimetresOr1(unit->value, unit->name, header.warnings);
  const auto firstOf = [&](const HeaderField& field, glm::dvec3& numbers) {
    const auto values = fields.reals(field, axes);
    for (std::size_t a = 0; a < std::min<std::size_t>(values.size(), 3); ++a)
      numbers[static_cast<int>(a)] = values[a] * mm;
  };
  if (const HeaderField* field = fields.find({"elementspacing", "elementsize"}))
    firstOf(*field, spacing);
  else
    header.warnings.push_back("ElementSpacing is missing; " + std::string(kSpacingAssumed));
  if (const HeaderField* field = oneOf(fields, {"offset", "position", "origin"}, "origins", header.warnings))
    firstOf(*field, origin);
  if (const HeaderField* field =
          oneOf(fields, {"transformmatrix", "orientation", "rotation"}, "directions", header.warnings)) {
    std::vector<double> values;
    const std::size_t rows = fields.matrix(*field, axes, values);
    const std::size_t used = std::min<std::size_t>(rows, 3);
    for (std::size_t axis = 0; axis < used; ++axis)
      for (std::size_t i = 0; i < used; ++i)
        directions[static_cast<int>(axis)][static_cast<int>(i)] = values[axis * rows + i];
  }
  header.worldFromVoxel = checkedGeometry(directions, spacing, origin, file, header.warnings);
  if (const HeaderField* field = fields.find({"anatomicalorientation"}))
    header.axes = axesOf(*field, directions, header.warnings);
}

// "Kinds = domain domain list": the frames of a sequence are no slices. Tracked ultrasound says so, or gives
// each frame keys of its own.
void readKinds(const Fields& fields, std::size_t axes, const std::string& file, ImageHeader& header) {
  const HeaderField* const field = fields.find({"kinds"});
  const auto kinds = field ? wordsOf(field->value) : std::vector<std::string_view>();
  const auto isFrames = [&](std::size_t axis) {
    return axis < kinds.size() && !sameIgnoringCase(kinds[axis], "domain") &&
           !sameIgnoringCase(kinds[axis], "space");
  };
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (isFrames(axis))
      throwInput(file, field->place(), "an axis before the third is not a domain; not supported");
  if (axes != 3 || !(isFrames(2) || (kinds.empty() && fields.isSequence()))) return;
  header.timeSteps = header.dims[2];
  header.dims[2] = 1;
  header.warnings.push_back(
      "the frames of this sequence are time steps, each of one slice; where the probe "
      "was is not read");
}

// value = slope * stored + offset, as MetaIO's ElementToIntensityFunction has it.
void readScaling(const Fields& fields, ImageHeader& header) {
  if (const HeaderField* slope = fields.find({"elementtointensityfunctionslope"}))
    header.slope = fields.reals(*slope, 1)[0];
  if (const HeaderField* offset = fields.find({"elementtointensityfunctionoffset"}))
    header.intercept = fields.reals(*offset, 1)[0];
}

// "slice%03d.raw": the name with one number put in. Nothing but one %d, %i or %u with digits is accepted.
std::string numberedName(std::string_view pattern, std::int64_t number, const std::string& file,
                         const std::string& place) {
  const std::size_t percent = pattern.find('%');
  std::size_t end = percent + 1;
  while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9') ++end;
  const auto width = end > percent + 1 ? integerOf(pattern.substr(percent + 1, end - percent - 1)) : 0;
  const bool isNumber =
      end < pattern.size() && (pattern[end] == 'd' || pattern[end] == 'i' || pattern[end] == 'u');
  if (!isNumber || !width || *width > 20 || pattern.find('%', end) != std::string_view::npos)
    throwInput(file, place, inQuotes(pattern) + " is not a pattern for file names");
  std::string digits = std::to_string(number);
  if (digits.size() < static_cast<std::size_t>(*width)) {
    const bool zeros = pattern[percent + 1] == '0';
    digits.insert(0, static_cast<std::size_t>(*width) - digits.size(), zeros ? '0' : ' ');
  }
  return std::string(pattern.substr(0, percent)) + digits + std::string(pattern.substr(end + 1));
}

void readDataFile(const Fields& fields, std::string_view text, const std::string& file, ImageHeader& header) {
  const HeaderField& field = *fields.find({"elementdatafile"});
  Payload& payload = header.payload;
  const auto words = wordsOf(field.value);
  if (words.empty()) throwInput(file, field.place(), "names no data file");
  if (sameIgnoringCase(words[0], "local")) {
    payload.offset = fields.end();
    return;
  }
  if (sameIgnoringCase(words[0], "list")) {
    payload.files = listedFiles(text.substr(fields.end()), file, field.place());
    return;
  }
  if (words.size() >= 3 && words[0].find('%') != std::string_view::npos) {
    const auto first = integerOf(words[1]), last = integerOf(words[2]);
    const auto step = words.size() > 3 ? integerOf(words[3]) : std::optional<std::int64_t>(1);
    if (!first || !last || !step || *first < 0 || *step < 1 || *last < *first ||
        (*last - *first) / *step >= static_cast<std::int64_t>(mostFiles))
      throwInput(file, field.place(), "the range of file numbers is wrong");
    for (std::int64_t i = 0; i <= (*last - *first) / *step; ++i)
      payload.files.push_back(numberedName(words[0], *first + i * *step, file, field.place()));
    return;
  }
  payload.files.emplace_back(field.value);
}

}  // namespace

bool looksLikeMetaImage(std::string_view text) {
  Lines lines(text.substr(0, 4096));
  for (int count = 0; count < 40; ++count) {
    const auto line = lines.next();
    if (!line) return false;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) {
      if (trimmed(*line).empty()) continue;
      return false;
    }
    const std::string key = lowered(trimmed(line->substr(0, equals)));
    if (key == "objecttype" || key == "ndims" || key == "dimsize" || key == "elementtype") return true;
  }
  return false;
}

ImageHeader parseMetaImageHeader(std::string_view text, const std::string& file) {
  const Fields fields(text.substr(0, kLongestMetaImageHeader), file);
  ImageHeader header;
  header.format = "MetaImage";
  header.warnings = fields.warnings();
  if (const HeaderField* type = fields.find({"objecttype"}); type && !sameIgnoringCase(type->value, "image"))
    throwInput(file, type->place(), inQuotes(type->value) + " is not an image");

  const HeaderField& sizes = fields.need("dimsize", "DimSize");
  const HeaderField& count = fields.need("ndims", "NDims");
  const std::int64_t axes = fields.integer(count);
  if (axes < 2 || axes > 4)
    throwInput(file, count.place(), "2, 3 or 4 axes are read, not " + std::to_string(axes));
  const auto dims = integersOf(sizes.value);
  if (!dims) throwInput(file, sizes.place(), inQuotes(sizes.value) + " is not a list of whole numbers");
  if (dims->size() != static_cast<std::size_t>(axes))
    throwInput(file, sizes.place(),
               "has " + std::to_string(dims->size()) + " sizes for " + std::to_string(axes) + " axes");
  for (std::size_t a = 0; a < dims->size(); ++a) (a < 3 ? header.dims[a] : header.timeSteps) = (*dims)[a];

  const HeaderField& type = fields.need("elementtype", "ElementType");
  const auto voxelType = metaImageType(type.value);
  if (!voxelType)
    throwInput(file, type.place(), "the voxel type " + inQuotes(type.value) + " is not supported");
  header.type = *voxelType;
  if (const HeaderField* channels = fields.find({"elementnumberofchannels"})) {
    header.components = fields.integer(*channels);
    if (header.components < 1) throwInput(file, channels->place(), "there must be at least one channel");
  }
  readKinds(fields, static_cast<std::size_t>(axes), file, header);
  checkDims(header, file, sizes.place());
  readGeometry(fields, static_cast<std::size_t>(axes), file, header);
  readScaling(fields, header);

  Payload& payload = header.payload;
  const bool big = fields.flag(fields.find({"binarydatabyteordermsb", "elementbyteordermsb"}), false);
  payload.endianness = big ? Endianness::big : Endianness::little;
  const HeaderField* compressed = fields.find({"compresseddata"});
  if (fields.flag(compressed, false)) payload.encoding = Encoding::zlib;
  const HeaderField* binary = fields.find({"binarydata"});
  if (!fields.flag(binary, true)) {
    if (payload.encoding == Encoding::zlib)
      throwInput(file, compressed->place(), "text data cannot be compressed");
    payload.encoding = Encoding::ascii;
  }
  readDataFile(fields, text.substr(0, kLongestMetaImageHeader), file, header);
  if (const HeaderField* size = fields.find({"compresseddatasize"});
      size && payload.encoding == Encoding::zlib) {
    const std::int64_t bytes = fields.integer(*size);
    if (bytes < 0) throwInput(file, size->place(), "is negative");
    if (payload.files.size() <= 1) payload.compressedBytes = static_cast<std::uint64_t>(bytes);
  }
  if (const HeaderField* skip = fields.find({"headersize"})) {
    const std::int64_t bytes = fields.integer(*skip);
    if (bytes < -1) throwInput(file, skip->place(), "must be -1 or a number of bytes");
    if (bytes == -1) {
      if (payload.encoding != Encoding::raw)
        throwInput(file, skip->place(), "-1 (the data end the file) needs uncompressed binary data");
      payload.fromEnd = true;
    } else if (!payload.files.empty()) {
      payload.offset = static_cast<std::uint64_t>(bytes);
    }
  }
  return header;
}

}  // namespace isolux::volume
