// What the reader of HDF5 files says of a dataset: its shape, how its chunks are packed, and where they lie.
//
// Goes over the wire as volume/read/process/reader_messages.h says; the table of chunks through the shared
// memory. decodeHdf5Layout() believes nothing and throws base::Error{input}.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "volume/read/chunks/array_statements.h"
#include "volume/read/chunks/chunk_format.h"

namespace isolux::volume {

// A filter of HDF5's pipeline, by its registered number.
struct Hdf5Filter {
  std::uint32_t id = 0;
  std::vector<std::uint32_t> values;
  bool operator==(const Hdf5Filter&) const = default;
};

// Where a chunk lies in the file, or in number `file` - 1 of layout.files. Size 0: nowhere. Bit i of the
// mask: filter i was passed by.
struct Hdf5Chunk {
  std::uint64_t address = 0, size = 0, mask = 0, file = 0;
};

struct Hdf5Layout {
  std::string dataset;                     // "/group/name"
  std::vector<std::string> others;         // what else the file holds, with "\t" and a description
  std::vector<std::string> files;          // others that chunks lie in, in the folder of the file or below
  std::vector<std::uint64_t> dims, chunk;  // a contiguous dataset is one chunk
  bool contiguous = false;
  FileNumber number;
  std::array<std::byte, 8> fill{};  // a number of `number.type`
  std::vector<Hdf5Filter> filters;  // in the order in which they were applied
  ArrayStatements statements;       // by the conventions that the file follows

  // Of the table, in the order of C arrays. After decodeHdf5Layout(): at most 2^24.
  std::uint64_t chunkCount() const;
};
inline constexpr std::uint64_t kMostHdf5Chunks = std::uint64_t{1} << 24;

std::string encode(const Hdf5Layout& layout);
Hdf5Layout decodeHdf5Layout(std::string_view body);

// Of the shared memory.
std::uint64_t bulkBytes(const Hdf5Layout& announced);

}  // namespace isolux::volume
