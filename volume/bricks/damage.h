// Parts of a chunked volume that cannot be read: what they hold is not known, and nothing is drawn of it.
//
// A pass over all voxels goes on around them, so that one bad chunk of thousands does not hide the others.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/bricks/chunked_volume.h"

namespace isolux::volume {

struct DamagedPart {
  glm::ivec3 low{0}, size{0};  // voxels of the level that was read
  std::string error;           // one line: file, chunk and why

  bool operator==(const DamagedPart&) const = default;
};

// A volume with more of them is refused.
inline constexpr std::size_t kMostDamagedParts = 4096;

// file.read(), but where it throws Error{input}: chunk by chunk then (slice by slice in files that keep
// rows), and what cannot be read is 0 (NaN) and listed in `damaged`. Throws other errors. Returns the bytes
// read.
std::size_t readAround(const ChunkedVolume& file, VolumePart part, std::size_t level, glm::ivec3 low,
                       glm::ivec3 size, std::span<std::byte> voxels, std::vector<DamagedPart>& damaged);

// Adds one to those of a file unless it is among them. Throws Error{input} where there are too many.
void recordDamage(const std::string& file, DamagedPart&& part, std::vector<DamagedPart>& damaged);

// How many there are, and the first one's error: "a part of it cannot be read: ...".
std::string damageText(const std::vector<DamagedPart>& damaged);

// Whether any of them, of level 0, can be read again.
bool isRepaired(const ChunkedVolume& file, VolumePart part, const std::vector<DamagedPart>& damaged);

}  // namespace isolux::volume
