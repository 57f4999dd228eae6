#include "readers/hdf5/conventions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <regex>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "readers/hdf5/attributes.h"
#include "readers/hdf5/hdf5_handles.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/image_header.h"
#include "volume/read/input/text.h"
#include "volume/read/zarr/ome.h"

namespace isolux::readers {

using namespace volume;
using base::throwInput;

namespace {

constexpr std::uint64_t kMostPositions = 1000000;
constexpr const char* kMincImages = "/minc-2.0/image/";

std::string parentOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == 0 || slash == std::string::npos ? "/" : path.substr(0, slash);
}
std::string leafOf(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

std::string textOf(hid_t object, const char* name) {
  return textIn(attributesOf(object), name);
}

// "z,y,x" or, by older NeXus files, "z:y:x".
std::vector<std::string> namesIn(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(",:", at), text.size());
    names.emplace_back(trimmed(std::string_view(text).substr(at, end - at)));
    at = end + 1;
  }
  return names;
}

// A dataset with the positions of `entries` entries, or with their borders.
void readPositions(hid_t location, const std::string& path, std::uint64_t entries, AxisStatement& axis,
                   std::vector<std::string>& warnings) {
  const Hdf5Handle dataset = openedObject(location, path);
  if (!dataset) return;
  const Attributes attributes = attributesOf(dataset.get());
  axis = cfAxis(attributes, axis.name);
  ArrayStatements packing;
  readCfValues(attributes, {}, packing);
  std::vector<double> positions = numbersOfDataset(location, path, kMostPositions);
  for (double& position : positions) position = packing.slope * position + packing.intercept;
  if (positions.size() == entries + 1) {  // of histograms
    for (std::size_t i = 0; i < entries; ++i) positions[i] = 0.5 * (positions[i] + positions[i + 1]);
    positions.pop_back();
  }
  if (positions.size() == entries)
    setPositions(axis, positions);
  else
    warnings.push_back("the axis " + inQuotes(axis.name) + " has " + std::to_string(positions.size()) +
                       " positions for " + std::to_string(entries) + " entries; left out");
}

// ---- netCDF-4 ----

// The scale of each axis (HDF5 dimension scales): the first that DIMENSION_LIST refers to.
std::vector<std::string> scalesOf(hid_t dataset, std::size_t axes) {
  std::vector<std::string> paths(axes);
  if (::H5Aexists(dataset, "DIMENSION_LIST") <= 0) return paths;
  const Hdf5Handle attribute(::H5Aopen(dataset, "DIMENSION_LIST", H5P_DEFAULT));
  const Hdf5Handle space(attribute ? ::H5Aget_space(attribute.get()) : H5I_INVALID_HID);
  const Hdf5Handle stored(attribute ? ::H5Aget_type(attribute.get()) : H5I_INVALID_HID);
  if (!space || !stored || ::H5Sget_simple_extent_npoints(space.get()) != static_cast<hssize_t>(axes) ||
      ::H5Tget_class(stored.get()) != H5T_VLEN)
    return paths;
  const Hdf5Handle base(::H5Tget_super(stored.get()));
  if (!base || ::H5Tequal(base.get(), H5T_STD_REF_OBJ) <= 0) return paths;
  std::vector<hvl_t> lists(axes);
  if (::H5Aread(attribute.get(), stored.get(), lists.data()) < 0) return paths;
  for (std::size_t i = 0; i < axes; ++i) {
    if (lists[i].len == 0) continue;
    const Hdf5Handle scale(::H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, lists[i].p));
    std::array<char, 1024> path{};
    if (scale && ::H5Iget_name(scale.get(), path.data(), path.size()) > 0) paths[i] = path.data();
  }
  ::H5Dvlen_reclaim(stored.get(), space.get(), H5P_DEFAULT, lists.data());
  return paths;
}

void readScales(hid_t file, hid_t dataset, const Candidate& chosen, ArrayStatements& statements) {
  const std::vector<std::string> scales = scalesOf(dataset, chosen.dims.size());
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (scales[i].empty()) continue;
    const Hdf5Handle scale = openedObject(file, scales[i]);
    // netCDF's mark of a dimension that has no positions.
    const bool named =
        scale && !textOf(scale.get(), "NAME").starts_with("This is a netCDF dimension but not");
    statements.axes[i].name = leafOf(scales[i]);
    if (named) readPositions(file, scales[i], chosen.dims[i], statements.axes[i], statements.warnings);
  }
}

