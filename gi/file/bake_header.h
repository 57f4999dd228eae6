// Reads the header of a bake file (bake_file.h): the lattice's size, texts, and the offsets of arrays.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <glm/vec3.hpp>

#include "gi/file/bake_file.h"
#include "volume/read/input/bytes.h"

namespace isolux::gi {

struct ArrayTag {
  std::string type;
  std::int64_t components = 0, offset = 0;
  bool operator==(const ArrayTag&) const = default;
};

struct BakeHeader {
  glm::ivec3 dims{0};
  std::map<std::string, ArrayTag> arrays;
  std::map<std::string, std::string> fields;
  std::uint64_t appendedAt = 0;  // byte that offsets count from
};

// Returns a text of the field data as written in the header. kBakeFileEnd is the text after the arrays.
std::string bakeTextField(const std::string& name, const std::string& text);
inline constexpr const char* kBakeFileEnd = "\n  </AppendedData>\n</VTKFile>\n";

// Reads the header. Throws base::Error{input} that names the file and its difference from files of this
// program.
BakeHeader readBakeHeader(const volume::Bytes& bytes);
BakeFacts bakeFactsOf(const BakeHeader& header, const std::string& file);

}  // namespace isolux::gi
