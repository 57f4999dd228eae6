// Compressed streams (gzip with any number of members, zlib), and what their first bytes say.
#include <array>

#include "tests/fuzz/fuzz_support.h"
#include "volume/read/input/streams.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const volume::MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  try {
    if (volume::inflatedHead(bytes, 4096).size() > 4096) std::abort();
    const auto stream = volume::inflateStream(bytes, 0, size);
    std::array<std::byte, 4096> chunk;
    for (std::size_t read = 0; read < fuzz::budgetBytes; read += chunk.size()) {
      stream->read(chunk);
      stream->hasMore();
    }
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) std::abort();
  }
  return 0;
}
