#include "app/files/image_io.h"

#include <algorithm>
#include <stdexcept>

#include "app/files/exr_file.h"
#include "app/version.h"
#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::string>> pictureTexts(const std::string& session) {
  std::vector<std::pair<std::string, std::string>> texts{{"Software", "isolux " + std::string(version())}};
  if (!session.empty()) texts.emplace_back(sessionKey, session);
  return texts;
}

void writeExr(const render::LinearImage* color, const std::vector<render::AovImage>& images,
              const fs::path& file, const std::string& session) {
  std::vector<ExrChannel> channels;
  if (color)
    for (std::size_t i = 0; i < (color->transparent ? 4 : 3); ++i)
      channels.push_back({std::string(1, "RGBA"[i]), color->rgba.data() + i, 4});
  if (!color && images.empty()) throw std::logic_error("writeExr: no channels");
  const glm::ivec2 size = color ? color->size : images.front().size;
  for (const render::AovImage& image : images) {
    if (image.size != size) throw std::logic_error("writeExr: sizes differ");
    const auto info = std::ranges::find(render::aovs(), image.aov, &render::AovInfo::aov);
    const auto count = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string suffix = info->channels.at(i);
      channels.push_back(
          {suffix.empty() ? info->name : info->name + ("." + suffix), image.values.data() + i, count});
    }
  }
  writeExrFile(size, channels, pictureTexts(session), file);
}

void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const fs::path& file,
              const std::string& session) {
  std::vector<ExrChannel> list;
  for (const FloatChannel& channel : channels) {
    if (channel.values.size() != volume::Extent2{size}.count())
      throw std::logic_error("writeExr: sizes differ");
    list.push_back({channel.name, channel.values.data(), 1});
  }
  writeExrFile(size, list, pictureTexts(session), file);
}

}  // namespace isolux::app
