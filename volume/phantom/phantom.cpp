#include "volume/phantom/phantom.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/random.h"
#include "base/words.h"
#include "volume/field/cubic_weights.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/phantom/phantom_head.h"

namespace isolux::volume {

namespace {

constexpr PhantomInfo kPhantoms[] = {
    {"head", "CT-like head: skin, skull, teeth, brain, eyes, airways; a bead on the patient's left ear", "HU",
     300.0, 192, scene::WorldAxes::anatomical},
    {"ball", "signed distance to a ball", "mm", 0.0, 128},
    {"torus", "signed distance to a torus around the z axis", "mm", 0.0, 128},
    {"cylinder", "signed distance to an infinite cylinder along z", "mm", 0.0, 128},
    {"plane", "signed distance to a tilted plane", "mm", 0.0, 128},
    {"saddle", "height below a hyperbolic paraboloid", "mm", 0.0, 128},
    {"gyroid", "the triply periodic gyroid, four periods per edge", "", 0.0, 128},
    {"marschner_lobb", "the Marschner-Lobb test signal for reconstruction", "", 0.5, 64},
    {"two_balls", "two balls that touch at one point, where the gradient vanishes", "mm", 0.0, 128},
    {"sheet", "a sheet thinner than a voxel", "mm", 0.0, 64},
    {"sheets", "half a ball, cut obliquely into parallel sheets and gaps, each two voxels thick", "mm", 0.0,
     128},
    {"wires", "six interlocking rings of wire with a smooth profile 1.4 voxels wide", "", 500.0, 128},
    {"noise", "smooth random field with white noise", "", 0.0, 128},
};
constexpr int kMinimumSize = 2, kMaximumSize = 1024;
constexpr double kPi = std::numbers::pi;

// Where the closed forms are put: the middle of the voxel domain and the length of its shortest edge, mm.
struct Placement {
  glm::dvec3 centre;
  double edge;
  glm::dvec3 layerNormal;  // unit, across the z layers of voxels
  double layerOffset;      // dot(layerNormal, p) on the layer nearest to the centre
  double layerSpacing;     // between layers

  explicit Placement(const GridGeometry& geometry) {
    const glm::dvec3 middle = glm::dvec3(geometry.dims - 1) * 0.5;
    centre = geometry.worldOf(middle);
    const glm::dvec3 lengths = glm::dvec3(glm::max(geometry.dims - 1, glm::ivec3(1))) * geometry.spacingMm();
    edge = std::min({lengths.x, lengths.y, lengths.z});
    // Voxel z = dot(row, p) + constant, where the row is that of the inverse: its length is layers per mm.
    const glm::dmat4 inverse = geometry.voxelFromWorld();
    const glm::dvec3 row(inverse[0][2], inverse[1][2], inverse[2][2]);
    layerSpacing = 1.0 / glm::length(row);
    layerNormal = row * layerSpacing;
    const glm::dvec3 onLayer = geometry.worldOf({middle.x, middle.y, std::floor(middle.z)});
    layerOffset = glm::dot(layerNormal, onLayer);
  }
};

// Smooth random field: random numbers on a unit lattice, blended by the cubic B-spline (so twice
// differentiable).
double latticeNoise(glm::dvec3 p, std::uint64_t seed) {
  const glm::dvec3 cell = glm::floor(p);
  const CubicWeights x = cubicWeights(p.x - cell.x), y = cubicWeights(p.y - cell.y),
                     z = cubicWeights(p.z - cell.z);
  const auto key = [](double c, int k) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(c) + k - 1) & 0x1fffffu;
  };
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const std::uint64_t counter = key(cell.x, i) | key(cell.y, j) << 21 | key(cell.z, k) << 42;
        sum += x.w[i] * y.w[j] * z.w[k] * (2.0 * base::uniformNoise(seed, counter) - 1.0);
      }
  return sum;
}

