// MetaImage files in memory: header, then the voxels behind it.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/plain/meta_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  volume::looksLikeMetaImage(fuzz::textOf(data, size));
  fuzz::readInMemory(data, size, [&](const volume::Bytes& bytes) {
    return volume::parseMetaImageHeader(fuzz::textOf(data, size), bytes.name());
  });
  return 0;
}
