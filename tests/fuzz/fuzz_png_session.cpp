// Any bytes as a picture that may carry a session.
#include "app/session.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const fuzz::MemoryFile file(data, size);
  app::isSession(file.path());
  try {
    app::loadSession(file.path());
  } catch (const scene::Error& error) {
    if (error.kind() != scene::ErrorKind::input) std::abort();
  }
  return 0;
}
