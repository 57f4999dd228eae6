#include "volume/read/length_doubt.h"

namespace isolux::volume {

std::optional<std::string> lengthDoubt(std::span<const std::string> warnings) {
  for (const std::string& warning : warnings)
    if (warning.find(kSpacingAssumed) != std::string::npos ||
        warning.find(kSlicesResampled) != std::string::npos)
      return warning;
  return std::nullopt;
}

}  // namespace isolux::volume
