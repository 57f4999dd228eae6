// Provides random access to the bytes of a file or of memory; every read is checked against the size.
//
// Offsets and sizes in bytes. Reads past the end, and files that are missing, not regular or not readable,
// throw base::Error{input}. Reading is const and safe from several threads.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace isolux::volume {

// Returns the number whose bytes begin at `at`, in big- or little-endian order.
template <class T>
T numberAt(const void* at, bool big) {
  std::array<std::byte, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}
// Reverses the bytes of each number of `width` bytes.
void swapBytes(std::span<std::byte> bytes, std::size_t width);

class Bytes {
 public:
  virtual ~Bytes() = default;

  const std::string& name() const { return name_; }  // the name in errors
  std::uint64_t size() const { return size_; }
  // Fills `out` from `offset`. Throws "the file ends after N bytes".
  void read(std::uint64_t offset, std::span<std::byte> out) const;
  // Returns the bytes from `offset` on, at most `most`; throws only where `offset` is behind the end.
  std::string text(std::uint64_t offset, std::size_t most) const;
  std::string head(std::size_t most) const { return text(0, most); }

 protected:
  std::string name_;
  std::uint64_t size_ = 0;

 private:
  virtual void doRead(std::uint64_t offset, std::span<std::byte> out) const = 0;  // range already checked
};

class FileBytes final : public Bytes {
 public:
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes() override;
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

 private:
  void doRead(std::uint64_t offset, std::span<std::byte> out) const override;
  int descriptor_ = -1;
};

// Bytes in memory owned by the caller, for tests and fuzzers.
class MemoryBytes final : public Bytes {
 public:
  MemoryBytes(std::string name, std::span<const std::byte> bytes);

 private:
  void doRead(std::uint64_t offset, std::span<std::byte> out) const override;
  std::span<const std::byte> bytes_;
};

// Opens a data file that a header names; `name` is as written in the header.
using OpenBeside = std::function<std::unique_ptr<Bytes>(const std::string& name)>;

// Returns a function that opens names in the folder of `header`. Absolute names and names with ".." are
// rejected: a header must not reach files outside its own folder.
OpenBeside openBeside(const std::filesystem::path& header);

}  // namespace isolux::volume
