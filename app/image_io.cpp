#include "app/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <OpenImageIO/imageio.h>

#include "app/files.h"
#include "app/version.h"
#include "scene/error.h"

namespace isolux::app {

namespace fs = std::filesystem;
using scene::throwInput;

namespace {

// OpenImageIO passes text attributes of this name through PNG (a tEXt chunk) and EXR unchanged.
constexpr const char* sessionKey = "isolux_session";
constexpr int largestAxis = 32768;  // pixels

std::string softwareName() {
  return "isolux " + std::string(version());
}

[[noreturn]] void cannotWrite(const fs::path& file, const std::string& reason) {
  throwInput(file.string(), "", "cannot be written: " + (reason.empty() ? "unknown reason" : reason));
}

OIIO::ImageSpec makeSpec(glm::ivec2 size, int channels, OIIO::TypeDesc type, const std::string& session) {
  OIIO::ImageSpec spec(size.x, size.y, channels, type);
  spec.attribute("Software", softwareName());
  if (!session.empty()) spec.attribute(sessionKey, session);
  return spec;
}

// Writes pixels of `format` to a file beside `file`, then renames it.
void writeImage(const char* plugin, const OIIO::ImageSpec& spec, OIIO::TypeDesc format, const void* pixels,
                OIIO::stride_t pixelBytes, const fs::path& file) {
  PendingFile pending(file);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin);
  if (!output) cannotWrite(file, OIIO::geterror());
  if (!output->open(pending.path().string(), spec)) cannotWrite(file, output->geterror());
  if (!output->write_image(format, pixels, pixelBytes)) cannotWrite(file, output->geterror());
  if (!output->close()) cannotWrite(file, output->geterror());
  pending.commit();
}

// `values`: channels interleaved.
void writeFloats(glm::ivec2 size, const std::vector<std::string>& names, const std::vector<float>& values,
                 const fs::path& file, const std::string& session) {
  OIIO::ImageSpec spec = makeSpec(size, static_cast<int>(names.size()), OIIO::TypeDesc::FLOAT, session);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", "zip");
  spec.alpha_channel = spec.z_channel = -1;
  spec.channelnames = names;
  writeImage("openexr", spec, OIIO::TypeDesc::FLOAT, values.data(), OIIO::AutoStride, file);
}

// IEC 61966-2-1.
float linearOfSrgb(std::uint8_t stored) {
  const double s = stored / 255.0;
  return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

std::unique_ptr<OIIO::ImageInput> openPng(const fs::path& file) {
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("png");
  OIIO::ImageSpec spec;
  if (!input) throwInput(file.string(), "", "cannot be read: " + OIIO::geterror());
  if (!input->open(file.string(), spec))
    throwInput(file.string(), "", "cannot be read: " + input->geterror());
  return input;
}

}  // namespace

void writePng(const render::ColorImage& image, const fs::path& file, const std::string& session) {
  OIIO::ImageSpec spec = makeSpec(image.size, 3, OIIO::TypeDesc::UINT8, session);
  spec.attribute("oiio:ColorSpace", "sRGB");
  writeImage("png", spec, OIIO::TypeDesc::UINT8, image.rgba.data(), 4, file);  // alpha is skipped
}

void writeExr(const render::ColorImage* color, const std::vector<render::AovImage>& images,
              const fs::path& file, const std::string& session) {
  // All channels, interleaved: `name` and where its values come from.
  struct Channel {
    std::string name;
    const render::AovImage* image;  // null: colour
    int index;
  };
  std::vector<Channel> channels;
  if (color)
    for (int i = 0; i < 3; ++i) channels.push_back({std::string(1, "RGB"[i]), nullptr, i});
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
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linearOfSrgb(static_cast<std::uint8_t>(i));

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
        value = linear[color->rgba[p * 4 + index]];
    }
  }

  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  writeFloats(size, names, values, file, session);
}

void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const fs::path& file,
              const std::string& session) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<std::string> names;
  std::vector<float> values(pixels * channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels[c].values.size() != pixels) throw std::logic_error("writeExr: sizes differ");
    names.push_back(channels[c].name);
    for (std::size_t p = 0; p < pixels; ++p) values[p * channels.size() + c] = channels[c].values[p];
  }
  writeFloats(size, names, values, file, session);
}

// Walks the chunks itself: libpng would print its own line about every broken file.
std::string readSessionText(const fs::path& file) {
  constexpr std::uint32_t longestText = std::uint32_t{16} << 20;
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 8> bytes{};
  const auto readBytes = [&] { return static_cast<bool>(stream.read(bytes.data(), bytes.size())); };
  if (!readBytes() || std::string_view(bytes.data(), bytes.size()) != "\x89PNG\r\n\x1a\n")
    throwInput(file.string(), "", "is not a PNG picture");
  const std::string wanted = std::string(sessionKey) + '\0';
  while (readBytes()) {  // length and type of a chunk; its data and 4 bytes of CRC follow
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<std::uint8_t>(bytes[i]);
    const std::string_view type(bytes.data() + 4, 4);
    if (type == "IEND") break;
    if (type != "tEXt" || length > longestText) {
      stream.seekg(std::streamoff{length} + 4, std::ios::cur);
      continue;
    }
    std::string text;
    for (std::array<char, 4096> part{}; text.size() < length;) {  // a false length costs nothing
      const std::size_t size = std::min<std::size_t>(part.size(), length - text.size());
      if (!stream.read(part.data(), static_cast<std::streamsize>(size))) return {};
      text.append(part.data(), size);
    }
    if (text.starts_with(wanted)) return text.substr(wanted.size());
    stream.seekg(4, std::ios::cur);
  }
  return {};
}

render::ColorImage readPng(const fs::path& file) {
  const std::unique_ptr<OIIO::ImageInput> input = openPng(file);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > largestAxis || spec.height > largestAxis)
    throwInput(file.string(), "", "a picture of at most 32768 x 32768 pixels was expected");
  if (spec.nchannels != 3 && spec.nchannels != 4)
    throwInput(file.string(), "", "a colour picture was expected");
  render::ColorImage image;
  image.size = {spec.width, spec.height};
  image.rgba.assign(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * 4, 255);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.rgba.data(), 4))
    throwInput(file.string(), "", "cannot be read: " + input->geterror());
  return image;
}

}  // namespace isolux::app
