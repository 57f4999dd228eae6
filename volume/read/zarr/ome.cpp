#include "volume/read/zarr/ome.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"
#include "volume/read/zarr/ome_labels.h"

namespace isolux::volume {

namespace {

struct OmeAxis {
  std::string name, type, unit;
};

std::vector<OmeAxis> axesOf(const JsonField& image) {
  std::vector<OmeAxis> axes;
  if (!image.has("axes"))  // before 0.3: always these
    return {
        {"t", "time", ""}, {"c", "channel", ""}, {"z", "space", ""}, {"y", "space", ""}, {"x", "space", ""}};
  for (const JsonField& axis : image.at("axes").entries()) {
    if (axis.value().is_string())
      axes.push_back({axis.text(), "", ""});
    else
      axes.push_back({axis.at("name").text(), axis.text("type", ""), axis.text("unit", "")});
  }
  if (axes.size() < 2 || axes.size() > kMostArrayAxes)
    image.at("axes").refuse("has " + std::to_string(axes.size()) + " axes; 2 to 8 are read");
  for (OmeAxis& axis : axes) {
    if (!axis.type.empty()) continue;
    const std::string name = lowered(axis.name);
    axis.type = name == "t" ? "time" : name == "c" ? "channel" : "space";
  }
  return axes;
}

void setOnce(std::optional<std::size_t>& axis, std::size_t index, const JsonField& field, const char* what) {
  if (axis) field.refuse(std::string("has two axes for ") + what);
  axis = index;
}

// Spatial axes by their names where these are x, y and z, else the last is x.
void placeSpace(const std::vector<OmeAxis>& list, const std::vector<std::size_t>& space,
                const JsonField& field, ArrayAxes& axes) {
  if (space.size() < 2 || space.size() > 3) field.refuse("has not two or three axes of space");
  std::array<std::optional<std::size_t>*, 3> slots = {&axes.x, &axes.y, &axes.z};
  const auto slotNamed = [&](std::size_t axis) { return std::string("xyz").find(lowered(list[axis].name)); };
  const bool named = std::ranges::all_of(space, [&](std::size_t axis) {
    return list[axis].name.size() == 1 && slotNamed(axis) != std::string::npos;
  });
  for (std::size_t i = 0; i < space.size(); ++i) {
    const std::size_t slot = named ? slotNamed(space[i]) : space.size() - 1 - i;
    setOnce(*slots[slot], space[i], field, "one direction");
  }
  if (!axes.x || !axes.y) field.refuse("has no axes x and y");
}

ArrayAxes rolesOf(const std::vector<OmeAxis>& list, const JsonField& field) {
  ArrayAxes axes;
  std::vector<std::size_t> space;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].type == "space")
      space.push_back(i);
    else if (list[i].type == "time")
      setOnce(axes.time, i, field, "time");
    else
      setOnce(axes.channel, i, field, "channels");
  }
  placeSpace(list, space, field, axes);
  return axes;
}

// p -> scale * p + translation, by axis.
struct AxisTransform {
  std::vector<double> scale, translation;
  bool scaled = false, placed = false;
};

void append(const JsonField& list, AxisTransform& transform) {
  const std::size_t count = transform.scale.size();
  for (const JsonField& step : list.entries()) {
    const std::string type = step.at("type").text();
    if (type == "identity") continue;
    if (type != "scale" && type != "translation")
      step.refuse("the transformation " + inQuotes(type) + " is not read; scale and translation are");
    const std::vector<double> values = step.at(type.c_str()).numbers(count);
    for (std::size_t axis = 0; axis < count; ++axis) {
      if (type == "scale") {
        transform.scale[axis] *= values[axis];
        transform.translation[axis] *= values[axis];
      } else {
        transform.translation[axis] += values[axis];
      }
    }
    transform.scaled = transform.scaled || type == "scale";
    transform.placed = transform.placed || type == "translation";
  }
}

// Since version 0.5 all is under "ome".
JsonField rootOf(const nlohmann::json& attributes, const std::string& file) {
  const bool inOme = attributes.contains("ome") && attributes["ome"].is_object();
  return {inOme ? attributes["ome"] : attributes, file, inOme ? "ome" : ""};
}

// What the channels are called ("omero"), as a warning says it; "" where they have no names.
std::string channelNames(const JsonField& root) {
  std::string names;
  if (!root.has("omero") || !root.at("omero").has("channels")) return names;
  for (const auto& channel : root.at("omero").at("channels").value()) {
    const auto label = channel.is_object() ? channel.value("label", nlohmann::json()) : nlohmann::json();
    if (label.is_string()) names += (names.empty() ? "" : ", ") + label.get<std::string>();
  }
  return names.empty() ? names : "channels are " + inQuotes(names);
}

std::string safePath(const JsonField& field) {
  const std::string text = field.text();
  const std::filesystem::path path(text);
  const bool out = std::ranges::any_of(path, [](const auto& part) { return part == ".."; });
  if (path.is_absolute() || out || text.find('\0') != std::string::npos)
    field.refuse("leaves the folder of the image");
  return text == "." ? "" : text;
}

}  // namespace

