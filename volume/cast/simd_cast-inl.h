// The kernels of the caster for one instruction set. Included by a source that CMake makes for each set
// (isolux_simd_sources() in cmake/IsoluxTargets.cmake); castKernels() chooses among them at run time.
#include "volume/cast/cast_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/cast/simd_cast-inl.h"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "volume/cast/derivatives-inl.h"
#include "volume/cast/edges-inl.h"
#include "volume/cast/kept_crossings-inl.h"
#include "volume/cast/shadows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

constexpr int kTile = StartDepths::kTile;

// The rays of a packet: four pixels wide.
struct Packet {
  VF origin[3], direction[3];
  VF slant;  // mm along the ray for each mm of depth
  VF voxel;  // mm along the ray
};

HWY_INLINE Packet packetAt(const PictureRays& rays, glm::ivec2 pixel) {
  const F f;
  const VI lane = hn::Iota(I(), 0);
  const auto along = [&](VI offset, int axis) {
    const VF at = hn::ConvertTo(f, hn::Add(offset, hn::Set(I(), pixel[axis] + rays.origin[axis])));
    const float size = static_cast<float>(rays.picture[axis]);
    const VF part = hn::Div(hn::Add(at, hn::Set(f, 0.5f)), hn::Set(f, size));
    return hn::Mul(hn::Sub(hn::Add(part, part), hn::Set(f, 1.0f)), hn::Set(f, rays.halfExtent[axis]));
  };
  const VF x = along(hn::And(lane, hn::Set(I(), kTile - 1)), 0), y = along(hn::ShiftRight<2>(lane), 1);
  Packet packet;
  packet.slant =
      rays.orthographic ? hn::Set(f, 1.0f) : hn::Sqrt(hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Set(f, 1.0f))));
  for (int axis = 0; axis < 3; ++axis) {
    const VF eye = hn::Set(f, rays.eye[axis]), forward = hn::Set(f, rays.forward[axis]);
    const VF offset = hn::MulAdd(x, hn::Set(f, rays.right[axis]), hn::Mul(y, hn::Set(f, rays.up[axis])));
    if (rays.orthographic) {
      packet.origin[axis] = hn::Add(eye, offset);
      packet.direction[axis] = forward;
    } else {
      packet.origin[axis] = hn::MulAdd(hn::Set(f, rays.startDepth), offset, eye);
      packet.direction[axis] = hn::Div(hn::Add(forward, offset), packet.slant);
    }
  }
  const auto& d = packet.direction;
  packet.voxel = hn::Div(hn::Set(f, 1.0f),
                         hn::Sqrt(hn::MulAdd(d[0], d[0], hn::MulAdd(d[1], d[1], hn::Mul(d[2], d[2])))));
  return packet;
}

// A packet's results in their places, without those beyond the end.
HWY_INLINE void store(const CastTarget& target, glm::ivec2 pixel, const VF (&point)[3], VF t, VF error,
                      VF known) {
  const F f;
  alignas(64) float points[4 * kLanes], infos[2 * kLanes];
  hn::StoreInterleaved4(point[0], point[1], point[2], t, f, points);
  hn::StoreInterleaved2(error, known, f, infos);
  const auto width = static_cast<std::size_t>(std::min(kTile, target.end.x - pixel.x));
  const int rows = std::min(static_cast<int>(kLanes) / kTile, target.end.y - pixel.y);
  for (int row = 0; row < rows; ++row) {
    const std::size_t at =
        static_cast<std::size_t>(pixel.y + row) * target.stride + static_cast<std::size_t>(pixel.x);
    std::memcpy(static_cast<void*>(&target.points[at]), points + 4 * kTile * row, width * sizeof(glm::vec4));
    std::memcpy(static_cast<void*>(&target.infos[at]), infos + 2 * kTile * row, width * sizeof(glm::vec2));
  }
}

HWY_INLINE void storeNothing(const CastTarget& target, glm::ivec2 pixel) {
  const VF zero = hn::Zero(F());
  const VF nowhere[3] = {zero, zero, zero};
  store(target, pixel, nowhere, hn::Set(F(), -1.0f), zero, zero);
}

template <class Cells>
HWY_INLINE void storeCrossings(const CrossingFinder<Cells>& finder, const Packet& packet,
                               const Crossings& crossing, const CastTarget& target, glm::ivec2 pixel) {
  const F f;
  if (hn::AllFalse(f, crossing.found)) {
    storeNothing(target, pixel);
    return;
  }
  VF point[3];
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = hn::IfThenElseZero(crossing.found,
                                     hn::MulAdd(crossing.t, packet.direction[axis], packet.origin[axis]));
  const VF error = hn::Abs(finder.valueMinus(point, crossing.surface, crossing.found));
  const MF sure = hn::And(crossing.found, hn::Eq(error, error));
  const VF known = hn::ConvertTo(f, hn::Add(crossing.surface, hn::ShiftLeft<2>(crossing.inside)));
  store(target, pixel, point,
        hn::IfThenElse(crossing.found, hn::Max(crossing.t, hn::Zero(f)), hn::Set(f, -1.0f)),
        hn::IfThenElseZero(sure, error), hn::IfThenElseZero(crossing.found, known));
}

// Where the rays of a packet end (CastField::rayEnds).
inline VF endsAt(const CastView& view, const CastTarget& target, glm::ivec2 pixel) {
  alignas(64) float ends[kLanes];
  for (int lane = 0; lane < static_cast<int>(kLanes); ++lane) {
    const glm::ivec2 at = glm::min(pixel + glm::ivec2(lane % kTile, lane / kTile),
                                   target.end - 1);  // those beyond are not stored
    ends[lane] =
        view.rayEnds[static_cast<std::size_t>(at.y) * target.stride + static_cast<std::size_t>(at.x)];
  }
  return hn::Load(F(), ends);
}

