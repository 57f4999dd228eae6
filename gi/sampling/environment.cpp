#include "gi/sampling/environment.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <new>
#include <numbers>
#include <span>

#include <glm/gtc/quaternion.hpp>

#include "base/color.h"
#include "base/error.h"
#include "base/huge_pages.h"
#include "base/portable_math.h"
#include "base/random.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/directions.h"
#include "gi/sampling/guide_table.h"
#include "volume/read/process/foreign.h"

namespace isolux::gi {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t certain = 1u << 31;  // probability 1

bool isFinite(glm::vec3 c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

// starts[i] .. starts[i + 1] (the last ends at `certain`) in proportion to weights, none of a positive weight
// empty. Fewer than 2^31 weights, one at least positive.
void distribute(std::span<const double> weights, std::span<std::uint32_t> starts) {
  double total = 0.0;
  for (const double weight : weights) total += weight;
  double before = 0.0;
  std::uint32_t least = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    starts[i] = std::max(least, static_cast<std::uint32_t>(std::lround(before / total * certain)));
    before += weights[i];
    least = starts[i] + (weights[i] > 0.0 ? 1 : 0);
  }
  std::uint32_t most = certain;
  for (std::size_t i = weights.size(); i-- > 0;) {
    starts[i] = std::min(starts[i], weights[i] > 0.0 ? most - 1 : most);
    most = starts[i];
  }
}

// The interval a number in [0, 1) falls in, and where in it.
struct Choice {
  int index;
  std::uint32_t count;  // of 2^-31: its probability
  float fraction;       // in (0, 1]
};

Choice choose(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> guide, float u) {
  const auto value = std::min(certain - 1, static_cast<std::uint32_t>(u * static_cast<float>(certain)));
  const std::size_t index = intervalOf(starts, guide, value);
  const std::uint32_t count = (index + 1 == starts.size() ? certain : starts[index + 1]) - starts[index];
  return {static_cast<int>(index), count,
          (static_cast<float>(value - starts[index]) + 0.5f) / static_cast<float>(count)};
}

// The angle of (x, y) from the x axis in [-pi, pi], off by a few 1e-7 (the polynomial is that of Cephes'
// atanf); 0 of (0, 0).
float angleOf(float y, float x) {
  const float ax = std::abs(x), ay = std::abs(y);
  const float low = std::min(ax, ay), high = std::max(ax, ay);
  const bool past = low > 0.414213562f * high;  // tan(pi / 8): measure from the diagonal
  const float above = past ? low - high : low, below = past ? low + high : high;
  const float t = below > 0.0f ? above / below : 0.0f;
  const float t2 = t * t;
  float angle =
      (((8.05374449538e-2f * t2 - 1.38776856032e-1f) * t2 + 1.99777106478e-1f) * t2 - 3.33329491539e-1f) *
          t2 * t +
      t;
  if (past) angle += 0.785398163f;
  if (ay > ax) angle = 1.57079633f - angle;
  if (x < 0.0f) angle = 3.14159265f - angle;
  return std::copysign(angle, y);
}

}  // namespace

Environment Environment::constant(glm::dvec3 radiance) {
  return Environment(1, 1, {glm::vec3(radiance)});
}

Environment Environment::load(const std::string& path) {
  base::Progress progress;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) base::throwInput(path, "", "is not a file");
  try {
    volume::DecodedImage image = volume::readImage(path, progress);
    return Environment(image.width, image.height, std::move(image.pixels));
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path, "", "is too large for the memory of this computer");
  }
}

Environment::Environment(int width, int height, std::vector<glm::vec3> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {
  assert(width >= 1 && height >= 1);
  if (pixels_.size() >> 31 != 0)
    throw base::Error(base::ErrorKind::memory, "", "",
                      "an environment map of 2^31 pixels or more is not supported");
  assert(pixels_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  repair();
  sumUp();
  buildDistribution();
}

void Environment::repair() {
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    glm::vec3& pixel = pixels_[i];
    if (!isFinite(pixel)) {
      broken.push_back(i);
    } else if (pixel.r < 0.0f || pixel.g < 0.0f || pixel.b < 0.0f) {
      pixel = glm::max(pixel, 0.0f);
      ++badPixels_;
    }
  }
  badPixels_ += broken.size();
  std::vector<glm::vec3> repaired;  // put in place last: a repaired pixel is no neighbour for another
  repaired.reserve(broken.size());
  for (const std::size_t index : broken) {
    const int row = static_cast<int>(index / width_), column = static_cast<int>(index % width_);
    glm::dvec3 sum(0.0);
    int count = 0;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, height_ - 1); ++r)
      for (int step = -1; step <= 1; ++step) {
        const int c = (column + step + width_) % width_;
        const glm::vec3 neighbor = pixels_[static_cast<std::size_t>(r) * width_ + c];
        if (!isFinite(neighbor)) continue;
        sum += glm::max(neighbor, 0.0f);
        ++count;
      }
    repaired.push_back(count > 0 ? glm::vec3(sum / static_cast<double>(count)) : glm::vec3(0.0f));
  }
  for (std::size_t i = 0; i < broken.size(); ++i) pixels_[broken[i]] = repaired[i];
}

