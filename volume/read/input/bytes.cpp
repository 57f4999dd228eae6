#include "volume/read/input/bytes.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace isolux::volume {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

template <class Word>
void swapWords(std::span<std::byte> bytes) {
  for (std::size_t at = 0; at + sizeof(Word) <= bytes.size(); at += sizeof(Word)) {
    const Word swapped = numberAt<Word>(&bytes[at], std::endian::native == std::endian::little);
    std::memcpy(&bytes[at], &swapped, sizeof(Word));
  }
}

}  // namespace

void swapBytes(std::span<std::byte> bytes, std::size_t width) {
  if (width == 2) return swapWords<std::uint16_t>(bytes);
  if (width == 4) return swapWords<std::uint32_t>(bytes);
  if (width == 8) return swapWords<std::uint64_t>(bytes);
  for (; bytes.size() >= width; bytes = bytes.subspan(width)) std::reverse(&bytes[0], &bytes[0] + width);
}

void Bytes::read(std::uint64_t offset, std::span<std::byte> out) const {
  if (offset > size_ || out.size() > size_ - offset)
    throwInput(name_, "byte " + std::to_string(offset),
               "truncated: the file ends after " + std::to_string(size_) + " bytes");
  if (!out.empty()) doRead(offset, out);
}

std::string Bytes::text(std::uint64_t offset, std::size_t most) const {
  const std::uint64_t left = size_ - std::min(offset, size_);
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(most, left)), '\0');
  read(offset, std::as_writable_bytes(std::span(text)));
  return text;
}

FileBytes::FileBytes(const fs::path& path) {
  name_ = path.string();
  struct stat status {};
  // Looked at before opening: opening a pipe would wait for its writer.
  if (::stat(path.c_str(), &status) != 0)
    throwInput(name_, "", errno == ENOENT ? "no such file" : std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throwInput(name_, "", "is a folder, not a file");
  if (!S_ISREG(status.st_mode)) throwInput(name_, "", "is not a regular file");
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) throwInput(name_, "", std::string("cannot be opened: ") + std::strerror(errno));
  size_ = static_cast<std::uint64_t>(status.st_size);
}

FileBytes::~FileBytes() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileBytes::doRead(std::uint64_t offset, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t got = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throwInput(name_, "byte " + std::to_string(offset),
                 std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0)
      throwInput(name_, "byte " + std::to_string(offset), "truncated: the file became shorter while read");
    offset += static_cast<std::uint64_t>(got);
    out = out.subspan(static_cast<std::size_t>(got));
  }
}

MemoryBytes::MemoryBytes(std::string name, std::span<const std::byte> bytes) : bytes_(bytes) {
  name_ = std::move(name);
  size_ = bytes.size();
}

void MemoryBytes::doRead(std::uint64_t offset, std::span<std::byte> out) const {
  std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), out.size(), out.begin());
}

OpenBeside openBeside(const fs::path& header) {
  return [header](const std::string& name) -> std::unique_ptr<Bytes> {
    fs::path relative(name);
    std::error_code ignored;
    if (!fs::exists(header.parent_path() / relative, ignored)) {  // as headers of Windows name files
      std::string slashes = name;
      std::ranges::replace(slashes, '\\', '/');
      relative = slashes;
    }
    const std::string place = "data file \"" + name + "\"";
    if (name.empty() || name.find('\0') != std::string::npos)
      throwInput(header.string(), "data file", "has no usable name");
    if (relative.is_absolute())
      throwInput(header.string(), place,
                 "path leaves the folder of the header: absolute paths are not allowed");
    if (std::ranges::any_of(relative, [](const fs::path& part) { return part == ".."; }))
      throwInput(header.string(), place, "path leaves the folder of the header: \"..\" is not allowed");
    const fs::path file = header.parent_path() / relative;
    if (!fs::exists(file, ignored)) throwInput(header.string(), place, "no such file");
    if (!fs::is_regular_file(file, ignored)) throwInput(header.string(), place, "is not a file");
    return std::make_unique<FileBytes>(file);
  };
}

}  // namespace isolux::volume
