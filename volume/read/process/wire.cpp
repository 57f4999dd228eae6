#include "volume/read/process/wire.h"

#include <cmath>
#include <cstring>

#include "base/error.h"

namespace isolux::volume {

void throwBadAnswer(const std::string& what) {
  base::throwInput("", "answer of the reader", what);
}

void WireWriter::put(std::uint64_t number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes_.append(raw, sizeof raw);
}

void WireWriter::passFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) put(matrix[column][row]);
}

void WireWriter::put(std::string_view text) {
  put(static_cast<std::uint64_t>(text.size()));
  bytes_.append(text);
}

std::string_view WireReader::take(std::uint64_t count) {
  if (count > rest_.size()) throwBadAnswer("ends too early");
  const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
  rest_.remove_prefix(taken.size());
  return taken;
}

std::uint64_t WireReader::number() {
  std::uint64_t number = 0;
  std::memcpy(&number, take(sizeof number).data(), sizeof number);
  return number;
}

std::uint64_t WireReader::number(std::uint64_t low, std::uint64_t high) {
  const std::uint64_t value = number();
  if (value < low || value > high) throwBadAnswer("a number is out of range");
  return value;
}

double WireReader::finite() {
  const double value = real();
  if (!std::isfinite(value)) throwBadAnswer("a number is not finite");
  return value;
}

void WireReader::passFinite(glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) matrix[column][row] = finite();
}

void WireReader::end() const {
  if (!rest_.empty()) throwBadAnswer("continues beyond its end");
}

}  // namespace isolux::volume