// Finds the first crossings of a packet, as far as clipping and the rays' own ends leave them.
template <class Cells>
HWY_INLINE Crossings firstOfPacket(const CastView& view, const CrossingFinder<Cells>& finder,
                                   RaySegments rays, const CastTarget& target, glm::ivec2 pixel) {
  if (!view.rayEnds) return findKept(view, finder, rays);
  const VF ends = endsAt(view, target, pixel);
  // Surfaces that are all clipped lie behind the faces that rays end at, where rays enter the region once.
  const int all = (1 << view.surfaces) - 1;
  if ((view.clipped & all) == all && view.removedCount == 0)
    rays.active = hn::And(rays.active, hn::Ge(ends, hn::Set(F(), kInfinity)));
  rays.active = hn::And(rays.active, hn::Lt(rays.t, ends));
  rays.continued = hn::And(rays.continued, rays.active);
  rays.tEnd = hn::Min(rays.tEnd, ends);
  Crossings crossing = findKept(view, finder, rays);
  crossing.found = hn::And(crossing.found, hn::Lt(crossing.t, ends));
  return crossing;
}

template <class Cells>
HWY_INLINE void castPacket(const CastView& view, const CrossingFinder<Cells>& finder, const PictureRays& rays,
                           StartDepths::Depths depths, const CastTarget& target, glm::ivec2 pixel) {
  const F f;
  const VF zero = hn::Zero(f);
  const Packet packet = packetAt(rays, pixel);
  const VF slack = hn::Mul(hn::Set(f, 0.05f), packet.voxel);  // rounding of the depths
  const VF begin = hn::Max(hn::Sub(hn::Mul(hn::Set(f, depths.first), packet.slant), slack), zero);
  const VF end = hn::MulAdd(hn::Set(f, depths.last), packet.slant, slack);
  const RaySegments segments{rayLanes(view, packet.origin, packet.direction),
                             begin,
                             end,
                             hn::Not(noLane()),
                             noLane(),
                             hn::Zero(I())};
  storeCrossings(finder, packet, firstOfPacket(view, finder, segments, target, pixel), target, pixel);
}

// The crossings before of a packet; t is negative where there is none, or where the pixel is covered.
struct Before {
  VF t;
  VI inside;
};

HWY_INLINE Before beforeAt(const CrossingsBefore& before, const CastTarget& target, glm::ivec2 pixel) {
  alignas(64) float t[kLanes];
  alignas(64) std::int32_t inside[kLanes] = {};
  for (int lane = 0; lane < static_cast<int>(kLanes); ++lane) {
    const glm::ivec2 at = pixel + glm::ivec2(lane % kTile, lane / kTile);
    t[lane] = -1.0f;
    if (at.x >= target.end.x || at.y >= target.end.y) continue;
    const std::size_t i = static_cast<std::size_t>(at.y) * target.stride + static_cast<std::size_t>(at.x);
    if (before.covered[i] > CrossingsBefore::kMostCovered) continue;
    t[lane] = before.crossings.points[i].w;
    inside[lane] = HitInfo::of(before.crossings.infos[i].y).sides();
  }
  return {hn::Load(F(), t), hn::Load(I(), inside)};
}

template <class Cells>
HWY_INLINE void castPacketBehind(const CastView& view, const CrossingFinder<Cells>& finder,
                                 const PictureRays& rays, const CrossingsBefore& before,
                                 const CastTarget& target, glm::ivec2 pixel) {
  const F f;
  const Before from = beforeAt(before, target, pixel);
  const MF active = hn::Ge(from.t, hn::Zero(f));
  if (hn::AllFalse(f, active)) {
    storeNothing(target, pixel);
    return;
  }
  const Packet packet = packetAt(rays, pixel);
  const RaySegments segments{rayLanes(view, packet.origin, packet.direction),
                             hn::MulAdd(hn::Set(f, 1e-4f), packet.voxel, from.t),
                             hn::Set(f, kInfinity),
                             active,
                             active,
                             from.inside};
  storeCrossings(finder, packet, firstOfPacket(view, finder, segments, target, pixel), target, pixel);
}

// Calls cast(finder, pixel) for each packet of the target.
template <class Cast>
HWY_INLINE void forPackets(const CastView& view, const CastTarget& target, const Cast& cast) {
  constexpr int rows = static_cast<int>(kLanes) / kTile;
  withFinder(view, [&](const auto& finder) {
    for (int y = target.begin.y; y < target.end.y; y += rows)
      for (int x = target.begin.x; x < target.end.x; x += kTile) cast(finder, glm::ivec2(x, y));
  });
}

void cast(const CastView& view, const PictureRays& rays, const StartDepths& depths,
          const CastTarget& target) {
  forPackets(view, target, [&](const auto& finder, glm::ivec2 pixel) {
    const StartDepths::Depths& tile = depths.at(pixel.x / kTile, pixel.y / kTile);
    if (tile.first > tile.last)
      storeNothing(target, pixel);
    else
      castPacket(view, finder, rays, tile, target, pixel);
  });
}

void castBehind(const CastView& view, const PictureRays& rays, const CrossingsBefore& before,
                const CastTarget& target) {
  forPackets(view, target, [&](const auto& finder, glm::ivec2 pixel) {
    castPacketBehind(view, finder, rays, before, target, pixel);
  });
}

void edges(const casting::EdgeView& view, const casting::EdgeTarget& target) {
  std::visit([&](const auto* samples) { edgesOf(view, samples, target); }, view.field.samples);
}

extern const casting::CastKernels kCastKernels;
const casting::CastKernels kCastKernels{kSimdSet, cast, castBehind, shadows, derivatives, edges};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();
