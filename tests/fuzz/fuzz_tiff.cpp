// The page directories of TIFF files in memory.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/tiff/tiff_pages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const volume::MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  const base::Progress progress;
  try {
    volume::tiffPages(bytes, progress);
  } catch (const base::Error&) {
    return 0;
  }
  return 0;
}
