#include "volume/read/tiff/tiff_stack.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/length_unit.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"
#include "volume/read/tiff/ome_tiff.h"

namespace isolux::volume {

using base::shortText;
using base::throwInput;

namespace {

constexpr const char* kDescription = "ImageDescription";
constexpr const char* kImageJAxes = "TZCYX";  // and of its copies: channel fastest, then slice, then frame
constexpr std::int64_t kMostPlanes = std::int64_t{1} << 31;

bool usableSpacing(double size) {
  return std::isfinite(size) && size >= 1e-9 && size <= 1e9;
}

class Statements {
 public:
  Statements(const TiffFile& file, const std::string& name, std::uint64_t fileBytes)
      : file_(file), says_(file.says), name_(name), fileBytes_(fileBytes) {}

  TiffStack stack() {
    takeAsSlices(static_cast<std::int64_t>(file_.pages.size()));
    const std::string_view text = trimmed(says_.description);
    if (text.starts_with("ImageJ="))
      readImageJ();
    else if (text.starts_with("<") && text.find("<OME") != std::string_view::npos)
      readOme();
    else if (!says_.lsmInfo.empty())
      readLsm();
    else if (text.starts_with("{"))
      readShape();
    if (says_.uicPlanes > 1 && file_.pages.size() == 1) takeOnePage(says_.uicPlanes, "its MetaMorph record");
    if (!placed_) noteNoSpacing();
    readGdal();
    notePixels();
    return std::move(stack_);
  }

 private:
  void takeAsSlices(std::int64_t count) {
    stack_.channels = stack_.frames = 1;
    stack_.slices = count;
    stack_.planes.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < stack_.planes.size(); ++i) stack_.planes[i] = i;
  }

  // Planes behind one another, of which the directory describes the first only.
  void takeOnePage(std::int64_t count, const std::string& who) {
    const TiffPage& page = file_.pages.front();
    const auto announces = who + " announces " + std::to_string(count) + " images";
    if (!page.contiguous || page.bits % 8 != 0 || count > kMostPlanes)
      throwInput(name_, kDescription, announces + ", the file has one page");
    if (page.rawBytes() > (fileBytes_ - page.pixels) / static_cast<std::uint64_t>(count))
      throwInput(name_, kDescription, "truncated: " + announces + ", the file has room for fewer");
    takeAsSlices(count);
    stack_.inOnePage = true;
  }

  void ignore(const std::string& why) { stack_.warnings.push_back(why + "; the pages are taken as slices"); }

  // --- ImageJ

  std::map<std::string, std::string, std::less<>> imageJKeys() const {
    std::map<std::string, std::string, std::less<>> keys;
    Lines lines(says_.description);
    while (const auto line = lines.next()) {
      const std::size_t equals = line->find('=');
      if (equals != std::string_view::npos)
        keys.emplace(trimmed(line->substr(0, equals)), trimmed(line->substr(equals + 1)));
    }
    return keys;
  }

  void readImageJ() {
    const auto keys = imageJKeys();
    const auto text = [&](const char* key) {
      const auto it = keys.find(key);
      return it == keys.end() ? std::string() : it->second;
    };
    const auto count = [&](const char* key) {
      const auto value = integerOf(text(key));
      if (keys.contains(key) && (!value || *value < 1 || *value > kMostPlanes))
        throwInput(name_, kDescription, std::string(key) + "=" + text(key) + " is not a number of pages");
      return value.value_or(1);
    };
    const std::int64_t channels = count("channels"), frames = count("frames");
    const std::int64_t images = keys.contains("images") ? count("images") : stack_.slices;
    std::int64_t slices = count("slices");
    if (!keys.contains("slices") && channels * frames <= images && images % (channels * frames) == 0)
      slices = images / (channels * frames);
    if (images > 1 && file_.pages.size() == 1) takeOnePage(images, "ImageJ");
    if (images != stack_.slices)
      ignore("ImageJ announces " + std::to_string(images) + " images, the file has " +
             std::to_string(stack_.slices) + " pages");
    else if (channels > images || slices > images || channels * slices > images ||
             channels * slices * frames != images)
      ignore("ImageJ announces " + std::to_string(images) + " images, but " + std::to_string(channels) +
             " channels, " + std::to_string(slices) + " slices and " + std::to_string(frames) + " frames");
    else
      takeAxes(kImageJAxes, {frames, slices, channels, 1, 1});
    readImageJSpacing(text("unit"), text("yunit"), text("zunit"), realOf(text("spacing")));
    readCalibration(keys.contains("cf")   ? text("cf")
                    : keys.contains("c0") ? "0"
                                          : "",
                    realOf(text("c0")), realOf(text("c1")), text("vunit"));
  }

