// Numbers and texts as bytes between the program and its readers (volume/read/process/reader_process.h).
//
// Both ends run on one machine, so numbers keep its byte order. The receiving end believes nothing: whatever
// is missing, left over or out of range throws base::Error{input}.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

namespace isolux::volume {

class WireWriter {
 public:
  void put(std::uint64_t number);
  void put(std::int64_t number) { put(static_cast<std::uint64_t>(number)); }
  void put(double number);
  void put(const glm::dmat4& matrix);
  void put(std::string_view text);
  void put(const std::vector<std::string>& texts);

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
  double real();                                                // any, NaN too
  double finite();
  glm::dmat4 finiteMatrix();
  std::string text();
  std::vector<std::string> texts(std::size_t most);
  void end() const;  // throws unless everything was taken

 private:
  std::string_view take(std::uint64_t count);
  std::string_view rest_;
};

// What all of the receiving end throws: the other end does not keep to the protocol.
[[noreturn]] void throwBadAnswer(const std::string& what);

}  // namespace isolux::volume
