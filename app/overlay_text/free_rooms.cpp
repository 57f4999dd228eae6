#include "app/overlay_text/free_rooms.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "app/overlay_text/annotation_layout.h"
#include "render/passes/legend_overlay.h"

namespace isolux::app {

namespace {

// Pixels, y down, as far as nothing is written there; `high` excluded.
struct PixelRoom {
  glm::dvec2 low, high;
};

// What is left of a room beside a box in a corner of the picture, and what is left over or under it.
std::array<PixelRoom, 2> beside(const PixelRoom& room, const PixelBox& box, glm::ivec2 picture) {
  std::array<PixelRoom, 2> parts{room, room};
  for (int axis = 0; axis < 2; ++axis) {
    PixelRoom& part = parts[static_cast<std::size_t>(axis)];
    if (2 * box.low[axis] + box.size[axis] > picture[axis])
      part.high[axis] = std::min<double>(part.high[axis], box.low[axis]);
    else
      part.low[axis] = std::max<double>(part.low[axis], box.high()[axis]);
  }
  return parts;
}

// The same about the middle of the picture along these axes.
PixelRoom central(PixelRoom room, glm::ivec2 picture, bool across, bool up) {
  for (int axis = 0; axis < 2; ++axis) {
    if (!(axis == 0 ? across : up)) continue;
    const double off = std::max(room.low[axis], picture[axis] - room.high[axis]);
    room.low[axis] = off;
    room.high[axis] = picture[axis] - off;
  }
  return room;
}

scene::Room roomOf(const PixelRoom& room, glm::ivec2 picture) {
  const glm::dvec2 size(picture);
  const glm::dvec2 low = (2.0 * room.low - size) / size.y, high = (2.0 * room.high - size) / size.y;
  return {{low.x, -high.y}, {high.x, -low.y}};
}

// What the texts of a finished picture take, beside what is taken there.
std::vector<PixelBox> textBoxes(const scene::Scene& resolved, const Annotation& annotation,
                                AnnotationLayout& layout, glm::ivec2 size) {
  std::vector<PixelBox> boxes;
  if (!AnnotationLayout::hasTexts(size)) return boxes;
  if (annotation.scaleBar)  // how long, and of how many mm, is known when the picture is framed
    boxes.push_back(layout.bar({0.0, AnnotationLayout::longestBar(size), "0.05 mm at the centre"}));
  if (!annotation.values.empty())
    boxes.push_back(layout.values(annotation.values, areKeyed(annotation.values, resolved)));
  return boxes;
}

}  // namespace

scene::Rooms freeRooms(const scene::Scene& resolved, const volume::PreparedVolume& volume, glm::ivec2 size,
                       const Edges& live, glm::ivec2 overlayLegend) {
  const glm::dvec2 picture(size);
  const auto between = [&](const Edges& edges) {
    return PixelRoom{{edges.side, edges.end}, picture - glm::dvec2(edges.side, edges.end)};
  };
  if (resolved.camera.frames == scene::Frames::volume) return {roomOf(between(live), size)};
  scene::Scene known = resolved;
  known.picture.caveats = false;  // small, and not known before the surface is
  const Annotation annotation = annotationOf(known, volume, size);
  AnnotationLayout layout(size);
  std::vector<PixelBox> boxes;
  for (const glm::ivec2& legend : {render::legendReserve(resolved, size), overlayLegend}) {
    if (legend.x <= 0) continue;
    const glm::ivec2 origin =
        render::legendPlace(resolved.look.legendCorner, legend, size, [&](const volume::Rectangle& asked) {
          std::int64_t covered = 0;
          for (const PixelBox& box : boxes) {
            const glm::ivec2 low(box.low.x, size.y - box.high().y);
            const glm::ivec2 shared = volume::common(asked, {low, box.size}).size;
            covered += std::int64_t{shared.x} * shared.y;
          }
          return covered;
        });
    boxes.push_back({{origin.x, size.y - origin.y - legend.y}, legend});
    layout.take(boxes.back());
  }
  for (const PixelBox& box : textBoxes(resolved, annotation, layout, size)) boxes.push_back(box);
  Edges edges = live;
  if (AnnotationLayout::hasLetters(size)) {
    const std::array<PixelBox, 4> letters = layout.letters(annotation.letters);
    for (const PixelBox& side : {letters[0], letters[1]})
      if (!side.empty()) edges.side = std::max<double>(edges.side, layout.margin() + side.size.x);
    for (const PixelBox& end : {letters[2], letters[3]})
      if (!end.empty()) edges.end = std::max<double>(edges.end, layout.margin() + end.size.y);
  }
  std::vector<PixelRoom> rooms{between(edges)};
  for (const PixelBox& box : boxes) {
    std::vector<PixelRoom> parts;
    for (const PixelRoom& room : rooms)
      for (const PixelRoom& part : beside(room, box, size)) parts.push_back(part);
    rooms = std::move(parts);
  }
  scene::Rooms result;
  for (const auto& [across, up] : {std::pair{true, true}, {true, false}, {false, true}, {false, false}})
    for (const PixelRoom& room : rooms) {
      const PixelRoom moved = central(room, size, across, up);
      const scene::Room one = roomOf(moved, size);
      const bool isNew = std::ranges::find(result, one) == result.end();
      if (isNew && moved.low.x < moved.high.x && moved.low.y < moved.high.y) result.push_back(one);
    }
  return result.empty() ? scene::wholePicture(picture.x / picture.y) : result;
}

}  // namespace isolux::app
