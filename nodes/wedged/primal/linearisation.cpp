// Successive cone programs, the weights of each from the contact set of the last.
#include "nodes/wedged/primal/linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/conic/motions.hpp"

namespace kusabi::wedged {
namespace {

constexpr int max_programs = 15;

/// An excess up to this is zero: the programs are solved to 1e-8.
constexpr double no_excess = 1e-7;

/// The iteration ends if a program decreases the excess by less than this share.
constexpr double hardly_less = 1e-3;

/// Row sums count as no less than this share of the largest.
constexpr double min_row = 1e-3;

template <int D>
conic::WeightedRelaxation<D> relaxation(const problems::WedgedProblem& block, double unit) {
  return {block.compliance.matrix / unit,
          conic::ordered_motions<D, double>(block.modes.matrix, block.modes.error)};
}

}  // namespace

Linearisation::Linearisation(const problems::WedgedProblem& block)
    : relaxation_([&]() -> decltype(relaxation_) {
        const double unit = problems::mean_normal_compliance(block);
        if (block.dimension == 2) return relaxation<2>(block, unit);
        return relaxation<3>(block, unit);
      }()),
      own_friction_(block.friction.empty() ? std::vector<double>(block.contact_names.size(), 1)
                                           : block.friction),
      friction_(own_friction_) {
  const Eigen::Index d = block.dimension;
  const auto m = static_cast<Eigen::Index>(own_friction_.size());
  const double unit = problems::mean_normal_compliance(block);
  const bool unconstrained = block.modes.matrix.cols() > 0;
  normal_.resize(m);
  tangential_.resize(m);
  row_sums_.setZero(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto row = block.compliance.matrix.row(d * i);
    normal_[i] = row[d * i] / unit;
    tangential_[i] = row.segment(d * i + 1, d - 1).norm() / unit;
    for (Eigen::Index k = 0; k < m; ++k)
      row_sums_[i] += (unconstrained ? std::abs(row[d * k]) : row[d * k]) / unit;
  }
  row_sums_ = row_sums_.cwiseMax(min_row * row_sums_.maxCoeff());
}

void Linearisation::end_when(const support::Stop& stop) {
  std::visit([&](auto& relaxation) { relaxation.end_when(stop); }, relaxation_);
}

std::optional<conic::RelaxedPoint> Linearisation::minimise(const support::IndexSet& contact,
                                                           const Vector& scale) {
  ++programs_;
  Vector gap = Vector::Zero(scale.size()), reaction = Vector::Ones(scale.size());
  for (const int i : contact) {
    gap[i] = 1 / scale[i];
    reaction[i] = 0;
  }
  return std::visit([&](auto& relaxation) { return relaxation.minimise(friction_, gap, reaction); },
                    relaxation_);
}

std::optional<LinearisedPattern> Linearisation::from(const support::IndexSet& contact,
                                                     double factor, double share) {
  for (std::size_t i = 0; i < friction_.size(); ++i) friction_[i] = factor * own_friction_[i];
  Vector scale(normal_.size());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    const double own = normal_[i] + friction_[static_cast<std::size_t>(i)] * tangential_[i];
    scale[i] = std::pow(own, 1 - share) * std::pow(row_sums_[i], share);
  }
  LinearisedPattern result{contact, std::numeric_limits<double>::infinity()};
  for (int program = 0; program < max_programs; ++program) {
    const auto point = minimise(result.contact, scale);
    if (!point) return {};
    const Vector gaps = point->gap.cwiseMax(0).cwiseQuotient(scale);
    const double excess = gaps.cwiseMin(point->reaction).sum();
    const double before = result.excess;
    result = {{}, excess};
    for (int i = 0; i < static_cast<int>(gaps.size()); ++i)
      if (gaps[i] < point->reaction[i]) result.contact.insert(i);
    if (excess < no_excess || !(excess < (1 - hardly_less) * before)) break;
  }
  return result;
}

}  // namespace kusabi::wedged
