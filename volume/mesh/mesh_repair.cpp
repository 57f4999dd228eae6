#include "volume/mesh/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <limits>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "volume/mesh/merge_points.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/voxels/bounds.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPolled = 1 << 14;  // elements between looks at the stop

// A side of a triangle; (low, high) are its points in the order of their numbers.
struct EdgeSide {
  int low, high;
  int triangle;
  bool forward;  // the triangle runs from low to high
};

using Loop = std::vector<int>;  // points; the last is followed by the first

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

double areaOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

// Points at (nearly) the same place become one; triangles that lose a corner by that are dropped.
void mergePoints(TriangleMesh& mesh, const base::Progress& progress) {
  Bounds<glm::dvec3> bounds;
  for (const glm::dvec3& point : mesh.points) bounds.add(point);
  const std::vector<int> mergedTo =
      mergedPoints(mesh.points, std::max(1e-6 * glm::length(bounds.size()), 1e-300), progress);
  progress.throwIfStopped();
  for (Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) t[i] = mergedTo[static_cast<std::size_t>(t[i])];
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t.x == t.y || t.y == t.z || t.z == t.x; });
}

// So that the sides of one edge stand together: by low, then high, then triangle. Those of each low point are
// counted and put into its place first, in the order of their triangles, so that only few are sorted at a
// time.
std::vector<EdgeSide> sidesOf(const TriangleMesh& mesh, const base::Progress& progress) {
  std::vector<std::size_t> places(mesh.points.size() + 1);
  const auto forEachSide = [&](const auto& f) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (t % kPolled == 0) progress.throwIfStopped();
      for (int i = 0; i < 3; ++i) {
        const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
        f(EdgeSide{std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
      }
    }
  };
  forEachSide([&](const EdgeSide& side) { ++places[static_cast<std::size_t>(side.low) + 1]; });
  for (std::size_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
  std::vector<std::size_t> next = places;
  std::vector<EdgeSide> sides;
  resizeStoppably(sides, places.back(), progress);
  forEachSide([&](const EdgeSide& side) { sides[next[static_cast<std::size_t>(side.low)]++] = side; });
  for (std::size_t low = 0; low < mesh.points.size(); ++low) {
    if (low % kPolled == 0) progress.throwIfStopped();
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(places[low]),
              sides.begin() + static_cast<std::ptrdiff_t>(places[low + 1]),
              [](const EdgeSide& a, const EdgeSide& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  return sides;
}

// Calls f(begin, end) for the sides of each edge.
template <typename F>
void forEachEdge(const std::vector<EdgeSide>& sides, const base::Progress& progress, F&& f) {
  std::size_t edges = 0;
  for (auto begin = sides.begin(); begin != sides.end();) {
    if (edges++ % kPolled == 0) progress.throwIfStopped();
    const auto end = std::find_if(
        begin, sides.end(), [&](const EdgeSide& s) { return s.low != begin->low || s.high != begin->high; });
    f(begin, end);
    begin = end;
  }
}

// The neighbours of each triangle across edges of exactly two triangles.
struct Neighbours {
  struct Link {
    int triangle = -1;
    bool disagrees = false;  // both run through the edge the same way
  };
  std::vector<std::array<Link, 3>> links;
  bool allAgree = true;

  Neighbours(const TriangleMesh& mesh, const std::vector<EdgeSide>& sides, const base::Progress& progress)
      : links(mesh.triangles.size()) {
    forEachEdge(sides, progress, [&](auto begin, auto end) {
      if (end - begin != 2) return;
      const EdgeSide &a = *begin, &b = *(begin + 1);
      const bool disagrees = a.forward == b.forward;
      allAgree = allAgree && !disagrees;
      add(a.triangle, {b.triangle, disagrees});
      add(b.triangle, {a.triangle, disagrees});
    });
  }

 private:
  void add(int triangle, Link link) {
    for (Link& slot : links[static_cast<std::size_t>(triangle)])
      if (slot.triangle < 0) {
        slot = link;
        return;
      }
  }
};

struct Turned {
  std::size_t triangles = 0;
  bool oneSided = false;  // a Moebius strip: no way to make all agree
};

// Turns triangles so that neighbours agree; of each connected part the larger share stays as it is.
Turned orient(TriangleMesh& mesh, const Neighbours& neighbours, const base::Progress& progress) {
  Turned turned;
  enum : signed char { unseen, kept, flipped };
  std::vector<signed char> state(mesh.triangles.size(), unseen);
  std::vector<std::size_t> part;
  for (std::size_t seed = 0; seed < state.size(); ++seed) {
    if (state[seed] != unseen) continue;
    progress.throwIfStopped();
    part.assign(1, seed);
    state[seed] = kept;
    std::size_t flips = 0;
    for (std::size_t next = 0; next < part.size(); ++next) {
      if (next % kPolled == kPolled - 1) progress.throwIfStopped();
      const std::size_t t = part[next];
      for (const Neighbours::Link& link : neighbours.links[t]) {
        if (link.triangle < 0) continue;
        const auto other = static_cast<std::size_t>(link.triangle);
        const signed char wanted = (state[t] == flipped) != link.disagrees ? flipped : kept;
        if (state[other] == unseen) {
          state[other] = wanted;
          flips += wanted == flipped;
          part.push_back(other);
        } else if (state[other] != wanted) {
          turned.oneSided = true;
        }
      }
    }
    const signed char minority = 2 * flips > part.size() ? kept : flipped;
    for (const std::size_t t : part)
      if (state[t] == minority) {
        std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
        ++turned.triangles;
      }
  }
  return turned;
}

// What the triangles leave open, as loops without a repeated point, run through against the triangles.
std::vector<Loop> openLoops(const std::vector<EdgeSide>& sides, const base::Progress& progress) {
  std::map<int, std::vector<int>> next;  // as many edges leave a point as arrive
  forEachEdge(sides, progress, [&](auto begin, auto end) {
    int net = 0;
    for (auto side = begin; side != end; ++side) net += side->forward ? 1 : -1;
    for (int i = 0; i < std::abs(net); ++i)
      next[net > 0 ? begin->high : begin->low].push_back(net > 0 ? begin->low : begin->high);
  });
  std::vector<Loop> loops;
  std::map<int, std::size_t> position;  // of the points on the path
  Loop path;
  for (std::size_t step = 0; !next.empty(); ++step) {
    if (step % kPolled == 0) progress.throwIfStopped();
    int at = path.empty() ? next.begin()->first : path.back();
    if (path.empty()) {
      path.push_back(at);
      position[at] = 0;
    }
    const auto leaving = next.find(at);
    at = leaving->second.back();
    leaving->second.pop_back();
    if (leaving->second.empty()) next.erase(leaving);
    const auto seen = position.find(at);
    if (seen == position.end()) {
      position[at] = path.size();
      path.push_back(at);
      continue;
    }
    const std::size_t first = seen->second;
    loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(first), path.end());
    for (std::size_t i = first; i < path.size(); ++i) position.erase(path[i]);
    path.resize(first);
    // Goes on from the point where the loop closed, if anything still leaves it.
    if (next.contains(at)) {
      position[at] = path.size();
      path.push_back(at);
    }
  }
  return loops;
}

// Triangulates a loop with the smallest area, Barequet & Sharir 1995: the best of every segment of it, from
// the shortest on; O(n^3).
void spanSmallest(TriangleMesh& mesh, const Loop& loop, const base::Progress& progress) {
  const std::size_t n = loop.size();
  const auto point = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(loop[i])]; };
  std::vector<double> area(n * n, 0.0);
  std::vector<std::size_t> apex(n * n, 0);
  for (std::size_t length = 2; length < n; ++length) {
    progress.throwIfStopped();
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t k = i + length;
      area[i * n + k] = std::numeric_limits<double>::infinity();
      for (std::size_t m = i + 1; m < k; ++m) {
        const double candidate = area[i * n + m] + area[m * n + k] + areaOf(point(i), point(m), point(k));
        if (candidate < area[i * n + k]) {
          area[i * n + k] = candidate;
          apex[i * n + k] = m;
        }
      }
    }
  }
  std::deque<std::array<std::size_t, 2>> segments{{0, n - 1}};
  for (; !segments.empty(); segments.pop_front()) {
    const auto [i, k] = segments.front();
    if (k - i < 2) continue;
    const std::size_t m = apex[i * n + k];
    mesh.triangles.emplace_back(loop[i], loop[m], loop[k]);
    segments.push_back({i, m});
    segments.push_back({m, k});
  }
}

