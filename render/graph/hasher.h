// FNV-1a over the bytes of plain values.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace isolux::render {

class Hasher {
 public:
  template <class T>
  Hasher& add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3ull;
    return *this;
  }
  template <class T, std::size_t N>
  Hasher& add(const std::array<T, N>& values) {
    for (const T& value : values) add(value);
    return *this;
  }
  operator std::uint64_t() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace isolux::render
