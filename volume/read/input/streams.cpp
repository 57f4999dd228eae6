#include "volume/read/input/streams.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include <bzlib.h>
#include <zlib.h>
#include <zstd.h>

#include "base/error.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using base::throwInput;

namespace {

bool isZstd(std::string_view head) {
  return head.starts_with("\x28\xb5\x2f\xfd");
}

bool isBzip2(std::string_view head) {
  return head.starts_with("BZh");
}

// What all kinds of packed streams share.
class PackedStream : public VoxelStream {
 public:
  PackedStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length)
      : bytes_(bytes), at_(offset), end_(offset + length) {}

  void read(std::span<std::byte> out) override {
    constexpr std::size_t most = std::size_t{1} << 20;
    while (!out.empty()) {
      const auto part = out.first(std::min(out.size(), most));
      const std::size_t got = readSome(part);
      produced_ += got;
      if (got < part.size())
        throwInput(
            bytes_.name(), "byte " + std::to_string(at_),
            "truncated: the compressed data end after " + std::to_string(produced_) + " bytes of voxels");
      out = out.subspan(got);
    }
  }

  // To the end: where the stream is damaged, it is there that its sum says so.
  bool hasMore() override {
    std::byte one;
    const bool open = !ended_;
    const std::uint64_t ends = ends_;
    try {
      if (readSome({&one, 1}) == 0) {
        cut_ = open && ends_ == ends;
        return false;
      }
    } catch (const base::Error&) {
      if (open && ends_ == ends) throw;
      return false;  // rubbish after the data
    }
    std::vector<std::byte> rest(std::size_t{1} << 20);
    while (readSome(rest) > 0) {
    }
    return true;
  }

  bool isCut() const override { return cut_; }

  // As many bytes as there are, up to out.size().
  virtual std::size_t readSome(std::span<std::byte> out) = 0;

 protected:
  // The next bytes of the file; none at the end.
  std::span<const std::byte> refill() {
    const auto part =
        std::span(input_).first(static_cast<std::size_t>(std::min<std::uint64_t>(input_.size(), end_ - at_)));
    bytes_.read(at_, part);
    at_ += part.size();
    return part;
  }
  [[noreturn]] void fail(std::size_t unused, const char* why) const {
    throwInput(bytes_.name(), "byte " + std::to_string(at_ - unused),
               std::string("the compressed data are damaged: ") + why);
  }

  void end() {
    ended_ = true;
    ++ends_;
  }

  const Bytes& bytes_;
  bool ended_ = false;  // the last byte that was used is the last of a gzip member, a zstd frame, ...

 private:
  std::uint64_t at_, end_, produced_ = 0, ends_ = 0;
  bool cut_ = false;
  std::vector<std::byte> input_ = std::vector<std::byte>(std::size_t{1} << 16);
};

class InflateStream final : public PackedStream {
 public:
  InflateStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length)
      : PackedStream(bytes, offset, length) {
    constexpr int zlibOrGzip = 15 + 32;
    if (inflateInit2(&z_, zlibOrGzip) != Z_OK) throwInput(bytes_.name(), "", "zlib cannot start");
  }
  ~InflateStream() override { inflateEnd(&z_); }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;

  std::size_t readSome(std::span<std::byte> out) override {
    z_.next_out = reinterpret_cast<Bytef*>(out.data());
    z_.avail_out = static_cast<uInt>(out.size());
    while (z_.avail_out > 0) {
      if (z_.avail_in == 0) {
        const auto more = refill();
        if (more.empty()) break;
        z_.next_in = reinterpret_cast<const Bytef*>(more.data());
        z_.avail_in = static_cast<uInt>(more.size());
      }
      if (ended_) {
        // Another gzip member may follow; anything else is padding.
        if (*z_.next_in != 0x1f || inflateReset(&z_) != Z_OK) break;
        ended_ = false;
      }
      const int result = inflate(&z_, Z_NO_FLUSH);
      if (result == Z_STREAM_END)
        end();
      else if (result != Z_OK && result != Z_BUF_ERROR)
        fail(z_.avail_in, z_.msg ? z_.msg : "zlib error");
    }
    return out.size() - z_.avail_out;
  }

 private:
  z_stream z_{};
};

