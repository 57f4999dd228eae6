// Any bytes as session text: parsed, or refused with an Error; what was parsed survives a round trip.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "app/documents/session.h"
#include "base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace isolux;
  const std::string text(data, data + size);
  try {
    const scene::Scene scene = app::parseSession(text, "fuzz.isolux", {"/folder"});
    const scene::Scene again =
        app::parseSession(app::sessionText(scene, "/folder"), "again.isolux", {"/folder"});
    if (!(again == scene)) std::abort();
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) std::abort();
  }
  return 0;
}