// Rings of wire round axes that lean by 40 degrees, a sixth of a turn apart.
double distanceToRings(glm::dvec3 q, double radius) {
  constexpr double lean = 40.0 / 180.0 * kPi;
  double nearest = std::numeric_limits<double>::infinity();
  for (int ring = 0; ring < 6; ++ring) {
    const double turn = ring * kPi / 3.0;
    const glm::dvec3 axis(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
    const double along = glm::dot(q, axis);
    nearest = std::min(nearest, std::hypot(along, glm::length(q - along * axis) - radius));
  }
  return nearest;
}

// A voxel that a closed form is evaluated at.
struct FormVoxel {
  const PhantomRequest& request;
  const Placement& at;
  glm::dvec3 p, q;  // mm: its position in the world, and from the centre
  double e;         // length of the domain's shortest edge, mm
  std::size_t index;
};

struct NamedForm {
  std::string_view name;
  double (*valueAt)(const FormVoxel& v);
};
constexpr NamedForm kForms[] = {
    {"ball", [](const FormVoxel& v) { return 0.35 * v.e - glm::length(v.q); }},
    {"torus",
     [](const FormVoxel& v) {
       return 0.12 * v.e - glm::length(glm::dvec2(glm::length(glm::dvec2(v.q)) - 0.27 * v.e, v.q.z));
     }},
    {"cylinder", [](const FormVoxel& v) { return 0.25 * v.e - glm::length(glm::dvec2(v.q)); }},
    {"plane", [](const FormVoxel& v) { return -glm::dot(glm::dvec3(2, 3, 6), v.q) / 7.0; }},
    {"saddle", [](const FormVoxel& v) { return 2.0 * (v.q.x * v.q.x - v.q.y * v.q.y) / v.e - v.q.z; }},
    {"gyroid",
     [](const FormVoxel& v) {
       const glm::dvec3 q = v.q * (8.0 * kPi / v.e);
       return std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) + std::sin(q.z) * std::cos(q.x);
     }},
    {"marschner_lobb",
     [](const FormVoxel& v) {
       const glm::dvec3 q = v.q * (2.0 / v.e);
       const double ripple = std::cos(12.0 * kPi * std::cos(0.5 * kPi * glm::length(glm::dvec2(q))));
       return (1.0 - std::sin(0.5 * kPi * q.z) + 0.25 * (1.0 + ripple)) / 2.5;
     }},
    {"two_balls",
     [](const FormVoxel& v) {
       const double radius = 0.2 * v.e;
       const glm::dvec3 shift(radius, 0.0, 0.0);
       const double a = glm::dot(v.q - shift, v.q - shift) - radius * radius;
       const double b = glm::dot(v.q + shift, v.q + shift) - radius * radius;
       return -a * b / (8.0 * radius * radius * radius);
     }},
    {"sheet",
     [](const FormVoxel& v) {
       return 0.5 * v.request.sheetVoxels * v.at.layerSpacing -
              std::abs(glm::dot(v.at.layerNormal, v.p) - v.at.layerOffset);
     }},
    {"sheets",
     [](const FormVoxel& v) {
       const double period = v.e / 31.75, across = glm::dot(glm::dvec3(2, 14, -5), v.q) / 15.0;
       const double fromSheet = std::abs(across - period * std::round(across / period));
       return std::min({0.4 * v.e - glm::length(v.q), v.q.y, 0.25 * period - fromSheet});
     }},
    {"wires",
     [](const FormVoxel& v) {
       const double width = 0.6 * v.e / 127.0, distance = distanceToRings(v.q, 0.3 * v.e);
       return 1000.0 * std::exp(-0.5 * distance * distance / (width * width));
     }},
    {"noise", [](const FormVoxel& v) {
       const glm::dvec3 q = v.q / v.e;
       const std::uint64_t seed = v.request.seed;
       return 2.0 * latticeNoise(q * 8.0, seed + 1) + latticeNoise(q * 20.0, seed + 2) +
              0.02 * base::normalNoise(seed + 3, v.index);
     }}};

