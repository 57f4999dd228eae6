// Numbers and texts as bytes between the program and its readers (volume/read/process/reader_process.h).
//
// Both ends run on one machine, so numbers keep its byte order. The receiving end believes nothing: whatever
// is missing, left over or out of range throws base::Error{input}.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

namespace isolux::volume {

class WireWriter {
 public:
  void put(std::uint64_t number);
  void put(std::int64_t number) { put(static_cast<std::uint64_t>(number)); }
  void put(double number) { put(std::bit_cast<std::uint64_t>(number)); }
  void put(std::string_view text);

  // As WireReader::pass(), in the other direction.
  void pass(double number) { put(number); }
  void pass(const std::string& text) { put(std::string_view(text)); }
  void pass(const std::vector<std::string>& texts, std::size_t most) {
    passEach(texts, 0, most, [this](const std::string& text) { pass(text); });
  }
  void passFinite(double number) { put(number); }
  void passFinite(const glm::dmat4& matrix);
  template <class T>
  void pass(T number, std::uint64_t, std::uint64_t) {
    put(static_cast<std::uint64_t>(number));
  }
  template <class T, class F>
  void passEach(const std::vector<T>& entries, std::uint64_t, std::uint64_t, const F& passOne) {
    put(static_cast<std::uint64_t>(entries.size()));
    for (const T& entry : entries) passOne(entry);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class WireReader {
 public:
  // `bytes` must outlive it.
  explicit WireReader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number();
  std::uint64_t number(std::uint64_t low, std::uint64_t high);  // within [low, high]
  double real() { return std::bit_cast<double>(number()); }     // any, NaN too
  double finite();
  std::string text() { return std::string(take(number())); }
  void end() const;  // throws unless everything was taken

  void pass(double& number) { number = real(); }
  void pass(std::string& text) { text = this->text(); }
  void pass(std::vector<std::string>& texts, std::size_t most) {
    passEach(texts, 0, most, [this](std::string& text) { pass(text); });
  }
  void passFinite(double& number) { number = finite(); }
  void passFinite(glm::dmat4& matrix);
  // A whole number, an enumerator or a flag within [low, high].
  template <class T>
  void pass(T& number, std::uint64_t low, std::uint64_t high) {
    number = static_cast<T>(this->number(low, high));
  }
  // From `least` to `most` entries.
  template <class T, class F>
  void passEach(std::vector<T>& entries, std::uint64_t least, std::uint64_t most, const F& passOne) {
    entries.resize(static_cast<std::size_t>(number(least, most)));
    for (T& entry : entries) passOne(entry);
  }

 private:
  std::string_view take(std::uint64_t count);
  std::string_view rest_;
};

// The bytes of a message, and back: passFields(wire, message) passes each of its fields to either wire.
template <class Message, class F>
std::string messageBytes(const Message& message, const F& passFields) {
  WireWriter wire;
  passFields(wire, message);
  return wire.bytes();
}

template <class Message, class F>
Message messageOf(std::string_view bytes, const F& passFields) {
  WireReader wire(bytes);
  Message message;
  passFields(wire, message);
  wire.end();
  return message;
}

// What all of the receiving end throws: the other end does not keep to the protocol.
[[noreturn]] void throwBadAnswer(const std::string& what);

}  // namespace isolux::volume