void readNetCdfFill(hid_t file, const Attributes& attributes, const FileNumber& number,
                    ArrayStatements& statements) {
  const Hdf5Handle root = openedObject(file, "/");
  const bool netCdf = attributes.contains("_Netcdf4Dimid") || attributes.contains("_Netcdf4Coordinates") ||
                      (root && ::H5Aexists(root.get(), "_NCProperties") > 0);
  const auto fill = netCdfFill(number);
  if (netCdf && fill && !attributes.contains("_FillValue")) statements.missing.values.push_back(*fill);
}

// ---- NeXus ----

void readNeXus(hid_t file, const Candidate& chosen, ArrayStatements& statements) {
  const Hdf5Handle group = openedObject(file, parentOf(chosen.path));
  if (!group || textOf(group.get(), "NX_class") != "NXdata") return;
  std::vector<std::string> names = textsOfAttribute(group.get(), "axes");
  if (names.size() == 1) names = namesIn(names.front());
  if (names.size() == chosen.dims.size())
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == "." || names[i].empty()) continue;
      statements.axes[i].name = names[i];
      readPositions(group.get(), names[i], chosen.dims[i], statements.axes[i], statements.warnings);
    }
  const auto number = [&](const char* what, double otherwise) {
    std::vector<double> values = numbersOfDataset(group.get(), leafOf(chosen.path) + "_" + what, 1);
    if (values.empty()) values = numbersOfDataset(group.get(), what, 1);
    return values.empty() ? otherwise : values.front();
  };
  const double slope = number("scaling_factor", 1.0), offset = number("offset", 0.0);
  if (slope == 0.0 || !std::isfinite(slope) || !std::isfinite(offset)) {
    statements.warnings.emplace_back("scaling_factor and offset cannot be applied; left out");
    return;
  }
  statements.slope *= slope;
  statements.intercept = statements.intercept * slope + offset;
}

// ---- MINC 2 ----

// The world of MINC is RAS: x and y change sign.
void readMincAxis(hid_t file, AxisStatement& axis) {
  const Hdf5Handle dimension = openedObject(file, "/minc-2.0/dimensions/" + axis.name);
  static constexpr std::array<const char*, 3> names = {"xspace", "yspace", "zspace"};
  const auto found = std::ranges::find(names, axis.name);
  if (!dimension || found == names.end()) return;
  const auto step = numbersOfAttribute(dimension.get(), "step"),
             start = numbersOfAttribute(dimension.get(), "start");
  auto cosines = numbersOfAttribute(dimension.get(), "direction_cosines");
  if (cosines.size() != 3) {
    cosines.assign(3, 0.0);
    cosines[static_cast<std::size_t>(found - names.begin())] = 1.0;
  }
  const glm::dvec3 direction(-cosines[0], -cosines[1], cosines[2]);
  const double length = glm::length(direction);
  axis.step = step.empty() ? 1.0 : step.front();  // both by the format
  axis.first = start.empty() ? 0.0 : start.front();
  axis.unit = textOf(dimension.get(), "units");
  if (axis.unit.empty()) axis.unit = "mm";
  if (length > 0.0 && std::isfinite(length)) axis.direction = direction / length;
  if (textOf(dimension.get(), "spacing").starts_with("irregular")) axis.deviation = 1.0;
}

