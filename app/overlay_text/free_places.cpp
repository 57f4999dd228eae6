#include "app/overlay_text/free_places.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace isolux::app {

namespace {

// Liang and Barsky 1984: the part of the line that is inside of both axes' ranges.
bool crosses(glm::dvec2 from, glm::dvec2 to, const TextBox& box) {
  double enters = 0.0, leaves = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = to[axis] - from[axis], low = box.low[axis] - from[axis],
                 high = box.high()[axis] - from[axis];
    if (way == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    enters = std::max(enters, std::min(low / way, high / way));
    leaves = std::min(leaves, std::max(low / way, high / way));
  }
  return enters <= leaves;
}

}  // namespace

bool FreePlaces::clearOfBoxes(const TextBox& box) const {
  return std::ranges::none_of(boxes_, [&](const TextBox& taken) { return meet(box, taken, gap_); });
}

bool FreePlaces::clearOfLines(const TextBox& box) const {
  const double off = 2.0 * gap_;  // a line beside an I is read as one
  const TextBox around{box.low - off, box.size + 2.0 * off};
  return std::ranges::none_of(lines_,
                              [&](const auto& line) { return crosses(line.first, line.second, around); });
}

bool FreePlaces::holds(const TextBox& box) const {
  return glm::all(glm::greaterThanEqual(box.low, picture_.low)) &&
         glm::all(glm::lessThanEqual(box.high(), picture_.high()));
}

std::optional<TextBox> FreePlaces::place(const TextBox& wanted, int axis) {
  const auto nearest = [&](auto isGood) -> std::optional<TextBox> {
    for (double far = 0.0; far < picture_.size[axis]; far += 1.0)
      for (const double by : {-far, far}) {
        TextBox moved = wanted;
        moved.low[axis] += by;
        if ((far == 0.0 || holds(moved)) && isGood(moved)) return moved;
      }
    return std::nullopt;
  };
  auto found = nearest([&](const TextBox& box) { return isFree(box); });
  if (!found) found = nearest([&](const TextBox& box) { return clearOfBoxes(box); });
  if (found) take(*found);
  return found;
}

}  // namespace isolux::app
