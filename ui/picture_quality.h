// Decides how fine the next picture is: coarse while something moves, then the full size, then the full
// supersampling. Plain logic, no Qt; times in milliseconds.
#pragma once

#include <glm/vec2.hpp>

#include "render/frame.h"

namespace isolux::ui {

class PictureQuality {
 public:
  enum class Stage { moving, sharp, full };

  PictureQuality() = default;
  // A software rasteriser starts with small pictures in motion instead of finding out with a slow one.
  explicit PictureQuality(bool software) : scale_(software ? 0.5 : 1.0) {}

  Stage stage() const { return stage_; }
  double scale() const { return stage_ == Stage::moving ? scale_ : 1.0; }

  // The scene or the size changed: the next picture has to be quick.
  void changed() { stage_ = Stage::moving; }
  // The next finer stage; false when the picture is already complete for this supersampling.
  bool refine(int supersampling);
  bool complete(int supersampling) const;
  // The time of a picture of this stage: pictures in motion shrink until they are quick enough.
  void measured(double milliseconds);

  // How long to wait for the user before the next finer picture: a slow one must not stand in the way.
  double pauseMilliseconds(int supersampling) const;

  // What to ask the renderer for.
  render::FrameRequest request(glm::ivec2 pixels, int supersampling) const;

 private:
  Stage stage_ = Stage::moving;
  double scale_ = 1.0;
  double lastMilliseconds_ = 0.0;
};

}  // namespace isolux::ui
