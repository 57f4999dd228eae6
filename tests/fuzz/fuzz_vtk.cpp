// Legacy VTK files in memory, and the check that stands before VTK's .vti reader.
#include "tests/fuzz/fuzz_support.h"
#include "volume/read/vtk/vti.h"
#include "volume/read/vtk/vtk_legacy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  if (fuzz::textOf(data, size).starts_with("# vtk")) {
    fuzz::readInMemory(data, size,
                       [&](const volume::Bytes& bytes) { return volume::parseVtkLegacyHeader(bytes); });
    return 0;
  }
  const volume::MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  try {
    volume::parseVtiHeader(bytes, {});
  } catch (const base::Error&) {
    return 0;
  }
  return 0;
}