// value = image-min + (stored - valid minimum) / (valid maximum - valid minimum) * (image-max - image-min).
void readMincScaling(hid_t file, hid_t dataset, const Candidate& chosen, const std::string& name,
                     ArrayStatements& statements) {
  if (chosen.number.type == VoxelType::float32 || chosen.number.type == VoxelType::float64) return;
  const std::string group = parentOf(chosen.path);
  const auto minima = numbersOfDataset(file, group + "/image-min", kMostPositions),
             maxima = numbersOfDataset(file, group + "/image-max", kMostPositions);
  const std::vector<double> ofType = withType(chosen.number.type, []<class T>(T) {
    return std::vector<double>{static_cast<double>(std::numeric_limits<T>::lowest()),
                               static_cast<double>(std::numeric_limits<T>::max())};
  });
  auto range = numbersOfAttribute(dataset, "valid_range");
  if (range.size() != 2) range = ofType;
  if (range[0] > range[1]) std::swap(range[0], range[1]);
  if (range[0] > ofType[0]) statements.missing.least = range[0];
  if (range[1] < ofType[1]) statements.missing.greatest = range[1];
  if (minima.empty() && maxima.empty()) return;
  std::uint64_t axes = 0, places = 1;
  while (places < minima.size() && axes < chosen.dims.size()) places *= chosen.dims[axes++];
  if (minima.size() != maxima.size() || places != minima.size() || !(range[1] > range[0]))
    throwInput(name, group + "/image-min", "image-min, image-max and valid_range do not fit the image");
  std::vector<double> slopes, intercepts;
  for (std::size_t i = 0; i < minima.size(); ++i) {
    slopes.push_back((maxima[i] - minima[i]) / (range[1] - range[0]));
    intercepts.push_back(minima[i] - range[0] * slopes.back());
  }
  if (places == 1 && slopes[0] != 0.0 && std::isfinite(slopes[0]) && std::isfinite(intercepts[0])) {
    statements.slope = slopes[0];
    statements.intercept = intercepts[0];
  } else {
    statements.slices = {axes, std::move(slopes), std::move(intercepts)};
  }
}

void readMinc(hid_t file, hid_t dataset, const Candidate& chosen, const std::string& name,
              ArrayStatements& statements) {
  const std::vector<std::string> names = namesIn(textOf(dataset, "dimorder"));
  if (names.size() == chosen.dims.size())
    for (std::size_t i = 0; i < names.size(); ++i) {
      statements.axes[i].name = names[i];
      // Lower resolutions have steps of their own, which the file does not state.
      if (chosen.path.starts_with(std::string(kMincImages) + "0/")) readMincAxis(file, statements.axes[i]);
    }
  statements.anatomical =
      std::ranges::any_of(statements.axes, [](const AxisStatement& axis) { return axis.step.has_value(); });
  readMincScaling(file, dataset, chosen, name, statements);
}

// ---- VTKHDF ----

void readVtkHdf(hid_t group, Candidate& chosen, const std::string& name, ArrayStatements& statements) {
  const std::string type = textOf(group, "Type");
  if (type != "ImageData")
    throwInput(name, "/VTKHDF",
               "its type " + inQuotes(type) +
                   " is not a regular volume; save it as ImageData (ParaView: Resample To Image)");
  const bool cells = chosen.path.starts_with("/VTKHDF/CellData/");
  const auto extent = numbersOfAttribute(group, "WholeExtent"),
             spacing = numbersOfAttribute(group, "Spacing"), origin = numbersOfAttribute(group, "Origin"),
             direction = numbersOfAttribute(group, "Direction");
  if (extent.size() != 6) throwInput(name, "/VTKHDF WholeExtent", "is not six whole numbers");
  const bool timed = ::H5Lexists(group, "Steps", H5P_DEFAULT) > 0;
  const std::size_t first = timed ? 1 : 0, axes = chosen.dims.size();
  if (axes < first + 3 || axes > first + 4) throwInput(name, chosen.path, "has not the axes of an image");
  glm::dvec3 corner(0.0);
  statements.originMm = origin.size() == 3 ? glm::dvec3(origin[0], origin[1], origin[2]) : glm::dvec3(0.0);
  if (timed) statements.axes[0].name = "t";
  if (axes == first + 4) statements.axes[first + 3].name = "c";
  for (std::size_t d = 0; d < 3; ++d) {
    AxisStatement& axis = statements.axes[first + 2 - d];
    const double points = extent[2 * d + 1] - extent[2 * d] + 1.0,
                 wanted = cells ? std::max(points - 1.0, 1.0) : points;
    if (static_cast<double>(chosen.dims[first + 2 - d]) != wanted)
      throwInput(name, chosen.path,
                 "has " + std::to_string(chosen.dims[first + 2 - d]) + " entries along " +
                     std::string(1, "xyz"[d]) + ", WholeExtent says " + base::shortText(wanted));
    axis.name = std::string(1, "xyz"[d]);
    axis.unit = "mm";  // by convention, as of .vti
    axis.step = spacing.size() == 3 ? spacing[d] : 1.0;
    axis.first = *axis.step * (extent[2 * d] + (cells && points > 1.0 ? 0.5 : 0.0));
    if (direction.size() == 9) axis.direction = {direction[d], direction[3 + d], direction[6 + d]};
  }
  if (cells) statements.warnings.emplace_back(kValuesOfCells);
}

