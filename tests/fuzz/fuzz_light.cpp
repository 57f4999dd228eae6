// Files of stored light, read for the volume and the keys that those of the corpus are of.
#include "base/error.h"
#include "gi/file/bake_file.h"
#include "tests/fuzz/light_keys.h"
#include "tests/fuzz/memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  static const volume::Grid grid = fuzz::lightGrid();
  const fuzz::MemoryFile file(data, size);
  for (const char* key : {fuzz::kIrradianceKey, fuzz::kTransferKey}) {
    base::Progress progress;
    try {
      gi::readBakeFile(file.path(), grid, {}, key, fuzz::kLampsKey, progress);
    } catch (const base::Error& error) {
      if (error.kind() != base::ErrorKind::input && error.kind() != base::ErrorKind::memory) std::abort();
    }
  }
  return 0;
}