class ZstdStream final : public PackedStream {
 public:
  ZstdStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length)
      : PackedStream(bytes, offset, length), zstd_(ZSTD_createDStream()) {
    if (!zstd_) throw std::bad_alloc();
  }

  std::size_t readSome(std::span<std::byte> out) override {
    ZSTD_outBuffer to{out.data(), out.size(), 0};
    while (to.pos < to.size) {
      if (from_.pos == from_.size) {
        const auto more = refill();
        from_ = {more.data(), more.size(), 0};
      }
      const std::size_t before = to.pos, used = from_.pos;
      const std::size_t result = ZSTD_decompressStream(zstd_.get(), &to, &from_);
      if (ZSTD_isError(result)) fail(from_.size - from_.pos, ZSTD_getErrorName(result));
      const bool moved = to.pos != before || from_.pos != used;
      if (result == 0 && moved)
        end();
      else if (moved)
        ended_ = false;
      if (!moved && from_.size == 0) break;  // the file ends
    }
    return to.pos;
  }

 private:
  struct Free {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };
  std::unique_ptr<ZSTD_DStream, Free> zstd_;
  ZSTD_inBuffer from_{nullptr, 0, 0};
};

class Bzip2Stream final : public PackedStream {
 public:
  Bzip2Stream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length)
      : PackedStream(bytes, offset, length) {
    begin();
  }
  ~Bzip2Stream() override { BZ2_bzDecompressEnd(&bz_); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  std::size_t readSome(std::span<std::byte> out) override {
    bz_.next_out = reinterpret_cast<char*>(out.data());
    bz_.avail_out = static_cast<unsigned>(out.size());
    while (bz_.avail_out > 0) {
      if (bz_.avail_in == 0) {
        const auto more = refill();
        if (more.empty()) break;
        bz_.next_in = const_cast<char*>(reinterpret_cast<const char*>(more.data()));  // its older signature
        bz_.avail_in = static_cast<unsigned>(more.size());
      }
      if (ended_) {
        // Another stream may follow (pbzip2 makes many); anything else is padding.
        if (*bz_.next_in != 'B') break;
        BZ2_bzDecompressEnd(&bz_);
        begin();
      }
      const int result = BZ2_bzDecompress(&bz_);
      if (result == BZ_STREAM_END)
        end();
      else if (result != BZ_OK)
        fail(bz_.avail_in, result == BZ_DATA_ERROR_MAGIC ? "no bzip2 stream" : "a block's sum is wrong");
    }
    return out.size() - bz_.avail_out;
  }

 private:
  void begin() {
    if (BZ2_bzDecompressInit(&bz_, 0, 0) != BZ_OK) throw std::bad_alloc();
    ended_ = false;
  }
  bz_stream bz_{};
};

std::unique_ptr<PackedStream> packedStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length) {
  const std::string mark = bytes.text(offset, static_cast<std::size_t>(std::min<std::uint64_t>(4, length)));
  if (isZstd(mark)) return std::make_unique<ZstdStream>(bytes, offset, length);
  if (isBzip2(mark)) return std::make_unique<Bzip2Stream>(bytes, offset, length);
  return std::make_unique<InflateStream>(bytes, offset, length);
}

class TextStream final : public VoxelStream {
 public:
  TextStream(const Bytes& bytes, std::uint64_t offset, VoxelType type)
      : bytes_(bytes), at_(offset), type_(type) {}

