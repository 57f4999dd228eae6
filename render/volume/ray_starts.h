// Provides the start depths of a frame's rays (volume/cast/start_depths.h) to shaders that cast rays, and
// draws only the tiles whose rays can meet anything.
#pragma once

#include <optional>

#include "render/gl/gl_objects.h"
#include "volume/cast/picture_area.h"
#include "volume/cast/start_depths.h"

namespace isolux::render {

class RayStarts {
 public:
  explicit RayStarts(const GlPtr& gl);

  // Returns log2 of a tile's pixels per axis: at most 256 tiles along the longer side, so that large images
  // cost no more.
  static int tileShift(glm::ivec2 size);

  // Uploads the depths of tiles of 1 << shift pixels, for an image of `size`.
  void update(const volume::StartDepths& depths, int shift, glm::ivec2 size);
  void clear(glm::ivec2 size);  // no ray can meet anything
  // Returns the area that draw() draws.
  const volume::PictureArea& area() const { return area_; }

  // Sets the inputs of start.glsl and fullscreen.vert.glsl (TILES), on texture unit `unit`.
  void bind(Program& program, int unit) const;
  // Draws the pixels of those tiles with the current program, as points: squares without a diagonal, because
  // pixel groups along a diagonal would be drawn twice. Changes the viewport.
  void draw() const;
  std::size_t bytes() const { return depths_.bytes() + buffer_.bytes(); }

 private:
  GlPtr gl_;
  Texture depths_;  // RG32F, texel per tile: StartDepths::Depths
  Buffer buffer_;   // squares of tiles: x, y, side
  VertexArray array_;
  std::size_t squares_ = 0;
  volume::PictureArea area_;
  int shift_ = 0;
};

}  // namespace isolux::render
