#include "volume/read/tiff/ome_tiff.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "volume/read/input/text.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr const char* kOmeXml = "ImageDescription (OME-XML)";

class OmeParser {
 public:
  explicit OmeParser(const std::string& file) : file_(file) {}

  OmeTiff parse(const std::string& xml) {
    Tags tags(xml, file_);
    int images = 0;
    while (const auto tag = tags.next()) {
      const std::string_view name = tag->name.substr(tag->name.find(':') + 1);  // "OME:Pixels", too
      if (name == "Image") ++images;
      if (name == "BinaryOnly") noteCompanion(*tag);
      if (images > 1) continue;
      if (name == "Pixels") readPixels(*tag);
      if (name == "TiffData") readPlanes(*tag);
      if (name == "UUID" && !ome_.planes.empty())
        ome_.planes.back().file = tag->find("FileName").value_or("");
    }
    if (images > 1)
      ome_.warnings.push_back("OME-XML describes " + std::to_string(images) + " images; the first is shown");
    leaveOtherFiles();
    return std::move(ome_);
  }

 private:
  std::int64_t number(const Tag& tag, const char* key, std::int64_t least) const {
    const auto text = tag.find(key);
    if (!text) return least;
    const auto value = integerOf(*text);
    if (!value || *value < least || *value > (std::int64_t{1} << 31))
      throwInput(file_, kOmeXml, std::string(key) + " " + inQuotes(*text) + " is not a count");
    return *value;
  }

  void noteCompanion(const Tag& tag) {
    ome_.warnings.push_back("channels, slices and distances are stated in another file (" +
                            std::string(tag.find("MetadataFile").value_or("?")) +
                            "), which is not read; the pages are taken as slices");
  }

  void readPixels(const Tag& tag) {
    ome_.known = true;
    ome_.width = number(tag, "SizeX", 1);
    ome_.height = number(tag, "SizeY", 1);
    ome_.slices = number(tag, "SizeZ", 1);
    ome_.channels = number(tag, "SizeC", 1);
    ome_.frames = number(tag, "SizeT", 1);
    if (const auto order = tag.find("DimensionOrder")) ome_.order = *order;
    std::string sorted = ome_.order;
    std::ranges::sort(sorted);
    if (sorted != "CTXYZ" || !ome_.order.starts_with("XY"))
      throwInput(file_, kOmeXml, "DimensionOrder " + inQuotes(ome_.order) + " is not known");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string key = std::string("PhysicalSize") + "XYZ"[axis];
      if (const auto text = tag.find(key)) ome_.spacing[axis] = realOf(*text);
      if (const auto unit = tag.find(key + "Unit")) ome_.units[axis] = *unit;
    }
  }

  void readPlanes(const Tag& tag) {
    OmeTiff::Planes planes;
    if (tag.find("IFD")) planes.directory = number(tag, "IFD", 0);
    if (tag.find("PlaneCount")) planes.count = number(tag, "PlaneCount", 0);
    planes.slice = number(tag, "FirstZ", 0);
    planes.channel = number(tag, "FirstC", 0);
    planes.frame = number(tag, "FirstT", 0);
    ome_.planes.push_back(planes);
  }

  // A file that was renamed is the only one that the XML names.
  void leaveOtherFiles() {
    std::set<std::string> names;
    for (const auto& planes : ome_.planes) names.insert(planes.file);
    if (names.size() < 2) return;
    const std::string own = std::filesystem::path(file_).filename().string();
    for (const std::string& name : names)
      if (name != own) ome_.elsewhere = name;
    std::erase_if(ome_.planes, [&](const auto& planes) { return planes.file != own; });
    if (ome_.planes.empty()) throwInput(file_, kOmeXml, "no plane is in this file, but in " + ome_.elsewhere);
  }

  const std::string& file_;
  OmeTiff ome_;
};

}  // namespace

std::vector<std::int64_t> OmeTiff::directories(std::int64_t pageChannels) const {
  const std::int64_t total = slices * pageChannels * frames;
  // Planes in the order of the file: `order` without "XY".
  const auto sizeOf = [&](char axis) { return axis == 'Z' ? slices : axis == 'C' ? pageChannels : frames; };
  const std::int64_t samples = channels / pageChannels;
  std::int64_t strides[3];  // of slice, channel, frame
  const auto strideOf = [&](char axis) {
    std::int64_t stride = 1;
    for (std::size_t i = 2; order[i] != axis; ++i) stride *= sizeOf(order[i]);
    return stride;
  };
  for (int i = 0; i < 3; ++i) strides[i] = strideOf("ZCT"[i]);
  std::vector<std::int64_t> byOrder(static_cast<std::size_t>(total), -1);
  const std::vector<Planes> all{Planes{}};
  for (const Planes& some : planes.empty() ? all : planes) {
    const std::int64_t channel = some.channel / samples;
    if (some.slice >= slices || channel >= pageChannels || some.frame >= frames) continue;
    const std::int64_t first = some.slice * strides[0] + channel * strides[1] + some.frame * strides[2];
    const std::int64_t count = some.count.value_or(some.directory ? 1 : total);
    for (std::int64_t i = 0; i < count && first + i < total; ++i)
      byOrder[static_cast<std::size_t>(first + i)] = some.directory.value_or(0) + i;
  }
  std::vector<std::int64_t> result;
  result.reserve(byOrder.size());
  for (std::int64_t t = 0; t < frames; ++t)
    for (std::int64_t c = 0; c < pageChannels; ++c)
      for (std::int64_t z = 0; z < slices; ++z)
        result.push_back(byOrder[static_cast<std::size_t>(z * strides[0] + c * strides[1] + t * strides[2])]);
  return result;
}

OmeTiff parseOmeTiff(const std::string& xml, const std::string& name) {
  try {
    return OmeParser(name).parse(xml);
  } catch (const base::Error& error) {
    throwInput(name, kOmeXml, error.reason());
  }
}

}  // namespace isolux::volume
