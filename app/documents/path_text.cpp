#include "app/documents/path_text.h"

#include <charconv>
#include <string_view>

#include <nlohmann/json.hpp>

namespace isolux::app {

namespace {

using nlohmann::json;

constexpr std::string_view kBytesPrefix = "bytes:";

bool isUtf8(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)) == text;
}

}  // namespace

std::string pathText(const std::string& path) {
  if (isUtf8(path) && !path.starts_with(kBytesPrefix)) return path;
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text(kBytesPrefix);
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte > 0x20 && byte < 0x7f && byte != '%')
      text += letter;
    else
      text.append({'%', digits[byte >> 4], digits[byte & 15]});
  }
  return text;
}

std::string pathOfText(const std::string& text) {
  if (!text.starts_with(kBytesPrefix)) return text;
  std::string path;
  for (std::size_t at = kBytesPrefix.size(); at < text.size(); ++at) {
    unsigned byte = 0;
    const char* const hex = text.data() + at + 1;
    if (text[at] == '%' && at + 2 < text.size() && std::from_chars(hex, hex + 2, byte, 16).ptr == hex + 2) {
      path += static_cast<char>(byte);
      at += 2;
    } else {
      path += text[at];
    }
  }
  return path;
}

}  // namespace isolux::app