  void readImageJSpacing(const std::string& unit, const std::string& yUnit, const std::string& zUnit,
                         const std::optional<double>& spacing) {
    std::vector<std::string>& warnings = stack_.warnings;
    const bool named = !unit.empty() && !lowered(unit).starts_with("pixel");
    if (!named && !spacing) return;
    const std::string statement = std::string("of ") + kDescription;
    const double mm = named ? millimetresOr1(unit, statement, warnings) : millimetresOr1("", "", warnings);
    const glm::dvec3 units(mm, yUnit.empty() ? mm : millimetresOr1(yUnit, statement, warnings),
                           zUnit.empty() ? mm : millimetresOr1(zUnit, statement, warnings));
    glm::dvec3 size(says_.xResolution > 0.0 ? 1.0 / says_.xResolution : 1.0,
                    says_.yResolution > 0.0 ? 1.0 / says_.yResolution : 1.0, spacing.value_or(1.0));
    if (named && says_.xResolution > 0.0 && says_.resolutionUnit > 1) {
      const double tagMm = says_.resolutionUnit == 2 ? 25.4 : 10.0;
      const bool micrometresPerCm = says_.resolutionUnit == 3 && mm == 1e-3;  // older versions of ImageJ
      if (micrometresPerCm)
        size *= glm::dvec3(tagMm / mm, tagMm / mm, 1.0);
      else if (tagMm != mm)
        warnings.push_back("ResolutionUnit says " + std::string(tagMm == 10.0 ? "cm" : "inch") +
                           ", ImageJ's description " + unit + "; " + unit + " is taken");
    }
    if (says_.xResolution <= 0.0 || says_.yResolution <= 0.0)
      warnings.push_back("the file states no size of pixels; " + std::string(kSpacingAssumed));
    if (!spacing && stack_.slices > 1)
      warnings.push_back("ImageJ's description has no spacing: 1 " + unit + " " +
                         std::string(kSliceDistanceAssumed));
    place(size * units);
  }

  // Value = c0 + c1 * stored, ImageJ's function 0; it has others, which are curves.
  void readCalibration(const std::string& function, const std::optional<double>& c0,
                       const std::optional<double>& c1, const std::string& unit) {
    if (function.empty()) return;
    if (function == "0" && c0 && c1 && std::isfinite(*c0) && std::isfinite(*c1) && *c1 != 0.0) {
      stack_.slope = *c1;
      stack_.intercept = *c0;
      if (!sameIgnoringCase(unit, "gray value")) stack_.unit = unit;
      return;
    }
    stack_.warnings.push_back("ImageJ's calibration function " + inQuotes(function) +
                              " is not applied; the stored numbers are shown");
  }

  // --- OME-TIFF

