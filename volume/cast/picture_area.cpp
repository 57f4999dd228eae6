#include "volume/cast/picture_area.h"

#include <algorithm>
#include <cassert>

#include <glm/common.hpp>

namespace isolux::volume {

Rectangle common(const Rectangle& a, const Rectangle& b) {
  const glm::ivec2 low = glm::max(a.low, b.low), high = glm::min(a.low + a.size, b.low + b.size);
  return {low, glm::max(high - low, glm::ivec2(0))};
}

void PictureArea::Columns::add(const Columns& other) {
  if (other.begin == other.end) return;
  if (begin == end)
    *this = other;
  else
    *this = {std::min(begin, other.begin), std::max(end, other.end)};
}

PictureArea::PictureArea(glm::ivec2 imageSize)
    : size_(imageSize), strips_(static_cast<std::size_t>((imageSize.y + kRows - 1) / kRows)) {}

PictureArea PictureArea::of(glm::ivec2 imageSize, const Rectangle& part) {
  PictureArea area(imageSize);
  const Rectangle there = common(part, {glm::ivec2(0), imageSize});
  const glm::ivec2 end = there.low + there.size;
  if (there.size.x == 0) return area;
  for (int row = there.low.y; row < end.y; row += kRows - row % kRows) area.add(row, there.low.x, end.x);
  return area;
}

void PictureArea::add(int row, int begin, int end) {
  assert(row >= 0 && row < size_.y && begin >= 0 && end <= size_.x && begin <= end);
  strips_[static_cast<std::size_t>(row / kRows)].add({begin, end});
}

void PictureArea::add(const PictureArea& other) {
  assert(size_ == other.size_);
  for (std::size_t i = 0; i < strips_.size(); ++i) strips_[i].add(other.strips_[i]);
}

bool PictureArea::empty() const {
  return std::all_of(strips_.begin(), strips_.end(), [](const Columns& c) { return c.begin == c.end; });
}

bool PictureArea::meets(const Rectangle& part) const {
  const int begin = part.low.x, end = begin + part.size.x;
  for (int strip = part.low.y / kRows; strip * kRows < part.low.y + part.size.y; ++strip) {
    const Columns& columns = strips_[static_cast<std::size_t>(strip)];
    if (columns.begin < std::min(columns.end, end) && begin < columns.end) return true;
  }
  return false;
}

// Strips of the same columns are one rectangle.
std::vector<Rectangle> PictureArea::rectangles() const {
  std::vector<Rectangle> list;
  int row = 0;
  Columns before;
  for (const Columns& columns : strips_) {
    const int rows = std::min(kRows, size_.y - row);
    if (columns.begin < columns.end) {
      if (columns == before)
        list.back().size.y += rows;
      else
        list.push_back({{columns.begin, row}, {columns.end - columns.begin, rows}});
    }
    before = columns;
    row += rows;
  }
  return list;
}

std::vector<Rectangle> partsOf(const PictureArea& area, const Rectangle& within) {
  std::vector<Rectangle> parts;
  for (const Rectangle& one : area.rectangles())
    if (const Rectangle part = common(one, within); part.size.x > 0 && part.size.y > 0) parts.push_back(part);
  return parts;
}

}  // namespace isolux::volume
