// Polyhedral friction cones as sums of plane ones.
#include "nodes/wedged/relaxation/facets.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace kusabi::wedged {
namespace {

int checked(int facets) {
  if (facets < FacetBound::minimum || facets > FacetBound::maximum || facets % 2 != 0) {
    throw std::invalid_argument(
        fmt::format("a friction cone takes an even number of facets from {} to {}, not {}",
                    FacetBound::minimum, FacetBound::maximum, facets));
  }
  return facets;
}

// Row 2k of the spread is the normal of cone k, row 2k + 1 its tangent, both as displacements of
// its candidate: the cones have the compliance spread F spread'.
Eigen::MatrixXd spread_of(Eigen::Index m, int facets) {
  const int each = facets / 2;
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(2 * each * m, 3 * m);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (int k = 0; k < each; ++k) {
      const double angle = std::numbers::pi * (2 * k + 1) / facets;
      const Eigen::Index row = 2 * (each * i + k);
      spread(row, 3 * i) = 1;
      spread(row + 1, 3 * i + 1) = std::cos(angle);
      spread(row + 1, 3 * i + 2) = std::sin(angle);
    }
  }
  return spread;
}

// Rounding errors of the spread and of the products, in addition to those of F and G.
constexpr double spread_roundings = 32 * 0x1p-53;

conic::NodeSolver<2> solver_of(const Eigen::MatrixXd& spread, const Eigen::MatrixXd& compliance,
                               std::span<const double> friction, int facets,
                               conic::Tolerances tolerances, double error,
                               const conic::Motions<double>& motions) {
  std::vector<double> widened;
  std::vector<int> owners;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    for (int k = 0; k < facets / 2; ++k) {
      widened.push_back(friction[i] / std::cos(std::numbers::pi / facets));
      owners.push_back(static_cast<int>(i));
    }
  }
  const Eigen::MatrixXd product = spread * compliance * spread.transpose();
  return {0.5 * (product + product.transpose()),
          widened,
          std::move(owners),
          tolerances,
          error + spread_roundings,
          motions};
}

Eigen::MatrixXd checked_spread(const Eigen::MatrixXd& compliance, std::size_t candidates,
                               int facets) {
  const auto m = static_cast<Eigen::Index>(candidates);
  if (compliance.rows() != 3 * m || compliance.cols() != 3 * m)
    throw std::invalid_argument("polyhedral friction is for contact in space");
  return spread_of(m, checked(facets));
}

conic::Motions<double> spread_motions(const Eigen::MatrixXd& spread, const Eigen::MatrixXd& motions,
                                      double error) {
  if (motions.cols() == 0) return {};
  return conic::ordered_motions<2, double>(spread * motions, 2 * error + spread_roundings);
}

}  // namespace

FacetBound::FacetBound(const Eigen::MatrixXd& compliance, std::span<const double> friction,
                       int facets, conic::Tolerances tolerances, double error,
                       const Eigen::MatrixXd& motions, double motion_error)
    : FacetBound(facets, checked_spread(compliance, friction.size(), facets), compliance, friction,
                 tolerances, error,
                 spread_motions(checked_spread(compliance, friction.size(), facets), motions,
                                motion_error)) {}

FacetBound::FacetBound(int facets, const Eigen::MatrixXd& spread, const Eigen::MatrixXd& compliance,
                       std::span<const double> friction, conic::Tolerances tolerances, double error,
                       const conic::Motions<double>& motions)
    : cones_each_(facets / 2),
      combination_(motions.combination),
      solver_(solver_of(spread, compliance, friction, facets, tolerances, error, motions)) {}

Eigen::VectorXd FacetBound::multipliers() const {
  Eigen::VectorXd result = solver_.multipliers();
  const Eigen::Index p = combination_.cols();
  if (p > 0) result.tail(p) = combination_ * Eigen::VectorXd(result.tail(p));
  return result;
}

conic::ConicResult FacetBound::solve(const support::IndexSet& contact,
                                     const support::IndexSet& separated, conic::StopEarly stop,
                                     const support::IndexSet& ignored) {
  return solver_.solve(contact, separated, stop, ignored);
}

double FacetBound::normal_reaction(int candidate) const {
  double sum = 0;
  for (int k = 0; k < cones_each_; ++k)
    sum += solver_.reaction()[2 * (Eigen::Index{cones_each_} * candidate + k)];
  return sum;
}

double FacetBound::normal_displacement(int candidate) const {
  return solver_.displacement()[2 * Eigen::Index{cones_each_} * candidate];
}

}  // namespace kusabi::wedged
