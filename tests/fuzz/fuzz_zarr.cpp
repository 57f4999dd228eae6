// Zarr hierarchies in memory: metadata of both versions, OME's, shards and every codec. The input is a list
// of files, each "NAME LENGTH\n" and its bytes; what is opened lies at the root.
#include <charconv>
#include <map>
#include <memory>
#include <string>

#include "tests/fuzz/fuzz_support.h"
#include "tests/support/memory_store.h"
#include "volume/read/zarr/zarr.h"

namespace {

std::map<std::string, std::string> filesIn(std::string_view text) {
  std::map<std::string, std::string> files;
  while (files.size() < 64) {
    const std::size_t line = text.find('\n');
    const std::size_t space = text.substr(0, line).rfind(' ');
    if (line == std::string_view::npos || space == std::string_view::npos) break;
    std::size_t length = 0;
    const char* const begin = text.data() + space + 1;
    if (std::from_chars(begin, text.data() + line, length).ec != std::errc()) break;
    const std::string name(text.substr(0, space));
    text.remove_prefix(line + 1);
    length = std::min(length, text.size());
    files[name] = std::string(text.substr(0, length));
    text.remove_prefix(length);
  }
  return files;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const auto store = std::make_shared<const test::MemoryStore>(filesIn(fuzz::textOf(data, size)));
  base::Progress progress;
  base::machineMemory().setLimit(16 * fuzz::budgetBytes);  // of chunks
  try {
    const auto opened = volume::openZarr(store, "", "input", "");
    const volume::ChunkedFacts& facts = opened->facts();
    for (std::size_t level = 0; level < facts.levels.size(); ++level) {
      const glm::ivec3 dims = facts.levels[level].geometry.dims, part = glm::min(dims, glm::ivec3(8));
      std::vector<std::byte> voxels(512 * volume::bytesOf(facts.storedType));
      opened->read({facts.times - 1, facts.channels - 1}, level, dims - part, part, voxels);
    }
    volume::ReadOptions options;
    options.budgetBytes = fuzz::budgetBytes;
    fuzz::prepare(volume::wholeVolume(*opened, options, progress), progress);
  } catch (const base::Error&) {
    return 0;
  }
  return 0;
}
