#include "gi/sampling/facing_sky.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

namespace isolux::gi {

namespace {

constexpr int kCells = FacingSky::kCells, kFacings = FacingSky::kFacings;
constexpr int kTried = 8, kDirectionsOfCell = kTried * kTried;  // per axis
constexpr float kBeyondHorizon = 0.1f;  // normals stand for others that are so far off, in radians
constexpr float kLeastCosine = 0.05f;   // of a cell
constexpr float kLargestNumber = 1.0f - 0x1p-24f;

float signOf(float x) {
  return x < 0.0f ? -1.0f : 1.0f;
}

glm::vec3 normalOfFacing(int column, int row) {
  const float x = 2.0f * (static_cast<float>(column) + 0.5f) / kFacings - 1.0f;
  const float y = 2.0f * (static_cast<float>(row) + 0.5f) / kFacings - 1.0f;
  const float z = 1.0f - std::abs(x) - std::abs(y);
  if (z >= 0.0f) return glm::normalize(glm::vec3(x, y, z));
  return glm::normalize(glm::vec3((1.0f - std::abs(y)) * signOf(x), (1.0f - std::abs(x)) * signOf(y), z));
}

std::size_t facingOf(glm::vec3 n) {
  const float scale = 1.0f / std::max(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1e-30f);
  float x = n.x * scale, y = n.y * scale;
  if (n.z < 0.0f) {
    const float folded = (1.0f - std::abs(y)) * signOf(x);
    y = (1.0f - std::abs(x)) * signOf(y);
    x = folded;
  }
  const auto cell = [](float at) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((at + 1.0f) * (0.5f * kFacings)), 0, kFacings - 1));
  };
  return cell(y) * kFacings + cell(x);
}

// Where parts in proportion to `weights` begin.
void startsOf(std::span<const float> weights, std::array<float, kCells>& starts) {
  double total = 0.0, before = 0.0;
  for (const float weight : weights) total += static_cast<double>(weight);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    starts[i] = static_cast<float>(before / total);
    before += static_cast<double>(weights[i]);
  }
}

// The part a number falls in, its length, and where in it.
struct Part {
  std::size_t index;
  float length, fraction;
};
Part partOf(const std::array<float, kCells>& starts, float u) {
  std::size_t i = 0;  // no branches: which part it is nobody could foretell
  for (std::size_t step = kCells / 2; step > 0; step /= 2) i += u >= starts[i + step] ? step : 0;
  const float length = (i + 1 < starts.size() ? starts[i + 1] : 1.0f) - starts[i];
  return {i, length, (u - starts[i]) / length};
}

// At least 0; compilers make no vectors of a choice.
float clamped(float x) {
  return 0.5f * (x + std::abs(x));
}

using OfFacings = std::array<float, kFacings * kFacings>;

struct Normals {
  OfFacings x, y, z;
};
Normals normalsOfFacings() {
  Normals normals;
  for (int i = 0; i < kFacings * kFacings; ++i) {
    const glm::vec3 normal = normalOfFacing(i % kFacings, i / kFacings);
    const auto at = static_cast<std::size_t>(i);
    normals.x[at] = normal.x, normals.y[at] = normal.y, normals.z[at] = normal.z;
  }
  return normals;
}

// Sums over directions: of squares of clamped cosines slightly past the horizon, and of clamped cosines. Side
// by side for all normals, which is what compilers make vectors of.
struct CosineSums {
  OfFacings squares{}, cosines{};

  void add(const Normals& n, glm::vec3 d) {
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const float cosine = n.x[i] * d.x + n.y[i] * d.y + n.z[i] * d.z;
      const float past = clamped(cosine + kBeyondHorizon);
      squares[i] += past * past;
      cosines[i] += clamped(cosine);
    }
  }
};

FacingSky::Facing facingFrom(const std::vector<CosineSums>& cells, std::size_t which) {
  FacingSky::Facing facing;
  std::array<float, kCells> rows{}, columns;
  float cosines = 0.0f;
  for (std::size_t row = 0; row < kCells; ++row) {
    for (std::size_t column = 0; column < kCells; ++column) {
      const CosineSums& cell = cells[row * kCells + column];
      columns[column] = kLeastCosine + std::sqrt(cell.squares[which] / kDirectionsOfCell);
      rows[row] += columns[column];
      cosines += cell.cosines[which];
    }
    startsOf(columns, facing.columns[row]);
  }
  startsOf(rows, facing.rows);
  facing.inverseMean = 1.0f / std::max(cosines / (kDirectionsOfCell * kCells * kCells), kLeastCosine);
  return facing;
}

}  // namespace

FacingSky::FacingSky(const std::function<glm::vec3(glm::vec2)>& directionAt) {
  const Normals normals = normalsOfFacings();
  std::vector<CosineSums> cells(kCells * kCells);
  for (int cell = 0; cell < kCells * kCells; ++cell)
    for (int i = 0; i < kDirectionsOfCell; ++i) {
      const glm::vec2 at(cell % kCells * kTried + i % kTried, cell / kCells * kTried + i / kTried);
      cells[static_cast<std::size_t>(cell)].add(
          normals, directionAt((at + 0.5f) / static_cast<float>(kCells * kTried)));
    }
  facings_.reserve(normals.x.size());
  for (std::size_t i = 0; i < normals.x.size(); ++i) facings_.push_back(facingFrom(cells, i));
}

const FacingSky::Facing& FacingSky::of(glm::vec3 normal) const {
  return facings_[gi::facingOf(normal)];
}

BentPair bend(const FacingSky::Facing& facing, glm::vec2 u) {
  const Part row = partOf(facing.rows, u.y);
  const Part column = partOf(facing.columns[row.index], u.x);
  const auto number = [](const Part& part) {
    return std::min((static_cast<float>(part.index) + part.fraction) / kCells, kLargestNumber);
  };
  return {{number(column), number(row)}, row.length * column.length * (kCells * kCells)};
}

}  // namespace isolux::gi
