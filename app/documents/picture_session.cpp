// The session inside a picture: found by walking chunks and attributes, so that nothing of the picture need
// be decoded.
#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

#include "app/files/files.h"
#include "app/files/image_io.h"
#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kExrSignature = "\x76\x2f\x31\x01";
constexpr std::uint32_t kLongestText = std::uint32_t{16} << 20;  // bytes
constexpr std::size_t kLongestName = 255;                        // of an EXR attribute

// `length` bytes; empty where the file ends before. A false length costs nothing.
std::string readBytes(std::istream& stream, std::uint32_t length) {
  std::string text;
  for (std::array<char, 4096> part{}; text.size() < length;) {
    const std::size_t size = std::min<std::size_t>(part.size(), length - text.size());
    if (!stream.read(part.data(), static_cast<std::streamsize>(size))) return {};
    text.append(part.data(), size);
  }
  return text;
}

std::uint32_t bigEndian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<std::uint8_t>(byte);
  return number;
}

std::string sessionOfPng(std::istream& stream) {
  const std::string wanted = std::string(sessionKey) + '\0';
  for (std::string head; !(head = readBytes(stream, 8)).empty();) {  // length and type; 4 bytes of CRC follow
    const std::uint32_t length = bigEndian(head.substr(0, 4));
    const std::string_view type = std::string_view(head).substr(4);
    if (type == "IEND") break;
    if (type == "tEXt" && length <= kLongestText) {
      const std::string text = readBytes(stream, length);
      if (text.starts_with(wanted)) return text.substr(wanted.size());
      stream.seekg(4, std::ios::cur);
    } else {
      stream.seekg(std::streamoff{length} + 4, std::ios::cur);
    }
  }
  return {};
}

// A name with a zero byte behind it; empty at the end of the attributes, and where it is too long.
std::string readName(std::istream& stream) {
  std::string name;
  for (int c = stream.get(); c > 0; c = stream.get()) {
    if (name.size() == kLongestName) return {};
    name.push_back(static_cast<char>(c));
  }
  return name;
}

std::string sessionOfExr(std::istream& stream) {
  stream.seekg(4, std::ios::cur);  // the version
  for (std::string name; !(name = readName(stream)).empty();) {
    const std::string type = readName(stream);
    const std::string size = readBytes(stream, 4);
    if (size.empty()) break;
    const std::uint32_t length = bigEndian(std::string(size.rbegin(), size.rend()));
    if (name == sessionKey && type == "string" && length <= kLongestText) return readBytes(stream, length);
    stream.seekg(std::streamoff{length}, std::ios::cur);
  }
  return {};
}

}  // namespace

bool looksLikePicture(std::string_view beginning) {
  return beginning.starts_with(kPngSignature) || beginning.starts_with(kExrSignature);
}

std::string readSessionText(const fs::path& file) {
  const std::string beginning = readBeginning(file, kPngSignature.size());
  if (!looksLikePicture(beginning)) base::throwInput(file.string(), "", "is not a PNG or EXR image");
  const bool png = beginning == kPngSignature;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(png ? kPngSignature.size() : kExrSignature.size()));
  return png ? sessionOfPng(stream) : sessionOfExr(stream);
}

glm::ivec2 pngSize(const fs::path& file) {
  constexpr std::size_t sizeAt = 16;  // behind the signature and the head of the first chunk
  const std::string beginning = readBeginning(file, sizeAt + 8);
  if (!beginning.starts_with(kPngSignature) || beginning.size() < sizeAt + 8) return glm::ivec2(0);
  const std::uint32_t width = bigEndian(std::string_view(beginning).substr(sizeAt, 4));
  const std::uint32_t height = bigEndian(std::string_view(beginning).substr(sizeAt + 4, 4));
  if (width - 1 >= std::uint32_t{kLargestPicture} || height - 1 >= std::uint32_t{kLargestPicture})
    return glm::ivec2(0);
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace isolux::app
