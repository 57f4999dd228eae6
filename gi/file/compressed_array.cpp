#include "gi/file/compressed_array.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

#include <zlib.h>

#include "base/error.h"
#include "volume/read/input/streams.h"

namespace isolux::gi {

namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 20;  // that are compressed at a time
constexpr std::uint64_t kMostChunkBytes = std::uint64_t{1} << 24;

}  // namespace

ArrayWriter::ArrayWriter(base::OutputFile& file, std::uint64_t bytes)
    : file_(file),
      chunkBytes_(static_cast<std::size_t>(std::min<std::uint64_t>(kChunkBytes, bytes))),
      table_{(bytes + chunkBytes_ - 1) / chunkBytes_, chunkBytes_, bytes % chunkBytes_},
      tableAt_(file.at()),
      packed_(compressBound(chunkBytes_)) {
  table_.resize(3 + table_[0]);
  file_.write(table_.data(), table_.size() * 8);
  chunk_.reserve(chunkBytes_);
}

void ArrayWriter::add(const void* bytes, std::size_t count) {
  const auto* from = static_cast<const std::uint8_t*>(bytes);
  while (count > 0) {
    const std::size_t part = std::min(count, chunkBytes_ - chunk_.size());
    chunk_.insert(chunk_.end(), from, from + part);
    from += part;
    count -= part;
    if (chunk_.size() == chunkBytes_) pack();
  }
}

void ArrayWriter::end() {
  if (!chunk_.empty()) pack();
  const std::uint64_t behind = file_.at();
  file_.go(tableAt_);
  file_.write(table_.data(), table_.size() * 8);
  file_.go(behind);
}

void ArrayWriter::pack() {
  uLongf size = packed_.size();
  if (compress2(packed_.data(), &size, chunk_.data(), chunk_.size(), Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc();
  file_.write(packed_.data(), size);
  table_.at(next_++) = size;
  chunk_.clear();
}

ArrayReader::ArrayReader(const volume::Bytes& bytes, const BakeHeader& header, const std::string& name,
                         const char* type, std::int64_t components)
    : bytes_(bytes), place_("DataArray " + name) {
  const auto found = header.arrays.find(name);
  if (found == header.arrays.end()) fail("is missing");
  const ArrayTag& tag = found->second;
  if (tag.type != type || tag.components != components)
    fail("is not " + std::to_string(components) + " components of " + type);
  total_ = static_cast<std::uint64_t>(components) * 4;
  for (int a = 0; a < 3; ++a)
    if (__builtin_mul_overflow(total_, static_cast<std::uint64_t>(header.dims[a]), &total_))
      fail("is too large");
  if (static_cast<std::uint64_t>(tag.offset) > bytes.size())
    fail("truncated: it begins behind the end of the file");
  at_ = header.appendedAt + static_cast<std::uint64_t>(tag.offset);
  std::array<std::uint64_t, 3> first{};
  read(std::as_writable_bytes(std::span(first)));
  const auto [chunks, size, rest] = first;
  if (size == 0 || size > kMostChunkBytes || rest >= size || chunks != (total_ + size - 1) / size ||
      rest != total_ % size)
    fail("the table of compressed chunks makes no sense");
  if (chunks > bytes.size() / 8 || total_ / volume::kBestDeflateRatio > bytes.size())
    fail("truncated: the file is too short");
  size_ = size;
  sizes_.resize(chunks);
  read(std::as_writable_bytes(std::span(sizes_)));
  for (const std::uint64_t packed : sizes_)
    if (packed > size + size / 100 + 1024) fail("the table of compressed chunks makes no sense");
}

void ArrayReader::next(std::span<std::uint32_t> out) {
  auto* to = reinterpret_cast<std::uint8_t*>(out.data());
  for (std::size_t left = out.size_bytes(); left > 0;) {
    if (used_ == chunk_.size()) unpack();
    const std::size_t part = std::min(left, chunk_.size() - used_);
    std::memcpy(to, chunk_.data() + used_, part);
    to += part;
    used_ += part;
    left -= part;
  }
}
void ArrayReader::fail(const std::string& reason) const {
  base::throwInput(bytes_.name(), place_, reason);
}

void ArrayReader::read(std::span<std::byte> out) {
  if (at_ > bytes_.size() || out.size() > bytes_.size() - at_) fail("truncated: the file is too short");
  bytes_.read(at_, out);
  at_ += out.size();
}

void ArrayReader::unpack() {
  packed_.resize(sizes_.at(chunkIndex_));
  read(packed_);
  const std::uint64_t done = chunkIndex_++ * size_;
  chunk_.resize(static_cast<std::size_t>(std::min(size_, total_ - done)));
  used_ = 0;
  uLongf size = chunk_.size();
  if (uncompress(chunk_.data(), &size, reinterpret_cast<const Bytef*>(packed_.data()), packed_.size()) !=
          Z_OK ||
      size != chunk_.size())
    fail("is damaged");
}

}  // namespace isolux::gi
