#include "base/printable.h"

namespace isolux::base {

std::string printable(std::string text) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < text.size(); ++from) {
    const auto byte = static_cast<unsigned char>(text[from]);
    const auto next = from + 1 < text.size() ? static_cast<unsigned char>(text[from + 1]) : 0u;
    const bool c1 = byte == 0xc2 && next >= 0x80 && next < 0xa0;
    text[to++] = c1 || byte < 0x20 || byte == 0x7f ? '?' : text[from];
    if (c1) ++from;
  }
  text.resize(to);
  return text;
}

}  // namespace isolux::base
