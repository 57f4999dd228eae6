#include "volume/phantom/phantom_head.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/phantom/phantom_anatomy.h"

namespace isolux::volume {

namespace {

constexpr double kCubeMm = 250.0;
const glm::dvec3 kCubeCentreMm(0.0, -12.0, 0.0);
constexpr float kNeckCutMm = -119.0f;  // below: air, as if the scan had ended there
constexpr float kFleshOnSkullMm = 2.5f, kFleshOnJawMm = 2.5f, kFleshBlendMm = 5.0f;
constexpr float kFarMm = 1e4f;                  // from an organ that is not there
constexpr int kShapeBlock = PointRow::kPoints;  // voxels per axis that share one selection of shapes

namespace hu {
constexpr float air = -1000.0f, skin = 60.0f, fat = -90.0f, muscle = 50.0f, brain = 36.0f, liquor = 8.0f;
constexpr float eyeball = 18.0f, lens = 90.0f;
constexpr float cortical = 1200.0f, diploe = 600.0f, tooth = 2300.0f, metal = 3000.0f;
}  // namespace hu

// How much of a voxel lies inside a surface at signed distance d, seen through a point spread of half-width
// w: a box (the detector) convolved with a narrower box (the focal spot). Linear but for rounded ends, so
// that interpolated isosurfaces are smooth.
float coverage(float d, float w) {
  constexpr float box = 0.75f, round = 0.25f;  // half-widths, in w
  const float x = std::min(std::abs(d) / w, box + round);
  const float y = x <= box - round ? x : x - (x - box + round) * (x - box + round) / (4.0f * round);
  const float half = 0.5f * y / box;
  return d > 0.0f ? 0.5f - half : 0.5f + half;
}

float mix(float a, float b, float t) {
  return a + t * (b - a);
}

// Compact bone round spongy bone; d: signed distance to the bone's surface, edge: how soon one turns into the
// other.
float addBone(float value, float d, float edge, float cut, float w) {
  if (d >= w) return value;
  const float bone = mix(hu::cortical, hu::diploe, coverage(d + 2.6f, edge));
  return mix(value, bone, coverage(std::max(d, cut), w));
}

// The grooves of the sutures in the brain case: how far they lower its surface at p, which lies `skull` from
// it.
float sutureDepth(glm::vec3 p, float skull) {
  constexpr float width = 2.4f, depth = 1.2f, tooth = 7.0f, swing = 2.2f;
  if (std::abs(skull) > 4.0f || p.z < 12.0f) return 0.0f;
  const float x = std::abs(p.x);
  const float phase = x / tooth - std::floor(x / tooth);
  const float zigzag = swing * (std::abs(2.0f * phase - 1.0f) - 0.5f);
  float nearest = width;
  // Coronal: from the bregma down and forward to the temples.
  if (p.z > 34.0f)
    nearest = std::min(nearest, std::abs(p.y + 15.0f + 0.36f * (112.0f - p.z) + zigzag) * 0.94f);
  // Sagittal: along the middle of the roof.
  if (p.z > 60.0f && p.y > -15.0f && p.y < 80.0f) nearest = std::min(nearest, x);
  // Lambdoid: from the lambda sideways and down.
  if (p.y > 40.0f)
    nearest = std::min(nearest, std::abs(p.y - 80.0f + 0.31f * (78.0f - p.z) + zigzag) * 0.95f);
  // Squamous: an arch over the ear.
  if (x > 45.0f && p.z > 14.0f) {
    const glm::vec2 q((p.y + 4.0f) / 40.0f, (p.z - 4.0f) / 36.0f);
    nearest = std::min(nearest, std::abs(glm::length(q) - 1.0f) * 38.0f);
  }
  const float t = 1.0f - nearest / width;
  return depth * t * t * (3.0f - 2.0f * t);
}

// The shapes of every organ that matter in one block of voxels.
class LocalAnatomy {
 public:
  void select(const Anatomy& anatomy, glm::vec3 centre, float reach, float margin) {
    for (std::size_t i = 0; i < organs_.size(); ++i)
      anatomy.organs[i].select(centre, reach, margin, organs_[i]);
  }
  bool has(Organ organ) const { return !organs_[static_cast<std::size_t>(organ)].empty(); }
  // Nothing but air around: no skin is within the margin.
  bool air() const {
    return !has(Organ::flesh) && !has(Organ::skull) && !has(Organ::mandible) && !has(Organ::marker);
  }

