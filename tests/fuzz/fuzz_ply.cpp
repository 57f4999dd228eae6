// PLY meshes, text and binary.
#include "tests/fuzz/fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  isolux::fuzz::meshInMemory(data, size, isolux::volume::readPlyMesh);
  return 0;
}
