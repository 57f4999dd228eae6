// Finds places for texts on a picture, clear of one another, of other boxes and of lines.
//
// Pixels, y down.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace isolux::app {

template <class Point>
struct Box {
  Point low{0}, size{0};
  Point high() const { return low + size; }
  bool empty() const { return !(size.x > 0 && size.y > 0); }
};
using TextBox = Box<glm::dvec2>;
using PixelBox = Box<glm::ivec2>;

// Returns whether less than `gap` lies between the boxes.
template <class Point>
bool meet(const Box<Point>& a, const Box<Point>& b, typename Point::value_type gap) {
  return a.low.x < b.high().x + gap && b.low.x < a.high().x + gap && a.low.y < b.high().y + gap &&
         b.low.y < a.high().y + gap;
}

class FreePlaces {
 public:
  // Places lie within `picture`, and `gap` from all boxes that are taken, twice that from lines.
  FreePlaces(const TextBox& picture, double gap) : picture_(picture), gap_(gap) {}

  void take(const TextBox& box) { boxes_.push_back(box); }
  void takeLine(glm::dvec2 from, glm::dvec2 to) { lines_.emplace_back(from, to); }
  bool isFree(const TextBox& box) const { return clearOfBoxes(box) && clearOfLines(box); }
  // Takes `wanted`, else the nearest free place along that axis; where none is free, the nearest that is
  // clear of boxes at least. Nothing: there is no room.
  std::optional<TextBox> place(const TextBox& wanted, int axis);

 private:
  bool clearOfBoxes(const TextBox& box) const;
  bool clearOfLines(const TextBox& box) const;
  bool holds(const TextBox& box) const;

  TextBox picture_;
  double gap_;
  std::vector<TextBox> boxes_;
  std::vector<std::pair<glm::dvec2, glm::dvec2>> lines_;
};

}  // namespace isolux::app
