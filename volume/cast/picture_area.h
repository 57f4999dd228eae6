// A part of an image: of each strip of rows, the columns between the first and the last that something is in.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace isolux::volume {

// Pixels [low, low + size).
struct Rectangle {
  glm::ivec2 low{0}, size{0};
  bool operator==(const Rectangle&) const = default;
};
// What is in both; of size 0 where nothing is.
Rectangle common(const Rectangle& a, const Rectangle& b);

class PictureArea {
 public:
  static constexpr int kRows = 16;  // of a strip

  PictureArea() = default;
  explicit PictureArea(glm::ivec2 imageSize);  // nothing of it
  static PictureArea of(glm::ivec2 imageSize, const Rectangle& part);
  static PictureArea whole(glm::ivec2 imageSize) { return of(imageSize, {glm::ivec2(0), imageSize}); }

  // The columns [begin, end) of a row.
  void add(int row, int begin, int end);
  // Of an image of the same size.
  void add(const PictureArea& other);
  glm::ivec2 size() const { return size_; }  // of the image
  bool empty() const;
  bool meets(const Rectangle& part) const;
  // Apart from one another; none is empty.
  std::vector<Rectangle> rectangles() const;

 private:
  struct Columns {
    int begin = 0, end = 0;  // none where they are the same
    bool operator==(const Columns&) const = default;
    void add(const Columns& other);
  };
  glm::ivec2 size_{0};
  std::vector<Columns> strips_;
};

// Returns the rectangles of what is in both.
std::vector<Rectangle> partsOf(const PictureArea& area, const Rectangle& within);

}  // namespace isolux::volume
