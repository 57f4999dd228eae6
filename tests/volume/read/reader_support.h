// What the reader tests share: writing small files, and judging what came of reading them.
#pragma once

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/test_data.h"
#include "volume/read/reader.h"

namespace isolux::test {

void writeFile(const std::filesystem::path& path, const std::string& bytes);
std::string contentOfFile(const std::filesystem::path& path);
std::string gzipped(const std::string& bytes);
std::string zlibbed(const std::string& bytes);
std::string bzip2(const std::string& bytes);

// The bytes of numbers, little or big endian.
template <typename T>
std::string bytesOf(const std::vector<T>& values, bool big = false) {
  std::string bytes;
  for (const T& value : values) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

// 0, 1, 2, ... (times `step`, from `first`).
template <typename T>
std::vector<T> ramp(std::size_t count, T first = T(0), T step = T(1)) {
  std::vector<T> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<T>(first + static_cast<T>(i) * step));
  return values;
}

inline const std::vector<double> zeroToSeven = ramp<double>(8);

volume::Volume readFile(const std::filesystem::path& path, const volume::ReadOptions& options = {});

// All values of the grid, x fastest.
std::vector<double> valuesOf(const volume::Volume& volume);
// World position of a voxel, mm LPS.
glm::dvec3 worldOf(const volume::Volume& volume, int x, int y, int z);
void expectNear(const glm::dvec3& got, const glm::dvec3& wanted, double tolerance = 1e-9);
bool warns(const volume::Volume& volume, const std::string& part);

// Reading must throw Error{kind}; its one line must name `file` and hold `reason`.
void expectError(const std::filesystem::path& path, const std::string& reason,
                 const volume::ReadOptions& options = {}, base::ErrorKind kind = base::ErrorKind::input);

// A NIfTI-1 header and voxels, built field by field.
struct NiftiFile {
  std::vector<int> dims{2, 2, 2};
  int datatype = 2, bitpix = 8;
  std::vector<float> pixdim{1, 1, 1, 1};  // [0] is qfac
  float slope = 0, intercept = 0, voxOffset = 352;
  int qformCode = 0, sformCode = 0, units = 2, intent = 0;
  std::vector<float> quaternion{0, 0, 0}, qoffset{0, 0, 0};
  std::vector<float> srow{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::string magic = "n+1";
  bool big = false;
  std::string voxels;
  std::string bytes() const;
  std::string header() const;  // 348 bytes
};

}  // namespace isolux::test