// Evaluates the form at every voxel, on all cores, and adds noise.
std::vector<float> closedForm(const PhantomRequest& request, const GridGeometry& geometry,
                              base::Progress& progress) {
  const auto valueAt = std::ranges::find(kForms, request.name, &NamedForm::name)->valueAt;
  const Placement at(geometry);
  const Extent3 extent = geometry.extent();
  std::vector<float> values;
  resizeStoppably(values, geometry.voxelCount(), progress);
  const glm::dvec3 origin = geometry.originMm();
  const glm::dmat3 linear(geometry.worldFromVoxel);
  parallelSteps(extent.rows(), progress, {0.0, 1.0, "making the phantom"}, [&](std::size_t row) {
    const glm::dvec3 first(extent.firstOfRow(row));
    const glm::dvec3 start = origin + linear[1] * first.y + linear[2] * first.z;
    std::size_t i = row * extent.row();
    for (int x = 0; x < extent.dims.x; ++x, ++i) {
      const glm::dvec3 p = start + linear[0] * static_cast<double>(x);
      double value = valueAt({request, at, p, p - at.centre, at.edge, i});
      if (request.noise > 0.0) value += request.noise * base::normalNoise(request.seed, i);
      values[i] = static_cast<float>(value);
    }
  });
  return values;
}

}  // namespace

std::span<const PhantomInfo> phantoms() {
  return kPhantoms;
}

const PhantomInfo& phantomNamed(const std::string& name) {
  for (const PhantomInfo& info : kPhantoms)
    if (info.name == name) return info;
  base::throwUsage(
      "", "phantom",
      "unknown name \"" + name + "\"; choose one of " + base::joined(kPhantoms, ", ", &PhantomInfo::name));
}

Grid makePhantom(const PhantomRequest& request, base::Progress& progress) {
  const PhantomInfo& info = phantomNamed(request.name);
  const int size = request.size == 0 ? info.defaultSize : request.size;
  if (!request.geometry && (size < kMinimumSize || size > kMaximumSize))
    base::throwUsage("", "phantom size",
                     std::to_string(size) + " is outside " + std::to_string(kMinimumSize) + " to " +
                         std::to_string(kMaximumSize));
  if (!(request.noise >= 0.0) || !std::isfinite(request.noise))
    base::throwUsage("", "phantom noise", "must be 0 or more");
  progress.report(0.0, "making the phantom");
  const bool head = info.name == "head";
  const GridGeometry geometry =
      request.geometry ? *request.geometry
      : head           ? headGeometry(size)
                       : GridGeometry::make(glm::ivec3(size), glm::dvec3(1.0), glm::dvec3(-0.5 * (size - 1)));
  base::machineMemory().check(geometry.voxelCount() * (head ? sizeof(std::int16_t) : sizeof(float)),
                              "this phantom", "a smaller size needs less");
  VoxelArray voxels;
  if (head)
    voxels = headVoxels(geometry, request.noise, request.seed, progress);
  else
    voxels = closedForm(request, geometry, progress);
  return Grid(geometry, std::move(voxels), 1.0, 0.0, progress);
}

PhantomRequest parsePhantom(std::string_view text) {
  PhantomRequest request;
  const std::size_t colon = text.find(':');
  request.name = std::string(text.substr(0, colon));
  phantomNamed(request.name);
  if (colon != std::string_view::npos) {
    const std::string_view digits = text.substr(colon + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), request.size);
    const bool whole = error == std::errc() && end == digits.data() + digits.size();
    if (!whole || request.size < kMinimumSize || request.size > kMaximumSize)
      base::throwUsage("", "phantom size",
                       "\"" + std::string(digits) + "\" is not a whole number from " +
                           std::to_string(kMinimumSize) + " to " + std::to_string(kMaximumSize));
  }
  return request;
}

}  // namespace isolux::volume
