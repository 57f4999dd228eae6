#include "render/volume/ray_starts.h"

#include <algorithm>

namespace isolux::render {

namespace {

struct Square {
  std::int32_t x, y, size;  // tiles
};

// The tiles whose rays can meet anything, in squares as large as they may be: a quadtree.
class Squares {
 public:
  Squares(const volume::StartDepths& depths, int largest) : depths_(depths) {
    for (int y = 0; y < depths.tiles.y; y += largest)
      for (int x = 0; x < depths.tiles.x; x += largest)
        if (fill(x, y, largest)) squares_.push_back({x, y, largest});
  }
  const std::vector<Square>& all() const { return squares_; }

 private:
  // True: all of the square, and it is not among the squares yet.
  bool fill(int x, int y, int size) {
    if (x >= depths_.tiles.x || y >= depths_.tiles.y) return false;
    if (size == 1) return depths_.at(x, y).first <= depths_.at(x, y).last;
    const int half = size / 2;
    const Square parts[4] = {
        {x, y, half}, {x + half, y, half}, {x, y + half, half}, {x + half, y + half, half}};
    bool filled[4];
    for (int i = 0; i < 4; ++i) filled[i] = fill(parts[i].x, parts[i].y, half);
    if (filled[0] && filled[1] && filled[2] && filled[3]) return true;
    for (int i = 0; i < 4; ++i)
      if (filled[i]) squares_.push_back(parts[i]);
    return false;
  }

  const volume::StartDepths& depths_;
  std::vector<Square> squares_;
};

// The pixels of tiles whose rays can meet anything.
volume::PictureArea areaOf(const volume::StartDepths& depths, int shift, glm::ivec2 size) {
  volume::PictureArea area(size);
  for (int y = 0; y < depths.tiles.y; ++y)
    for (int x = 0; x < depths.tiles.x; ++x) {
      if (depths.at(x, y).first > depths.at(x, y).last) continue;
      const int end = std::min((y + 1) << shift, size.y);
      for (int row = y << shift; row < end;
           row += volume::PictureArea::kRows - row % volume::PictureArea::kRows)
        area.add(row, x << shift, std::min((x + 1) << shift, size.x));
    }
  return area;
}

// Of the squares' sides, a power of two.
int largestSquare(const Gl& gl, int tilePixels) {
  int tiles = 1;
  while (tiles < 16 && 2 * tiles * tilePixels <= gl.maxPointSize) tiles *= 2;
  return tiles;
}

}  // namespace

RayStarts::RayStarts(const GlPtr& gl) : gl_(gl), buffer_(gl), array_(gl) {
  gl->EnableVertexArrayAttrib(array_.id(), 0);
  gl->VertexArrayAttribIFormat(array_.id(), 0, 3, GL_INT, 0);
  gl->VertexArrayAttribBinding(array_.id(), 0, 0);
}

int RayStarts::tileShift(glm::ivec2 size) {
  constexpr int mostTiles = 256, least = 2;
  int shift = least;
  while (std::max(size.x, size.y) >> shift > mostTiles) ++shift;
  return shift;
}

void RayStarts::clear(glm::ivec2 size) {
  squares_ = 0;
  area_ = volume::PictureArea(size);
}

void RayStarts::update(const volume::StartDepths& depths, int shift, glm::ivec2 size) {
  shift_ = shift;
  area_ = areaOf(depths, shift, size);
  if (glm::ivec2(depths_.size()) != depths.tiles) depths_ = Texture::make2D(gl_, GL_RG32F, depths.tiles);
  depths_.write(GL_RG, GL_FLOAT, depths.depths.data());
  const Squares squares(depths, largestSquare(*gl_, 1 << shift));
  squares_ = squares.all().size();
  buffer_.setData(squares.all().data(), squares_ * sizeof(Square));
  gl_->VertexArrayVertexBuffer(array_.id(), 0, buffer_.id(), 0, sizeof(Square));
}

void RayStarts::bind(Program& program, int unit) const {
  if (squares_ == 0) return;
  program.setTexture("uStartDepths", unit, depths_);
  program.set("uTileShift", shift_);
  program.set("uTiles", glm::ivec2(depths_.size()));
}

void RayStarts::draw() const {
  if (squares_ == 0) return;
  // Whole tiles: a point is dropped where its middle lies outside.
  gl_->Viewport(0, 0, depths_.size().x << shift_, depths_.size().y << shift_);
  gl_->Enable(GL_PROGRAM_POINT_SIZE);
  gl_->BindVertexArray(array_.id());
  gl_->DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(squares_));
  gl_->Disable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace isolux::render