// Long loops: a fan round the middle.
void spanFan(TriangleMesh& mesh, const Loop& loop) {
  glm::dvec3 sum(0.0);
  for (const int i : loop) sum += mesh.points[static_cast<std::size_t>(i)];
  const int middle = static_cast<int>(mesh.points.size());
  mesh.points.push_back(sum / static_cast<double>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i)
    mesh.triangles.emplace_back(middle, loop[i], loop[(i + 1) % loop.size()]);
}

}  // namespace

TriangleMesh closedMesh(TriangleMesh mesh, std::vector<std::string>& warnings,
                        const base::Progress& progress) {
  constexpr std::size_t longestSpanned = 400;
  const std::size_t before = mesh.triangles.size();
  mergePoints(mesh, progress);
  const auto flat = static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
    return areaOf(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) == 0.0;
  }));
  if (const std::size_t degenerate = before - mesh.triangles.size() + flat; degenerate > 0)
    warnings.push_back(counted(degenerate, "triangle") + " without area");

  std::vector<EdgeSide> sides = sidesOf(mesh, progress);
  if (const Neighbours neighbours(mesh, sides, progress); !neighbours.allAgree) {
    const Turned turned = orient(mesh, neighbours, progress);
    warnings.push_back(counted(turned.triangles, "triangle") +
                       " faced the other way than their neighbours and were turned");
    if (turned.oneSided) warnings.push_back("the surface has only one side: its inside is a guess");
    sides = sidesOf(mesh, progress);
  }
  std::size_t boundary = 0, crowded = 0;
  forEachEdge(sides, progress, [&](auto begin, auto end) {
    boundary += end - begin == 1;
    crowded += end - begin > 2;
  });
  if (crowded > 0)
    warnings.push_back(counted(crowded, "edge") +
                       " with more than two triangles: inside is where the surface winds round");
  const std::vector<Loop> loops = openLoops(sides, progress);
  if (!loops.empty())
    warnings.push_back(counted(boundary, "boundary edge") + " in " + counted(loops.size(), "loop") +
                       ": the surface has holes; each is closed with a smallest patch to decide the inside");
  for (const Loop& loop : loops) {
    progress.throwIfStopped();
    if (loop.size() <= longestSpanned)
      spanSmallest(mesh, loop, progress);
    else
      spanFan(mesh, loop);
  }
  return mesh;
}

}  // namespace isolux::volume
