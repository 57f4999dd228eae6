#include "volume/measure/geodesic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

using Path = std::vector<glm::dvec3>;

constexpr double kCoarsestVoxels = 2.0, kFinestVoxels = 0.25;  // between points of the polyline
constexpr double kOverRelaxation = 1.6;
constexpr double kTight = 1e-7;  // of the length that a round of sweeps must still gain
constexpr int kMostSweeps = 4000, kSweepsInRound = 20;
constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kGeodesicSafety = 5.0;  // over edges the estimate is a quarter of the error

// Where the front that passes a and b at distances da and db comes from when it reaches p.
struct Arrival {
  double distance = kUnreached;
  double part = 0.0;  // of the way from a to b at which it passes that edge
};

// A straight front over one triangle: the source is unfolded into its plane, on the side of edge ab away from
// p; where the line from it to p misses the edge, along the edge's nearer end.
Arrival arrivalAt(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double da, double db) {
  const glm::dvec3 edge = b - a, toP = p - a;
  const double length = glm::length(edge);
  Arrival best{da + glm::length(toP), 0.0};
  const double overB = db + glm::length(p - b);
  if (overB < best.distance) best = {overB, 1.0};
  if (!(length > 0.0) || !(db < kUnreached) || !(da < kUnreached)) return best;
  const double px = glm::dot(toP, edge) / length, py2 = glm::dot(toP, toP) - px * px;
  const double sx = (da * da - db * db + length * length) / (2.0 * length), sy2 = da * da - sx * sx;
  if (!(py2 > 0.0 && sy2 >= 0.0)) return best;
  const double py = std::sqrt(py2), sy = std::sqrt(sy2), crossing = sx + (px - sx) * sy / (sy + py);
  if (crossing <= 0.0 || crossing >= length) return best;
  const double straight = std::hypot(px - sx, py + sy);
  return straight < best.distance ? Arrival{straight, crossing / length} : best;
}

struct Front {
  double distance;
  int point;
  bool operator<(const Front& other) const { return distance > other.distance; }  // nearest on top
};

class March {
 public:
  March(const SurfaceGraph& graph, int begin)
      : graph_(graph),
        distance_(graph.points.size(), kUnreached),
        from_(graph.points.size(), -1),
        known_(graph.points.size(), false) {
    distance_[static_cast<std::size_t>(begin)] = 0.0;
    front_.push({0.0, begin});
  }

  bool reach(int end, base::Progress& progress) {
    for (std::size_t step = 0; !front_.empty(); ++step) {
      if (step % 4096 == 0) progress.throwIfStopped();
      const Front next = front_.top();
      front_.pop();
      const auto i = static_cast<std::size_t>(next.point);
      if (known_[i]) continue;
      known_[i] = true;
      if (next.point == end) return true;
      spread(next.point);
    }
    return false;
  }

  int from(int point) const { return from_[static_cast<std::size_t>(point)]; }

 private:
  void offer(int point, double distance, int from) {
    const auto i = static_cast<std::size_t>(point);
    if (known_[i] || !(distance < distance_[i])) return;
    distance_[i] = distance;
    from_[i] = from;
    front_.push({distance, point});
  }

  void spread(int point) {
    const auto at = static_cast<std::size_t>(point);
    for (std::uint32_t t = graph_.firstOfPoint[at]; t < graph_.firstOfPoint[at + 1]; ++t) {
      const glm::ivec3& triangle = graph_.triangles[graph_.trianglesOfPoint[t]];
      for (int k = 0; k < 3; ++k) {
        if (triangle[k] != point) continue;
        for (const auto& [b, p] : {std::pair(triangle[(k + 1) % 3], triangle[(k + 2) % 3]),
                                   std::pair(triangle[(k + 2) % 3], triangle[(k + 1) % 3])}) {
          const auto bi = static_cast<std::size_t>(b), pi = static_cast<std::size_t>(p);
          if (known_[pi]) continue;
          const double db = known_[bi] ? distance_[bi] : kUnreached;
          const Arrival arrival =
              arrivalAt(graph_.points[pi], graph_.points[at], graph_.points[bi], distance_[at], db);
          offer(p, arrival.distance, arrival.part < 0.5 ? point : b);
        }
      }
    }
  }

  const SurfaceGraph& graph_;
  std::vector<double> distance_;
  std::vector<int> from_;
  std::vector<bool> known_;
  std::priority_queue<Front> front_;
};

// First-order geodesic distances over a surface's graph, as far as one point: which way to go. Points of the
// graph from `end` back to `begin`, one step of the front each; empty where none leads there.
Path marchedWay(const SurfaceGraph& graph, int begin, int end, base::Progress& progress) {
  March march(graph, begin);
  if (!march.reach(end, progress)) return {};
  Path way;
  for (int point = end; point != -1; point = march.from(point))
    way.push_back(graph.points[static_cast<std::size_t>(point)]);
  return way;
}

double lengthOf(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += glm::length(path[i] - path[i - 1]);
  return length;
}

