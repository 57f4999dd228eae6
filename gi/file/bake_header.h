// Reads the header of a bake file (bake_file.h): the lattice's size, texts, and the offsets of arrays.
#pragma once

#include <cstdint>
#include <map>
#include <new>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/pending_file.h"
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

  const std::string* field(const std::string& name) const;  // null: there is none
};

// Returns a text of the field data as written in the header. kBakeFileEnd is the text after the arrays.
std::string bakeTextField(const std::string& name, const std::string& text);
inline constexpr const char* kBakeFileEnd = "\n  </AppendedData>\n</VTKFile>\n";

// Reads the header. Throws base::Error{input} that names the file and its difference from files of this
// program.
BakeHeader readBakeHeader(const volume::Bytes& bytes);
BakeFacts bakeFactsOf(const BakeHeader& header, const std::string& file);

// Offsets of arrays are written as so many digits: zeros, until the arrays are written.
inline constexpr std::size_t kOffsetDigits = 16;
// Returns the places of the digits of all offsets in a header.
std::vector<std::size_t> offsetsIn(const std::string& head);
// Writes, at `place` in the header of `headBytes`, the offset of the array that begins here.
void writeOffset(base::OutputFile& file, std::size_t place, std::size_t headBytes);

// Calls work(); an error names the file where memory runs out while light is `doing`.
template <class Work>
auto namingFile(const std::filesystem::path& path, const char* doing, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path.string(), "",
                      std::string("out of memory while light is ") + doing);
  }
}

}  // namespace isolux::gi
