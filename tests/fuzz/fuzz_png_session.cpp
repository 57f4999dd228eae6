// Any bytes as a picture that may carry a session.
#include "app/documents/session.h"
#include "base/error.h"
#include "tests/fuzz/memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const fuzz::MemoryFile file(data, size);
  app::isSession(file.path());
  try {
    app::loadSession(file.path());
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) std::abort();
  }
  return 0;
}
