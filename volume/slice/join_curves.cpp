#include "volume/slice/join_curves.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "base/hash.h"

namespace isolux::volume {

namespace {

constexpr double kSamePoint = 1e-9;

struct CurveEdgeHash {
  std::size_t operator()(const CurveEdge& edge) const {
    base::Hasher hash;
    hash.add(edge.low.x).add(edge.low.y).add(edge.high.x).add(edge.high.y);
    return static_cast<std::size_t>(static_cast<std::uint64_t>(hash));
  }
};

void addPoint(std::vector<glm::dvec2>& points, glm::dvec2 point) {
  if (points.empty() || glm::distance(points.back(), point) > kSamePoint) points.push_back(point);
}

}  // namespace

std::vector<JoinedCurve> joinedCurves(const std::vector<CurvePiece>& pieces) {
  std::unordered_map<CurveEdge, std::size_t, CurveEdgeHash> beginning;
  std::unordered_set<CurveEdge, CurveEdgeHash> ends;
  beginning.reserve(pieces.size());
  ends.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    beginning.emplace(pieces[i].from, i);
    ends.insert(pieces[i].to);
  }
  std::vector<bool> used(pieces.size());
  std::vector<JoinedCurve> curves;
  const auto follow = [&](std::size_t first) {
    JoinedCurve curve;
    std::size_t at = first;
    while (!used[at]) {
      used[at] = true;
      addPoint(curve.points, pieces[at].start);
      const auto next = beginning.find(pieces[at].to);
      if (next == beginning.end() || (used[next->second] && next->second != first)) {
        addPoint(curve.points, pieces[at].end);
        break;
      }
      at = next->second;
      curve.closed = at == first;
    }
    while (curve.closed && curve.points.size() > 1 &&
           glm::distance(curve.points.front(), curve.points.back()) <= kSamePoint)
      curve.points.pop_back();
    if (curve.points.size() > 1) curves.push_back(std::move(curve));
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!ends.contains(pieces[i].from)) follow(i);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!used[i]) follow(i);
  return curves;
}

}  // namespace isolux::volume
