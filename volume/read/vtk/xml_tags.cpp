#include "volume/read/vtk/xml_tags.h"

#include <algorithm>

#include "base/error.h"
#include "volume/read/input/streams.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

std::optional<std::string_view> Tag::find(std::string_view key) const {
  const auto it = attributes.find(key);
  if (it == attributes.end()) return std::nullopt;
  return it->second;
}

std::optional<Tag> Tags::next() {
  for (;;) {
    const std::size_t begin = text_.find('<', at_);
    if (begin == std::string_view::npos) return std::nullopt;
    if (text_.substr(begin).starts_with("<!--")) {
      const std::size_t end = text_.find("-->", begin);
      if (end == std::string_view::npos) fail(begin, "a comment is not closed");
      at_ = end + 3;
      continue;
    }
    if (text_.substr(begin).starts_with("<![CDATA[")) {
      const std::size_t end = text_.find("]]>", begin);
      if (end == std::string_view::npos) fail(begin, "a CDATA section is not closed");
      at_ = end + 3;
      continue;
    }
    if (text_.substr(begin).starts_with("<!")) fail(begin, "document types and entities are not supported");
    const std::size_t end = endOfTag(begin);
    at_ = end;
    if (text_[begin + 1] == '?') continue;
    return parse(begin, end);
  }
}

void Tags::fail(std::size_t at, const std::string& reason) const {
  base::throwInput(file_, "byte " + std::to_string(at), reason);
}

std::size_t Tags::endOfTag(std::size_t begin) const {
  char quote = 0;
  for (std::size_t i = begin + 1; i < text_.size(); ++i) {
    const char c = text_[i];
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  fail(begin, "truncated: a tag is not closed");
}

Tag Tags::parse(std::size_t begin, std::size_t end) const {
  Tag tag;
  tag.end = end;
  std::string_view inner = text_.substr(begin + 1, end - begin - 2);
  std::size_t at = std::min(inner.find_first_of(" \t\r\n/", 1), inner.size());
  tag.name = inner.substr(0, at);
  while (at < inner.size()) {
    at = inner.find_first_not_of(" \t\r\n/", at);
    if (at == std::string_view::npos) break;
    const std::size_t equals = inner.find('=', at);
    const std::size_t open = equals == std::string_view::npos ? equals : inner.find_first_of("\"'", equals);
    const std::size_t close = open == std::string_view::npos ? open : inner.find(inner[open], open + 1);
    if (close == std::string_view::npos) fail(begin, "an attribute has no quoted value");
    tag.attributes.emplace(trimmed(inner.substr(at, equals - at)), inner.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return tag;
}

void checkArrayClaims(const Tag& tag, const Bytes& bytes) {
  constexpr std::uint64_t mostComponents = 65536;
  const std::string place = std::string(tag.name) + " ";
  const auto check = [&](const char* key, std::uint64_t least, std::uint64_t most) {
    const auto text = tag.find(key);
    if (!text) return;
    const auto count = integerOf(*text);
    if (!count || *count < static_cast<std::int64_t>(least))
      base::throwInput(bytes.name(), place + key, inQuotes(*text) + " is not a count");
    if (static_cast<std::uint64_t>(*count) > most)
      base::throwInput(bytes.name(), place + key,
                       "truncated: the file is too short for " + std::string(*text));
  };
  check("NumberOfComponents", 0, mostComponents);
  check("NumberOfTuples", 0, bytes.size() * kBestDeflateRatio);
}

}  // namespace isolux::volume
