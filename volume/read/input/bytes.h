// Random access to the bytes of one file, or of memory, with every read checked against the size.
//
// Offsets and sizes in bytes. Reads past the end and files that are missing, not regular or not readable
// throw base::Error{input}. Reading is const and safe from several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace isolux::volume {

class Bytes {
 public:
  virtual ~Bytes() = default;

  const std::string& name() const { return name_; }  // as errors name it
  std::uint64_t size() const { return size_; }
  // Fills `out` from `offset`, or throws "the file ends after N bytes".
  void read(std::uint64_t offset, std::span<std::byte> out) const;
  // The first bytes, at most `most`.
  std::string head(std::size_t most) const;

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

// Bytes that live elsewhere: tests and fuzzers.
class MemoryBytes final : public Bytes {
 public:
  MemoryBytes(std::string name, std::span<const std::byte> bytes);

 private:
  void doRead(std::uint64_t offset, std::span<std::byte> out) const override;
  std::span<const std::byte> bytes_;
};

// Opens a data file that a header names; the argument is the name as it stands in the header.
using OpenBeside = std::function<std::unique_ptr<Bytes>(const std::string& name)>;

// Opens names in the folder of `header`. Absolute names and names with ".." are refused: a header must not
// reach files outside its own folder.
OpenBeside openBeside(const std::filesystem::path& header);

}  // namespace isolux::volume
