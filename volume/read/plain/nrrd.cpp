#include "volume/read/plain/nrrd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "volume/read/input/length_unit.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"
#include "volume/read/plain/nrrd_segments.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Axis {
  std::int64_t size = 1;
  std::string_view kind;
  double spacing = nan;                 // of "spacings"; nan: not given
  double first = nan;                   // where the first sample is, by "axis mins"; nan: not given
  std::string_view unit;                // of `spacing` and `first`
  std::optional<glm::dvec3> direction;  // of "space directions"
  bool withoutDirection = false;        // "none"
};

class Header : private HeaderFields {
 public:
  Header(std::string_view text, const std::string& file);
  ImageHeader read();

 private:
  // One entry per axis.
  std::vector<std::string_view> perAxis(const HeaderField& field,
                                        std::vector<std::string_view> entries) const {
    if (entries.size() != axes_.size())
      throwInput(
          file_, field.place(),
          "has " + std::to_string(entries.size()) + " entries for " + std::to_string(axes_.size()) + " axes");
    return entries;
  }
  std::vector<std::string_view> perAxis(const HeaderField& field) const {
    return perAxis(field, wordsOf(field.value));
  }
  double real(std::string_view word, const HeaderField& field) const {
    const auto value = realOf(word);
    if (!value) throwInput(file_, field.place(), inQuotes(word) + " is not a number");
    return *value;
  }

  void readAxes();
  void readMinsAndMaxs(const HeaderField& low, const HeaderField* high);
  void readSpace();
  std::vector<std::string_view> quoted(const HeaderField& field) const;
  glm::dvec3 spaceUnitsMm();
  void readValues(ImageHeader& header);
  std::vector<std::string_view> vectorsOf(const HeaderField& field) const;
  glm::dvec3 vectorOf(std::string_view text, const HeaderField& field) const;
  bool isSpatial(const Axis& axis) const;
  void assignAxes(ImageHeader& header);
  void readGeometry(ImageHeader& header);
  void noteContradictions();
  void readLabels(ImageHeader& header) const;
  void readEncoding(ImageHeader& header) const;
  void readDataFiles(ImageHeader& header) const;

  std::string_view text_;
  std::size_t end_ = 0;  // of the header
  int endLine_ = 0;
  bool attached_ = false;  // an empty line ended the header
  NrrdKeys keys_;
  std::vector<Axis> axes_;
  std::vector<std::size_t> spatial_;  // the axes that are x, y, z
  int spaceDimension_ = 0;
  glm::dvec3 toLps_{1.0};      // signs
  bool patientSpace_ = false;  // the space is named by the patient's sides
};

// The synonyms of the definition, without spaces around the name.
std::string canonicalName(std::string_view name) {
  std::string lower = lowered(trimmed(name));
  static constexpr std::pair<std::string_view, std::string_view> synonyms[] = {
      {"datafile", "data file"},       {"lineskip", "line skip"},
      {"byteskip", "byte skip"},       {"axismins", "axis mins"},
      {"axismaxs", "axis maxs"},       {"centerings", "centers"},
      {"sampleunits", "sample units"}, {"oldmin", "old min"},
      {"oldmax", "old max"},           {"spacedimension", "space dimension"}};
  for (const auto& [other, known] : synonyms)
    if (lower == other) return std::string(known);
  return lower;
}

Header::Header(std::string_view text, const std::string& file) : HeaderFields(file), text_(text) {
  Lines lines(text);
  const auto magic = lines.next();
  if (!magic || !magic->starts_with("NRRD000") || magic->size() != 8 || (*magic)[7] < '1' ||
      (*magic)[7] > '6')
    throwInput(file_, "line 1", "is not an NRRD magic from NRRD0001 to NRRD0006");
  while (const auto line = lines.next()) {
    end_ = lines.offset();
    endLine_ = lines.number();
    if (line->empty()) {
      attached_ = true;
      break;
    }
    if ((*line)[0] == '#') continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string_view::npos)
      throwInput(file_, linePlace(endLine_), "is not a \"field: value\" line");
    if (colon + 1 < line->size() && (*line)[colon + 1] == '=') {
      keys_.emplace(line->substr(0, colon),
                    HeaderField{line->substr(0, colon), line->substr(colon + 2), endLine_});
      continue;
    }
    const HeaderField field{trimmed(line->substr(0, colon)), trimmed(line->substr(colon + 1)), endLine_};
    const std::string name = canonicalName(field.name);
    add(name, field, "fields");
    if (name == "data file" && !wordsOf(field.value).empty() && wordsOf(field.value)[0] == "LIST")
      break;  // the rest are file names
  }
}

