// NRRD files in memory: header, then the voxels behind it.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/plain/nrrd.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  fuzz::readInMemory(data, size, [&](const volume::Bytes& bytes) {
    return volume::parseNrrdHeader(fuzz::textOf(data, size), bytes.name());
  });
  return 0;
}
