// Any bytes as a recording: read, or refused with an Error; what was read has a scene at every time.
#include "app/documents/recording.h"
#include "base/error.h"
#include "tests/fuzz/memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const fuzz::MemoryFile file(data, size);
  try {
    const app::Recording recording = app::loadRecording(file.path());
    const double duration = recording.duration();
    if (!(duration >= 0.0)) std::abort();
    for (const double part : {0.0, 0.5, 1.0}) app::Playback(recording).at(part * duration);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) std::abort();
  }
  return 0;
}