std::optional<OmeImage> parseOme(const nlohmann::json& attributes, const std::string& file) {
  const JsonField root = rootOf(attributes, file);
  const bool inOme = !root.place().empty();
  if (!root.has("multiscales")) return std::nullopt;
  const std::vector<JsonField> images = root.at("multiscales").entries();
  if (images.empty()) root.at("multiscales").refuse("is empty");
  const JsonField& image = images.front();
  OmeImage ome;
  ome.version = inOme ? root.text("version", "0.5") : image.text("version", "0.4");
  ome.name = image.text("name", "");
  if (images.size() > 1)
    ome.warnings.push_back(std::to_string(images.size()) + " multiscales; the first is shown");
  if (const std::string names = channelNames(root); !names.empty()) ome.warnings.push_back(names);
  if (auto labels = imageLabelsOf(root)) ome.labels = std::make_shared<const LabelTable>(std::move(*labels));
  const std::vector<OmeAxis> axes = axesOf(image);
  ome.axisCount = axes.size();
  ome.axes = rolesOf(axes, image.has("axes") ? image.at("axes") : image);
  const std::vector<std::optional<std::size_t>> space = {ome.axes.x, ome.axes.y, ome.axes.z};
  for (const JsonField& dataset : image.at("datasets").entries()) {
    AxisTransform transform{std::vector<double>(axes.size(), 1.0), std::vector<double>(axes.size(), 0.0)};
    if (dataset.has("coordinateTransformations")) append(dataset.at("coordinateTransformations"), transform);
    if (image.has("coordinateTransformations")) append(image.at("coordinateTransformations"), transform);
    if (!transform.scaled && ome.levels.empty())
      ome.warnings.push_back("the image does not state the voxel size; " + std::string(kSpacingAssumed));
    OmeLevel level{safePath(dataset.at("path")), glm::dvec3(1.0), glm::dvec3(0.0), transform.placed};
    for (std::size_t direction = 0; direction < 3; ++direction) {
      if (!space[direction]) continue;
      const double unit =
          transform.scaled ? millimetresOr1(axes[*space[direction]].unit, "", ome.warnings) : 1.0;
      const auto axis = static_cast<int>(direction);
      level.spacingMm[axis] = transform.scale[*space[direction]] * unit;
      level.originMm[axis] = transform.translation[*space[direction]] * unit;
    }
    ome.levels.push_back(std::move(level));
    if (ome.levels.size() > 64) image.at("datasets").refuse("has more than 64 levels");
  }
  if (ome.levels.empty()) image.at("datasets").refuse("is empty");
  return ome;
}

std::vector<std::string> wellsOf(const nlohmann::json& attributes, const std::string& file) {
  const JsonField root = rootOf(attributes, file);
  std::vector<std::string> wells;
  if (root.has("plate"))
    for (const JsonField& well : root.at("plate").at("wells").entries())
      wells.push_back(safePath(well.at("path")));
  return wells;
}

ArrayAxes axesNamed(const std::vector<std::string>& names, const std::vector<std::uint64_t>& dims,
                    const std::string& file, const std::string& place) {
  ArrayAxes axes;
  const std::pair<std::vector<std::string>, std::optional<std::size_t>*> known[] = {
      {{"x", "xspace", "lon", "longitude"}, &axes.x},
      {{"y", "yspace", "lat", "latitude"}, &axes.y},
      {{"z", "zspace", "lev", "level", "depth", "height", "altitude", "plev"}, &axes.z},
      {{"t", "time"}, &axes.time},
      {{"c", "channel", "band", "vector_dimension"}, &axes.channel}};
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < dims.size(); ++i) {
    const std::string name = i < names.size() ? lowered(names[i]) : "";
    const auto found = std::find_if(std::begin(known), std::end(known), [&](const auto& row) {
      return std::ranges::find(row.first, name) != row.first.end();
    });
    if (found == std::end(known) || *found->second)
      others.push_back(i);
    else
      *found->second = i;
  }
  const auto takeLast = [&](std::optional<std::size_t>& axis) {
    if (axis || others.empty()) return;
    axis = others.back();
    others.pop_back();
  };
  const bool named = axes.x && axes.y;
  if (!named) {  // names say nothing: by place
    axes = ArrayAxes();
    others.resize(dims.size());
    std::iota(others.begin(), others.end(), std::size_t{0});
    takeLast(axes.x);
    takeLast(axes.y);
  }
  takeLast(axes.z);
  if (others.size() > 1) takeLast(axes.channel);
  takeLast(axes.time);
  if (!axes.x || !axes.y)
    base::throwInput(file, place, "the array has one axis; two or three of space are needed");
  for (const std::size_t axis : others)
    if (dims[axis] != 1)
      base::throwInput(file, place,
                       "it is not known what axis " + std::to_string(axis) + " of " +
                           std::to_string(dims[axis]) + " entries is; x, y, z, time and channel are read");
  return axes;
}

}  // namespace isolux::volume
