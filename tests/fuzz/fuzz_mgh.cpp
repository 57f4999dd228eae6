// FreeSurfer's MGH files in memory, not gzipped.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/plain/mgh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  volume::looksLikeMgh(fuzz::textOf(data, size));
  fuzz::readInMemory(data, size, [&](const volume::Bytes& bytes) {
    return volume::parseMghHeader(fuzz::textOf(data, size), false, bytes.name());
  });
  return 0;
}