// ---- Imaris ----

struct ImarisPlace {
  int level = 0, time = 0, channel = 0;
};

std::string imarisPath(ImarisPlace place) {
  return "/DataSet/ResolutionLevel " + std::to_string(place.level) + "/TimePoint " +
         std::to_string(place.time) + "/Channel " + std::to_string(place.channel) + "/Data";
}

std::optional<ImarisPlace> imarisPlaceOf(const std::string& path) {
  static const std::regex pattern(
      R"(/DataSet/ResolutionLevel (\d{1,6})/TimePoint (\d{1,6})/Channel (\d{1,6})/Data)");
  std::smatch found;
  if (!std::regex_match(path, found, pattern)) return std::nullopt;
  const ImarisPlace place{std::stoi(found[1]), std::stoi(found[2]), std::stoi(found[3])};
  return imarisPath(place) == path ? std::optional(place) : std::nullopt;
}

// Imaris writes numbers as texts, a letter each.
std::optional<double> imarisNumber(const Attributes& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return std::nullopt;
  if (!found->second.numbers.empty()) return found->second.numbers.front();
  return realOf(trimmed(found->second.text));
}

void readImaris(hid_t file, const Candidate& chosen, ArrayStatements& statements) {
  const Hdf5Handle info = openedObject(file, "/DataSetInfo/Image");
  const Attributes said = info ? attributesOf(info.get()) : Attributes();
  const ImarisImage image = imarisImage(file, chosen, true);
  std::string unit(trimmed(textIn(said, "Unit")));
  for (std::size_t d = 0; d < 3; ++d) {
    AxisStatement& axis = statements.axes[2 - d];
    axis.name = std::string(1, "xyz"[d]);
    const auto low = imarisNumber(said, "ExtMin" + std::to_string(d)),
               high = imarisNumber(said, "ExtMax" + std::to_string(d));
    if (!low || !high) continue;
    axis.unit = unit;
    axis.step = (*high - *low) / static_cast<double>(image.dims[2 - d]);
    axis.first = *low + 0.5 * *axis.step;  // the extents are outer faces
  }
  std::string names;
  for (int channel = 0; channel < 100; ++channel) {
    const Hdf5Handle described = openedObject(file, "/DataSetInfo/Channel " + std::to_string(channel));
    if (!described) break;
    names += (channel > 0 ? ", " : "") + textOf(described.get(), "Name");
  }
  if (!names.empty()) statements.warnings.push_back("channels are " + inQuotes(names));
}

// ---- ilastik ----

// vigra's axistags: {"axes": [{"key": "z", ...}, ...]}; else HDF5's labels of dimensions.
std::vector<std::string> axisNamesOf(hid_t dataset, std::size_t axes) {
  std::vector<std::string> names;
  const nlohmann::json json = nlohmann::json::parse(textOf(dataset, "axistags"), nullptr, false);
  if (json.is_object() && json.contains("axes") && json["axes"].is_array())
    for (const auto& axis : json["axes"])
      names.push_back(axis.is_object() ? axis.value("key", nlohmann::json("")).dump() : "");
  for (std::string& name : names) std::erase(name, '"');
  if (names.size() != axes) names = textsOfAttribute(dataset, "DIMENSION_LABELS");
  if (names.size() != axes) names.clear();
  return names;
}

// Sizes of z, y and x, whatever other axes there are.
void readElementSizes(hid_t dataset, ArrayStatements& statements) {
  const std::vector<double> sizes = numbersOfAttribute(dataset, "element_size_um");
  if (sizes.empty()) return;
  const std::size_t axes = statements.axes.size();
  if (sizes.size() != 3 || axes < 2) {
    statements.warnings.push_back("element_size_um has " + std::to_string(sizes.size()) +
                                  " numbers instead of three; left out");
    return;
  }
  std::vector<std::uint64_t> dims(axes, 1);
  const ArrayAxes roles = axesNamed(namesOf(statements.axes), dims, "", "");
  const std::optional<std::size_t> space[] = {roles.z, roles.y, roles.x};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!space[i]) continue;
    AxisStatement& axis = statements.axes[*space[i]];
    const auto mm = axis.step ? millimetresIn(axis.unit) : std::nullopt;
    if (mm && std::abs(std::abs(*axis.step) * *mm - 1e-3 * sizes[i]) > 1e-5 * std::abs(sizes[i]))
      statements.warnings.push_back("element_size_um contradicts the positions of the axis " +
                                    inQuotes(axis.name) + "; element_size_um is used");
    if (mm) axis.first *= *mm * 1e3;  // in micrometres from here on
    if (!mm) axis.first = 0.0;
    axis.unit = "um";
    axis.step = axis.step && *axis.step < 0.0 ? -sizes[i] : sizes[i];
  }
}

}  // namespace

