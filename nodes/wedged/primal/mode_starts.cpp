// Modes by subspace iteration; coefficients by a generator with a seed.
#include "nodes/wedged/primal/mode_starts.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace kusabi::wedged {
namespace {

constexpr Eigen::Index max_modes = 8;
constexpr int iterations = 30;

/// Weight of the softest mode. It has one sign everywhere, so the others determine the shape.
constexpr double weight_of_first = 0.3;

/// Shares of the candidates that are in contact.
constexpr double min_share = 0.1, max_share = 0.9;

/// Numbers in [0, 1), independent of the standard library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}

  double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

  /// Approximately normal distribution.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += (*this)();
    return sum;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace

ModeStarts::ModeStarts(const problems::WedgedProblem& block) {
  const Eigen::Index d = block.dimension;
  const auto m = static_cast<Eigen::Index>(block.contact_names.size());
  Eigen::MatrixXd normal(m, m);
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = 0; i < m; ++i) normal(i, j) = block.compliance.matrix(d * i, d * j);
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  normal = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::Index count = std::min(m, max_modes);
  Uniform uniform(static_cast<std::uint64_t>(m));
  modes_.resize(m, count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < m; ++i) modes_(i, j) = uniform() - 0.5;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(normal * modes_);
    modes_ = factors.householderQ() * Eigen::MatrixXd::Identity(m, count);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> within(modes_.transpose() * normal * modes_);
  modes_ = modes_ * within.eigenvectors().rowwise().reverse();
}

ModeStart ModeStarts::at(std::uint64_t number) const {
  Uniform uniform(0x9e3779b97f4a7c15U * (number + 1));
  Eigen::VectorXd weights(modes_.cols());
  for (Eigen::Index j = 0; j < weights.size(); ++j)
    weights[j] = uniform.normal() / std::sqrt(1.0 + static_cast<double>(j));
  weights[0] *= weight_of_first;
  const Eigen::VectorXd field = modes_ * weights;
  const double share = min_share + (max_share - min_share) * uniform();
  std::vector<double> sorted(field.begin(), field.end());
  std::ranges::sort(sorted);
  const double level =
      sorted[static_cast<std::size_t>((1 - share) * static_cast<double>(sorted.size() - 1))];
  ModeStart start;
  for (int i = 0; i < static_cast<int>(field.size()); ++i)
    if (field[i] >= level) start.contact.insert(i);
  start.share = 0.5 * std::floor(3 * uniform());
  return start;
}

}  // namespace kusabi::wedged
