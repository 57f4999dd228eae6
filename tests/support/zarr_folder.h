// A volume written as Zarr version 2 in chunks that are not packed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace isolux::test {

inline std::string chunkName(glm::ivec3 chunk) {
  return std::to_string(chunk.z) + "." + std::to_string(chunk.y) + "." + std::to_string(chunk.x);
}

// Voxels x fastest; chunks at the far borders are as large as the others, filled with 0.
template <class T>
void writeZarr(const std::filesystem::path& folder, glm::ivec3 dims, glm::ivec3 chunk,
               const std::vector<T>& voxels) {
  std::filesystem::create_directories(folder);
  const auto list = [](glm::ivec3 n) {
    return "[" + std::to_string(n.z) + ", " + std::to_string(n.y) + ", " + std::to_string(n.x) + "]";
  };
  const char kind = std::is_floating_point_v<T> ? 'f' : std::is_signed_v<T> ? 'i' : 'u';
  std::ofstream(folder / ".zarray")
      << R"({"zarr_format": 2, "shape": )" << list(dims) << R"(, "chunks": )" << list(chunk)
      << R"(, "dtype": ")" << (sizeof(T) == 1 ? '|' : '<') << kind << sizeof(T)
      << R"(", "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
  const glm::ivec3 chunks = (dims + chunk - 1) / chunk;
  for (int cz = 0; cz < chunks.z; ++cz)
    for (int cy = 0; cy < chunks.y; ++cy)
      for (int cx = 0; cx < chunks.x; ++cx) {
        std::vector<T> bytes;
        for (int z = cz * chunk.z; z < (cz + 1) * chunk.z; ++z)
          for (int y = cy * chunk.y; y < (cy + 1) * chunk.y; ++y)
            for (int x = cx * chunk.x; x < (cx + 1) * chunk.x; ++x) {
              const bool inside = x < dims.x && y < dims.y && z < dims.z;
              bytes.push_back(inside ? voxels[static_cast<std::size_t>((z * dims.y + y) * dims.x + x)]
                                     : T(0));
            }
        std::ofstream(folder / chunkName({cx, cy, cz}), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size() * sizeof(T)));
      }
}

// What a copy that was interrupted leaves of a chunk.
inline void cutChunk(const std::filesystem::path& folder, glm::ivec3 chunk) {
  const std::filesystem::path file = folder / chunkName(chunk);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
}

}  // namespace isolux::test