std::optional<VoxelType> nrrdType(std::string_view name) {
  static constexpr std::pair<VoxelType, std::array<std::string_view, 8>> all[] = {
      {VoxelType::int8, {"signed char", "int8", "int8_t"}},
      {VoxelType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {VoxelType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {VoxelType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {VoxelType::int32, {"int", "signed int", "int32", "int32_t"}},
      {VoxelType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {VoxelType::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
        "int64_t"}},
      {VoxelType::uint64,
       {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {VoxelType::float32, {"float"}},
      {VoxelType::float64, {"double"}}};
  for (const auto& [type, names] : all)
    for (std::string_view known : names)
      if (!known.empty() && sameIgnoringCase(known, name)) return type;
  return std::nullopt;
}

void Header::readAxes() {
  const HeaderField& dimension = need("dimension");
  const std::int64_t count = integer(dimension);
  if (count < 2 || count > 5)
    throwInput(file_, dimension.place(), "2 to 5 axes are read, not " + std::to_string(count));
  axes_.resize(static_cast<std::size_t>(count));
  const HeaderField& sizes = need("sizes");
  const auto words = perAxis(sizes);
  for (std::size_t a = 0; a < words.size(); ++a) {
    const auto size = integerOf(words[a]);
    if (!size) throwInput(file_, sizes.place(), inQuotes(words[a]) + " is not a whole number");
    if (*size < 1)
      throwInput(file_, sizes.place(),
                 "an axis has " + std::to_string(*size) + " voxels; at least 1 is needed");
    axes_[a].size = *size;
  }
  if (const HeaderField* kinds = find("kinds")) {
    const auto names = perAxis(*kinds);
    for (std::size_t a = 0; a < names.size(); ++a) axes_[a].kind = names[a];
  }
  if (const HeaderField* spacings = find("spacings")) {
    const auto values = perAxis(*spacings);
    for (std::size_t a = 0; a < values.size(); ++a) axes_[a].spacing = real(values[a], *spacings);
  }
  if (const HeaderField* low = find("axis mins")) readMinsAndMaxs(*low, find("axis maxs"));
  if (const HeaderField* units = find("units")) {
    const auto names = perAxis(*units, quoted(*units));
    for (std::size_t a = 0; a < names.size(); ++a) axes_[a].unit = names[a];
  }
}

// Of a cell-centred axis, the usual kind, the ends lie half a sample beyond the first and the last one.
void Header::readMinsAndMaxs(const HeaderField& low, const HeaderField* high) {
  const auto lows = perAxis(low), highs = high ? perAxis(*high) : lows;
  const HeaderField* centers = find("centers");
  const auto centering = centers ? perAxis(*centers) : std::vector<std::string_view>(axes_.size());
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    Axis& axis = axes_[a];
    const bool node = sameIgnoringCase(centering[a], "node");
    const double begin = real(lows[a], low), width = high ? real(highs[a], *high) - begin : nan;
    const std::int64_t steps = axis.size - (node ? 1 : 0);
    const double spacing = steps > 0 ? width / static_cast<double>(steps) : nan;
    if (std::isnan(axis.spacing))
      axis.spacing = spacing;
    else if (std::abs(spacing - axis.spacing) > 0.01 * std::abs(axis.spacing))
      warnings_.push_back(
          "\"spacings\" and \"axis mins\" with \"axis maxs\" disagree; the spacings are taken");
    axis.first = node || std::isnan(axis.spacing) ? begin : begin + 0.5 * axis.spacing;
  }
}

// "mm" "mm" "" -> the texts between the quotes; words without quotes as they are.
std::vector<std::string_view> Header::quoted(const HeaderField& field) const {
  std::vector<std::string_view> texts;
  for (std::string_view rest = trimmed(field.value); !rest.empty(); rest = trimmed(rest)) {
    const bool isQuoted = rest[0] == '"';
    const std::size_t end = isQuoted ? rest.find('"', 1) : std::min(rest.find_first_of(" \t"), rest.size());
    if (end == std::string_view::npos) throwInput(file_, field.place(), "a quotation mark is not closed");
    texts.push_back(rest.substr(isQuoted ? 1 : 0, isQuoted ? end - 1 : end));
    rest.remove_prefix(isQuoted ? end + 1 : end);
  }
  return texts;
}

void Header::readSpace() {
  if (const HeaderField* space = find("space")) {
    std::string name = lowered(space->value);
    spaceDimension_ = 3;
    patientSpace_ = true;
    if (name.ends_with("-time")) {
      name.resize(name.size() - 5);
      spaceDimension_ = 4;
    } else if (name.size() == 4 && name.back() == 't') {
      name.pop_back();
      spaceDimension_ = 4;
    }
    if (name == "left-posterior-superior" || name == "lps") {
      toLps_ = {1.0, 1.0, 1.0};
    } else if (name == "right-anterior-superior" || name == "ras") {
      toLps_ = {-1.0, -1.0, 1.0};
    } else if (name == "left-anterior-superior" || name == "las") {
      toLps_ = {1.0, -1.0, 1.0};
    } else if (name == "scanner-xyz" || name == "3d-right-handed" || name == "3d-left-handed") {
      patientSpace_ = false;
      if (name == "3d-left-handed") toLps_ = {-1.0, 1.0, 1.0};  // or it would be shown mirrored
      warnings_.push_back("the space \"" + name +
                          "\" does not state the patient's orientation; taken as LPS");
    } else {
      throwInput(file_, space->place(), "the space " + inQuotes(space->value) + " is not known");
    }
  } else if (const HeaderField* dimension = find("space dimension")) {
    const std::int64_t n = integer(*dimension);
    if (n < 2 || n > 4) throwInput(file_, dimension->place(), "2, 3 or 4 space dimensions are read");
    spaceDimension_ = static_cast<int>(n);
  }
  if (const HeaderField* directions = find("space directions")) {
    if (spaceDimension_ == 0) throwInput(file_, directions->place(), "needs a space or a space dimension");
    const auto vectors = perAxis(*directions, vectorsOf(*directions));
    for (std::size_t a = 0; a < vectors.size(); ++a) {
      if (sameIgnoringCase(vectors[a], "none"))
        axes_[a].withoutDirection = true;
      else
        axes_[a].direction = vectorOf(vectors[a], *directions);
    }
  }
}

// "(1,0,0) none (0, 1, 0)" -> "(1,0,0)", "none", "(0, 1, 0)".
std::vector<std::string_view> Header::vectorsOf(const HeaderField& field) const {
  std::vector<std::string_view> vectors;
  std::string_view rest = trimmed(field.value);
  while (!rest.empty()) {
    const std::size_t end =
        rest[0] == '(' ? rest.find(')') : std::min(rest.find_first_of(" \t("), rest.size()) - 1;
    if (end == std::string_view::npos) throwInput(file_, field.place(), "a parenthesis is not closed");
    vectors.push_back(rest.substr(0, end + 1));
    rest = trimmed(rest.substr(end + 1));
  }
  return vectors;
}

// The fourth number of a space with time is left out.
glm::dvec3 Header::vectorOf(std::string_view text, const HeaderField& field) const {
  if (text.size() < 2 || text.front() != '(' || text.back() != ')')
    throwInput(file_, field.place(), inQuotes(text) + " is not a vector like (1,0,0)");
  std::string inner(text.substr(1, text.size() - 2));
  std::ranges::replace(inner, ',', ' ');
  const auto values = realsOf(inner);
  if (!values || values->size() != static_cast<std::size_t>(spaceDimension_))
    throwInput(file_, field.place(),
               inQuotes(text) + " is not a vector of " + std::to_string(spaceDimension_) + " numbers");
  glm::dvec3 result(0.0);
  for (int i = 0; i < std::min(spaceDimension_, 3); ++i) result[i] = (*values)[static_cast<std::size_t>(i)];
  return result;
}

bool Header::isSpatial(const Axis& axis) const {
  if (axis.withoutDirection) return false;
  if (axis.kind.empty() || axis.kind == "???" || sameIgnoringCase(axis.kind, "none")) return true;
  return sameIgnoringCase(axis.kind, "domain") || sameIgnoringCase(axis.kind, "space");
}

// Which axes are x, y, z; the others must stand before or behind them.
void Header::assignAxes(ImageHeader& header) {
  const HeaderField& sizes = need("sizes");
  for (std::size_t a = 0; a < axes_.size(); ++a)
    if (isSpatial(axes_[a])) spatial_.push_back(a);
  if (spatial_.size() == 4 && axes_.size() == 4 && !find("space directions")) {
    // Nothing says which axis is not spatial. A NaN spacing does; else a short first axis is colours.
    const bool firstHasNoSpacing = std::isnan(axes_[0].spacing) && !std::isnan(axes_[3].spacing);
    const bool firstIsShort = std::isnan(axes_[0].spacing) && axes_[0].size <= 4 && axes_[3].size > 4;
    const bool first = firstHasNoSpacing || firstIsShort;
    spatial_.erase(first ? spatial_.begin() : spatial_.end() - 1);
    warnings_.push_back(std::string("the header does not state which of the 4 axes is not spatial; the ") +
                        (first ? "first is taken as components" : "last is taken as time"));
  }
  if (spatial_.size() < 2 || spatial_.size() > 3)
    throwInput(file_, sizes.place(),
               std::to_string(spatial_.size()) + " of " + std::to_string(axes_.size()) +
                   " axes are spatial; 2 or 3 are needed");
  const std::size_t first = spatial_.front(), last = spatial_.back();
  if (last - first + 1 != spatial_.size())
    throwInput(file_, sizes.place(), "a non-spatial axis between spatial ones; not supported");
  for (std::size_t i = 0; i < spatial_.size(); ++i) header.dims[i] = axes_[spatial_[i]].size;
  if (first > 1 || axes_.size() - last > 3)
    throwInput(file_, sizes.place(), "more axes that are not spatial than are supported");
  if (first == 1) header.components = axes_[0].size;
  for (std::size_t a = last + 1; a < axes_.size(); ++a) {
    const std::string kind = lowered(axes_[a].kind);
    const bool isComponents =
        kind.find("vector") != std::string::npos || kind.find("color") != std::string::npos ||
        kind.find("matrix") != std::string::npos || kind == "complex" || kind == "quaternion";
    std::int64_t& target = isComponents ? header.slowComponents : header.timeSteps;
    if (target != 1)
      throwInput(file_, sizes.place(), "two axes of the same kind follow the spatial ones; not supported");
    if (isComponents && a + 1 < axes_.size())
      throwInput(file_, sizes.place(), "components must be the last axis; not supported");
    target = axes_[a].size;
  }
}

// mm in the units of the space's axes; without a word they are mm.
glm::dvec3 Header::spaceUnitsMm() {
  glm::dvec3 mm(1.0);
  const HeaderField* units = find("space units");
  if (!units) return mm;
  const auto names = quoted(*units);
  if (names.size() != static_cast<std::size_t>(spaceDimension_))
    throwInput(file_, units->place(),
               "has " + std::to_string(names.size()) + " entries for " + std::to_string(spaceDimension_) +
                   " dimensions of space");
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 3); ++i)
    if (!names[i].empty()) mm[static_cast<int>(i)] = millimetresOr1(names[i], "space units", warnings_);
  return mm;
}

// What the numbers mean. NRRD's range before quantisation is for reconstruction by Teem's own rule, which
// other programs do not apply either.
void Header::readValues(ImageHeader& header) {
  if (const HeaderField* unit = find("sample units")) {
    const auto names = quoted(*unit);
    header.unit = names.size() == 1 ? names[0] : unit->value;
  }
  const HeaderField *low = find("old min"), *high = find("old max");
  if (low || high)
    warnings_.push_back("the values were quantised from " + std::string(low ? low->value : "?") + " to " +
                        std::string(high ? high->value : "?") +
                        " (old min, old max); the stored numbers are taken");
  if (header.components * header.slowComponents > 1 && find("measurement frame"))
    warnings_.push_back("the measurement frame of the components is not applied");
}

void Header::noteContradictions() {
  const bool placed = std::ranges::any_of(axes_, [](const Axis& axis) { return axis.direction.has_value(); });
  bool differ = false;
  for (const Axis& axis : axes_)
    if (axis.direction && !std::isnan(axis.spacing)) {
      const double length = std::hypot(axis.direction->x, axis.direction->y, axis.direction->z);
      differ = differ || std::abs(length - std::abs(axis.spacing)) > 0.01 * length;
    }
  if (placed && differ)
    warnings_.push_back("\"spacings\" and \"space directions\" disagree; the directions are taken");
  if (const HeaderField* dimension = find("space dimension");
      dimension && find("space") && integer(*dimension) != spaceDimension_)
    warnings_.push_back("\"space\" and \"space dimension\" disagree; the space is taken");
}

void Header::readGeometry(ImageHeader& header) {
  glm::dvec3 spacing(1.0), origin(0.0);
  glm::dmat3 directions(1.0);
  int known = 0;
  const glm::dvec3 spaceMm = spaceUnitsMm() * toLps_;
  for (std::size_t i = 0; i < spatial_.size(); ++i) {
    const int column = static_cast<int>(i);
    const Axis& axis = axes_[spatial_[i]];
    if (axis.direction) {
      const glm::dvec3 d = *axis.direction * spaceMm;
      spacing[column] = std::hypot(d.x, d.y, d.z);
      directions[column] = spacing[column] > 0.0 ? d / spacing[column] : d;
      ++known;
    } else if (!std::isnan(axis.spacing)) {
      const double mm = axis.unit.empty() ? 1.0 : millimetresOr1(axis.unit, "units", warnings_);
      spacing[column] = axis.spacing * mm;
      if (!std::isnan(axis.first)) origin += axis.first * mm * directions[column] * toLps_;
      directions[column] *= toLps_;
      ++known;
    } else {
      directions[column] *= toLps_;
    }
  }
  if (known < static_cast<int>(spatial_.size()))
    warnings_.push_back("the spacing is missing; " + std::string(kSpacingAssumed));
  if (spatial_.size() == 2 && axes_[spatial_[0]].direction) {  // one slice: any thickness along its normal
    const glm::dvec3 a = directions[0], b = directions[1];
    directions[2] = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  if (const HeaderField* field = find("space origin")) {
    if (spaceDimension_ == 0) throwInput(file_, field->place(), "needs a space or a space dimension");
    origin = vectorOf(field->value, *field) * spaceMm;
  }
  header.worldFromVoxel = checkedGeometry(directions, spacing, origin, file_, warnings_);
  // The space names the world's axes, the directions say how the voxels' axes lie among them: it takes both.
  const bool placed =
      std::ranges::all_of(spatial_, [this](std::size_t a) { return axes_[a].direction.has_value(); });
  if (patientSpace_ && placed && usableDirections(directions)) header.axes = scene::WorldAxes::anatomical;
}

void Header::readLabels(ImageHeader& header) const {
  const std::int64_t layers = header.components * header.slowComponents;
  if (auto table = segmentsOf(keys_, layers, file_, header.warnings))
    header.labels = std::make_shared<const LabelTable>(std::move(*table));
}

void Header::readEncoding(ImageHeader& header) const {
  const HeaderField& encoding = need("encoding");
  const std::string name = lowered(encoding.value);
  Payload& payload = header.payload;
  if (name == "raw") {
    payload.encoding = Encoding::raw;
  } else if (name == "gzip" || name == "gz" || name == "bzip2" || name == "bz2") {
    payload.encoding = Encoding::zlib;
  } else if (name == "txt" || name == "text" || name == "ascii") {
    payload.encoding = Encoding::ascii;
  } else if (name == "hex") {
    throwInput(file_, encoding.place(),
               "the encoding \"hex\" is not supported; gzip, bzip2, raw and text are");
  } else {
    throwInput(file_, encoding.place(), "the encoding " + inQuotes(encoding.value) + " is not known");
  }
  if (const HeaderField* endian = find("endian")) {
    if (sameIgnoringCase(endian->value, "big"))
      payload.endianness = Endianness::big;
    else if (!sameIgnoringCase(endian->value, "little"))
      throwInput(file_, endian->place(), inQuotes(endian->value) + " is neither little nor big");
  } else if (bytesOf(header.type) > 1 && payload.encoding != Encoding::ascii) {
    header.warnings.push_back("the field \"endian\" is missing; little endian assumed");
  }
  if (const HeaderField* skip = find("line skip")) {
    const std::int64_t lines = integer(*skip);
    if (lines < 0) throwInput(file_, skip->place(), "is negative");
    payload.lineSkip = static_cast<std::uint64_t>(lines);
  }
  if (const HeaderField* skip = find("byte skip")) {
    const std::int64_t bytes = integer(*skip);
    if (bytes < -1) throwInput(file_, skip->place(), "must be -1 or a number of bytes");
    if (bytes == -1) {
      if (payload.encoding != Encoding::raw)
        throwInput(file_, skip->place(), "-1 (the data end the file) needs raw encoding");
      payload.fromEnd = true;
    } else if (payload.encoding == Encoding::zlib) {
      payload.skipDecoded = static_cast<std::uint64_t>(bytes);  // counted after inflating, by definition
    } else {
      payload.skipBytes = static_cast<std::uint64_t>(bytes);
    }
  }
}

void Header::readDataFiles(ImageHeader& header) const {
  Payload& payload = header.payload;
  const HeaderField* data = find("data file");
  if (!data) {
    if (!attached_)
      throwInput(file_, linePlace(endLine_),
                 "truncated: no empty line ends the header, no data file is named");
    payload.offset = end_;
    return;
  }
  const auto words = wordsOf(data->value);
  if (words.empty()) throwInput(file_, data->place(), "names no data file");
  if (words[0] == "LIST") {
    payload.files = listedFiles(text_.substr(end_), file_, data->place());
  } else if (words.size() >= 4 && words[0].find('%') != std::string_view::npos) {
    throwInput(file_, data->place(), "file name patterns are not supported; list the files with LIST");
  } else {
    payload.files.emplace_back(data->value);
  }
}

ImageHeader Header::read() {
  ImageHeader header;
  header.format = "NRRD";
  const HeaderField& type = need("type");
  const auto voxelType = nrrdType(type.value);
  if (!voxelType)
    throwInput(file_, type.place(), "the voxel type " + inQuotes(type.value) + " is not supported");
  header.type = *voxelType;
  readAxes();
  readSpace();
  assignAxes(header);
  checkDims(header, file_, need("sizes").place());
  noteContradictions();
  readGeometry(header);
  readValues(header);
  header.warnings = warnings_;
  readLabels(header);
  readEncoding(header);
  readDataFiles(header);
  return header;
}

}  // namespace

ImageHeader parseNrrdHeader(std::string_view text, const std::string& file) {
  return Header(text.substr(0, kLongestNrrdHeader), file).read();
}

}  // namespace isolux::volume
