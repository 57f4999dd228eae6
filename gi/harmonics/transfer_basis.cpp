#include "gi/harmonics/transfer_basis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

#include "gi/harmonics/bit_allocation.h"

namespace isolux::gi {

namespace {

using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXf;

// How much an error in a band counts. Environments have less in the higher bands. Of the exponents 0, 1/2, 1
// and 2 this one has the smallest mean error under three light probes
// (docs/explanation/global-illumination.md).
double bandWeight(int band) {
  return 1.0 / std::sqrt(1.0 + band);
}

constexpr std::size_t kMostNumbers = 4000;  // of a component, that its bits are chosen by

// A transfer vector a row, of at most `most` baked texels, evenly chosen.
Eigen::MatrixXd gather(std::span<const LightLattice* const> lattices, std::size_t most,
                       const base::Progress* progress) {
  const auto d = static_cast<std::size_t>(lattices.front()->content().components());
  std::size_t baked = 0;
  for (const LightLattice* lattice : lattices) baked += lattice->bakedTexels();
  const std::size_t every = std::max<std::size_t>((baked + most - 1) / std::max<std::size_t>(most, 1), 1);
  std::vector<double> values;
  values.reserve(std::min(baked, most) * d);
  std::size_t seen = 0;
  const auto take = [&](const LatticeBlock& block) {
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      if (block.samples[i] == 0 || seen++ % every != 0) continue;
      const float* const means = block.means.data() + i * d;
      if (std::all_of(means, means + d, [](float m) { return std::isfinite(m); }))
        values.insert(values.end(), means, means + d);
    }
  };
  for (const LightLattice* lattice : lattices)
    for (std::uint32_t b = 0; b < lattice->geometry().blockCount(); ++b) {
      if (progress) progress->throwIfStopped();
      if (const auto block = lattice->at(b)) take(*block);
    }
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), static_cast<Eigen::Index>(values.size() / d), static_cast<Eigen::Index>(d));
}

// At most kMostNumbers of a column, rising.
std::vector<double> someSorted(const Eigen::MatrixXd& coefficients, Eigen::Index column) {
  const auto count = static_cast<std::size_t>(coefficients.rows());
  const std::size_t every = (count + kMostNumbers - 1) / kMostNumbers;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; i += every)
    numbers.push_back(coefficients(static_cast<Eigen::Index>(i), column));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

template <class Matrix>
std::vector<float> floatsOf(const Matrix& matrix) {
  const Rows rows = matrix.template cast<float>();
  return {rows.data(), rows.data() + rows.size()};
}

}  // namespace

std::shared_ptr<const TransferBasis> TransferBasis::fit(std::span<const LightLattice* const> lattices,
                                                        int components, int bits,
                                                        const base::Progress* progress,
                                                        std::size_t mostTexels) {
  const LightContent& content = lattices.front()->content();
  assert(content.kind == LightContent::Kind::transfer && bits > 0 && components > 0);
  const auto heedStop = [&] {
    if (progress) progress->throwIfStopped();
  };
  Eigen::MatrixXd texels = gather(lattices, mostTexels, progress);
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
  basis->words_ = static_cast<std::size_t>((bits + kWordBits - 1) / kWordBits);
  basis->mean_ = floatsOf(mean);
  const Eigen::MatrixXd coefficients = weighted * axes;
  std::vector<std::vector<double>> sorted;
  for (Eigen::Index k = 0; k < kept; ++k) {
    sorted.push_back(someSorted(coefficients, k));
    // Texels that differ by rounding alone are the same.
    if (!(sorted.back().back() - sorted.back().front() > 1e-9 * weights[0] * mean.norm())) sorted.pop_back();
    if (sorted.size() <= static_cast<std::size_t>(k)) break;  // those that follow vary less
  }
  heedStop();
  std::vector<int> widths = allocateBits(sorted, static_cast<int>(basis->words_) * kWordBits);
  const std::vector<FieldPlace> places = placeFields(widths, static_cast<int>(basis->words_));
  std::vector<Eigen::Index> coded;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].word < 0) continue;
    const Quantizer quantizer = quantizerOf(sorted[k], widths[k]);
    basis->fields_.push_back({places[k].word, places[k].shift, widths[k], static_cast<float>(quantizer.low),
                              static_cast<float>(quantizer.step)});
    coded.push_back(static_cast<Eigen::Index>(k));
  }
  const Eigen::MatrixXd used = axes(Eigen::all, coded);
  basis->basis_ = floatsOf(used.transpose() * weights.cwiseInverse().asDiagonal());
  basis->projection_ = floatsOf(used.transpose() * weights.asDiagonal());
  return basis;
}

void TransferBasis::encode(std::span<const float> transfer, std::span<std::uint32_t> words) const {
  assert(transfer.size() == mean_.size() && words.size() == words_);
  const auto d = static_cast<Eigen::Index>(mean_.size());
  const auto components = static_cast<Eigen::Index>(fields_.size());
  const Vector c = Eigen::Map<const Rows>(projection_.data(), components, d) *
                   (Eigen::Map<const Vector>(transfer.data(), d) - Eigen::Map<const Vector>(mean_.data(), d));
  std::fill(words.begin(), words.end(), 0u);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const Field& field = fields_[k];
    const Quantizer quantizer{static_cast<double>(field.low), static_cast<double>(field.step)};
    const std::uint32_t code =
        codeOf(quantizer, field.bits, static_cast<double>(c[static_cast<Eigen::Index>(k)]));
    words[static_cast<std::size_t>(field.word)] |= code << field.shift;
  }
}

std::uint32_t TransferBasis::code(std::span<const std::uint32_t> words, std::size_t component) const {
  const Field& field = fields_[component];
  return words[static_cast<std::size_t>(field.word)] >> field.shift & ((1u << field.bits) - 1u);
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
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const glm::dvec3 factor = lit(basis_.data() + k * mean_.size());
    offset += static_cast<double>(fields_[k].low) * factor;
    lighting.factors.emplace_back(static_cast<double>(fields_[k].step) * factor);
  }
  lighting.offset = glm::vec3(offset);
  return lighting;
}

}  // namespace isolux::gi
