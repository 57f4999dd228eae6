#include <stop_token>

#include "render/passes/passes.h"
#include "volume/cast/hit_info.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/pieces/pieces.h"

namespace isolux::render {

namespace {

constexpr float kNoPiece = -1.0f;

using PiecesOfSurfaces = std::vector<std::shared_ptr<const volume::Pieces>>;

PiecesOfSurfaces piecesOf(const FrameState& frame) {
  base::Progress progress;
  const std::stop_callback stop(frame.request.stop, [&progress] { progress.requestStop(); });
  PiecesOfSurfaces pieces;
  for (std::size_t i = 0; i < frame.surfaces.size(); ++i)
    pieces.push_back(frame.volumeOf(i).prepared()->pieces->at(frame.surfaces[i].value,
                                                              frame.scene->isosurface.inside, progress));
  return pieces;
}

// Of a rectangle of the picture, row by row.
std::vector<float> idsOf(const FrameState& frame, const PiecesOfSurfaces& pieces,
                         const volume::Rectangle& part) {
  const std::vector<float> points = frame.image(image::surface, 0).readFloats(4, part);
  const std::vector<float> infos = frame.image(image::surface, 1).readFloats(2, part);
  std::vector<float> ids(points.size() / 4, kNoPiece);
  volume::parallelRanges(ids.size(), 1024, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const float* const p = &points[4 * i];
      if (!(p[3] >= 0.0f)) continue;
      const auto surface = static_cast<std::size_t>(volume::HitInfo::of(infos[2 * i + 1]).surface());
      if (surface >= pieces.size()) continue;
      const std::uint32_t id = volume::pieceOfSurface(*pieces[surface], {p[0], p[1], p[2]});
      if (id != volume::Pieces::kNone) ids[i] = static_cast<float>(id);
    }
  });
  return ids;
}

void declarePiece(Declaring& d) {
  d.reads(image::surface).writes(image::piece, 4).volume().isovalues().settings({"isosurface.inside"});
}

void findPieces(FrameState& frame) {
  Target& target = frame.target(image::piece, {GL_R32F});
  const float none[4] = {kNoPiece, 0.0f, 0.0f, 0.0f};
  frame.clear(target, {none});
  if (frame.empty()) return;
  const PiecesOfSurfaces pieces = piecesOf(frame);
  for (const volume::Rectangle& part : frame.area().rectangles())
    target.images[0].write(GL_RED, GL_FLOAT, idsOf(frame, pieces, part).data(), part);
}

}  // namespace

Pass piecePass() {
  return {.name = "piece", .declare = declarePiece, .run = findPieces, .cpu = Pass::Cpu::always};
}

}  // namespace isolux::render
