#include "gi/file/bake_header.h"

#include <cinttypes>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "volume/read/input/text.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::gi {

using base::throwInput;

namespace {

constexpr std::size_t kHeaderWithin = std::size_t{1} << 20;

// A text as VTK writes it: the codes of its characters, then 0.
std::string textOf(std::string_view codes, const std::string& file, const std::string& place) {
  const auto numbers = volume::integersOf(codes);
  if (!numbers || numbers->empty() || numbers->back() != 0) throwInput(file, place, "is not text");
  std::string text;
  for (std::size_t i = 0; i + 1 < numbers->size(); ++i) {
    if ((*numbers)[i] < 1 || (*numbers)[i] > 255) throwInput(file, place, "is not text");
    text += static_cast<char>((*numbers)[i]);
  }
  return text;
}

}  // namespace

const std::string* BakeHeader::field(const std::string& name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? nullptr : &found->second;
}

std::string bakeTextField(const std::string& name, const std::string& text) {
  std::string xml =
      "      <Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"1\" format=\"ascii\">\n       ";
  for (const char c : text) xml += ' ' + std::to_string(static_cast<unsigned char>(c));
  return xml + " 0\n      </Array>\n";
}

BakeHeader readBakeHeader(const volume::Bytes& bytes) {
  const std::string& file = bytes.name();
  std::string text = bytes.head(kHeaderWithin);
  const std::size_t appended = text.find("<AppendedData");
  const std::size_t mark = appended == std::string::npos ? appended : text.find('_', appended);
  if (mark == std::string::npos)
    throwInput(file, "AppendedData", "is not a file of light, or truncated: the data do not start");
  BakeHeader header;
  header.appendedAt = mark + 1;
  text.resize(mark);

  volume::Tags tags(text, file);
  bool zlib = false;
  while (const auto tag = tags.next()) {
    const auto attribute = [&](std::string_view key) { return std::string(tag->find(key).value_or("")); };
    if (tag->name == "VTKFile") {
      zlib = attribute("type") == "ImageData" && attribute("byte_order") == "LittleEndian" &&
             attribute("header_type") == "UInt64" && attribute("compressor") == "vtkZLibDataCompressor";
    } else if (tag->name == "ImageData") {
      const auto extent = volume::integersOf(attribute("WholeExtent"));
      if (!extent || extent->size() != 6)
        throwInput(file, "ImageData WholeExtent", "is not six whole numbers");
      for (std::size_t a = 0; a < 3; ++a) {
        const std::int64_t last = (*extent)[2 * a + 1];
        if ((*extent)[2 * a] != 0 || last < 0 || last >= 1 << 24)
          throwInput(file, "ImageData WholeExtent", "is not that of a light lattice");
        header.dims[static_cast<int>(a)] = static_cast<int>(last) + 1;
      }
    } else if (tag->name == "Array") {
      const std::size_t close = text.find("</Array", tag->end);
      if (close == std::string::npos)
        throwInput(file, "Array " + attribute("Name"), "truncated: is not closed");
      header.fields[attribute("Name")] = textOf(std::string_view(text).substr(tag->end, close - tag->end),
                                                file, "Array " + attribute("Name"));
    } else if (tag->name == "DataArray") {
      const auto components = volume::integerOf(attribute("NumberOfComponents"));
      const auto offset = volume::integerOf(attribute("offset"));
      if (!components || !offset || *components < 1 || *offset < 0 || attribute("format") != "appended")
        throwInput(file, "DataArray " + attribute("Name"), "is not as this program writes it");
      header.arrays[attribute("Name")] = {attribute("type"), *components, *offset};
    }
  }
  if (!zlib) throwInput(file, "VTKFile", "is not a file of light as this program writes it");
  if (header.dims.x < 1) throwInput(file, "ImageData", "is missing");
  if (!header.fields.contains("volume_hash"))
    throwInput(file, "Array volume_hash", "is missing: this is not a file of light");
  return header;
}

BakeFacts bakeFactsOf(const BakeHeader& header, const std::string& file) {
  BakeFacts facts;
  if (const std::string* arithmetic = header.field("arithmetic")) facts.arithmetic = *arithmetic;
  const std::string* part = header.field("part");
  if (!part) return facts;
  const nlohmann::json text = nlohmann::json::parse(*part, nullptr, false);
  const auto integer = [&](const char* name) {
    return text.is_object() && text.contains(name) && text[name].is_number_integer()
               ? text[name].get<std::int64_t>()
               : -1;
  };
  const std::int64_t index = integer("part"), count = integer("of"), samples = integer("samples");
  if (index < 1 || count < index || count > kMostParts || samples < 1 || samples > 0xffffffff ||
      !text.contains("texels") || !text["texels"].is_string() || !text.contains("complete") ||
      !text["complete"].is_boolean())
    throwInput(file, "Array part", "does not describe a part of a bake");
  facts.part = {{static_cast<int>(index), static_cast<int>(count)},
                static_cast<std::uint32_t>(samples),
                text["texels"],
                text["complete"]};
  return facts;
}

std::vector<std::size_t> offsetsIn(const std::string& head) {
  constexpr std::string_view mark = "offset=\"";
  std::vector<std::size_t> places;
  for (std::size_t at = head.find(mark); at != std::string::npos; at = head.find(mark, at + 1))
    places.push_back(at + mark.size());
  return places;
}

void writeOffset(base::OutputFile& file, std::size_t place, std::size_t headBytes) {
  const std::uint64_t begin = file.at();
  char digits[kOffsetDigits + 4];
  std::snprintf(digits, sizeof digits, "%016" PRIu64, begin - headBytes);
  file.go(place);
  file.write(digits, kOffsetDigits);
  file.go(begin);
}

}  // namespace isolux::gi
