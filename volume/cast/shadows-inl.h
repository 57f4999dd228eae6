// Tests whether a distant light reaches surface points, as resources/shaders/light/shadow.frag.glsl does for
// exact hits. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_SHADOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_SHADOWS_INL_H
#undef ISOLUX_VOLUME_CAST_SHADOWS_INL_H
#else
#define ISOLUX_VOLUME_CAST_SHADOWS_INL_H
#endif

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "volume/cast/cast_kernels.h"
#include "volume/cast/hit_info.h"
#include "volume/cast/kept_crossings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

using casting::ShadowTarget;

// A length that neither under- nor overflows.
HWY_INLINE glm::vec3 safeNormalize(glm::vec3 v, glm::vec3 otherwise) {
  const float largest = std::fmax(std::fmax(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z));
  return largest > 0.0f ? glm::normalize(v / largest) : otherwise;
}

// Where the way to the light begins: a little before the surface, along its normal for `offset` mm.
struct WayToLight {
  glm::vec3 origin, normal;  // voxels; voxels per mm
  float offset;
  HitInfo before;  // the sides at the origin
};

// None where the surface faces away from the light.
HWY_INLINE std::optional<WayToLight> wayFrom(const ShadowRays& shadow, glm::ivec2 pixel, glm::vec4 point,
                                             HitInfo known, glm::vec3 gradient) {
  const glm::vec2 at = glm::vec2(pixel + shadow.rays.origin) + 0.5f;
  const glm::vec2 plane = (at / glm::vec2(shadow.rays.picture) * 2.0f - 1.0f) * shadow.rays.halfExtent;
  const glm::vec3 ray = shadow.rays.orthographic
                            ? shadow.forward
                            : glm::normalize(shadow.forward + plane.x * shadow.right + plane.y * shadow.up);
  const float side = known.risesBehind() == (shadow.outward < 0.0f) ? 1.0f : -1.0f;
  glm::vec3 normal = side * safeNormalize(shadow.outward * gradient, -ray);
  if (const float away = glm::dot(normal, ray); away > 0.0f)
    normal = safeNormalize(normal - away * ray, -ray);
  const float facing = glm::dot(normal, shadow.light);
  if (facing <= 0.0f) return std::nullopt;
  constexpr float back = 1e-3f;  // voxels
  const glm::vec3 toPoint = shadow.voxelFromWorld * ray, out = shadow.voxelFromWorld * normal;
  const float voxel = 1.0f / std::fmax(glm::length(out), 1e-30f);  // mm
  return WayToLight{glm::vec3(point) - toPoint * back / std::fmax(glm::length(toPoint), 1e-30f), out,
                    (0.02f + 0.4f * (1.0f - facing) * (1.0f - facing)) * voxel, known.before()};
}

// Points whose ways are traced together.
struct ShadowPacket {
  alignas(64) float origin[3][kLanes] = {}, normal[3][kLanes] = {}, offset[kLanes] = {};
  alignas(64) std::int32_t inside[kLanes] = {}, known[kLanes] = {};
  std::size_t pixel[kLanes] = {};  // in the image
  std::size_t count = 0;

  // Adds a way. Of surfaces that are not traced the sides are not known.
  void add(const WayToLight& way, const ShadowRays& shadow, std::size_t at) {
    const int place = way.before.surface() - shadow.first;
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis][count] = way.origin[axis];
      normal[axis][count] = way.normal[axis];
    }
    offset[count] = way.offset;
    inside[count] = way.before.sides() >> (shadow.first & 3);
    known[count] = place >= 0 && place < shadow.surfaces ? -1 : 0;
    pixel[count++] = at;
  }
};

