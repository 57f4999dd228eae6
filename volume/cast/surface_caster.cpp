#include "volume/cast/surface_caster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include <tbb/combinable.h>

#include "volume/cast/cast_kernels.h"
#include "volume/field/value_scaling.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

// How samples become texels (render/volume/volume_texture.h).
void scaleVoxels(const Grid& grid, casting::CastView& view) {
  const std::size_t bytes = bytesOf(grid.storedType());
  if (bytes == sizeof(float)) {
    const ValueScaling scaling = scalingOf(grid.storedMinimum(), grid.storedMaximum());
    view.offset = scaling.offset;
    view.scale = std::ldexp(1.0f, -scaling.exponent);
  } else {
    view.scale = bytes == 1 ? 1.0f / 255.0f : 1.0f / 65535.0f;
  }
}

void takeCoefficients(const Coefficients& coefficients, const Grid& grid, casting::CastView& view) {
  view.samples = coefficients.values.data();
  view.scale = std::ldexp(
      1.0f, -exponentOf(static_cast<double>(coefficients.least), static_cast<double>(coefficients.most)));
  if (view.gaps) view.gapsOf = std::get<std::vector<float>>(grid.voxels()).data();
}

void addHits(const CrossingImage& crossings, const Rectangle& part, PictureArea& area) {
  const auto hit = [](const glm::vec4& point) { return point.w >= 0.0f; };
  const glm::ivec2 end = part.low + part.size;
  for (int y = part.low.y; y < end.y; ++y) {
    const auto row = crossings.points.begin() + static_cast<std::ptrdiff_t>(y) * crossings.area.size().x;
    const auto begin = row + part.low.x, stop = row + end.x;
    const auto first = std::find_if(begin, stop, hit);
    if (first == stop) continue;
    const auto last = std::find_if(std::make_reverse_iterator(stop), std::make_reverse_iterator(first), hit);
    area.add(y, static_cast<int>(first - row), static_cast<int>(last.base() - row));
  }
}

bool anyBlock(const StartDepths& depths, const Rectangle& part) {
  const glm::ivec2 begin = part.low / StartDepths::kTile,
                   end = (part.low + part.size + (StartDepths::kTile - 1)) / StartDepths::kTile;
  for (int y = begin.y; y < end.y; ++y)
    for (int x = begin.x; x < end.x; ++x)
      if (depths.at(x, y).first <= depths.at(x, y).last) return true;
  return false;
}

// Calls draw(square) for squares of all pixels, on all threads; for some once a stop is asked for.
template <class Draw>
void forPieces(glm::ivec2 size, const std::stop_token& stop, const Draw& draw) {
  constexpr int piece = 32;  // pixels
  const glm::ivec2 pieces = (size + (piece - 1)) / piece;
  parallelEach(pieces.x * pieces.y, [&](int i) {
    if (stop.stop_requested()) return;
    const glm::ivec2 begin = piece * glm::ivec2(i % pieces.x, i / pieces.x);
    draw(Rectangle{begin, glm::min(begin + piece, size) - begin});
  });
}

}  // namespace

namespace casting {

VisibleCrossing visibleCrossing(const CastView& view, glm::ivec3 cell, const glm::dvec3& from,
                                const glm::dvec3& to, int inside, bool entered, bool first) {
  VisibleCrossing seen{.inside = inside};
  for (std::size_t k = 0; k < view.shown.size(); ++k) {
    const VisibilityIntervals way = view.shown[k].along(cell, from, to);
    std::span<const VisibilityIntervals::Part> parts = way.parts();
    const int bit = 1 << k;
    if (entered)
      seen.inside = parts.front().inside == view.insideIsAbove ? seen.inside | bit : seen.inside & ~bit;
    if (first) parts = parts.subspan(1);
    const bool onSide = ((seen.inside & bit) != 0) == view.insideIsAbove;
    const auto other = std::find_if(parts.begin(), parts.end(), [&](const VisibilityIntervals::Part& part) {
      return part.inside != onSide;
    });
    if (other == parts.end() || other->begin >= seen.s) continue;
    seen.s = other->begin;
    seen.changed = bit;
  }
  return seen;
}

}  // namespace casting

const char* SurfaceCaster::target() {
  const casting::CastKernels* const kernels = casting::castKernels(TracerTarget::automatic);
  return kernels ? kernels->set.name : nullptr;
}

