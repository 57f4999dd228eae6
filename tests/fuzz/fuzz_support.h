// What the volume fuzz targets share: read an in-memory file as far as its header allows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "scene/error.h"
#include "volume/read/payload.h"

namespace isolux::fuzz {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Decodes with a budget of 1 MiB; no other file can be opened. Errors are the expected end of most inputs.
template <typename Parse>
void readInMemory(const std::uint8_t* data, std::size_t size, Parse&& parse) {
  using namespace volume;
  const MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  const OpenBeside nothing = [](const std::string& name) -> std::unique_ptr<Bytes> {
    scene::throwInput("input", name, "no other file here");
  };
  scene::Progress progress;
  for (const int component : {0, -1}) {
    ReadOptions options;
    options.component = component;
    options.budgetBytes = std::size_t{1} << 20;
    try {
      volumeFrom(parse(bytes), bytes, nothing, options, progress);
    } catch (const scene::Error&) {
      continue;
    }
  }
}

}  // namespace isolux::fuzz
