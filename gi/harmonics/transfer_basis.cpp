#include "gi/harmonics/transfer_basis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

namespace isolux::gi {

namespace {

using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXf;

// How much an error in a band counts. Environments have less in the higher bands. Of the exponents 0, 1/2, 1
// and 2 this one has the smallest mean error under three light probes (docs/architecture.md).
double bandWeight(int band) {
  return 1.0 / std::sqrt(1.0 + band);
}

// The range of codes goes beyond that of the texels by this part of it, on either side.
constexpr double kMargin = 0.03;

// A transfer vector a row, of at most `most` baked texels, evenly chosen.
Eigen::MatrixXd gather(const LightLattice& lattice, std::size_t most, const base::Progress* progress) {
  const std::size_t baked = lattice.bakedTexels(),
                    d = static_cast<std::size_t>(lattice.content().components());
  const std::size_t every = std::max<std::size_t>((baked + most - 1) / std::max<std::size_t>(most, 1), 1);
  std::vector<double> values;
  values.reserve(std::min(baked, most) * d);
  std::size_t seen = 0;
  for (std::uint32_t b = 0; b < lattice.geometry().blockCount(); ++b) {
    if (progress) progress->throwIfStopped();
    const auto block = lattice.at(b);
    if (!block) continue;
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      if (block->samples[i] == 0 || seen++ % every != 0) continue;
      const float* const means = block->means.data() + i * d;
      if (std::all_of(means, means + d, [](float m) { return std::isfinite(m); }))
        values.insert(values.end(), means, means + d);
    }
  }
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), static_cast<Eigen::Index>(values.size() / d), static_cast<Eigen::Index>(d));
}

template <class Matrix>
std::vector<float> floatsOf(const Matrix& matrix) {
  const Rows rows = matrix.template cast<float>();
  return {rows.data(), rows.data() + rows.size()};
}

}  // namespace

std::shared_ptr<const TransferBasis> TransferBasis::fit(const LightLattice& lattice, int components, int bits,
                                                        const base::Progress* progress,
                                                        std::size_t mostTexels) {
  const LightContent& content = lattice.content();
  assert(content.kind == LightContent::Kind::transfer && (bits == 8 || bits == 16) && components > 0);
  const auto heedStop = [&] {
    if (progress) progress->throwIfStopped();
  };
  Eigen::MatrixXd texels = gather(lattice, mostTexels, progress);
  if (texels.rows() == 0) return nullptr;
  const Eigen::Index d = texels.cols(), kept = std::min<Eigen::Index>(components, d);

  Eigen::VectorXd weights(d);
  const int ofChannel = content.order * content.order;
  for (Eigen::Index i = 0; i < d; ++i)
    weights[i] = bandWeight(static_cast<int>(std::sqrt(static_cast<double>(i % ofChannel) + 0.5)));

  // Principal components of the weighted vectors; the eigenvalues rise.
  const Eigen::RowVectorXd mean = texels.colwise().mean();
  texels.rowwise() -= mean;
  const Eigen::MatrixXd weighted = texels * weights.asDiagonal();
  heedStop();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(weighted.transpose() * weighted);
  const Eigen::MatrixXd axes = solver.eigenvectors().rowwise().reverse().leftCols(kept);

  heedStop();
  auto basis = std::make_shared<TransferBasis>();
  basis->content_ = content;
  basis->bits_ = bits;
  basis->mean_ = floatsOf(mean);
  basis->basis_ = floatsOf(axes.transpose() * weights.cwiseInverse().asDiagonal());
  basis->projection_ = floatsOf(axes.transpose() * weights.asDiagonal());
  const Eigen::MatrixXd coefficients = weighted * axes;
  const double codes = std::ldexp(1.0, bits) - 1.0;
  for (Eigen::Index k = 0; k < kept; ++k) {
    const double low = coefficients.col(k).minCoeff(), high = coefficients.col(k).maxCoeff();
    // Texels that differ by rounding alone are the same.
    const double range = high - low > 1e-9 * weights[0] * mean.norm() ? high - low : 0.0;
    basis->low_.push_back(static_cast<float>(low - kMargin * range));
    basis->step_.push_back(static_cast<float>((1.0 + 2.0 * kMargin) * range / codes));
  }
  return basis;
}

void TransferBasis::encode(std::span<const float> transfer, std::span<std::uint8_t> codes) const {
  assert(transfer.size() == mean_.size() && codes.size() == bytesPerTexel());
  const auto d = static_cast<Eigen::Index>(mean_.size());
  const Vector c = Eigen::Map<const Rows>(projection_.data(), components(), d) *
                   (Eigen::Map<const Vector>(transfer.data(), d) - Eigen::Map<const Vector>(mean_.data(), d));
  const float last = std::ldexp(1.0f, bits_) - 1.0f;
  for (std::size_t k = 0; k < low_.size(); ++k) {
    const float at = step_[k] > 0.0f ? (c[static_cast<Eigen::Index>(k)] - low_[k]) / step_[k] : 0.0f;
    // NaN becomes 0.
    const auto code = static_cast<std::uint32_t>(std::lround(std::min(at > 0.0f ? at : 0.0f, last)));
    if (bits_ == 8) {
      codes[k] = static_cast<std::uint8_t>(code);
    } else {
      codes[2 * k] = static_cast<std::uint8_t>(code & 0xff);
      codes[2 * k + 1] = static_cast<std::uint8_t>(code >> 8);
    }
  }
}

void TransferBasis::decode(std::span<const std::uint8_t> codes, std::span<float> transfer) const {
  assert(transfer.size() == mean_.size() && codes.size() == bytesPerTexel());
  const auto d = static_cast<Eigen::Index>(mean_.size());
  Vector c(components());
  for (std::size_t k = 0; k < low_.size(); ++k) {
    const std::uint32_t code = bits_ == 8 ? codes[k] : codes[2 * k] | std::uint32_t{codes[2 * k + 1]} << 8;
    c[static_cast<Eigen::Index>(k)] = low_[k] + static_cast<float>(code) * step_[k];
  }
  Eigen::Map<Vector>(transfer.data(), d) =
      Eigen::Map<const Vector>(mean_.data(), d) +
      Eigen::Map<const Rows>(basis_.data(), components(), d).transpose() * c;
}

TransferBasis::Lighting TransferBasis::under(std::span<const glm::vec3> environment) const {
  const auto ofChannel = static_cast<std::size_t>(content_.order) * static_cast<std::size_t>(content_.order);
  assert(environment.size() == ofChannel);
  // E of a transfer vector; one channel serves all three.
  const auto lit = [&](const float* transfer) {
    glm::dvec3 light(0.0);
    for (int channel = 0; channel < 3; ++channel) {
      const std::size_t from = content_.channels == 1 ? 0 : static_cast<std::size_t>(channel) * ofChannel;
      for (std::size_t i = 0; i < ofChannel; ++i)
        light[channel] +=
            static_cast<double>(transfer[from + i]) * static_cast<double>(environment[i][channel]);
    }
    return light;
  };
  Lighting lighting;
  glm::dvec3 offset = lit(mean_.data());
  for (std::size_t k = 0; k < low_.size(); ++k) {
    const glm::dvec3 factor = lit(basis_.data() + k * mean_.size());
    offset += static_cast<double>(low_[k]) * factor;
    lighting.factors.emplace_back(static_cast<double>(step_[k]) * factor);
  }
  lighting.offset = glm::vec3(offset);
  return lighting;
}

}  // namespace isolux::gi