// Points at even distances along the polyline, its ends kept, on the surface.
Path resampled(const SurfaceOf& surface, const Path& path, double spacing) {
  const double length = lengthOf(path);
  const auto parts = static_cast<std::size_t>(std::max(2.0, std::ceil(length / spacing)));
  Path points;
  points.reserve(parts + 1);
  points.push_back(path.front());
  double passed = 0.0;
  std::size_t segment = 1;
  for (std::size_t i = 1; i < parts; ++i) {
    const double wanted = length * static_cast<double>(i) / static_cast<double>(parts);
    double step = glm::length(path[segment] - path[segment - 1]);
    while (segment + 1 < path.size() && passed + step < wanted) {
      passed += step;
      ++segment;
      step = glm::length(path[segment] - path[segment - 1]);
    }
    const double part = step > 0.0 ? (wanted - passed) / step : 0.0;
    const glm::dvec3 at = path[segment - 1] + (path[segment] - path[segment - 1]) * part;
    points.push_back(ontoSurface(surface, at, 4.0 * spacing).value_or(at));
  }
  points.push_back(path.back());
  return points;
}

// Sweeps over the points, each towards the middle of its neighbours and back onto the surface.
void tighten(const SurfaceOf& surface, Path& path, double spacing, base::Progress& progress) {
  double before = lengthOf(path);
  for (int sweep = 1; sweep <= kMostSweeps; ++sweep) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const glm::dvec3 middle = 0.5 * (path[i - 1] + path[i + 1]);
      const auto moved = ontoSurface(surface, path[i] + kOverRelaxation * (middle - path[i]), 2.0 * spacing);
      if (moved) path[i] = *moved;
    }
    if (sweep % kSweepsInRound != 0) continue;
    progress.throwIfStopped();
    const double now = lengthOf(path);
    if (before - now < kTight * now) return;
    before = now;
  }
}

int nearestPointOf(const SurfaceGraph& graph, glm::dvec3 world) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < graph.points.size(); ++i) {
    const glm::dvec3 off = graph.points[i] - world;
    const double squared = glm::dot(off, off);
    if (squared >= least || graph.firstOfPoint[i] == graph.firstOfPoint[i + 1]) continue;
    least = squared;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

// To the leading order a way on the object's surface differs by the integral of (normal curvature along it)
// times (distance of the surfaces), and by half the square of the slopes by which facets rise and fall.
void addErrors(const SurfaceOf& surface, double voxelMm, Geodesic& result) {
  const Path& path = result.path;
  double bent = 0.0, rough = 0.0, variance = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const glm::dvec3 way = path[i] - path[i - 1];
    const double length = glm::length(way);
    const auto point = surfacePoint(surface, 0.5 * (path[i] + path[i - 1]));
    if (!point || !(length > 0.0)) continue;
    const glm::dvec3 along = way / length;
    const double bend = std::clamp(glm::dot(along, point->shape * along), -1.0 / voxelMm, 1.0 / voxelMm),
                 slope = glm::dot(along, point->normal);
    bent += bend * point->samplingMm * length;
    rough += 0.5 * slope * slope * length;
    // Noise of neighbouring voxels is taken as alike over a voxel.
    const double noisy = bend * point->noiseMm * length;
    variance += noisy * noisy;
  }
  const glm::dvec3 begin = path.front(), end = path.back(), across = glm::normalize(end - begin);
  for (const glm::dvec3& at : {begin, end}) {
    const auto point = surfacePoint(surface, at);
    if (!point) continue;
    const double slope = glm::dot(across, point->normal);
    variance += point->noiseMm * point->noiseMm * slope * slope;
  }
  result.parts.sampling = kGeodesicSafety * (std::abs(bent) + rough);
  result.parts.noise = 2.0 * std::sqrt(variance / kFinestVoxels);
  result.lengthMm.error = result.parts.sum();
}

}  // namespace

std::optional<Geodesic> geodesic(const SurfaceOf& surface, const SurfaceGraph& graph, glm::dvec3 begin,
                                 glm::dvec3 end, base::Progress& progress) {
  if (begin == end) return Geodesic{{}, {}, {begin, end}};
  const int from = nearestPointOf(graph, begin), to = nearestPointOf(graph, end);
  if (from < 0 || to < 0) return std::nullopt;
  const Path way = marchedWay(graph, to, from, progress);  // so that it begins at `from`
  if (way.empty()) return std::nullopt;
  Path path;
  path.reserve(way.size() + 2);
  path.push_back(begin);
  path.insert(path.end(), way.begin(), way.end());
  path.push_back(end);
  const double voxel = surface.grid.geometry().voxelMm();
  double coarser = 0.0, length = 0.0;
  for (double spacing = kCoarsestVoxels; spacing >= kFinestVoxels; spacing *= 0.5) {
    path = resampled(surface, path, spacing * voxel);
    tighten(surface, path, spacing * voxel, progress);
    coarser = length;
    length = lengthOf(path);
  }
  Geodesic result;
  result.path = std::move(path);
  result.lengthMm.value = length;
  result.parts.quadrature = std::abs(length - coarser);
  addErrors(surface, voxel, result);
  return result;
}

}  // namespace isolux::volume
