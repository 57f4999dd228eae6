#include "volume/measure/fast_marching.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

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
  void spread(int point);
  void offer(int point, double distance, int from);

  const SurfaceGraph& graph_;
  std::vector<double> distance_;
  std::vector<int> from_;
  std::vector<bool> known_;
  std::priority_queue<Front> front_;
};

void March::offer(int point, double distance, int from) {
  const auto i = static_cast<std::size_t>(point);
  if (known_[i] || !(distance < distance_[i])) return;
  distance_[i] = distance;
  from_[i] = from;
  front_.push({distance, point});
}

void March::spread(int point) {
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

}  // namespace

std::vector<glm::dvec3> marchedWay(const SurfaceGraph& graph, int begin, int end, base::Progress& progress) {
  March march(graph, begin);
  if (!march.reach(end, progress)) return {};
  std::vector<glm::dvec3> way;
  for (int point = end; point != -1; point = march.from(point))
    way.push_back(graph.points[static_cast<std::size_t>(point)]);
  return way;
}

}  // namespace isolux::volume
