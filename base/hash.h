// Provides FNV-1a (Fowler, Noll & Vo), 64 bits, to detect changes of data. It is not a cryptographic hash.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace isolux::base {

class Hasher {
 public:
  template <class T>
  Hasher& add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    return addBytes(reinterpret_cast<const unsigned char*>(&value), sizeof(T));
  }
  template <class T, std::size_t N>
  Hasher& add(const std::array<T, N>& values) {
    for (const T& value : values) add(value);
    return *this;
  }
  // Adds large data eight bytes at a time, with one more fold per word. The result differs from that of
  // adding the same bytes one by one.
  Hasher& addWords(const void* data, std::size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    std::uint64_t hash = hash_;
    for (; bytes >= 8; at += 8, bytes -= 8) {
      std::uint64_t word;
      std::memcpy(&word, at, 8);
      hash = (hash ^ word) * kPrime;
      hash ^= hash >> 32;
    }
    hash_ = hash;
    return addBytes(at, bytes);
  }
  operator std::uint64_t() const { return hash_; }

 private:
  static constexpr std::uint64_t kPrime = 0x100000001b3ull;

  Hasher& addBytes(const unsigned char* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) hash_ = (hash_ ^ bytes[i]) * kPrime;
    return *this;
  }

  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace isolux::base