  void readOme() {
    const OmeTiff ome = parseOmeTiff(says_.description, name_);
    stack_.warnings.insert(stack_.warnings.end(), ome.warnings.begin(), ome.warnings.end());
    if (!ome.known) return;
    const TiffPage& page = file_.pages.front();
    if (ome.width != page.width || ome.height != page.height || ome.channels % page.samples != 0)
      return ignore("OME-XML says " + std::to_string(ome.width) + " x " + std::to_string(ome.height) +
                    " pixels of " + std::to_string(ome.channels) + " channels, the pages have " +
                    std::to_string(page.width) + " x " + std::to_string(page.height) + " x " +
                    std::to_string(page.samples));
    const std::int64_t channels = ome.channels / page.samples;
    const auto refuse = [&](const std::string& why) {
      throwInput(name_, kDescription,
                 "OME-XML announces " + std::to_string(ome.slices) + " slices, " + std::to_string(channels) +
                     " channels and " + std::to_string(ome.frames) + " time steps, but " + why);
    };
    const auto pageCount = static_cast<std::int64_t>(file_.pages.size());
    if (ome.slices > pageCount || ome.frames > pageCount || ome.slices * ome.frames > pageCount / channels)
      refuse("the file has " + std::to_string(pageCount) + " pages" +
             (ome.elsewhere.empty() ? "" : "; others are in " + ome.elsewhere));
    std::map<std::int64_t, std::size_t> pages;
    for (std::size_t i = 0; i < file_.pages.size(); ++i) pages.emplace(file_.pages[i].index, i);
    stack_.planes.clear();
    for (const std::int64_t directory : ome.directories(channels)) {
      const auto found = pages.find(directory);
      if (found == pages.end()) refuse("names no page of this size for each");
      stack_.planes.push_back(found->second);
    }
    stack_.channels = channels;
    stack_.slices = ome.slices;
    stack_.frames = ome.frames;
    const std::size_t shown = std::set<std::size_t>(stack_.planes.begin(), stack_.planes.end()).size();
    if (shown < file_.pages.size())
      stack_.warnings.push_back(std::to_string(file_.pages.size() - shown) +
                                " pages belong to no plane of the first image and are left out");
    placeOme(ome);
  }

  void placeOme(const OmeTiff& ome) {
    if (!ome.spacing[0] || !ome.spacing[1]) return;
    glm::dvec3 size(1.0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double mm = ome.spacing[i] ? millimetresOr1(ome.units[i], "of OME-XML", stack_.warnings) : 1.0;
      size[axis] = ome.spacing[i].value_or(0.0) * mm;
    }
    if (!ome.spacing[2]) {
      size.z = size.x;
      if (stack_.slices > 1)
        stack_.warnings.push_back("OME-XML has no PhysicalSizeZ: the " + shortText(size.x) +
                                  " mm of columns " + std::string(kSliceDistanceAssumed));
    }
    place(size);
  }

  // --- Zeiss LSM: sizes in voxels from byte 8 on, in metres from byte 40 on

  void readLsm() {
    const auto at = [&]<typename T>(std::size_t byte, T) {
      return numberAt<T>(&says_.lsmInfo[byte], file_.bigEndian);
    };
    const std::int64_t slices = at(16, std::int32_t{}), frames = at(24, std::int32_t{});
    const auto pages = static_cast<std::int64_t>(file_.pages.size());
    if (slices < 1 || frames < 1 || slices * frames != pages)
      ignore("the LSM record announces " + std::to_string(slices) + " slices and " + std::to_string(frames) +
             " frames, the file has " + std::to_string(pages) + " pages");
    else
      takeAxes(kImageJAxes, {frames, slices, 1, 1, 1});
    place(1e3 * glm::dvec3(at(40, 0.0), at(48, 0.0), at(56, 0.0)));
  }

  // --- tifffile: {"shape": [2, 8, 10, 12], "axes": "TZYX"}

  void readShape() {
    const auto json = nlohmann::json::parse(says_.description, nullptr, false);
    if (!json.is_object() || !json.contains("shape") || !json["shape"].is_array()) return;
    std::vector<std::int64_t> shape;
    for (const auto& size : json["shape"])
      if (shape.push_back(size.is_number_integer() ? size.get<std::int64_t>() : 0); shape.back() < 1) return;
    const TiffPage& page = file_.pages.front();
    if (page.samples > 1 && !shape.empty() && shape.back() == page.samples) shape.pop_back();
    if (shape.size() < 3) return;
    std::int64_t planes = 1;
    for (std::size_t i = 0; i + 2 < shape.size() && planes < kMostPlanes; ++i) planes *= shape[i];
    if (planes > 1 && file_.pages.size() == 1) takeOnePage(planes, "tifffile");
    if (shape.size() == 3 && !json.contains("axes")) return;
    const auto& axes = json.contains("axes") ? json["axes"] : nlohmann::json();
    if (!axes.is_string() || !takeAxes(axes.get<std::string>(), shape))
      ignore("the description has the shape " + json["shape"].dump() + ", whose axes are not known");
  }

