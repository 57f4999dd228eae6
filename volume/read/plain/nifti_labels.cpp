#include "volume/read/plain/nifti_labels.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/text.h"
#include "volume/read/vtk/xml_tags.h"

namespace isolux::volume {

namespace {

// The text up to the next tag, or what a CDATA section holds.
std::string_view contentAt(std::string_view text, std::size_t at) {
  constexpr std::string_view open = "<![CDATA[", close = "]]>";
  std::string_view rest = trimmed(text.substr(at));
  if (!rest.starts_with(open)) return trimmed(rest.substr(0, rest.find('<')));
  rest.remove_prefix(open.size());
  return trimmed(rest.substr(0, rest.find(close)));
}

std::optional<glm::vec3> colorOf(const Tag& tag) {
  glm::dvec3 srgb(0.0);
  int axis = 0;
  for (const char* key : {"Red", "Green", "Blue"}) {
    const auto text = tag.find(key);
    const auto number = text ? realOf(*text) : std::nullopt;
    if (!number) return std::nullopt;
    srgb[axis++] = *number;
  }
  return linearFromSrgb(srgb);
}

std::vector<Label> labelsInXml(std::string_view text) {
  const std::string name;
  std::vector<Label> labels;
  try {
    Tags tags(text, name);
    while (const auto tag = tags.next()) {
      if (tag->name == "/LabelTable") break;  // of the first map
      const auto key = tag->name == "Label" ? tag->find("Key") : std::nullopt;
      const auto value = key ? integerOf(*key) : std::nullopt;
      if (value)
        labels.push_back(
            {.value = *value, .name = std::string(contentAt(text, tag->end)), .color = colorOf(*tag)});
    }
  } catch (const base::Error&) {
    return {};
  }
  return labels;
}

}  // namespace

std::optional<LabelTable> labelsInExtensions(std::string_view extensions, bool bigEndian) {
  if (extensions.size() < 4 || extensions[0] == 0) return std::nullopt;
  extensions.remove_prefix(4);
  while (extensions.size() >= 8) {
    const auto size = numberAt<std::int32_t>(extensions.data(), bigEndian);
    if (size < 8 || static_cast<std::size_t>(size) > extensions.size()) return std::nullopt;
    const std::string_view content = extensions.substr(8, static_cast<std::size_t>(size) - 8);
    if (content.find("<LabelTable") != std::string_view::npos)
      if (std::vector<Label> labels = labelsInXml(content); !labels.empty())
        return LabelTable{"its header has a table of labels", "", std::move(labels)};
    extensions.remove_prefix(static_cast<std::size_t>(size));
  }
  return std::nullopt;
}

}  // namespace isolux::volume
