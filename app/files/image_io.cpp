#include "app/files/image_io.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/files/exr_file.h"
#include "app/files/png_file.h"
#include "app/version.h"
#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

std::string softwareName() {
  return "isolux " + std::string(version());
}

// What every picture carries: who made it, and the session unless empty.
std::vector<std::pair<std::string, std::string>> textsOf(const std::string& session) {
  std::vector<std::pair<std::string, std::string>> texts{{"Software", softwareName()}};
  if (!session.empty()) texts.emplace_back(sessionKey, session);
  return texts;
}

}  // namespace

void writePng(const render::ColorImage& image, const fs::path& file, const std::string& session) {
  std::vector<PngText> texts;
  for (const auto& [keyword, text] : textsOf(session)) texts.push_back({keyword, text});
  writePngFile(image, texts, file);
}

std::string pngBytes(const render::ColorImage& image, const std::string& session) {
  std::vector<PngText> texts;
  for (const auto& [keyword, text] : textsOf(session)) texts.push_back({keyword, text});
  return pngFileBytes(image, texts);
}

void writeExr(const render::LinearImage* color, const std::vector<render::AovImage>& images,
              const fs::path& file, const std::string& session) {
  // All channels, interleaved: `name` and where its values come from.
  struct Channel {
    std::string name;
    const render::AovImage* image;  // null: colour
    int index;
  };
  std::vector<Channel> channels;
  if (color)
    for (int i = 0; i < (color->transparent ? 4 : 3); ++i)
      channels.push_back({std::string(1, "RGBA"[i]), nullptr, i});
  for (const render::AovImage& image : images) {
    for (const render::AovInfo& info : render::aovs()) {
      if (info.aov != image.aov) continue;
      for (int i = 0; i < image.channels; ++i) {
        const std::string suffix = info.channels.at(static_cast<std::size_t>(i));
        channels.push_back({suffix.empty() ? info.name : info.name + ("." + suffix), &image, i});
      }
    }
  }
  if (channels.empty()) throw std::logic_error("writeExr: no channels");

  const glm::ivec2 size = color ? color->size : images.front().size;
  const std::size_t pixels = volume::Extent2{size}.count();

  std::vector<float> values(pixels * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Channel& channel = channels[c];
    if (channel.image && channel.image->size != size) throw std::logic_error("writeExr: sizes differ");
    const auto index = static_cast<std::size_t>(channel.index);
    for (std::size_t p = 0; p < pixels; ++p) {
      float& value = values[p * channels.size() + c];
      if (channel.image)
        value = channel.image->values[p * static_cast<std::size_t>(channel.image->channels) + index];
      else if (color)
        value = color->rgba[p * 4 + index];
    }
  }

  std::vector<std::string> names;
  names.reserve(channels.size());
  for (const Channel& channel : channels) names.push_back(channel.name);
  writeExrFile(size, names, values, textsOf(session), file);
}

void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const fs::path& file,
              const std::string& session) {
  const std::size_t pixels = volume::Extent2{size}.count();
  std::vector<std::string> names;
  std::vector<float> values(pixels * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].values.size() != pixels) throw std::logic_error("writeExr: sizes differ");
    names.push_back(channels[c].name);
    for (std::size_t p = 0; p < pixels; ++p) values[p * channels.size() + c] = channels[c].values[p];
  }
  writeExrFile(size, names, values, textsOf(session), file);
}

render::ColorImage readPng(const fs::path& file) {
  return readPngFile(file);
}

}  // namespace isolux::app