void Environment::sumUp() {
  using base::hash64;
  hash_ = hash64(static_cast<std::uint64_t>(width_) << 32 | static_cast<std::uint64_t>(height_));
  constant_ = black_ = true;
  for (int row = 0; row < height_; ++row) {
    glm::dvec3 sum(0.0);
    for (int column = 0; column < width_; ++column) {
      glm::vec3& pixel = pixels_[static_cast<std::size_t>(row) * width_ + column];
      pixel += 0.0f;  // -0 becomes 0
      sum += pixel;
      constant_ = constant_ && pixel == pixels_[0];
      black_ = black_ && pixel == glm::vec3(0.0f);
      const auto r = std::bit_cast<std::uint32_t>(pixel.r), g = std::bit_cast<std::uint32_t>(pixel.g);
      hash_ = hash64(hash_ ^ (static_cast<std::uint64_t>(g) << 32 | r));
      hash_ = hash64(hash_ ^ std::bit_cast<std::uint32_t>(pixel.b));
    }
    mean_ += sum * (solidAngle(row) / (4.0 * kPi));
  }
}

void Environment::buildDistribution() {
  rowStart_.resize(height_);
  columnStart_.resize(pixels_.size());
  const std::size_t columnGuide = guideSize(static_cast<std::size_t>(width_));
  rowGuide_.resize(guideSize(static_cast<std::size_t>(height_)));
  columnGuide_.resize(columnGuide * static_cast<std::size_t>(height_));
  rowDensity_.resize(height_);
  sineSquaredHalf_.resize(height_ + 1);
  for (int row = 0; row <= height_; ++row) {
    const double sine = base::portableSin(0.5 * kPi * row / height_);
    sineSquaredHalf_[row] = static_cast<float>(sine * sine);
  }
  std::vector<double> rows(height_), columns(width_);
  for (int row = 0; row < height_; ++row) {
    rowDensity_[row] = static_cast<float>(0x1p-62 / solidAngle(row));
    const std::size_t first = static_cast<std::size_t>(row) * width_;
    double sum = 0.0;
    for (int column = 0; column < width_; ++column) {
      columns[column] = black_ ? 1.0 : base::luminance(glm::dvec3(pixels_[first + column]));
      sum += columns[column];
    }
    rows[row] = sum * solidAngle(row);
    if (sum > 0.0) {
      const auto starts = std::span(columnStart_).subspan(first, width_);
      distribute(columns, starts);
      fillGuide(starts, std::span(columnGuide_).subspan(columnGuide * row, columnGuide));
    }
    // Else the row has no probability, and what its columns hold is not read.
  }
  distribute(rows, rowStart_);
  fillGuide(rowStart_, rowGuide_);
  // They are read all over.
  const base::Progress progress;
  volume::preferHugePages(columnStart_.data(), columnStart_.size() * sizeof columnStart_[0], progress);
  volume::preferHugePages(pixels_.data(), pixels_.size() * sizeof pixels_[0], progress);
}

double Environment::solidAngle(int row) const {
  // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2)
  const double middle = kPi * (row + 0.5) / height_, half = 0.5 * kPi / height_;
  return 2.0 * kPi / width_ * 2.0 * base::portableSin(middle) * base::portableSin(half);
}

glm::dvec3 Environment::directionOf(double column, double row) const {
  const double polar = kPi * row / height_, turn = 2.0 * kPi * (column / width_ - 0.5);
  return {base::portableSin(polar) * base::portableSin(turn),
          base::portableSin(polar) * base::portableCos(turn), base::portableCos(polar)};
}

Environment::Pixel Environment::pixelOf(glm::vec3 d) const {
  constexpr float inversePi = static_cast<float>(std::numbers::inv_pi);
  const float polar = angleOf(std::sqrt(d.x * d.x + d.y * d.y), d.z) * inversePi;
  const float turn = angleOf(d.x, d.y) * (0.5f * inversePi) + 0.5f;
  const int row = std::clamp(static_cast<int>(polar * static_cast<float>(height_)), 0, height_ - 1);
  const int column = std::clamp(static_cast<int>(turn * static_cast<float>(width_)), 0, width_ - 1);
  return {row, static_cast<std::size_t>(row) * width_ + column};
}

float Environment::pdfOf(int row, std::size_t index) const {
  const std::uint32_t rowEnd = row + 1 < height_ ? rowStart_[row + 1] : certain;
  if (rowEnd == rowStart_[row]) return 0.0f;
  const bool last = (index + 1) % width_ == 0;
  const std::uint32_t end = last ? certain : columnStart_[index + 1];
  return static_cast<float>(rowEnd - rowStart_[row]) * static_cast<float>(end - columnStart_[index]) *
         rowDensity_[row];
}