  // HU at the points; w: half-width of the point spread, mm.
  void hounsfield(const PointRow& points, float w, float (&values)[PointRow::kPoints]) {
    for (const Organ organ : {Organ::skull, Organ::mandible, Organ::flesh})
      if (has(organ)) measure(organ, points);
    float body[PointRow::kPoints];
    bool skin = has(Organ::marker);
    for (int i = 0; i < PointRow::kPoints; ++i) {
      body[i] = bodyAt(i, points.z[i]);
      skin = skin || body[i] < w;
      values[i] = hu::air;
    }
    if (!skin) return;
    for (std::size_t organ = 0; organ < kOrganCount; ++organ)
      if (!organs_[organ].empty()) measure(static_cast<Organ>(organ), points);
    for (int i = 0; i < PointRow::kPoints; ++i)
      values[i] = hounsfield({points.x[i], points.y[i], points.z[i]}, i, body[i], w);
  }

 private:
  using Distances = float[PointRow::kPoints];

  void measure(Organ organ, const PointRow& points) {
    const auto index = static_cast<std::size_t>(organ);
    distancesTo(organs_[index], points, distances_[index]);
  }
  float distance(Organ organ, int point) const {
    const auto index = static_cast<std::size_t>(organ);
    return organs_[index].empty() ? kFarMm : distances_[index][point];
  }

  // The skin: flesh, and what lies over the bones; cut off below.
  float bodyAt(int point, float z) const {
    const float overSkull = distance(Organ::skull, point) - kFleshOnSkullMm;
    const float body = smoothMinimum(distance(Organ::flesh, point), overSkull, kFleshBlendMm);
    const float overJaw = distance(Organ::mandible, point) - kFleshOnJawMm;
    return std::max(smoothMinimum(body, overJaw, kFleshBlendMm), kNeckCutMm - z);
  }

  float softTissue(int point, float body, float w) const {
    // Layers by depth: skin, fat, muscle.
    float soft = mix(hu::skin, hu::fat, coverage(body + 2.0f, w));
    soft = mix(soft, hu::muscle, coverage(body + 6.0f, w));
    if (has(Organ::brain)) {
      const float d = distance(Organ::brain, point);
      soft = mix(soft, mix(hu::liquor, hu::brain, coverage(d + 3.0f, w)), coverage(d, w));
      if (has(Organ::ventricles))
        soft = mix(soft, hu::liquor, coverage(distance(Organ::ventricles, point), w));
    }
    if (has(Organ::orbits))
      soft = mix(soft, hu::fat, coverage(std::max(distance(Organ::orbits, point), body + 4.0f), w));
    if (has(Organ::eyes)) soft = mix(soft, hu::eyeball, coverage(distance(Organ::eyes, point), w));
    if (has(Organ::lenses)) soft = mix(soft, hu::lens, coverage(distance(Organ::lenses, point), w));
    if (has(Organ::airways)) soft = mix(soft, hu::air, coverage(distance(Organ::airways, point), w));
    return soft;
  }

  float hounsfield(glm::vec3 p, int point, float body, float w) const {
    if (body >= w && !has(Organ::marker)) return hu::air;
    const float skull = distance(Organ::skull, point), cut = kNeckCutMm - p.z;
    float value = mix(hu::air, softTissue(point, body, w), coverage(body, w));
    value = addBone(value, skull + sutureDepth(p, skull), 0.8f, cut, w);
    value = addBone(value, distance(Organ::mandible, point), 1.5f, cut, w);
    value = addBone(value, distance(Organ::spine, point), 1.5f, cut, w);
    if (has(Organ::teeth)) value = mix(value, hu::tooth, coverage(distance(Organ::teeth, point), w));
    if (has(Organ::sinuses)) value = mix(value, hu::air, coverage(distance(Organ::sinuses, point), w));
    if (has(Organ::marker)) value = mix(value, hu::metal, coverage(distance(Organ::marker, point), w));
    return value;
  }

