// Paints the bounds of errors on a picture (app/accuracy/error_overlay.h) on a background thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/accuracy/error_overlay.h"
#include "base/task.h"

namespace isolux::app {

struct OverlaySubject {
  std::function<render::ColorImage()> picture;  // copied out on the thread
  std::shared_ptr<const PictureErrors> errors;  // of that picture, in its size
  OverlayWish wish;
  double shortestEdgeMm = 1.0;
  scene::LegendCorner corner = scene::LegendCorner::automatic;
  std::optional<render::Tile> taken;  // by the picture's own legend
};
struct MarkedPicture {
  render::ColorImage image;
  std::optional<render::Tile> legend;  // where it stands in it
};
using OverlayTask = base::Task<MarkedPicture>;
std::unique_ptr<OverlayTask> overlayTask(OverlaySubject asked);

}  // namespace isolux::app
