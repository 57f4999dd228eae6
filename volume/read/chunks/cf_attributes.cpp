#include "volume/read/chunks/cf_attributes.h"

#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace {

bool isInteger(VoxelType type) {
  return type != VoxelType::float32 && type != VoxelType::float64;
}

bool saysUnsigned(const Attributes& attributes) {
  return sameIgnoringCase(textIn(attributes, "_Unsigned"), "true");
}

class Values {
 public:
  Values(const Attributes& attributes, FileNumber number, ArrayStatements& statements)
      : attributes_(attributes), number_(number), statements_(statements) {}

  void read() {
    statements_.slope = single("scale_factor", 1.0);
    statements_.intercept = single("add_offset", 0.0);
    if (!std::isfinite(statements_.slope) || statements_.slope == 0.0 ||
        !std::isfinite(statements_.intercept)) {
      statements_.warnings.push_back("scale_factor " + base::shortText(statements_.slope) +
                                     " and add_offset " + base::shortText(statements_.intercept) +
                                     " cannot be applied; left out");
      statements_.slope = 1.0;
      statements_.intercept = 0.0;
    }
    for (const char* name : {"_FillValue", "missing_value"})
      for (const double value : numbers(name))
        if (!std::isnan(value)) statements_.missing.values.push_back(stored(value));
    readRange();
    statements_.unit = textIn(attributes_, "units");
    if (statements_.unit == "1") statements_.unit.clear();  // CF's word for numbers without one
  }

 private:
  std::vector<double> numbers(const char* name) const {
    const auto found = attributes_.find(name);
    if (found == attributes_.end()) return {};
    if (!found->second.numbers.empty()) return found->second.numbers;
    const auto parsed = realsOf(found->second.text);
    if (parsed && !parsed->empty()) return *parsed;
    statements_.warnings.push_back(std::string(name) + " is not a number; left out");
    return {};
  }

  double single(const char* name, double otherwise) const {
    const std::vector<double> values = numbers(name);
    if (values.size() > 1)
      statements_.warnings.push_back(std::string(name) + " has " + std::to_string(values.size()) +
                                     " numbers instead of one; the first is used");
    return values.empty() ? otherwise : values.front();
  }

  // As the array holds it: rounded to its type, of signed numbers that stand for unsigned ones.
  double stored(double value) const {
    if (number_.type == VoxelType::float32) return static_cast<double>(static_cast<float>(value));
    return unsigned_ && value < 0.0 ? value + std::ldexp(1.0, static_cast<int>(8 * bytesOf(number_.type)))
                                    : value;
  }

  // Of the stored numbers, unless it has the type of the values that they become (NUG, appendix A).
  double bound(const char* name, double value) const {
    const auto found = attributes_.find(name);
    const bool ofValues = isInteger(number_.type) && found != attributes_.end() && !found->second.whole &&
                          attributes_.contains("scale_factor");
    return ofValues ? (value - statements_.intercept) / statements_.slope : stored(value);
  }

  void readRange() {
    MissingNumbers& missing = statements_.missing;
    const std::vector<double> range = numbers("valid_range");
    if (range.size() == 2) {
      missing.least = bound("valid_range", range[0]);
      missing.greatest = bound("valid_range", range[1]);
    } else {
      if (!range.empty()) statements_.warnings.emplace_back("valid_range has not two numbers; left out");
      if (const auto least = numbers("valid_min"); !least.empty())
        missing.least = bound("valid_min", least[0]);
      if (const auto most = numbers("valid_max"); !most.empty())
        missing.greatest = bound("valid_max", most[0]);
    }
    // A negative slope turns bounds of values round.
    if (statements_.slope < 0.0 && missing.least > missing.greatest)
      std::swap(missing.least, missing.greatest);
    if (missing.least <= missing.greatest) return;
    statements_.warnings.emplace_back("the valid range is empty or no number; left out");
    missing.least = -std::numeric_limits<double>::infinity();
    missing.greatest = std::numeric_limits<double>::infinity();
  }

  const Attributes& attributes_;
  FileNumber number_;
  ArrayStatements& statements_;
  bool unsigned_ = saysUnsigned(attributes_) && isInteger(number_.type);
};

}  // namespace

std::string textIn(const Attributes& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::string() : found->second.text;
}

FileNumber withSign(const Attributes& attributes, FileNumber number) {
  if (saysUnsigned(attributes) && isInteger(number.type))
    number.type = *integerType(bytesOf(number.type), false);
  return number;
}

void readCfValues(const Attributes& attributes, FileNumber number, ArrayStatements& statements) {
  Values(attributes, number, statements).read();
}

AxisStatement cfAxis(const Attributes& attributes, const std::string& name) {
  static const std::map<std::string, std::string> standard = {{"longitude", "x"},
                                                              {"projection_x_coordinate", "x"},
                                                              {"latitude", "y"},
                                                              {"projection_y_coordinate", "y"},
                                                              {"time", "t"}};
  AxisStatement axis;
  axis.name = lowered(textIn(attributes, "axis"));
  if (axis.name.empty())
    if (const auto found = standard.find(textIn(attributes, "standard_name")); found != standard.end())
      axis.name = found->second;
  if (axis.name.empty()) axis.name = name;
  axis.unit = textIn(attributes, "units");
  if (sameIgnoringCase(textIn(attributes, "positive"), "down")) axis.direction = {0.0, 0.0, -1.0};
  return axis;
}

std::optional<double> netCdfFill(const FileNumber& number) {
  // In the order of VoxelType, from int16 on.
  static constexpr double fills[] = {-32767.0,
                                     65535.0,
                                     -2147483647.0,
                                     4294967295.0,
                                     -9223372036854775806.0,
                                     18446744073709551614.0,
                                     static_cast<double>(9.9692099683868690e+36f),
                                     9.9692099683868690e+36};
  if (bytesOf(number.type) == 1) return std::nullopt;
  return fills[static_cast<int>(number.type) - static_cast<int>(VoxelType::int16)];
}

}  // namespace isolux::volume
