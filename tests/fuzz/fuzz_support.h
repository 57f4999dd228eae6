// What the volume fuzz targets share: read an in-memory file as far as its header allows, and prepare what
// was read as every opened volume is.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "base/error.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/input/payload.h"

namespace isolux::fuzz {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

constexpr std::size_t budgetBytes = std::size_t{1} << 20;

// What pictures start from must be numbers, whatever the voxels and their scaling are.
inline void prepare(volume::Volume volume, base::Progress& progress) {
  const auto prepared = volume::prepareVolume(std::move(volume), progress);
  const scene::VolumeFacts& facts = prepared->facts;
  const volume::DerivativeChoice choice =
      prepared->derivativeChoices->choose({facts.suggestedIsovalue}, progress);
  for (const double number :
       {choice.noise, choice.scaleMm, choice.normalScaleMm, facts.suggestedIsovalue, facts.minimum,
        facts.maximum, facts.boundsMinMm.x, facts.boundsMinMm.y, facts.boundsMinMm.z, facts.boundsMaxMm.x,
        facts.boundsMaxMm.y, facts.boundsMaxMm.z})
    if (!std::isfinite(number)) std::abort();
}

// Decodes with a budget of 1 MiB; no other file can be opened. Errors are the expected end of most inputs.
template <typename Parse>
void readInMemory(const std::uint8_t* data, std::size_t size, Parse&& parse) {
  using namespace volume;
  const MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  const OpenBeside nothing = [](const std::string& name) -> std::unique_ptr<Bytes> {
    base::throwInput("input", name, "no other file here");
  };
  base::Progress progress;
  for (const int component : {0, -1}) {
    ReadOptions options;
    options.component = component;
    options.budgetBytes = budgetBytes;
    try {
      prepare(volumeFrom(parse(bytes), bytes, nothing, options, progress), progress);
    } catch (const base::Error&) {
      continue;
    }
  }
}

}  // namespace isolux::fuzz
