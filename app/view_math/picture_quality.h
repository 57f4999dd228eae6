// Decides how fine the next picture is. Plain logic, no Qt; times in milliseconds.
//
// While something moves, pictures take the finest level that keeps picture.motion_target; at rest the full
// size follows, then the full supersampling. The time of a picture is taken to grow at most with its rays: a
// level is left when a picture took longer than the target, and a finer one taken only when it should stay
// well below it, so that the level settles. Without picture.adaptive every picture is the full one.
//
// A change of the look alone casts no rays as long as the size stays: it starts at the level that is on
// screen.
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "render/graph/frame.h"
#include "scene/scene.h"
#include "scene/settings/host_settings.h"

namespace isolux::app {

// What moves: what the rays hit, or only how it is shown. Each has a level of its own.
enum class Motion { rays, look };

class PictureQuality {
 public:
  enum class Stage { moving, sharp, full };

  // A software rasteriser starts with small pictures in motion instead of finding out with a slow one.
  explicit PictureQuality(bool software = false);

  void setSupersampling(int rays) { supersampling_ = rays; }  // picture.supersampling
  void setHostSettings(const scene::HostSettings& host) { host_ = host; }

  Stage stage() const { return stage_; }
  double scale() const;       // of the next picture's width and height, 0..1
  int supersampling() const;  // of the next picture
  bool complete() const;      // the next picture is the full one

  // Something changed: the next picture has to be quick.
  void changed(Motion motion);
  // An animation went on by itself: a look that moves, without waiting for a finer picture being put off.
  void animated();
  // Stored light comes in at rest: pictures follow one another, at the full size but with one ray per pixel,
  // until it ends.
  void setLightChanging(bool changing);
  // The next finer stage; false when the picture is already complete, or while its light still changes.
  bool refine();
  bool mayRefine() const;
  // The time of a picture that request() asked for; `motion`: rays when rays were cast for it.
  void measured(double milliseconds, Motion motion);

  // How long to wait for the user before the next finer picture: a slow one must not stand in the way.
  double pauseMilliseconds() const;

  // What to ask the renderer for.
  render::FrameRequest request(glm::ivec2 pixels) const;

 private:
  std::size_t level(Motion motion) const;

  int supersampling_ = scene::Picture{}.supersampling;
  scene::HostSettings host_;
  Stage stage_ = Stage::moving;
  Motion motion_ = Motion::rays;
  bool lightChanging_ = false;
  // Indices into the levels of the .cpp file: what each Motion can afford, and what was on screen when the
  // look began to move.
  std::size_t levels_[2], ceiling_;
  double lastMilliseconds_ = 0.0;
};

}  // namespace isolux::app
