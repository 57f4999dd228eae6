// A volume whose coarser levels hide something.
#pragma once

#include <fstream>

#include <QString>

namespace isolux::test {

// A block that any level shows, and beside it needles of one voxel, which no coarser one does; uint8 of 64^3.
inline QString writeNeedles(const QString& name) {
  constexpr int n = 64;
  std::ofstream file(name.toStdString(), std::ios::binary);
  file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 3\nsizes: 64 64 64\n\n";
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const bool block = x > 8 && x < 28 && y > 8 && y < 56 && z > 8 && z < 56;
        const bool needle = x > 40 && y % 12 == 5 && z % 12 == 5;
        file.put(block || needle ? '\xb4' : '\0');
      }
  return name;
}

}  // namespace isolux::test