SurfaceCaster::SurfaceCaster(const CastField& field, std::span<const double> storedIsovalues,
                             glm::ivec3 blocks, std::span<const std::uint64_t> masks, TracerTarget wanted)
    : masks_(masks), view_(std::make_unique<casting::CastView>()), kernels_(casting::castKernels(wanted)) {
  assert(kernels_ && !storedIsovalues.empty() && storedIsovalues.size() <= 4);
  casting::CastView& view = *view_;
  const Grid& grid = field.grid;
  view.dims = grid.dims();
  view.blockDims = blocks;
  view.masks = masks.data();
  view.gaps = grid.missingCount() > 0;
  view.cubic = field.field != scene::Field::trilinear;
  if (view.cubic) {
    const auto active = masks.size() - static_cast<std::size_t>(std::count(masks.begin(), masks.end(), 0u));
    cells_ = std::make_unique<casting::CellBitsOnDemand>(masks.size(), active);
    view.cells = cells_.get();
  }
  double origin = 0.0;  // of the samples, stored units
  if (field.field == scene::Field::cubic_interpolating) {
    takeCoefficients(*field.coefficients, grid, view);
    origin = field.coefficients->offset;
  } else {
    grid.visit([&](const auto& voxels) { view.samples = voxels.data(); });
    scaleVoxels(grid, view);
    origin = static_cast<double>(view.offset);
  }
  view.surfaces = static_cast<int>(storedIsovalues.size());
  view.isovalue = static_cast<float>(storedIsovalues[0] - origin);
  for (std::size_t k = 0; k < storedIsovalues.size(); ++k)
    view.shifts[k] = static_cast<float>(storedIsovalues[k] - storedIsovalues[0]) * view.scale;
  if (std::any_of(field.hidden.begin(), field.hidden.end(), [](const auto* hidden) { return hidden; })) {
    for (std::size_t k = 0; k < storedIsovalues.size(); ++k)
      shown_.emplace_back(grid, field.hidden[k], grid.valueOfStored(storedIsovalues[k]), field.inside,
                          field.field, field.coefficients);
    view.shown = shown_;
    view.insideIsAbove = (field.inside == scene::Inside::above) == (grid.slope() > 0.0);
  }
  if (field.region) {
    for (const glm::dvec4& face : field.region->faces()) view.faces[view.faceCount++] = glm::vec4(face);
    for (const ClipRegion::Removed& box : field.region->removed())
      view.removed[view.removedCount++] = {glm::vec3(box.low), glm::vec3(box.high)};
    view.axes = glm::mat3(field.region->axes());
  }
  view.clipped = field.clipped;
  view.rayEnds = field.rayEnds.empty() ? nullptr : field.rayEnds.data();
}

SurfaceCaster::~SurfaceCaster() = default;

StartDepths SurfaceCaster::startDepths(const PictureRays& rays, glm::ivec2 size) const {
  return volume::startDepths(rays, size, view_->dims, {view_->blockDims, masks_});
}

void SurfaceCaster::cast(const PictureRays& rays, const StartDepths& depths, const CastTarget& target) const {
  assert(target.begin.x % StartDepths::kTile == 0 && target.begin.y % StartDepths::kTile == 0);
  kernels_->cast(*view_, rays, depths, target);
}

CrossingImage::CrossingImage(glm::ivec2 size)
    : area(size),
      points(Extent2{size}.count(), {0.0f, 0.0f, 0.0f, -1.0f}),
      infos(points.size(), glm::vec2(0.0f)) {}

// Calls cast(target) for what may hit or has hit.
template <class MayHit, class Cast>
void SurfaceCaster::castPieces(CrossingImage& out, const std::stop_token& stop, const MayHit& mayHit,
                               const Cast& cast) {
  const glm::ivec2 size = out.area.size();
  tbb::combinable<PictureArea> areas([&] { return PictureArea(size); });
  forPieces(size, stop, [&](const Rectangle& part) {
    const bool may = mayHit(part);
    if (!may && !out.area.meets(part)) return;
    cast(CastTarget{part.low, part.low + part.size, out.points.data(), out.infos.data(),
                    static_cast<std::size_t>(size.x)});
    if (may) addHits(out, part, areas.local());
  });
  if (!stop.stop_requested()) out.area = PictureArea(size);  // else some of what was there may be left
  areas.combine_each([&](const PictureArea& area) { out.area.add(area); });
}

void SurfaceCaster::castAll(const PictureRays& rays, CrossingImage& out, const std::stop_token& stop) const {
  const StartDepths depths = startDepths(rays, out.area.size());
  castPieces(
      out, stop, [&](const Rectangle& part) { return anyBlock(depths, part); },
      [&](const CastTarget& target) { cast(rays, depths, target); });
}

void SurfaceCaster::castBehind(const PictureRays& rays, const CrossingsBefore& before, CrossingImage& out,
                               const std::stop_token& stop) const {
  assert(before.crossings.area.size() == out.area.size() && before.covered.size() == out.points.size());
  castPieces(
      out, stop, [&](const Rectangle& part) { return before.crossings.area.meets(part); },
      [&](const CastTarget& target) { kernels_->castBehind(*view_, rays, before, target); });
}

void SurfaceCaster::castShadows(const ShadowRays& shadow, const CrossingImage& hits,
                                std::span<const glm::vec4> gradients, ShadowImage& out,
                                const std::stop_token& stop) const {
  const glm::ivec2 size = hits.area.size();
  assert(gradients.size() == hits.points.size());
  if (out.area.size() != size) out.area = PictureArea(size);
  out.lit.resize(hits.points.size());
  forPieces(size, stop, [&](const Rectangle& part) {
    if (!hits.area.meets(part) && !out.area.meets(part)) return;
    kernels_->shadows(*view_, shadow,
                      {part.low, part.low + part.size, hits.points.data(), hits.infos.data(),
                       gradients.data(), out.lit.data(), static_cast<std::size_t>(size.x)});
  });
  if (!stop.stop_requested()) out.area = PictureArea(size);
  out.area.add(hits.area);
}

}  // namespace isolux::volume
