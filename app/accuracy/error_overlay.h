// Bounds of errors as colours on a finished picture, and hatching where they exceed what was asked for: what
// `isolux render --error-overlay` paints.
//
// Pictures in pixels, row 0 at the top. Any thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy/error_images.h"
#include "app/accuracy/error_limits.h"
#include "base/task.h"
#include "render/graph/frame.h"

namespace isolux::app {

struct OverlayRequest {
  bool asked = false;
  std::optional<ErrorImage> colors;  // none: the picture keeps its own
  std::vector<Limit> limits;         // of --error
};
// "noise", "normal_noise", "kappa_noise", "depth", "normal", "kappa", "light" or "limits"; "": nothing is
// asked for. Throws Error{usage} naming those that are known, and where limits are asked for and there are
// none that pixels can exceed.
OverlayRequest parseOverlay(const std::string& text, std::vector<Limit> limits);
std::string overlayNames();

// Which pixels are hatched: 1 where a bound exceeds its limit, and where nothing is certain. `colors`: its
// limits alone count. A depth in voxels counts along the shortest edge of a voxel.
std::vector<std::uint8_t> hatchedPixels(const PictureErrors& errors, const OverlayRequest& request,
                                        double shortestEdgeMm);

// How large the legend may become in a picture of this size, in pixels; 0: there is none.
glm::ivec2 overlayReserve(const OverlayRequest& request, glm::ivec2 picture);

// Colours of the logarithm of a bound (cividis), as bright as the picture is there; hatching; and a legend in
// the corner that look.legend_corner says. Says where the legend stands, as render::FrameReport has it; none
// where there is no room for one, and on a picture that shows no bound. Throws Error{usage} of light where
// none is stored.
std::optional<render::Tile> paintErrors(const PictureErrors& errors, const OverlayRequest& request,
                                        double shortestEdgeMm, scene::LegendCorner corner,
                                        const std::optional<render::Tile>& taken, render::ColorImage& image);

// The same on a background thread.
struct OverlaySubject {
  std::function<render::ColorImage()> picture;  // copied out on the thread
  std::shared_ptr<const PictureErrors> errors;  // of that picture, in its size
  OverlayRequest request;
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
