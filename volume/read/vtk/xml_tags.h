// Just enough XML to check what a VTK file claims before VTK reads it, and for tables of labels: tags, their
// attributes, sizes of arrays.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "volume/read/input/bytes.h"

namespace isolux::volume {

struct Tag {
  std::string_view name;  // "/Piece" when it closes
  std::map<std::string, std::string, std::less<>> attributes;
  std::size_t end = 0;  // of the byte after '>'

  std::optional<std::string_view> find(std::string_view key) const;
};

// Goes from tag to tag; text between them, CDATA, comments and declarations are passed over. Throws
// base::Error{input} with the byte of the fault. The text and the file's name must outlive it.
class Tags {
 public:
  Tags(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::optional<Tag> next();

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const;
  std::size_t endOfTag(std::size_t begin) const;
  Tag parse(std::size_t begin, std::size_t end) const;

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
};

// Components and tuples that an array's tag announces must be counts, and no more than the file can hold: VTK
// believes them. Throws base::Error{input}.
void checkArrayClaims(const Tag& tag, const Bytes& bytes);

}  // namespace isolux::volume