std::string preferredOf(hid_t file) {
  std::string path;
  if (const Hdf5Handle data = openedObject(file, "/VTKHDF")) {
    for (const char* kind : {"PointData", "CellData"})
      if (const Hdf5Handle arrays = openedObject(data.get(), kind); arrays && path.empty())
        if (const std::string scalars = textOf(arrays.get(), "Scalars"); !scalars.empty())
          path = "/VTKHDF/" + std::string(kind) + "/" + scalars;
  } else {
    std::string group;
    for (int depth = 0; depth < 4; ++depth) {
      const Hdf5Handle here = openedObject(file, group.empty() ? "/" : group);
      if (!here) break;
      if (const std::string signal = textOf(here.get(), "signal"); !signal.empty())
        path = signal.starts_with('/') ? signal : group + "/" + signal;
      const std::string next = textOf(here.get(), "default");
      if (next.empty()) break;
      group = next.starts_with('/') ? next : group + "/" + next;
    }
  }
  return path;
}

ArrayStatements statementsOf(hid_t file, Candidate& chosen, const std::string& name) {
  const Hdf5Handle dataset = openedObject(file, chosen.path);
  ArrayStatements statements;
  statements.axes.resize(chosen.dims.size());
  if (!dataset) return statements;
  const Attributes attributes = attributesOf(dataset.get());
  if (const Hdf5Handle group = openedObject(file, "/VTKHDF"); group && chosen.path.starts_with("/VTKHDF/")) {
    readVtkHdf(group.get(), chosen, name, statements);
  } else if (chosen.path.starts_with(kMincImages)) {
    readMinc(file, dataset.get(), chosen, name, statements);
  } else if (imarisPlaceOf(chosen.path) && chosen.dims.size() == 3) {
    readImaris(file, chosen, statements);
  } else {
    chosen.number = withSign(attributes, chosen.number);
    readCfValues(attributes, chosen.number, statements);
    readNetCdfFill(file, attributes, chosen.number, statements);
    readScales(file, dataset.get(), chosen, statements);
    readNeXus(file, chosen, statements);
  }
  const std::vector<std::string> names = axisNamesOf(dataset.get(), chosen.dims.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) statements.axes[i].name = names[i];
  readElementSizes(dataset.get(), statements);
  return statements;
}

ImarisImage imarisImage(hid_t file, const Candidate& chosen, bool alone) {
  ImarisImage image;
  const auto place = imarisPlaceOf(chosen.path);
  if (!place || chosen.dims.size() != 3) return image;
  constexpr int most = 100000;
  const auto exists = [&](ImarisPlace p) {
    return static_cast<bool>(openedObject(file, parentOf(imarisPath(p))));
  };
  int times = 1, channels = 1;
  if (!alone) {
    while (times < most && exists({place->level, times, 0})) ++times;
    while (channels < most && exists({place->level, 0, channels})) ++channels;
  }
  for (int time = 0; time < times; ++time)
    for (int channel = 0; channel < channels; ++channel)
      image.datasets.push_back(alone ? chosen.path : imarisPath({place->level, time, channel}));
  image.times = static_cast<std::uint64_t>(times);
  image.channels = static_cast<std::uint64_t>(channels);
  const Hdf5Handle group = openedObject(file, parentOf(chosen.path)),
                   info = openedObject(file, "/DataSetInfo/Image");
  const Attributes own = group ? attributesOf(group.get()) : Attributes(),
                   whole = info && place->level == 0 ? attributesOf(info.get()) : Attributes();
  image.dims = chosen.dims;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::string letter(1, "XYZ"[d]);
    auto size = imarisNumber(own, "ImageSize" + letter);
    if (!size) size = imarisNumber(whole, letter);
    if (size && *size >= 1.0 && *size < static_cast<double>(chosen.dims[2 - d]))
      image.dims[2 - d] = static_cast<std::uint64_t>(*size);
  }
  return image;
}

}  // namespace isolux::readers