  // False where the axes are not among T, Z and C before Y and X.
  bool takeAxes(const std::string& axes, const std::vector<std::int64_t>& shape) {
    const std::size_t plain = axes.find("YX");
    if (plain == std::string::npos || plain + 2 != shape.size()) return false;
    std::map<char, std::int64_t> sizes{{'T', 1}, {'Z', 1}, {'C', 1}}, strides = sizes;
    std::int64_t stride = 1;
    for (std::size_t i = plain; i-- > 0;) {
      if (!sizes.contains(axes[i]) || sizes[axes[i]] != 1) return false;
      sizes[axes[i]] = shape[i];
      strides[axes[i]] = stride;
      stride *= shape[i];
    }
    if (stride != static_cast<std::int64_t>(stack_.planes.size())) return false;
    stack_.channels = sizes['C'];
    stack_.slices = sizes['Z'];
    stack_.frames = sizes['T'];
    std::size_t plane = 0;
    for (std::int64_t t = 0; t < stack_.frames; ++t)
      for (std::int64_t c = 0; c < stack_.channels; ++c)
        for (std::int64_t z = 0; z < stack_.slices; ++z)
          stack_.planes[plane++] =
              static_cast<std::size_t>(t * strides['T'] + c * strides['C'] + z * strides['Z']);
    return true;
  }

  // --- any TIFF

  void place(const glm::dvec3& sizeMm) {
    placed_ = true;
    for (int axis = 0; axis < 3; ++axis) {
      stack_.spacingMm[axis] = usableSpacing(sizeMm[axis]) ? sizeMm[axis] : 1.0;
      if (!usableSpacing(sizeMm[axis]))
        stack_.warnings.push_back("the spacing along " + std::string(1, "xyz"[axis]) + " is " +
                                  shortText(sizeMm[axis]) + " mm; " + std::string(kSpacingAssumed));
    }
  }

  // Most programs write 72 or 300 pixels per inch into any file, for printers.
  void noteNoSpacing() {
    std::string resolution;
    if (says_.xResolution > 0.0 && (says_.resolutionUnit == 2 || says_.resolutionUnit == 3))
      resolution = ", and its " + shortText(says_.xResolution) + " x " + shortText(says_.yResolution) +
                   " pixels per " + (says_.resolutionUnit == 2 ? "inch" : "cm") + " are not used";
    stack_.warnings.push_back("TIFF states no distance of slices" + resolution + "; 1 x 1 x 1 mm assumed");
  }

  void readGdal() {
    if (const auto value = realOf(trimmed(says_.noData))) stack_.noData = *value;
    const auto role = [&](const std::string& name, double& target) {
      const std::string& text = says_.gdalMetadata;
      const std::size_t at = text.find("role=\"" + name + "\""), open = text.find('>', at);
      if (at == std::string::npos || open == std::string::npos) return;
      const auto value = realOf(trimmed(
          std::string_view(text).substr(open + 1, std::min(text.find('<', open), text.size()) - open - 1)));
      if (value && std::isfinite(*value)) target = *value;
    };
    role("scale", stack_.slope);
    role("offset", stack_.intercept);
  }

  void notePixels() {
    const TiffPage& page = file_.pages.front();
    for (const std::string& record : says_.unreadRecords)
      stack_.warnings.push_back("the record of " + record + " in this file is not read");
    if (page.photometric == 0)
      stack_.warnings.push_back(
          "the file shows small numbers as white (MinIsWhite); the stored numbers are taken");
    if (page.photometric == 3)
      stack_.warnings.push_back("the file has a palette of colours; the stored numbers are taken");
    if (page.orientation > 1)
      stack_.warnings.push_back("Orientation " + std::to_string(page.orientation) +
                                " requests rotated or mirrored pages; they are read as stored");
    if (page.sampleFormat == 4)
      stack_.warnings.push_back("SampleFormat states an unknown kind of numbers; unsigned assumed");
  }

  const TiffFile& file_;
  const TiffStatements& says_;
  const std::string& name_;
  std::uint64_t fileBytes_;
  TiffStack stack_;
  bool placed_ = false;
};

}  // namespace

TiffStack tiffStackOf(const TiffFile& file, const std::string& name, std::uint64_t fileBytes) {
  return Statements(file, name, fileBytes).stack();
}

}  // namespace isolux::volume
