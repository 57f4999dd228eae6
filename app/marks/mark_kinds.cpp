#include "app/marks/mark_kinds.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string_view>

namespace isolux::app {

namespace {

using scene::MarkKind;

constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

constexpr MarkKindInfo kMarkKinds[] = {
    {MarkKind::point, "point", "Pin", 1, 1, "one point"},
    {MarkKind::distance, "distance", "Distance", 2, kAnyNumber, "two points or more"},
    {MarkKind::path, "path", "Path", 2, kAnyNumber, "two points or more"},
    {MarkKind::angle, "angle", "Angle", 3, 4, "three or four points"},
    {MarkKind::circle, "circle", "Circle", 3, 3, "three points"},
    {MarkKind::thickness, "thickness", "Thickness", 1, 1, "one point"},
    {MarkKind::piece, "piece", "Piece", 1, 1, "one point"},
};

}  // namespace

std::span<const MarkKindInfo> markKinds() {
  return kMarkKinds;
}

const MarkKindInfo& markKind(MarkKind kind) {
  return *std::find_if(std::begin(kMarkKinds), std::end(kMarkKinds),
                       [kind](const MarkKindInfo& info) { return info.kind == kind; });
}

std::string wrongPoints(const scene::Mark& mark) {
  const MarkKindInfo& info = markKind(mark.kind);
  if (mark.points.size() >= info.fewest && mark.points.size() <= info.most) return {};
  return std::string("a mark of kind ") + info.name + " has " + info.points + ", not " +
         std::to_string(mark.points.size());
}

std::string freshName(MarkKind kind, std::span<const scene::Mark> marks) {
  return freshName(markKind(kind).title, marks);
}

std::string freshName(const std::string& title, std::span<const scene::Mark> marks) {
  std::set<std::string_view> taken;
  for (const scene::Mark& mark : marks) taken.insert(mark.name);
  for (std::size_t number = 1;; ++number)
    if (const std::string name = title + ' ' + std::to_string(number); !taken.contains(name)) return name;
}

}  // namespace isolux::app
