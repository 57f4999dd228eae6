// NIfTI files in memory, not gzipped.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/plain/nifti.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  volume::looksLikeNifti(fuzz::textOf(data, size));
  fuzz::readInMemory(data, size, [&](const volume::Bytes& bytes) {
    bool pairs = false;
    return volume::parseNiftiHeader(fuzz::textOf(data, size), bytes.name(), pairs);
  });
  return 0;
}