  std::array<std::vector<const Shape*>, kOrganCount> organs_;
  std::array<Distances, kOrganCount> distances_{};
};

// World positions, mm, of a row of voxels along x.
PointRow pointsFrom(glm::dvec3 origin, const glm::dmat3& linear, glm::ivec3 first) {
  PointRow points;
  for (int i = 0; i < PointRow::kPoints; ++i) {
    const glm::vec3 world(origin + linear * glm::dvec3(first.x + i, first.y, first.z));
    points.x[i] = world.x;
    points.y[i] = world.y;
    points.z[i] = world.z;
  }
  return points;
}

}  // namespace

GridGeometry headGeometry(int size) {
  const double spacing = kCubeMm / size;
  return GridGeometry::make(glm::ivec3(size), glm::dvec3(spacing),
                            kCubeCentreMm - glm::dvec3(0.5 * spacing * (size - 1)));
}

std::vector<std::int16_t> headVoxels(const GridGeometry& geometry, double noise, std::uint64_t seed,
                                     base::Progress& progress) {
  const glm::ivec3 dims = geometry.dims;
  std::vector<std::int16_t> voxels;
  resizeStoppably(voxels, geometry.voxelCount(), progress);
  const Anatomy anatomy = makeAnatomy();
  const glm::dvec3 origin = geometry.originMm(), spacing = geometry.spacingMm();
  const glm::dmat3 linear(geometry.worldFromVoxel);
  const auto w = static_cast<float>(1.4 * (spacing.x + spacing.y + spacing.z) / 3.0);
  const float margin = std::max(w, 1.5f) + kFleshOnJawMm + kFleshBlendMm;

  const glm::ivec3 blocks = (dims + kShapeBlock - 1) / kShapeBlock;
  const int rows = blocks.y * blocks.z;
  std::atomic<int> rowsDone{0};
  parallelRanges(rows, 1, [&](const Indices<int>& range) {
    LocalAnatomy local;
    for (int row = range.begin(); row != range.end(); ++row) {
      for (int blockX = 0; blockX < blocks.x; ++blockX) {
        if (progress.stopRequested()) return;
        const glm::ivec3 low = glm::ivec3(blockX, row % blocks.y, row / blocks.y) * kShapeBlock;
        const glm::ivec3 high = glm::min(low + kShapeBlock, dims) - 1;
        const glm::dvec3 half = glm::dvec3(high - low) * 0.5;
        const glm::dvec3 middle = origin + linear * (glm::dvec3(low) + half);
        const double reach = glm::length(linear[0]) * half.x + glm::length(linear[1]) * half.y +
                             glm::length(linear[2]) * half.z;
        local.select(anatomy, glm::vec3(middle), static_cast<float>(reach), margin);
        const bool air = local.air();
        for (int z = low.z; z <= high.z; ++z) {
          for (int y = low.y; y <= high.y; ++y) {
            std::size_t i = (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) +
                             static_cast<std::size_t>(y)) *
                                static_cast<std::size_t>(dims.x) +
                            static_cast<std::size_t>(low.x);
            float values[PointRow::kPoints];
            if (air)
              std::fill(std::begin(values), std::end(values), hu::air);
            else
              local.hounsfield(pointsFrom(origin, linear, {low.x, y, z}), w, values);
            for (int x = low.x; x <= high.x; ++x, ++i) {
              auto value = static_cast<double>(values[x - low.x]);
              if (noise > 0.0) value += noise * base::normalNoise(seed, i);
              voxels[i] = static_cast<std::int16_t>(std::clamp(std::floor(value + 0.5), -1024.0, 3071.0));
            }
          }
        }
      }
    }
    const int done = rowsDone += static_cast<int>(range.size());
    progress.report(static_cast<double>(done) / rows, "making the phantom");
  });
  progress.throwIfStopped();
  return voxels;
}

}  // namespace isolux::volume
