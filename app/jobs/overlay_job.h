// Paints the bounds of errors on a picture (app/accuracy/error_overlay.h) on a background thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/accuracy/error_overlay.h"
#include "app/jobs/quiet_job.h"

namespace isolux::app {

struct OverlayWork {
  struct Subject {
    std::function<render::ColorImage()> picture;  // copied out on the thread
    std::shared_ptr<const PictureErrors> errors;  // of that picture, in its size
    OverlayWish wish;
    double shortestEdgeMm = 1.0;
    scene::LegendCorner corner = scene::LegendCorner::automatic;
    std::optional<render::Tile> taken;  // by the picture's own legend
  };
  static constexpr const char* kDoes = "show errors on the image";
  void run(base::Progress&) {
    painted = subject.picture();
    legend = paintErrors(*subject.errors, subject.wish, subject.shortestEdgeMm, subject.corner, subject.taken,
                         painted);
  }

  Subject subject;
  render::ColorImage painted{};
  std::optional<render::Tile> legend{};  // where it stands in it
};

class OverlayJob : public QuietJob<OverlayWork> {
 public:
  using QuietJob::QuietJob;
  // After finished(), without an error.
  const render::ColorImage& painted() const { return work().painted; }
  const std::optional<render::Tile>& legend() const { return work().legend; }
};

}  // namespace isolux::app