Environment::Sample Environment::sample(glm::vec2 u) const {
  const Choice row = choose(rowStart_, rowGuide_, u.y);
  const std::size_t first = static_cast<std::size_t>(row.index) * width_;
  const std::size_t columnGuide = guideSize(static_cast<std::size_t>(width_));
  const Choice column = choose(std::span(columnStart_).subspan(first, width_),
                               std::span(columnGuide_).subspan(columnGuide * row.index, columnGuide), u.x);

  // 1 - cos of the angle from the nearer pole, over 2, is even within the row.
  const bool lower = 2 * row.index >= height_;
  const float top = sineSquaredHalf_[lower ? height_ - row.index : row.index];
  const float bottom = sineSquaredHalf_[lower ? height_ - row.index - 1 : row.index + 1];
  const float half = top + row.fraction * (bottom - top);
  const float sine = 2.0f * std::sqrt(half * std::max(0.0f, 1.0f - half));
  const float z = lower ? 2.0f * half - 1.0f : 1.0f - 2.0f * half;
  const float turn = (static_cast<float>(column.index) + column.fraction) / static_cast<float>(width_) - 0.5f;
  float sineOfTurn, cosineOfTurn;
  sineCosineOfTurn(turn, sineOfTurn, cosineOfTurn);
  return {{sine * sineOfTurn, sine * cosineOfTurn, z},
          pixels_[first + column.index],
          static_cast<float>(row.count) * static_cast<float>(column.count) * rowDensity_[row.index]};
}

EnvironmentTables Environment::tables() const {
  return {.width = width_,
          .height = height_,
          .pixels = &pixels_[0].x,
          .rowStart = rowStart_.data(),
          .columnStart = columnStart_.data(),
          .rowGuide = rowGuide_.data(),
          .columnGuide = columnGuide_.data(),
          .rowDensity = rowDensity_.data(),
          .sineSquaredHalf = sineSquaredHalf_.data()};
}

std::vector<glm::dvec3> Environment::project(int order) const {
  // Separable: Y_l^m over a pixel is an integral over its row's angle from the zenith (of Y_l^|m| at azimuth
  // 0, times the sine) and one over its column's azimuth, of cos(m phi) or sin(|m| phi).
  std::vector<glm::dvec3> coefficients(shTerms(order), glm::dvec3(0.0));
  std::vector<double> cosines(static_cast<std::size_t>(order) * width_), sines(cosines.size());
  const double step = 2.0 * kPi / width_;
  for (int m = 0; m < order; ++m)
    for (int column = 0; column < width_; ++column) {
      const double phi =
          0.5 * kPi - step * (column + 0.5) + kPi;  // from +x toward +y, of the column's middle
      const double span = m == 0 ? step : 2.0 * base::portableSin(0.5 * m * step) / m;
      cosines[static_cast<std::size_t>(m) * width_ + column] = span * base::portableCos(m * phi);
      sines[static_cast<std::size_t>(m) * width_ + column] = span * base::portableSin(m * phi);
    }
  const GaussLegendre rule(24);  // full precision even where one row is the whole sphere
  std::array<double, shTerms(maxShOrder)> y, row;
  for (int r = 0; r < height_; ++r) {
    row.fill(0.0);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double polar = kPi * (r + 0.5 + 0.5 * rule.nodes[k]) / height_;
      evaluateSh(order, glm::dvec3(base::portableSin(polar), 0.0, base::portableCos(polar)), y.data());
      const double weight = rule.weights[k] * 0.5 * kPi / height_ * base::portableSin(polar);
      for (int i = 0; i < shTerms(order); ++i) row[i] += weight * y[i];
    }
    const glm::vec3* pixels = pixels_.data() + static_cast<std::size_t>(r) * width_;
    for (int m = 0; m < order; ++m) {
      const double* cosine = cosines.data() + static_cast<std::size_t>(m) * width_;
      const double* sine = sines.data() + static_cast<std::size_t>(m) * width_;
      glm::dvec3 even(0.0), odd(0.0);
      for (int column = 0; column < width_; ++column) {
        const glm::dvec3 value(pixels[column]);
        even += value * cosine[column];
        odd += value * sine[column];
      }
      for (int l = m; l < order; ++l) {
        coefficients[l * (l + 1) + m] += row[l * (l + 1) + m] * even;
        if (m > 0) coefficients[l * (l + 1) - m] += row[l * (l + 1) + m] * odd;
      }
    }
  }
  return coefficients;
}

glm::dmat3 worldFromEnvironment(glm::dquat rotation) {
  const double length = glm::length(rotation);
  return length > 0.0 ? glm::mat3_cast(rotation / length) : glm::dmat3(1.0);
}

}  // namespace isolux::gi
