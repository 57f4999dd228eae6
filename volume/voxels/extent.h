// Provides the sizes of images and volumes with the indices of their elements, and the corners of cells.
//
// x varies fastest in memory. Counts and indices have 64 bits; coordinates are those of elements, from 0.
#pragma once

#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace isolux::volume {

// Returns corner i, 0 .. 7, of the cell from (0, 0, 0) to (1, 1, 1): x is bit 0 of i, y bit 1, z bit 2.
template <class Index>
glm::ivec3 cornerStep(Index i) {
  return {static_cast<int>(i & 1), static_cast<int>(i >> 1 & 1), static_cast<int>(i >> 2)};
}

// Calls visit(v) for each v with low <= v < end on every axis, in the order of memory.
template <class Visit>
void forEachIn(glm::ivec3 low, glm::ivec3 end, const Visit& visit) {
  for (int z = low.z; z < end.z; ++z)
    for (int y = low.y; y < end.y; ++y)
      for (int x = low.x; x < end.x; ++x) visit(glm::ivec3(x, y, z));
}

struct Extent2 {
  glm::ivec2 size{0};

  std::size_t row() const { return static_cast<std::size_t>(size.x); }
  std::size_t count() const { return row() * static_cast<std::size_t>(size.y); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * row() + static_cast<std::size_t>(x);
  }
  std::size_t index(glm::ivec2 p) const { return index(p.x, p.y); }
  // Returns the element that has this index.
  glm::ivec2 at(std::size_t i) const { return {static_cast<int>(i % row()), static_cast<int>(i / row())}; }
  bool contains(glm::ivec2 p) const { return p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y; }
};

struct Extent3 {
  glm::ivec3 dims{0};

  std::size_t row() const { return static_cast<std::size_t>(dims.x); }
  std::size_t slice() const { return row() * static_cast<std::size_t>(dims.y); }
  std::size_t rows() const { return static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z); }
  std::size_t count() const { return row() * rows(); }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(y)) *
               row() +
           static_cast<std::size_t>(x);
  }
  std::size_t index(glm::ivec3 v) const { return index(v.x, v.y, v.z); }
  // Return the element that has this index, and the first one of a row, 0 .. rows() - 1.
  glm::ivec3 at(std::size_t i) const {
    return firstOfRow(i / row()) + glm::ivec3(static_cast<int>(i % row()), 0, 0);
  }
  glm::ivec3 firstOfRow(std::size_t i) const {
    const auto height = static_cast<std::size_t>(dims.y);
    return {0, static_cast<int>(i % height), static_cast<int>(i / height)};
  }
  bool contains(glm::ivec3 v) const {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < dims.x && v.y < dims.y && v.z < dims.z;
  }
  // Returns corner i of a cell. On an axis of one voxel both corners are that voxel.
  template <class Index>
  glm::ivec3 corner(glm::ivec3 cell, Index i) const {
    return glm::min(cell + cornerStep(i), dims - 1);
  }
};

}  // namespace isolux::volume
