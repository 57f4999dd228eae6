// The page directories of TIFF files in memory, and what they say of themselves.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/tiff/tiff_stack.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const volume::MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  const base::Progress progress;
  try {
    volume::TiffFile file = volume::tiffPages(bytes, progress);
    std::erase_if(file.pages, [&](const auto& page) { return !page.sameLayoutAs(file.pages.front()); });
    volume::tiffStackOf(file, bytes.name(), bytes.size());
  } catch (const base::Error&) {
    return 0;
  }
  return 0;
}