// Returns the lanes that meet an opaque surface from 0 to tEnd; `inside` counts in those that are continued.
// t becomes that of the last crossing, and `inside` the state behind the transparent surfaces that were
// passed.
template <class Cells>
HWY_INLINE MF meets(const CastView& view, const CrossingFinder<Cells>& finder, int opaque,
                    RaySegments& rays) {
  const F f;
  constexpr int most = 32;  // transparent surfaces passed through
  MF met = noLane();
  rays.t = hn::Zero(f);
  for (int i = 0; i < most && !hn::AllFalse(f, rays.active); ++i) {
    const Crossings crossing = findKept(view, finder, rays);
    rays.t = hn::IfThenElse(crossing.found, crossing.t, rays.t);
    const MF stops = hn::And(crossing.found, isOneOf(view, opaque, crossing.surface));
    met = hn::Or(met, stops);
    rays.active = hn::AndNot(stops, crossing.found);
    rays.continued = rays.active;
    rays.inside = hn::IfThenElse(hn::RebindMask(I(), rays.active), crossing.inside, rays.inside);
  }
  return hn::Or(met, rays.active);
}

template <class Cells>
HWY_INLINE void tracePacket(const CastView& view, const CrossingFinder<Cells>& finder,
                            const ShadowRays& shadow, ShadowPacket& packet, std::uint8_t* lit) {
  if (packet.count == 0) return;
  const F f;
  const I i;
  const MF active =
      hn::RebindMask(f, hn::Lt(hn::Iota(i, 0), hn::Set(i, static_cast<std::int32_t>(packet.count))));
  VF origin[3], normal[3], toLight[3];
  const glm::vec3 light = shadow.voxelFromWorld * shadow.light;
  for (int axis = 0; axis < 3; ++axis) {
    origin[axis] = hn::Load(f, packet.origin[axis]);
    normal[axis] = hn::Load(f, packet.normal[axis]);
    toLight[axis] = hn::Set(f, light[axis]);
  }
  VF offset = hn::Load(f, packet.offset);
  // Halfway to what the normal meets, so that no light leaks through a narrow gap.
  const MF known = hn::And(active, hn::RebindMask(f, hn::Ne(hn::Load(i, packet.known), hn::Zero(i))));
  RaySegments rays{rayLanes(view, origin, normal), hn::Zero(f), offset, active, known,
                   hn::Load(i, packet.inside)};
  const MF narrow = meets(view, finder, shadow.opaque, rays);
  offset = hn::IfThenElse(narrow, hn::Mul(hn::Set(f, 0.5f), rays.t), offset);
  for (int axis = 0; axis < 3; ++axis) origin[axis] = hn::MulAdd(offset, normal[axis], origin[axis]);
  rays.ray = rayLanes(view, origin, toLight);
  rays.tEnd = hn::Set(f, kInfinity);
  rays.active = active;
  rays.continued = known;
  const MF blocked = meets(view, finder, shadow.opaque, rays);
  alignas(64) std::int32_t dark[kLanes];
  hn::Store(hn::VecFromMask(i, hn::RebindMask(i, blocked)), i, dark);
  for (std::size_t lane = 0; lane < packet.count; ++lane) lit[packet.pixel[lane]] = dark[lane] != 0 ? 0 : 255;
  packet.count = 0;
}

// Points of 4x4 pixels are neighbours on their way, too.
void shadows(const CastView& view, const ShadowRays& shadow, const ShadowTarget& target) {
  constexpr int tile = StartDepths::kTile;
  withFinder(view, [&](const auto& finder) {
    ShadowPacket packet;
    for (int y0 = target.begin.y; y0 < target.end.y; y0 += tile)
      for (int x0 = target.begin.x; x0 < target.end.x; x0 += tile)
        for (int y = y0; y < std::min(y0 + tile, target.end.y); ++y)
          for (int x = x0; x < std::min(x0 + tile, target.end.x); ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * target.stride + static_cast<std::size_t>(x);
            target.lit[at] = 0;
            const glm::vec4 point = target.points[at];
            if (point.w < 0.0f) continue;
            const auto way = wayFrom(shadow, {x, y}, point, HitInfo::of(target.infos[at].y),
                                     glm::vec3(target.gradients[at]));
            if (way) packet.add(*way, shadow, at);
            if (packet.count == kLanes) tracePacket(view, finder, shadow, packet, target.lit);
          }
    tracePacket(view, finder, shadow, packet, target.lit);
  });
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
