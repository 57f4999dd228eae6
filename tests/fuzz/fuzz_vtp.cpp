// VTK PolyData files (.vtp), as the process that reads them does: VTK, between our check and our conversion.
// What VTK itself does with damaged files is no business of this target but as far as its results are used.
#include <exception>

#include "readers/vtk/vtk_files.h"
#include "tests/fuzz/fuzz_mesh.h"
#include "tests/fuzz/memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const fuzz::MemoryFile file(data, size);
  try {
    fuzz::meshInMemory(data, size, [&](const volume::Bytes&, base::Progress& progress) {
      return readers::decodePolyData(file.path(), progress);
    });
  } catch (const std::exception&) {  // VTK's vectors: the process's end, and one line for the user
    return 0;
  }
  return 0;
}
