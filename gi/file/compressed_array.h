// Streams VTK's compressed arrays of appended data: number of chunks, bytes of a chunk, bytes of a shorter
// last chunk, compressed sizes, chunks (zlib).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/pending_file.h"
#include "gi/file/bake_header.h"
#include "volume/read/input/bytes.h"

namespace isolux::gi {

// Writes an array from its beginning to its end. The bytes depend only on the numbers, not on how they are
// divided among calls.
class ArrayWriter {
 public:
  ArrayWriter(base::OutputFile& file, std::uint64_t bytes);  // of all numbers; not 0
  void add(const void* bytes, std::size_t count);
  void end();

 private:
  void pack();

  base::OutputFile& file_;
  std::size_t chunkBytes_;
  std::vector<std::uint64_t> table_;
  std::uint64_t tableAt_;
  std::vector<std::uint8_t> packed_, chunk_;
  std::size_t next_ = 3;
};

// Reads an array from its beginning to its end. `bytes` must outlive it. Throws base::Error{input} naming
// file and array: missing, of another type, truncated, damaged.
class ArrayReader {
 public:
  ArrayReader(const volume::Bytes& bytes, const BakeHeader& header, const std::string& name, const char* type,
              std::int64_t components);
  void next(std::span<std::uint32_t> out);
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  void read(std::span<std::byte> out);
  void unpack();

  const volume::Bytes& bytes_;
  std::string place_;
  std::uint64_t total_ = 0, at_ = 0, size_ = 0;
  std::vector<std::uint64_t> sizes_;
  std::size_t chunkIndex_ = 0, used_ = 0;
  std::vector<std::byte> packed_;
  std::vector<std::uint8_t> chunk_;
};

}  // namespace isolux::gi
