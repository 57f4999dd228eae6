// Raw descriptions ("256x256x128 int16 big"); what parses must survive the way to text and back.
#include <cstdlib>

#include "tests/fuzz/fuzz_support.h"
#include "volume/read/plain/raw.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  try {
    const auto first = volume::parseRawDescription(std::string(fuzz::textOf(data, size)));
    const auto second = volume::parseRawDescription(volume::toText(first));
    if (first.dims != second.dims || first.type != second.type || first.endianness != second.endianness ||
        first.spacingMm != second.spacingMm || first.headerBytes != second.headerBytes)
      std::abort();
    volume::headerOfRaw(first, "input");
  } catch (const base::Error&) {
    return 0;
  }
  return 0;
}