  void read(std::span<std::byte> out) override {
    withType(type_, [&](auto zero) {
      using T = decltype(zero);
      for (std::size_t i = 0; i + sizeof(T) <= out.size(); i += sizeof(T)) {
        const T value = parse<T>();
        std::memcpy(out.data() + i, &value, sizeof(T));
      }
    });
  }

  bool hasMore() override { return !nextWord().empty(); }

 private:
  static bool separates(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == ',' || c == '\f' || c == '\v';
  }

  // Empty at the end of the file. Valid until the next call.
  std::string_view nextWord() {
    word_.clear();
    for (;;) {
      if (position_ == count_) {
        count_ = static_cast<std::size_t>(std::min<std::uint64_t>(buffer_.size(), bytes_.size() - at_));
        position_ = 0;
        if (count_ == 0) return word_;
        bytes_.read(at_, std::as_writable_bytes(std::span(buffer_).first(count_)));
        at_ += count_;
      }
      const char c = buffer_[position_++];
      if (!separates(c))
        word_ += c;
      else if (!word_.empty())
        return word_;
      if (word_.size() > 400) fail("a number has more than 400 characters");
    }
  }

  template <typename T>
  T parse() {
    const std::string_view word = nextWord();
    if (word.empty())
      throwInput(bytes_.name(), "byte " + std::to_string(bytes_.size()),
                 "truncated: the text ends after " + std::to_string(produced_) + " numbers");
    ++produced_;
    if constexpr (std::is_integral_v<T>) {
      if (const auto whole = integerOf(word)) {
        if (!std::in_range<T>(*whole)) fail(inQuotes(word) + " does not fit " + std::string(nameOf(type_)));
        return static_cast<T>(*whole);
      }
      if constexpr (std::is_same_v<T, std::uint64_t>) {
        T big = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), big);
        if (error == std::errc() && end == word.data() + word.size()) return big;
      }
      // Some writers print integers as "3.0".
      const auto real = realOf(word);
      if (!real || *real != std::trunc(*real) || std::abs(*real) > 0x1p53)
        fail(inQuotes(word) + " is not a whole number");
      const auto whole = static_cast<std::int64_t>(*real);
      if (!std::in_range<T>(whole)) fail(inQuotes(word) + " does not fit " + std::string(nameOf(type_)));
      return static_cast<T>(whole);
    } else {
      const auto real = realOf(word);
      if (!real) fail(inQuotes(word) + " is not a number");
      if constexpr (std::is_same_v<T, float>) {
        if (std::abs(*real) > static_cast<double>(std::numeric_limits<float>::max()))
          return std::numeric_limits<float>::infinity();
      }
      return static_cast<T>(*real);
    }
  }

  [[noreturn]] void fail(const std::string& reason) {
    throwInput(bytes_.name(), "byte " + std::to_string(at_ - count_ + position_), reason);
  }

  const Bytes& bytes_;
  std::uint64_t at_;
  VoxelType type_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t position_ = 0, count_ = 0;
  std::string word_;
  std::uint64_t produced_ = 0;
};

}  // namespace

bool isPacked(std::string_view head) {
  return head.starts_with("\x1f\x8b") || isZstd(head) || isBzip2(head);
}

std::uint64_t bestRatio(std::string_view head) {
  return isZstd(head) ? 32768 : isBzip2(head) ? std::uint64_t{1} << 21 : kBestDeflateRatio;
}

std::unique_ptr<VoxelStream> inflateStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length) {
  return packedStream(bytes, offset, length);
}

std::unique_ptr<VoxelStream> textStream(const Bytes& bytes, std::uint64_t offset, VoxelType type) {
  return std::make_unique<TextStream>(bytes, offset, type);
}

std::string inflatedHead(const Bytes& bytes, std::size_t most) {
  std::string head(most, '\0');
  try {
    head.resize(packedStream(bytes, 0, bytes.size())->readSome(std::as_writable_bytes(std::span(head))));
  } catch (const base::Error&) {
    head.clear();
  }
  return head;
}

}  // namespace isolux::volume
